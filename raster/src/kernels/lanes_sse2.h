// SPDX-License-Identifier: Apache-2.0
// Eight lanes in pairs of SSE2 registers, the baseline of x86-64. The contract is in lanes_scalar.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <emmintrin.h>

namespace auslan::raster {

/// Four lanes in one register: what fill_samples.h needs for up to four samples, so that a pixel at a time is in hand.
struct Sse2Quad {
  static constexpr int kRowsAtOnce = 1;
  static constexpr size_t kLanes = 4;
  struct F {
    __m128 v;
    friend F operator+(F a, F b) { return {_mm_add_ps(a.v, b.v)}; }
    friend F operator-(F a, F b) { return {_mm_sub_ps(a.v, b.v)}; }
    friend F operator*(F a, F b) { return {_mm_mul_ps(a.v, b.v)}; }
    friend F operator/(F a, F b) { return {_mm_div_ps(a.v, b.v)}; }
  };
  struct I {
    __m128i v;
    friend I operator+(I a, I b) { return {_mm_add_epi32(a.v, b.v)}; }
    friend I operator-(I a, I b) { return {_mm_sub_epi32(a.v, b.v)}; }
    friend I operator&(I a, I b) { return {_mm_and_si128(a.v, b.v)}; }
    friend I operator|(I a, I b) { return {_mm_or_si128(a.v, b.v)}; }
  };
  static F set(float x) { return {_mm_set1_ps(x)}; }
  static I set(int32_t x) { return {_mm_set1_epi32(x)}; }
  static F spread(const float* p) { return {_mm_set1_ps(*p)}; }
  static I spread(const int32_t* p) { return {_mm_shuffle_epi32(_mm_loadu_si32(p), 0)}; }
  static F load(const float* p) { return {_mm_loadu_ps(p)}; }
  static I load(const uint32_t* p) { return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))}; }
  static void store(float* p, F a) { _mm_storeu_ps(p, a.v); }
  static void store(uint32_t* p, I a) { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), a.v); }
  static void store(int32_t* p, I a) { _mm_storeu_si128(reinterpret_cast<__m128i*>(p), a.v); }
  static I select(I mask, I yes, I no) {
    return {_mm_xor_si128(_mm_and_si128(_mm_xor_si128(yes.v, no.v), mask.v), no.v)};
  }
  static F select(I mask, F yes, F no) {
    return {_mm_castsi128_ps(select(mask, I{_mm_castps_si128(yes.v)}, I{_mm_castps_si128(no.v)}).v)};
  }
  static F min(F a, F b) { return {_mm_min_ps(a.v, b.v)}; }
  static F max(F a, F b) { return {_mm_max_ps(a.v, b.v)}; }
  static I greater(F a, F b) { return {_mm_castps_si128(_mm_cmpgt_ps(a.v, b.v))}; }
  static F to_float(I a) { return {_mm_cvtepi32_ps(a.v)}; }
  static I truncate(F a) { return {_mm_cvttps_epi32(a.v)}; }
  template <int kBits>
  static I shift_right(I a) {
    return {_mm_srai_epi32(a.v, kBits)};
  }
  static I dot(I a, I b) { return {_mm_madd_epi16(a.v, b.v)}; }
  static I min16(I a, I b) { return {_mm_min_epi16(a.v, b.v)}; }
  static I max16(I a, I b) { return {_mm_max_epi16(a.v, b.v)}; }
  static I add16(I a, I b) { return {_mm_add_epi16(a.v, b.v)}; }
  static I multiply16(I a, I b) { return {_mm_mullo_epi16(a.v, b.v)}; }
  static I low_halves(I a) { return {_mm_shufflehi_epi16(_mm_shufflelo_epi16(a.v, 0xA0), 0xA0)}; }
  static I high_halves(I a) { return {_mm_shufflehi_epi16(_mm_shufflelo_epi16(a.v, 0xF5), 0xF5)}; }
  template <int kBits>
  static I shift_left(I a) {
    return {_mm_slli_epi32(a.v, kBits)};
  }
  template <int kBits>
  static I shift_right16(I a) {
    return {_mm_srli_epi16(a.v, kBits)};
  }
  static I keep_greater(I outside, F z, F& stored) {
    const __m128 inside = _mm_andnot_ps(_mm_castsi128_ps(_mm_srai_epi32(outside.v, 31)), z.v);
    const __m128 visible = _mm_cmpgt_ps(inside, stored.v);
    stored = {_mm_max_ps(inside, stored.v)};
    return {_mm_castps_si128(visible)};
  }
  template <size_t kSamples>
  static F repeat(const float* p) {
    if constexpr (kSamples == 2) {
      const __m128 two = _mm_castpd_ps(_mm_load_sd(reinterpret_cast<const double*>(p)));
      return {_mm_movelh_ps(two, two)};
    } else {
      return load(p);
    }
  }
  template <size_t kSamples>
  static I repeat(const int32_t* p) {
    return {_mm_castps_si128(repeat<kSamples>(reinterpret_cast<const float*>(p)).v)};  // bits that pass through
  }
  static I pack_colours(I colours) { return {_mm_packus_epi16(colours.v, colours.v)}; }
  template <size_t kSamples>
  static Sse2Quad sample_lanes();
  template <size_t kSamples, size_t kVector>
  static I words_of_samples(I packed) {
    return {_mm_shuffle_epi32(packed.v, kSamples == 2 ? 0x50 : kVector * 0x55)};
  }
};

