// SPDX-License-Identifier: Apache-2.0
// Eight lanes in pairs of NEON registers, the baseline of AArch64. The contract is in lanes_scalar.h.
#pragma once

#include <arm_neon.h>
#include <cstddef>
#include <cstdint>

namespace auslan::raster {

struct Neon {
  static constexpr int kRowsAtOnce = 2;
  static constexpr size_t kLanes = 8;
  static constexpr size_t kAveragedSamples = 0;
  struct F {
    float32x4_t l, h;
    friend F operator+(F a, F b) { return {vaddq_f32(a.l, b.l), vaddq_f32(a.h, b.h)}; }
    friend F operator-(F a, F b) { return {vsubq_f32(a.l, b.l), vsubq_f32(a.h, b.h)}; }
    friend F operator*(F a, F b) { return {vmulq_f32(a.l, b.l), vmulq_f32(a.h, b.h)}; }
    friend F operator/(F a, F b) { return {vdivq_f32(a.l, b.l), vdivq_f32(a.h, b.h)}; }
  };
  struct I {
    int32x4_t l, h;
    friend I operator+(I a, I b) { return {vaddq_s32(a.l, b.l), vaddq_s32(a.h, b.h)}; }
    friend I operator-(I a, I b) { return {vsubq_s32(a.l, b.l), vsubq_s32(a.h, b.h)}; }
    friend I operator&(I a, I b) { return {vandq_s32(a.l, b.l), vandq_s32(a.h, b.h)}; }
    friend I operator|(I a, I b) { return {vorrq_s32(a.l, b.l), vorrq_s32(a.h, b.h)}; }
    friend I operator^(I a, I b) { return {veorq_s32(a.l, b.l), veorq_s32(a.h, b.h)}; }
  };
  static F set(float x) { return {vdupq_n_f32(x), vdupq_n_f32(x)}; }
  static I set(int32_t x) { return {vdupq_n_s32(x), vdupq_n_s32(x)}; }
  static F spread(const float* p) { return {vld1q_dup_f32(p), vld1q_dup_f32(p)}; }
  static I spread(const int32_t* p) { return {vld1q_dup_s32(p), vld1q_dup_s32(p)}; }
  static F load(const float* p) { return load_2x4(p, 4); }
  static I load(const int32_t* p) { return {vld1q_s32(p), vld1q_s32(p + 4)}; }
  static I load(const uint32_t* p) { return load_2x4(p, 4); }
  static void store(float* p, F a) { store_2x4(p, 4, a); }
  static void store(int32_t* p, I a) {
    vst1q_s32(p, a.l);
    vst1q_s32(p + 4, a.h);
  }
  static void store(uint32_t* p, I a) { store_2x4(p, 4, a); }

  // NEON's own minimum of a number and a NaN is NaN; the contract's is the second operand.
  static F min(F a, F b) {
    return {vbslq_f32(vcltq_f32(a.l, b.l), a.l, b.l), vbslq_f32(vcltq_f32(a.h, b.h), a.h, b.h)};
  }
  static F max(F a, F b) {
    return {vbslq_f32(vcgtq_f32(a.l, b.l), a.l, b.l), vbslq_f32(vcgtq_f32(a.h, b.h), a.h, b.h)};
  }
  static I min(I a, I b) { return {vminq_s32(a.l, b.l), vminq_s32(a.h, b.h)}; }
  static I max(I a, I b) { return {vmaxq_s32(a.l, b.l), vmaxq_s32(a.h, b.h)}; }
  static F sqrt(F a) { return {vsqrtq_f32(a.l), vsqrtq_f32(a.h)}; }
  static I greater(F a, F b) { return lanes_of(vcgtq_f32(a.l, b.l), vcgtq_f32(a.h, b.h)); }
  static I at_least(F a, F b) { return lanes_of(vcgeq_f32(a.l, b.l), vcgeq_f32(a.h, b.h)); }
  static I greater(I a, I b) { return lanes_of(vcgtq_s32(a.l, b.l), vcgtq_s32(a.h, b.h)); }
  static I equal(I a, I b) { return lanes_of(vceqq_s32(a.l, b.l), vceqq_s32(a.h, b.h)); }
  static I and_not(I mask, I a) { return {vbicq_s32(a.l, mask.l), vbicq_s32(a.h, mask.h)}; }
  template <int kBits>
  static I shift_left(I a) {
    return {vshlq_n_s32(a.l, kBits), vshlq_n_s32(a.h, kBits)};
  }
  template <int kBits>
  static I shift_right(I a) {
    return {vshrq_n_s32(a.l, kBits), vshrq_n_s32(a.h, kBits)};
  }

