// SPDX-License-Identifier: Apache-2.0
// Eight lanes in AVX2 registers. The contract of every lane type is in lanes_scalar.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <immintrin.h>

namespace auslan::raster {

struct Avx2 {
  struct F {
    __m256 v;
    friend F operator+(F a, F b) { return {_mm256_add_ps(a.v, b.v)}; }
    friend F operator-(F a, F b) { return {_mm256_sub_ps(a.v, b.v)}; }
    friend F operator*(F a, F b) { return {_mm256_mul_ps(a.v, b.v)}; }
    friend F operator/(F a, F b) { return {_mm256_div_ps(a.v, b.v)}; }
  };
  struct I {
    __m256i v;
    friend I operator+(I a, I b) { return {_mm256_add_epi32(a.v, b.v)}; }
    friend I operator-(I a, I b) { return {_mm256_sub_epi32(a.v, b.v)}; }
    friend I operator&(I a, I b) { return {_mm256_and_si256(a.v, b.v)}; }
    friend I operator|(I a, I b) { return {_mm256_or_si256(a.v, b.v)}; }
    friend I operator^(I a, I b) { return {_mm256_xor_si256(a.v, b.v)}; }
  };
  struct H {
    __m128i v;
    friend H operator+(H a, H b) { return {_mm_add_epi16(a.v, b.v)}; }
    friend H operator*(H a, H b) { return {_mm_mullo_epi16(a.v, b.v)}; }
  };