struct Sse2 {
  static constexpr int kRowsAtOnce = 1;
  static constexpr size_t kLanes = 8;
  static constexpr size_t kAveragedSamples = 4;
  struct F {
    __m128 l, h;
    friend F operator+(F a, F b) { return {_mm_add_ps(a.l, b.l), _mm_add_ps(a.h, b.h)}; }
    friend F operator-(F a, F b) { return {_mm_sub_ps(a.l, b.l), _mm_sub_ps(a.h, b.h)}; }
    friend F operator*(F a, F b) { return {_mm_mul_ps(a.l, b.l), _mm_mul_ps(a.h, b.h)}; }
    friend F operator/(F a, F b) { return {_mm_div_ps(a.l, b.l), _mm_div_ps(a.h, b.h)}; }
  };
  struct I {
    __m128i l, h;
    friend I operator+(I a, I b) { return {_mm_add_epi32(a.l, b.l), _mm_add_epi32(a.h, b.h)}; }
    friend I operator-(I a, I b) { return {_mm_sub_epi32(a.l, b.l), _mm_sub_epi32(a.h, b.h)}; }
    friend I operator&(I a, I b) { return {_mm_and_si128(a.l, b.l), _mm_and_si128(a.h, b.h)}; }
    friend I operator|(I a, I b) { return {_mm_or_si128(a.l, b.l), _mm_or_si128(a.h, b.h)}; }
    friend I operator^(I a, I b) { return {_mm_xor_si128(a.l, b.l), _mm_xor_si128(a.h, b.h)}; }
  };
  static F set(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
  static I set(int32_t x) { return {_mm_set1_epi32(x), _mm_set1_epi32(x)}; }
  static F spread(const float* p) { return set(*p); }
  static I spread(const int32_t* p) {
    const __m128i one = _mm_shuffle_epi32(_mm_loadu_si32(p), 0);
    return {one, one};
  }
  static F load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
  static I load(const int32_t* p) { return {load4(p), load4(p + 4)}; }
  static I load(const uint32_t* p) { return {load4(p), load4(p + 4)}; }
  static void store(float* p, F a) { store_2x4(p, 4, a); }
  static void store(int32_t* p, I a) {
    store4(p, a.l);
    store4(p + 4, a.h);
  }
  static void store(uint32_t* p, I a) { store_2x4(p, 4, a); }

  static F min(F a, F b) { return {_mm_min_ps(a.l, b.l), _mm_min_ps(a.h, b.h)}; }
  static F max(F a, F b) { return {_mm_max_ps(a.l, b.l), _mm_max_ps(a.h, b.h)}; }
  static I min(I a, I b) { return choose(greater(a, b), b, a); }
  static I max(I a, I b) { return choose(greater(a, b), a, b); }
  static F sqrt(F a) { return {_mm_sqrt_ps(a.l), _mm_sqrt_ps(a.h)}; }
  static I greater(F a, F b) { return bits({_mm_cmpgt_ps(a.l, b.l), _mm_cmpgt_ps(a.h, b.h)}); }
  static I at_least(F a, F b) { return bits({_mm_cmpge_ps(a.l, b.l), _mm_cmpge_ps(a.h, b.h)}); }
  static I greater(I a, I b) { return {_mm_cmpgt_epi32(a.l, b.l), _mm_cmpgt_epi32(a.h, b.h)}; }
  static I equal(I a, I b) { return {_mm_cmpeq_epi32(a.l, b.l), _mm_cmpeq_epi32(a.h, b.h)}; }
  static I and_not(I mask, I a) { return {_mm_andnot_si128(mask.l, a.l), _mm_andnot_si128(mask.h, a.h)}; }
  template <int kBits>
  static I shift_left(I a) {
    return {_mm_slli_epi32(a.l, kBits), _mm_slli_epi32(a.h, kBits)};
  }
  template <int kBits>
  static I shift_right(I a) {
    return {_mm_srai_epi32(a.l, kBits), _mm_srai_epi32(a.h, kBits)};
  }

  static F to_float(I a) { return {_mm_cvtepi32_ps(a.l), _mm_cvtepi32_ps(a.h)}; }
  static I truncate(F a) { return {_mm_cvttps_epi32(a.l), _mm_cvttps_epi32(a.h)}; }
  static I round(F a) { return {_mm_cvtps_epi32(a.l), _mm_cvtps_epi32(a.h)}; }
  static I bits(F a) { return {_mm_castps_si128(a.l), _mm_castps_si128(a.h)}; }
  static F from_bits(I a) { return {_mm_castsi128_ps(a.l), _mm_castsi128_ps(a.h)}; }

  static I sign_mask(I a) { return shift_right<31>(a); }
  // Masks are whole lanes here, so the sign bit need not be spread again.
  static F select(I mask, F yes, F no) {
    const I r = choose(mask, bits(yes), bits(no));
    return {_mm_castsi128_ps(r.l), _mm_castsi128_ps(r.h)};
  }
  static I select(I mask, I yes, I no) { return choose(mask, yes, no); }
  static uint32_t signs(I a) {
    return static_cast<uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(a.l))) |
           (static_cast<uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(a.h))) << 4U);
  }

  static I pair(I low, I high) { return (low & set(int32_t{0xFFFF})) | shift_left<16>(high); }
  static I dot(I a, I b) { return {_mm_madd_epi16(a.l, b.l), _mm_madd_epi16(a.h, b.h)}; }

  static I min16(I a, I b) { return {_mm_min_epi16(a.l, b.l), _mm_min_epi16(a.h, b.h)}; }
  static I max16(I a, I b) { return {_mm_max_epi16(a.l, b.l), _mm_max_epi16(a.h, b.h)}; }
  static I add16(I a, I b) { return {_mm_add_epi16(a.l, b.l), _mm_add_epi16(a.h, b.h)}; }
  static I multiply16(I a, I b) { return {_mm_mullo_epi16(a.l, b.l), _mm_mullo_epi16(a.h, b.h)}; }
  static I low_halves(I a) { return {Sse2Quad::low_halves({a.l}).v, Sse2Quad::low_halves({a.h}).v}; }
  static I high_halves(I a) { return {Sse2Quad::high_halves({a.l}).v, Sse2Quad::high_halves({a.h}).v}; }
  template <int kBits>
  static I shift_right16(I a) {
    return {_mm_srli_epi16(a.l, kBits), _mm_srli_epi16(a.h, kBits)};
  }
  static I subtract16(I a, I b) { return {_mm_sub_epi16(a.l, b.l), _mm_sub_epi16(a.h, b.h)}; }

  static I keep_greater(I outside, F z, F& stored) {
    const I mask = sign_mask(outside);
    const F inside = {_mm_andnot_ps(_mm_castsi128_ps(mask.l), z.l), _mm_andnot_ps(_mm_castsi128_ps(mask.h), z.h)};
    const I visible = greater(inside, stored);
    stored = max(inside, stored);
    return visible;
  }

  template <size_t kSamples>
  static F repeat(const float* p) {
    if constexpr (kSamples == 8) return load(p);
    const __m128 four = Sse2Quad::repeat<kSamples>(p).v;
    return {four, four};
  }
  template <size_t kSamples>
  static I repeat(const int32_t* p) {
    return bits(repeat<kSamples>(reinterpret_cast<const float*>(p)));  // bits that pass through
  }
  template <size_t kSamples>
  static void expand(I a, I (&out)[kSamples]) {
    if constexpr (kSamples == 2) {
      out[0] = {_mm_unpacklo_epi32(a.l, a.l), _mm_unpackhi_epi32(a.l, a.l)};
      out[1] = {_mm_unpacklo_epi32(a.h, a.h), _mm_unpackhi_epi32(a.h, a.h)};
    } else if constexpr (kSamples == 4) {
      out[0] = {_mm_shuffle_epi32(a.l, 0x00), _mm_shuffle_epi32(a.l, 0x55)};
      out[1] = {_mm_shuffle_epi32(a.l, 0xAA), _mm_shuffle_epi32(a.l, 0xFF)};
      out[2] = {_mm_shuffle_epi32(a.h, 0x00), _mm_shuffle_epi32(a.h, 0x55)};
      out[3] = {_mm_shuffle_epi32(a.h, 0xAA), _mm_shuffle_epi32(a.h, 0xFF)};
    } else {
      int32_t lanes[8];
      store(lanes, a);
      for (size_t v = 0; v < kSamples; ++v)
        out[v] = set(lanes[v]);
    }
  }
  template <size_t kSamples>
  static void split(const uint32_t* p, I (&out)[kSamples]) {
    const auto four = [p](size_t i) { return _mm_castsi128_ps(load4(p + i)); };
    if constexpr (kSamples == 2) {
      const auto every_other = [four](size_t i, bool odd) {
        return _mm_castps_si128(odd ? _mm_shuffle_ps(four(i), four(i + 4), 0xDD)
                                    : _mm_shuffle_ps(four(i), four(i + 4), 0x88));
      };
      out[0] = {every_other(0, false), every_other(8, false)};
      out[1] = {every_other(0, true), every_other(8, true)};
    } else {
      for (size_t s = 0; s < kSamples; s += 4) {
        const auto pixel = [four, s](size_t i) { return four(i * kSamples + s); };
        F f[4];
        transpose(pixel(0), pixel(1), pixel(2), pixel(3), f[0].l, f[1].l, f[2].l, f[3].l);
        transpose(pixel(4), pixel(5), pixel(6), pixel(7), f[0].h, f[1].h, f[2].h, f[3].h);
        for (size_t i = 0; i < 4; ++i)
          out[s + i] = bits(f[i]);
      }
    }
  }
  template <size_t kSamples>
  static bool alike(const uint32_t* p, I& pixels) {
    if constexpr (kSamples == 4) return alike_quads(p, pixels);
    I samples[kSamples];
    split<kSamples>(p, samples);
    I differ = samples[1] ^ samples[0];
    for (size_t s = 2; s < kSamples; ++s)
      differ = differ | (samples[s] ^ samples[0]);
    pixels = samples[0];
    return signs(equal(differ, set(0))) == 0xFFU;
  }
  // The root mean square of four samples, as Resolve::average has it, eight pixels.
  static I average(const uint32_t* p) {
    const auto levels = [p](size_t pixel) {
      const __m128i zero = _mm_setzero_si128();
      const __m128i four = load4(p + 4 * pixel);
      // Channel by channel the levels of samples 0 and 2, then those of 1 and 3.
      const __m128i bytes = _mm_unpacklo_epi8(four, _mm_srli_si128(four, 8));
      const __m128i even = _mm_unpacklo_epi8(bytes, zero);
      const __m128i odd = _mm_unpackhi_epi8(bytes, zero);
      const __m128 sum = _mm_cvtepi32_ps(_mm_add_epi32(_mm_madd_epi16(even, even), _mm_madd_epi16(odd, odd)));
      return _mm_cvttps_epi32(_mm_add_ps(_mm_sqrt_ps(_mm_mul_ps(sum, _mm_set1_ps(0.25F))), _mm_set1_ps(0.5F)));
    };
    const auto four_pixels = [levels](size_t first) {
      return _mm_packus_epi16(_mm_packs_epi32(levels(first), levels(first + 1)),
                              _mm_packs_epi32(levels(first + 2), levels(first + 3)));
    };
    return {four_pixels(0), four_pixels(4)};
  }
  static bool alike_quads(const uint32_t* p, I& pixels) {
    __m128i quad[8];
    __m128i same = _mm_set1_epi32(-1);
    for (size_t i = 0; i < 8; ++i) {
      quad[i] = load4(p + 4 * i);
      same = _mm_and_si128(same, _mm_cmpeq_epi32(quad[i], _mm_shuffle_epi32(quad[i], 0)));
    }
    if (_mm_movemask_epi8(same) != 0xFFFF) return false;
    const auto first_of = [&quad](size_t i) {
      return _mm_unpacklo_epi64(_mm_unpacklo_epi32(quad[i], quad[i + 1]), _mm_unpacklo_epi32(quad[i + 2], quad[i + 3]));
    };
    pixels = {first_of(0), first_of(4)};
    return true;
  }
  static I pack_colours(I colours) {
    const __m128i packed = _mm_packus_epi16(colours.l, colours.h);
    return {packed, packed};
  }
  template <size_t kSamples, size_t kVector>
  static I words_of_samples(I packed) {
    static_assert(kSamples == 8);
    const __m128i word = _mm_shuffle_epi32(packed.l, kVector * 0x55);
    return {word, word};
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
  template <size_t kSamples>
  static auto sample_lanes() {
    if constexpr (kSamples <= 4) {
      return Sse2Quad{};
    } else {
      return Sse2{};
    }
  }

  static F load_2x4(const float* p, size_t stride) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + stride)}; }
  static I load_2x4(const uint32_t* p, size_t stride) { return {load4(p), load4(p + stride)}; }
  static void store_2x4(float* p, size_t stride, F a) {
    _mm_storeu_ps(p, a.l);
    _mm_storeu_ps(p + stride, a.h);
  }
  static void store_2x4(uint32_t* p, size_t stride, I a) {
    store4(p, a.l);
    store4(p + stride, a.h);
  }

  // Keeps g++ from taking numbers that were just stored out of their register one by one, which costs more than loads.
  static void from_memory(const uint32_t*& number) {
    asm("" : "+r"(number) : "m"(*reinterpret_cast<const uint32_t(*)[8]>(number)));
  }
  static void gather_quads(const float* base, const uint32_t* number, size_t stride, F& a, F& b, F& c, F& d) {
    from_memory(number);
    const auto row = [=](size_t i) { return _mm_loadu_ps(base + size_t{number[i]} * stride); };
    transpose(row(0), row(1), row(2), row(3), a.l, b.l, c.l, d.l);
    transpose(row(4), row(5), row(6), row(7), a.h, b.h, c.h, d.h);
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
    const auto two = [=](size_t i) {
      const __m128d low = _mm_load_sd(reinterpret_cast<const double*>(base + size_t{number[i]} * stride));
      return _mm_castpd_ps(_mm_loadh_pd(low, reinterpret_cast<const double*>(base + size_t{number[i + 1]} * stride)));
    };
    const __m128 r0 = two(0);
    const __m128 r1 = two(2);
    const __m128 r2 = two(4);
    const __m128 r3 = two(6);
    a = {_mm_shuffle_ps(r0, r1, 0x88), _mm_shuffle_ps(r2, r3, 0x88)};
    b = {_mm_shuffle_ps(r0, r1, 0xDD), _mm_shuffle_ps(r2, r3, 0xDD)};
  }
  static void scatter_pairs(float* out, F a, F b) {
    _mm_storeu_ps(out, _mm_unpacklo_ps(a.l, b.l));
    _mm_storeu_ps(out + 4, _mm_unpackhi_ps(a.l, b.l));
    _mm_storeu_ps(out + 8, _mm_unpacklo_ps(a.h, b.h));
    _mm_storeu_ps(out + 12, _mm_unpackhi_ps(a.h, b.h));
  }
  static void scatter_quads(float* out, F a, F b, F c, F d) {
    __m128 rows[8];
    transpose(a.l, b.l, c.l, d.l, rows[0], rows[1], rows[2], rows[3]);
    transpose(a.h, b.h, c.h, d.h, rows[4], rows[5], rows[6], rows[7]);
    for (size_t i = 0; i < 8; ++i)
      _mm_storeu_ps(out + 4 * i, rows[i]);
  }
  static void store_kept(uint32_t* out, uint32_t kept, I a, I b, I c, I d) {
    const F f[4] = {from_bits(a), from_bits(b), from_bits(c), from_bits(d)};
    __m128 rows[8];
    transpose(f[0].l, f[1].l, f[2].l, f[3].l, rows[0], rows[1], rows[2], rows[3]);
    transpose(f[0].h, f[1].h, f[2].h, f[3].h, rows[4], rows[5], rows[6], rows[7]);
    for (size_t i = 0; i < 8; ++i) {
      store4(out, _mm_castps_si128(rows[i]));
      out += size_t{kept >> i & 1U} * 4;
    }
  }
  static void load_triples(const uint32_t* p, I& a, I& b, I& c) {
    const auto four = [p](size_t i) { return _mm_castsi128_ps(load4(p + i)); };
    F x, y, z;
    split_triples(four(0), four(4), four(8), x.l, y.l, z.l);
    split_triples(four(12), four(16), four(20), x.h, y.h, z.h);
    a = bits(x);
    b = bits(y);
    c = bits(z);
  }
  static void load_triples(const float* p, F& a, F& b, F& c) {
    split_triples(_mm_loadu_ps(p), _mm_loadu_ps(p + 4), _mm_loadu_ps(p + 8), a.l, b.l, c.l);
    split_triples(_mm_loadu_ps(p + 12), _mm_loadu_ps(p + 16), _mm_loadu_ps(p + 20), a.h, b.h, c.h);
  }

 private:
  static __m128i load4(const void* p) { return _mm_loadu_si128(static_cast<const __m128i*>(p)); }
  static void store4(void* p, __m128i a) { _mm_storeu_si128(static_cast<__m128i*>(p), a); }
  static I choose(I mask, I yes, I no) { return ((yes ^ no) & mask) ^ no; }
  static void transpose(__m128 r0, __m128 r1, __m128 r2, __m128 r3, __m128& a, __m128& b, __m128& c, __m128& d) {
    const __m128 t0 = _mm_unpacklo_ps(r0, r1);
    const __m128 t1 = _mm_unpackhi_ps(r0, r1);
    const __m128 t2 = _mm_unpacklo_ps(r2, r3);
    const __m128 t3 = _mm_unpackhi_ps(r2, r3);
    a = _mm_movelh_ps(t0, t2);
    b = _mm_movehl_ps(t2, t0);
    c = _mm_movelh_ps(t1, t3);
    d = _mm_movehl_ps(t3, t1);
  }
  // x0 y0 z0 x1 | y1 z1 x2 y2 | z2 x3 y3 z3
  static void split_triples(__m128 r0, __m128 r1, __m128 r2, __m128& a, __m128& b, __m128& c) {
    const __m128 x2y2x3y3 = _mm_shuffle_ps(r1, r2, 0x9E);
    const __m128 y0z0y1z1 = _mm_shuffle_ps(r0, r1, 0x49);
    a = _mm_shuffle_ps(r0, x2y2x3y3, 0x8C);
    b = _mm_shuffle_ps(y0z0y1z1, x2y2x3y3, 0xD8);
    c = _mm_shuffle_ps(y0z0y1z1, r2, 0xCD);
  }
};

}  // namespace auslan::raster