  static F to_float(I a) { return {vcvtq_f32_s32(a.l), vcvtq_f32_s32(a.h)}; }
  static I truncate(F a) { return {vcvtq_s32_f32(a.l), vcvtq_s32_f32(a.h)}; }
  static I round(F a) { return {vcvtnq_s32_f32(a.l), vcvtnq_s32_f32(a.h)}; }
  static I bits(F a) { return {vreinterpretq_s32_f32(a.l), vreinterpretq_s32_f32(a.h)}; }
  static F from_bits(I a) { return {vreinterpretq_f32_s32(a.l), vreinterpretq_f32_s32(a.h)}; }

  static I sign_mask(I a) { return shift_right<31>(a); }
  // Masks are whole lanes here, so the sign bit need not be spread again.
  static F select(I mask, F yes, F no) {
    return {vbslq_f32(unsigned_of(mask.l), yes.l, no.l), vbslq_f32(unsigned_of(mask.h), yes.h, no.h)};
  }
  static I select(I mask, I yes, I no) {
    return {vbslq_s32(unsigned_of(mask.l), yes.l, no.l), vbslq_s32(unsigned_of(mask.h), yes.h, no.h)};
  }
  static uint32_t signs(I a) {
    const int32_t places[4] = {0, 1, 2, 3};
    const int32x4_t place = vld1q_s32(places);
    const uint32x4_t low = vshlq_u32(vshrq_n_u32(unsigned_of(a.l), 31), place);
    const uint32x4_t high = vshlq_u32(vshrq_n_u32(unsigned_of(a.h), 31), place);
    return vaddvq_u32(vorrq_u32(low, vshlq_n_u32(high, 4)));
  }

  static I pair(I low, I high) { return {vsliq_n_s32(low.l, high.l, 16), vsliq_n_s32(low.h, high.h, 16)}; }
  static I dot(I a, I b) { return {dot4(a.l, b.l), dot4(a.h, b.h)}; }

  static I min16(I a, I b) { return {halves_min(a.l, b.l), halves_min(a.h, b.h)}; }
  static I max16(I a, I b) { return {halves_max(a.l, b.l), halves_max(a.h, b.h)}; }
  static I add16(I a, I b) { return {halves_add(a.l, b.l), halves_add(a.h, b.h)}; }
  static I low_halves(I a) {
    const auto both = [](int32x4_t x) {
      const int16x8_t halves = vreinterpretq_s16_s32(x);
      return vreinterpretq_s32_s16(vtrn1q_s16(halves, halves));
    };
    return {both(a.l), both(a.h)};
  }
  static I high_halves(I a) {
    const auto both = [](int32x4_t x) {
      const int16x8_t halves = vreinterpretq_s16_s32(x);
      return vreinterpretq_s32_s16(vtrn2q_s16(halves, halves));
    };
    return {both(a.l), both(a.h)};
  }
  static I multiply16(I a, I b) { return {halves_multiply(a.l, b.l), halves_multiply(a.h, b.h)}; }
  template <int kBits>
  static I shift_right16(I a) {
    return {halves_down<kBits>(a.l), halves_down<kBits>(a.h)};
  }
  static I subtract16(I a, I b) { return {halves_subtract(a.l, b.l), halves_subtract(a.h, b.h)}; }

  static I keep_greater(I outside, F z, F& stored) {
    const I visible = and_not(sign_mask(outside), greater(z, stored));
    stored = select(visible, z, stored);
    return visible;
  }

