// SPDX-License-Identifier: Apache-2.0
// Eight lanes in AVX2 registers. The contract of every lane type is in lanes_scalar.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <immintrin.h>

namespace auslan::raster {

struct Avx2 {
  static constexpr int kRowsAtOnce = 2;
  static constexpr size_t kLanes = 8;
  static constexpr size_t kAveragedSamples = 0;
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
  static F set(float x) { return {_mm256_set1_ps(x)}; }
  static I set(int32_t x) { return {_mm256_set1_epi32(x)}; }
  // As floats: a load that broadcasts, where an integer would go through a general register.
  static F spread(const float* p) { return {_mm256_broadcast_ss(p)}; }
  static I spread(const int32_t* p) {
    return {_mm256_castps_si256(_mm256_broadcast_ss(reinterpret_cast<const float*>(p)))};
  }
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
  static F from_bits(I a) { return {_mm256_castsi256_ps(a.v)}; }

  static I sign_mask(I a) { return a; }
  // In assembler because g++ 12 computes the sign mask anew before each _mm256_blendv_ps.
  static F select(I mask, F yes, F no) {
    __m256 r;
    asm("vblendvps %3, %2, %1, %0" : "=x"(r) : "x"(no.v), "xm"(yes.v), "x"(mask.v));
    return {r};
  }
  static I select(I mask, I yes, I no) {
    __m256i r;
    asm("vblendvps %3, %2, %1, %0" : "=x"(r) : "x"(no.v), "xm"(yes.v), "x"(mask.v));
    return {r};
  }
  static uint32_t signs(I a) { return static_cast<uint32_t>(_mm256_movemask_ps(_mm256_castsi256_ps(a.v))); }

  static I pair(I low, I high) { return {_mm256_blend_epi16(low.v, _mm256_slli_epi32(high.v, 16), 0xAA)}; }
  static I dot(I a, I b) { return {_mm256_madd_epi16(a.v, b.v)}; }
  static I min16(I a, I b) { return {_mm256_min_epi16(a.v, b.v)}; }
  static I max16(I a, I b) { return {_mm256_max_epi16(a.v, b.v)}; }
  static I add16(I a, I b) { return {_mm256_add_epi16(a.v, b.v)}; }
  static I multiply16(I a, I b) { return {_mm256_mullo_epi16(a.v, b.v)}; }
  static I low_halves(I a) { return {_mm256_shufflehi_epi16(_mm256_shufflelo_epi16(a.v, 0xA0), 0xA0)}; }
  static I high_halves(I a) { return {_mm256_shufflehi_epi16(_mm256_shufflelo_epi16(a.v, 0xF5), 0xF5)}; }
  template <int kBits>
  static I shift_right16(I a) {
    return {_mm256_srli_epi16(a.v, kBits)};
  }
  static I subtract16(I a, I b) { return {_mm256_sub_epi16(a.v, b.v)}; }

  static I keep_greater(I outside, F z, F& stored) {
    const I visible = and_not(outside, greater(z, stored));
    stored = select(visible, z, stored);
    return visible;
  }

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