  static F set(float x) { return {_mm256_set1_ps(x)}; }
  static I set(int32_t x) { return {_mm256_set1_epi32(x)}; }
  static F load(const float* p) { return {_mm256_loadu_ps(p)}; }
  static I load(const int32_t* p) { return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))}; }
  static I load(const uint32_t* p) { return {_mm256_loadu_si256(reinterpret_cast<const __m256i*>(p))}; }
  static void store(float* p, F a) { _mm256_storeu_ps(p, a.v); }
  static void store(int32_t* p, I a) { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), a.v); }
  static void store(uint32_t* p, I a) { _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), a.v); }

  static F min(F a, F b) { return {_mm256_min_ps(a.v, b.v)}; }
  static F max(F a, F b) { return {_mm256_max_ps(a.v, b.v)}; }
  static I min(I a, I b) { return {_mm256_min_epi32(a.v, b.v)}; }
  static I max(I a, I b) { return {_mm256_max_epi32(a.v, b.v)}; }
  static F sqrt(F a) { return {_mm256_sqrt_ps(a.v)}; }
  static I greater(F a, F b) { return {_mm256_castps_si256(_mm256_cmp_ps(a.v, b.v, _CMP_GT_OQ))}; }
  static I at_least(F a, F b) { return {_mm256_castps_si256(_mm256_cmp_ps(a.v, b.v, _CMP_GE_OQ))}; }
  static I greater(I a, I b) { return {_mm256_cmpgt_epi32(a.v, b.v)}; }
  static I equal(I a, I b) { return {_mm256_cmpeq_epi32(a.v, b.v)}; }
  static I and_not(I mask, I a) { return {_mm256_andnot_si256(mask.v, a.v)}; }
  template <int kBits>
  static I shift_left(I a) {
    return {_mm256_slli_epi32(a.v, kBits)};
  }
  template <int kBits>
  static I shift_right(I a) {
    return {_mm256_srai_epi32(a.v, kBits)};
  }

  static F to_float(I a) { return {_mm256_cvtepi32_ps(a.v)}; }
  static I truncate(F a) { return {_mm256_cvttps_epi32(a.v)}; }
  static I round(F a) { return {_mm256_cvtps_epi32(a.v)}; }
  static I bits(F a) { return {_mm256_castps_si256(a.v)}; }

  static I sign_mask(I a) { return a; }
  static F select(I mask, F yes, F no) { return {_mm256_blendv_ps(no.v, yes.v, _mm256_castsi256_ps(mask.v))}; }
  static I select(I mask, I yes, I no) {
    return {_mm256_castps_si256(
        _mm256_blendv_ps(_mm256_castsi256_ps(no.v), _mm256_castsi256_ps(yes.v), _mm256_castsi256_ps(mask.v)))};
  }
  static uint32_t signs(I a) { return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(a.v))); }

  static I pair(I low, I high) { return {_mm256_blend_epi16(low.v, _mm256_slli_epi32(high.v, 16), 0xAA)}; }
  static I dot(I a, I b) { return {_mm256_madd_epi16(a.v, b.v)}; }

  static F load_2x4(const float* p, size_t stride) {
    return {_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(p + stride), 1)};
  }
  static I load_2x4(const uint32_t* p, size_t stride) {
    const auto* upper = reinterpret_cast<const __m128i*>(p);
    const auto* lower = reinterpret_cast<const __m128i*>(p + stride);
    return {_mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(upper)), _mm_loadu_si128(lower), 1)};
  }
  static void store_2x4(float* p, size_t stride, F a) {
    _mm_storeu_ps(p, _mm256_castps256_ps128(a.v));
    _mm_storeu_ps(p + stride, _mm256_extractf128_ps(a.v, 1));
  }
  static void store_2x4(uint32_t* p, size_t stride, I a) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p), _mm256_castsi256_si128(a.v));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p + stride), _mm256_extracti128_si256(a.v, 1));
  }

  static H halves(uint32_t pair_of_equals) { return {_mm_set1_epi32(static_cast<int>(pair_of_equals))}; }
  static H load_halves(const int16_t* p) { return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))}; }
  static H min(H a, H b) { return {_mm_min_epi16(a.v, b.v)}; }
  static H max(H a, H b) { return {_mm_max_epi16(a.v, b.v)}; }
  template <int kBits>
  static H shift_left(H a) {
    return {_mm_slli_epi16(a.v, kBits)};
  }
  template <int kBits>
  static H shift_right(H a) {
    return {_mm_srli_epi16(a.v, kBits)};
  }
  static I pixels(H red, H green, H blue) {
    const __m128i low = _mm_or_si128(blue.v, _mm_slli_epi16(green.v, 8));
    return {_mm256_inserti128_si256(_mm256_castsi128_si256(_mm_unpacklo_epi16(low, red.v)),
                                    _mm_unpackhi_epi16(low, red.v), 1)};
  }

  // In each half: the 4x4 transpose of four rows.
  static void transpose(__m256 r0, __m256 r1, __m256 r2, __m256 r3, F& a, F& b, F& c, F& d) {
    const __m256 t0 = _mm256_unpacklo_ps(r0, r1);
    const __m256 t1 = _mm256_unpackhi_ps(r0, r1);
    const __m256 t2 = _mm256_unpacklo_ps(r2, r3);
    const __m256 t3 = _mm256_unpackhi_ps(r2, r3);
    a = {_mm256_shuffle_ps(t0, t2, 0x44)};
    b = {_mm256_shuffle_ps(t0, t2, 0xEE)};
    c = {_mm256_shuffle_ps(t1, t3, 0x44)};
    d = {_mm256_shuffle_ps(t1, t3, 0xEE)};
  }
  static __m256 two_quads(const float* low, const float* high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
  }
  static void gather_quads(const float* base, const uint32_t* number, size_t stride, F& a, F& b, F& c, F& d) {
    const auto row = [=](size_t i) {
      return two_quads(base + size_t{number[i]} * stride, base + size_t{number[i + 4]} * stride);
    };
    transpose(row(0), row(1), row(2), row(3), a, b, c, d);
  }
  static void gather_pairs(const float* base, const uint32_t* number, size_t stride, F& a, F& b) {
    const auto two = [=](size_t i, size_t j) {
      const __m128d low = _mm_load_sd(reinterpret_cast<const double*>(base + size_t{number[i]} * stride));
      return _mm_castpd_ps(_mm_loadh_pd(low, reinterpret_cast<const double*>(base + size_t{number[j]} * stride)));
    };
    const __m256 r0 = _mm256_insertf128_ps(_mm256_castps128_ps256(two(0, 1)), two(4, 5), 1);
    const __m256 r1 = _mm256_insertf128_ps(_mm256_castps128_ps256(two(2, 3)), two(6, 7), 1);
    a = {_mm256_shuffle_ps(r0, r1, 0x88)};
    b = {_mm256_shuffle_ps(r0, r1, 0xDD)};
  }
  static void scatter_octets(float* out, F a, F b, F c, F d, F e, F f, F g, F h) {
    F r0, r1, r2, r3, s0, s1, s2, s3;
    transpose(a.v, b.v, c.v, d.v, r0, r1, r2, r3);
    transpose(e.v, f.v, g.v, h.v, s0, s1, s2, s3);
    const F left[4] = {r0, r1, r2, r3};
    const F right[4] = {s0, s1, s2, s3};
    for (size_t i = 0; i < 4; ++i) {
      _mm256_storeu_ps(out + 8 * i, _mm256_permute2f128_ps(left[i].v, right[i].v, 0x20));
      _mm256_storeu_ps(out + 8 * (i + 4), _mm256_permute2f128_ps(left[i].v, right[i].v, 0x31));
    }
  }
  static void load_triples(const float* p, F& a, F& b, F& c) {
    // Lanes 0-3 and 4-7 are twelve floats each: x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3.
    const __m256 r0 = two_quads(p, p + 12);
    const __m256 r1 = two_quads(p + 4, p + 16);
    const __m256 r2 = two_quads(p + 8, p + 20);
    const __m256 x2y2x3y3 = _mm256_shuffle_ps(r1, r2, 0x9E);  // x2 y2 x3 y3
    const __m256 y0z0y1z1 = _mm256_shuffle_ps(r0, r1, 0x49);  // y0 z0 y1 z1
    a = {_mm256_shuffle_ps(r0, x2y2x3y3, 0x8C)};              // x0 x1 x2 x3
    b = {_mm256_shuffle_ps(y0z0y1z1, x2y2x3y3, 0xD8)};        // y0 y1 y2 y3
    c = {_mm256_shuffle_ps(y0z0y1z1, r2, 0xCD)};              // z0 z1 z2 z3
  }
};

}  // namespace auslan::raster