  template <size_t kSamples>
  static F repeat(const float* p) {
    if constexpr (kSamples == 2) {
      const float32x2_t two = vld1_f32(p);
      return {vcombine_f32(two, two), vcombine_f32(two, two)};
    } else {
      return load_2x4(p, kSamples == 4 ? 0 : 4);
    }
  }
  template <size_t kSamples>
  static I repeat(const int32_t* p) {
    return bits(repeat<kSamples>(reinterpret_cast<const float*>(p)));  // bits that pass through
  }
  template <size_t kSamples>
  static void expand(I a, I (&out)[kSamples]) {
    uint32_t lanes[8];
    store(lanes, a);
    for (size_t v = 0; v < kSamples; ++v) {
      const auto four = [&lanes](size_t first) {
        if constexpr (kSamples == 2) {
          const int32x4_t pair =
              vreinterpretq_s32_u64(vcombine_u64(vreinterpret_u64_u32(vdup_n_u32(lanes[first / 2])),
                                                 vreinterpret_u64_u32(vdup_n_u32(lanes[first / 2 + 1]))));
          return pair;
        } else {
          return vreinterpretq_s32_u32(vdupq_n_u32(lanes[first / kSamples]));
        }
      };
      out[v] = {four(8 * v), four(8 * v + 4)};
    }
  }
  template <size_t kSamples>
  static void split(const uint32_t* p, I (&out)[kSamples]) {
    if constexpr (kSamples == 2) {
      const uint32x4x2_t low = vld2q_u32(p);
      const uint32x4x2_t high = vld2q_u32(p + 8);
      for (size_t s = 0; s < 2; ++s)
        out[s] = lanes_of(low.val[s], high.val[s]);
    } else if constexpr (kSamples == 4) {
      const uint32x4x4_t low = vld4q_u32(p);
      const uint32x4x4_t high = vld4q_u32(p + 16);
      for (size_t s = 0; s < 4; ++s)
        out[s] = lanes_of(low.val[s], high.val[s]);
    } else {
      for (size_t s = 0; s < kSamples; ++s) {
        uint32_t lanes[8];
        for (size_t i = 0; i < 8; ++i)
          lanes[i] = p[i * kSamples + s];
        out[s] = load(lanes);
      }
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
  static I pack_colours(I colours) {
    const auto words = [](int32x4_t pixels) { return vreinterpret_s32_u8(vqmovun_s16(vreinterpretq_s16_s32(pixels))); };
    const int32x4_t packed = vcombine_s32(words(colours.l), words(colours.h));
    return {packed, packed};
  }
  template <size_t kSamples, size_t kVector>
  static I words_of_samples(I packed) {
    if constexpr (kSamples == 2) {
      return {vzip1q_s32(packed.l, packed.l), vzip2q_s32(packed.l, packed.l)};
    } else if constexpr (kSamples == 4) {
      return {vdupq_laneq_s32(packed.l, 2 * kVector), vdupq_laneq_s32(packed.l, 2 * kVector + 1)};
    } else {
      const int32x4_t word = vdupq_laneq_s32(packed.l, kVector);
      return {word, word};
    }
  }
  // With what fill_samples.h needs to find a row's pixels.
  struct Crossings {
    float32x4_t v;
  };
  static Crossings load_crossings(const float* p) { return {vld1q_f32(p)}; }
  static Crossings sum(Crossings a, Crossings b) { return {vaddq_f32(a.v, b.v)}; }
  static Crossings least_crossings(int32_t width) {
    return {vsetq_lane_f32(static_cast<float>(1 - width), vdupq_n_f32(-1.0F), 1)};
  }
  static void pixels_between(Crossings a, Crossings least, int32_t& first, int32_t& minus_last) {
    const float32x2_t greatest = vset_lane_f32(1.0F, vdup_n_f32(64.0F), 1);
    const float32x2_t held =
        vmin_f32(vmax_f32(vmax_f32(vget_low_f32(a.v), vget_high_f32(a.v)), vget_low_f32(least.v)), greatest);
    first = static_cast<int32_t>(vget_lane_f32(held, 0) + 1.0F);
    minus_last = static_cast<int32_t>(vget_lane_f32(held, 1));
  }
  template <size_t>
  static Neon sample_lanes();

  static F load_2x4(const float* p, size_t stride) { return {vld1q_f32(p), vld1q_f32(p + stride)}; }
  static I load_2x4(const uint32_t* p, size_t stride) { return lanes_of(vld1q_u32(p), vld1q_u32(p + stride)); }
  static void store_2x4(float* p, size_t stride, F a) {
    vst1q_f32(p, a.l);
    vst1q_f32(p + stride, a.h);
  }
  static void store_2x4(uint32_t* p, size_t stride, I a) {
    vst1q_u32(p, unsigned_of(a.l));
    vst1q_u32(p + stride, unsigned_of(a.h));
  }

  static void gather_quads(const float* base, const uint32_t* number, size_t stride, F& a, F& b, F& c, F& d) {
    const auto row = [=](size_t i) { return vld1q_f32(base + size_t{number[i]} * stride); };
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
    const auto two = [=](size_t i) {
      return vcombine_f32(vld1_f32(base + size_t{number[i]} * stride), vld1_f32(base + size_t{number[i + 1]} * stride));
    };
    const float32x4_t r0 = two(0);
    const float32x4_t r1 = two(2);
    const float32x4_t r2 = two(4);
    const float32x4_t r3 = two(6);
    a = {vuzp1q_f32(r0, r1), vuzp1q_f32(r2, r3)};
    b = {vuzp2q_f32(r0, r1), vuzp2q_f32(r2, r3)};
  }
  static void scatter_pairs(float* out, F a, F b) {
    vst2q_f32(out, float32x4x2_t{{a.l, b.l}});
    vst2q_f32(out + 8, float32x4x2_t{{a.h, b.h}});
  }
  static void scatter_quads(float* out, F a, F b, F c, F d) {
    vst4q_f32(out, float32x4x4_t{{a.l, b.l, c.l, d.l}});
    vst4q_f32(out + 16, float32x4x4_t{{a.h, b.h, c.h, d.h}});
  }
  static void store_kept(uint32_t* out, uint32_t kept, I a, I b, I c, I d) {
    uint32_t rows[32];
    vst4q_s32(reinterpret_cast<int32_t*>(rows), int32x4x4_t{{a.l, b.l, c.l, d.l}});
    vst4q_s32(reinterpret_cast<int32_t*>(rows + 16), int32x4x4_t{{a.h, b.h, c.h, d.h}});
    for (size_t i = 0; i < 8; ++i) {
      vst1q_u32(out, vld1q_u32(rows + 4 * i));
      out += size_t{kept >> i & 1U} * 4;
    }
  }
  static void load_triples(const uint32_t* p, I& a, I& b, I& c) {
    const uint32x4x3_t low = vld3q_u32(p);
    const uint32x4x3_t high = vld3q_u32(p + 12);
    a = lanes_of(low.val[0], high.val[0]);
    b = lanes_of(low.val[1], high.val[1]);
    c = lanes_of(low.val[2], high.val[2]);
  }
  static void load_triples(const float* p, F& a, F& b, F& c) {
    const float32x4x3_t low = vld3q_f32(p);
    const float32x4x3_t high = vld3q_f32(p + 12);
    a = {low.val[0], high.val[0]};
    b = {low.val[1], high.val[1]};
    c = {low.val[2], high.val[2]};
  }

 private:
  static int16x8_t halves16(int32x4_t a) { return vreinterpretq_s16_s32(a); }
  static int32x4_t halves_min(int32x4_t a, int32x4_t b) {
    return vreinterpretq_s32_s16(vminq_s16(halves16(a), halves16(b)));
  }
  static int32x4_t halves_max(int32x4_t a, int32x4_t b) {
    return vreinterpretq_s32_s16(vmaxq_s16(halves16(a), halves16(b)));
  }
  static int32x4_t halves_add(int32x4_t a, int32x4_t b) {
    return vreinterpretq_s32_s16(vaddq_s16(halves16(a), halves16(b)));
  }
  static int32x4_t halves_multiply(int32x4_t a, int32x4_t b) {
    return vreinterpretq_s32_s16(vmulq_s16(halves16(a), halves16(b)));
  }
  template <int kBits>
  static int32x4_t halves_down(int32x4_t a) {
    return vreinterpretq_s32_u16(vshrq_n_u16(vreinterpretq_u16_s32(a), kBits));
  }
  static int32x4_t halves_subtract(int32x4_t a, int32x4_t b) {
    return vreinterpretq_s32_s16(vsubq_s16(halves16(a), halves16(b)));
  }
  static uint32x4_t unsigned_of(int32x4_t a) { return vreinterpretq_u32_s32(a); }
  static I lanes_of(uint32x4_t l, uint32x4_t h) { return {vreinterpretq_s32_u32(l), vreinterpretq_s32_u32(h)}; }
  static int32x4_t dot4(int32x4_t a, int32x4_t b) {
    const int16x8_t x = vreinterpretq_s16_s32(a);
    const int16x8_t y = vreinterpretq_s16_s32(b);
    return vpaddq_s32(vmull_s16(vget_low_s16(x), vget_low_s16(y)), vmull_high_s16(x, y));
  }
  static void transpose(float32x4_t r0, float32x4_t r1, float32x4_t r2, float32x4_t r3, float32x4_t& a, float32x4_t& b,
                        float32x4_t& c, float32x4_t& d) {
    const float64x2_t t0 = vreinterpretq_f64_f32(vtrn1q_f32(r0, r1));
    const float64x2_t t1 = vreinterpretq_f64_f32(vtrn2q_f32(r0, r1));
    const float64x2_t t2 = vreinterpretq_f64_f32(vtrn1q_f32(r2, r3));
    const float64x2_t t3 = vreinterpretq_f64_f32(vtrn2q_f32(r2, r3));
    a = vreinterpretq_f32_f64(vzip1q_f64(t0, t2));
    b = vreinterpretq_f32_f64(vzip1q_f64(t1, t3));
    c = vreinterpretq_f32_f64(vzip2q_f64(t0, t2));
    d = vreinterpretq_f32_f64(vzip2q_f64(t1, t3));
  }
};

}  // namespace auslan::raster