  template <size_t kSamples>
  static F repeat(const float* p) {
    if constexpr (kSamples == 2)
      return {_mm256_castpd_ps(_mm256_broadcast_sd(reinterpret_cast<const double*>(p)))};
    else if constexpr (kSamples == 4)
      return {_mm256_broadcast_ps(reinterpret_cast<const __m128*>(p))};
    else
      return load(p);
  }
  template <size_t kSamples>
  static I repeat(const int32_t* p) {
    return bits(repeat<kSamples>(reinterpret_cast<const float*>(p)));  // bits that pass through
  }
  template <size_t kSamples>
  static void expand(I a, I (&out)[kSamples]) {
    for (size_t v = 0; v < kSamples; ++v) {
      const auto from = [v](size_t lane) { return static_cast<int>((v * 8 + lane) / kSamples); };
      const __m256i order = _mm256_setr_epi32(from(0), from(1), from(2), from(3), from(4), from(5), from(6), from(7));
      out[v] = {_mm256_permutevar8x32_epi32(a.v, order)};
    }
  }
  template <size_t kSamples>
  static void split(const uint32_t* p, I (&out)[kSamples]) {
    if constexpr (kSamples == 2) {
      const __m256 r0 = from_bits(load(p)).v;
      const __m256 r1 = from_bits(load(p + 8)).v;
      const auto in_order = [](__m256 halves) { return _mm256_permute4x64_epi64(_mm256_castps_si256(halves), 0xD8); };
      out[0] = {in_order(_mm256_shuffle_ps(r0, r1, 0x88))};
      out[1] = {in_order(_mm256_shuffle_ps(r0, r1, 0xDD))};
    } else if constexpr (kSamples == 4) {
      const auto two = [p](size_t i) { return load_2x4(reinterpret_cast<const float*>(p) + 4 * i, 16).v; };
      F f[4];
      transpose(two(0), two(1), two(2), two(3), f[0], f[1], f[2], f[3]);
      for (size_t s = 0; s < 4; ++s)
        out[s] = bits(f[s]);
    } else {
      static constexpr uint32_t kNumbers[8] = {0, 8, 16, 24, 32, 40, 48, 56};
      const __m256i numbers = load(kNumbers).v;
      for (size_t s = 0; s < kSamples; ++s)
        out[s] = {_mm256_i32gather_epi32(reinterpret_cast<const int*>(p + s), numbers, 4)};
    }
  }
  template <size_t kSamples>
  static bool alike(const uint32_t* p, I& pixels) {
    I samples[kSamples];
    split<kSamples>(p, samples);
    I differ = samples[1] ^ samples[0];
    for (size_t s = 2; s < kSamples; ++s)
      differ = differ | (samples[s] ^ samples[0]);
    pixels = samples[0];
    return signs(equal(differ, set(0))) == 0xFFU;
  }
  static I pack_colours(I colours) { return {_mm256_packus_epi16(colours.v, colours.v)}; }
  template <size_t kSamples, size_t kVector>
  static I words_of_samples(I packed) {
    // Pixels 0 and 1 are in the low half, 2 and 3 in the high one.
    const auto from = [](size_t lane) {
      const size_t pixel = (kVector * kLanes + lane) / kSamples;
      return static_cast<int>(pixel % 2 + pixel / 2 * 4);
    };
    const __m256i order = _mm256_setr_epi32(from(0), from(1), from(2), from(3), from(4), from(5), from(6), from(7));
    return {_mm256_permutevar8x32_epi32(packed.v, order)};
  }
  // With what fill_samples.h needs to find a row's pixels.
  struct Crossings {
    __m128 v;
  };
  static Crossings load_crossings(const float* p) { return {_mm_loadu_ps(p)}; }
  static Crossings sum(Crossings a, Crossings b) { return {_mm_add_ps(a.v, b.v)}; }
  static Crossings least_crossings(int32_t width) {
    return {_mm_setr_ps(-1.0F, static_cast<float>(1 - width), 0.0F, 0.0F)};
  }
  static void pixels_between(Crossings a, Crossings least, int32_t& first, int32_t& minus_last) {
    const __m128 greater = _mm_max_ps(_mm_max_ps(a.v, _mm_movehl_ps(a.v, a.v)), least.v);
    const __m128 held = _mm_min_ps(greater, _mm_setr_ps(64.0F, 1.0F, 0.0F, 0.0F));
    const int64_t both = _mm_cvtsi128_si64(_mm_cvttps_epi32(_mm_add_ps(held, _mm_setr_ps(1.0F, 0.0F, 0.0F, 0.0F))));
    first = static_cast<int32_t>(both);
    minus_last = static_cast<int32_t>(both >> 32);
  }
  template <size_t>
  static Avx2 sample_lanes();

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
  // Keeps g++ from taking numbers that were just stored out of their register one by one, which costs more than loads.
  static void from_memory(const uint32_t*& number) {
    asm("" : "+r"(number) : "m"(*reinterpret_cast<const uint32_t(*)[8]>(number)));
  }
  static void gather_quads(const float* base, const uint32_t* number, size_t stride, F& a, F& b, F& c, F& d) {
    from_memory(number);
    const auto row = [=](size_t i) {
      return two_quads(base + size_t{number[i]} * stride, base + size_t{number[i + 4]} * stride);
    };
    transpose(row(0), row(1), row(2), row(3), a, b, c, d);
  }
  static void gather_quads(const uint32_t* base, const uint32_t* number, I& a, I& b, I& c, I& d) {
    F f[4];
    gather_quads(reinterpret_cast<const float*>(base), number, 4, f[0], f[1], f[2], f[3]);  // bits that pass through
    a = bits(f[0]);
    b = bits(f[1]);
    c = bits(f[2]);
    d = bits(f[3]);
  }
  static void gather_pairs(const float* base, const uint32_t* number, size_t stride, F& a, F& b) {
    from_memory(number);
    const auto two = [=](size_t i, size_t j) {
      const __m128d low = _mm_load_sd(reinterpret_cast<const double*>(base + size_t{number[i]} * stride));
      return _mm_castpd_ps(_mm_loadh_pd(low, reinterpret_cast<const double*>(base + size_t{number[j]} * stride)));
    };
    const __m256 r0 = _mm256_insertf128_ps(_mm256_castps128_ps256(two(0, 1)), two(4, 5), 1);
    const __m256 r1 = _mm256_insertf128_ps(_mm256_castps128_ps256(two(2, 3)), two(6, 7), 1);
    a = {_mm256_shuffle_ps(r0, r1, 0x88)};
    b = {_mm256_shuffle_ps(r0, r1, 0xDD)};
  }
  static void scatter_pairs(float* out, F a, F b) {
    const __m256 low = _mm256_unpacklo_ps(a.v, b.v);   // pairs 0 1 | 4 5
    const __m256 high = _mm256_unpackhi_ps(a.v, b.v);  // pairs 2 3 | 6 7
    _mm256_storeu_ps(out, _mm256_permute2f128_ps(low, high, 0x20));
    _mm256_storeu_ps(out + 8, _mm256_permute2f128_ps(low, high, 0x31));
  }
  static void scatter_quads(float* out, F a, F b, F c, F d) {
    F r0, r1, r2, r3;
    transpose(a.v, b.v, c.v, d.v, r0, r1, r2, r3);
    _mm256_storeu_ps(out, _mm256_permute2f128_ps(r0.v, r1.v, 0x20));
    _mm256_storeu_ps(out + 8, _mm256_permute2f128_ps(r2.v, r3.v, 0x20));
    _mm256_storeu_ps(out + 16, _mm256_permute2f128_ps(r0.v, r1.v, 0x31));
    _mm256_storeu_ps(out + 24, _mm256_permute2f128_ps(r2.v, r3.v, 0x31));
  }
  static void store_kept(uint32_t* out, uint32_t kept, I a, I b, I c, I d) {
    const __m256i order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(kKept.order[kept])));
    const auto keep = [order](I words) { return F{_mm256_permutevar8x32_ps(from_bits(words).v, order)}; };
    scatter_quads(reinterpret_cast<float*>(out), keep(a), keep(b), keep(c), keep(d));
  }
  static void load_triples(const uint32_t* p, I& a, I& b, I& c) {
    const auto two = [p](size_t i) {
      const auto* low = reinterpret_cast<const __m128i*>(p + i);
      const auto* high = reinterpret_cast<const __m128i*>(p + i + 12);
      return _mm256_castsi256_ps(
          _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(low)), _mm_loadu_si128(high), 1));
    };
    F x, y, z;
    split_triples(two(0), two(4), two(8), x, y, z);
    a = bits(x);
    b = bits(y);
    c = bits(z);
  }
  static void load_triples(const float* p, F& a, F& b, F& c) {
    split_triples(two_quads(p, p + 12), two_quads(p + 4, p + 16), two_quads(p + 8, p + 20), a, b, c);
  }
  static void split_triples(__m256 r0, __m256 r1, __m256 r2, F& a, F& b, F& c) {
    // Lanes 0-3 and 4-7 are twelve floats each: x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3.
    const __m256 x2y2x3y3 = _mm256_shuffle_ps(r1, r2, 0x9E);  // x2 y2 x3 y3
    const __m256 y0z0y1z1 = _mm256_shuffle_ps(r0, r1, 0x49);  // y0 z0 y1 z1
    a = {_mm256_shuffle_ps(r0, x2y2x3y3, 0x8C)};              // x0 x1 x2 x3
    b = {_mm256_shuffle_ps(y0z0y1z1, x2y2x3y3, 0xD8)};        // y0 y1 y2 y3
    c = {_mm256_shuffle_ps(y0z0y1z1, r2, 0xCD)};              // z0 z1 z2 z3
  }

  // For each set of lanes the numbers of those in it, then zeros.
  struct Kept {
    uint8_t order[256][8] = {};
    constexpr Kept() {
      for (uint32_t set = 0; set < 256; ++set) {
        size_t count = 0;
        for (uint32_t lane = 0; lane < 8; ++lane) {
          if ((set >> lane & 1U) != 0U) order[set][count++] = static_cast<uint8_t>(lane);
        }
      }
    }
  };
  static const Kept kKept;
};

inline constexpr Avx2::Kept Avx2::kKept{};

}  // namespace auslan::raster
