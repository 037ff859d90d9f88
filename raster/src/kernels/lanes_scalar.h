// SPDX-License-Identifier: Apache-2.0
// Eight lanes in plain C++: the contract of every lane type, and what the others are measured against.
//
// F: eight IEEE single-precision numbers. I: eight 32-bit integers that wrap, or pairs of 16-bit ones.
// Masks are I too: a comparison gives one, sign_mask makes one of the lanes' signs, &, | and and_not combine them, and
// only select and signs may look into them (which bits count beside the sign is each type's own affair).
// No operation is fused or reassociated, so every lane type gives the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace auslan::raster {

struct Scalar {
  /// How many rows of pixels a loop takes at a time: as many as the registers hold.
  static constexpr int kRowsAtOnce = 1;
  static constexpr size_t kLanes = 8;
  /// Of how many samples a pixel `average` takes; 0 where there is none, and Resolve has its own for all.
  static constexpr size_t kAveragedSamples = 0;
  struct F {
    float v[kLanes];
    template <class Operation>
    static F map(const F& a, const F& b, Operation operation) {
      F r;
      for (size_t i = 0; i < kLanes; ++i)
        r.v[i] = operation(a.v[i], b.v[i]);
      return r;
    }
    friend F operator+(const F& a, const F& b) {
      return map(a, b, [](float x, float y) { return x + y; });
    }
    friend F operator-(const F& a, const F& b) {
      return map(a, b, [](float x, float y) { return x - y; });
    }
    friend F operator*(const F& a, const F& b) {
      return map(a, b, [](float x, float y) { return x * y; });
    }
    friend F operator/(const F& a, const F& b) {
      return map(a, b, [](float x, float y) { return x / y; });
    }
  };
  struct I {
    uint32_t v[kLanes];
    template <class Operation>
    static I map(const I& a, const I& b, Operation operation) {
      I r;
      for (size_t i = 0; i < kLanes; ++i)
        r.v[i] = operation(a.v[i], b.v[i]);
      return r;
    }
    friend I operator+(const I& a, const I& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x + y; });
    }
    friend I operator-(const I& a, const I& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x - y; });
    }
    friend I operator&(const I& a, const I& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x & y; });
    }
    friend I operator|(const I& a, const I& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x | y; });
    }
    friend I operator^(const I& a, const I& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x ^ y; });
    }
  };
  static F set(float x) {
    F r;
    for (float& lane : r.v)
      lane = x;
    return r;
  }
  static I set(int32_t x) {
    I r;
    for (uint32_t& lane : r.v)
      lane = static_cast<uint32_t>(x);
    return r;
  }
  /// One number from memory in all lanes.
  static F spread(const float* p) { return set(*p); }
  static I spread(const int32_t* p) { return set(*p); }
  static F load(const float* p) {
    F r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = p[i];
    return r;
  }
  static I load(const int32_t* p) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = static_cast<uint32_t>(p[i]);
    return r;
  }
  static I load(const uint32_t* p) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = p[i];
    return r;
  }
  static void store(float* p, const F& a) {
    for (size_t i = 0; i < kLanes; ++i)
      p[i] = a.v[i];
  }
  static void store(int32_t* p, const I& a) {
    for (size_t i = 0; i < kLanes; ++i)
      p[i] = static_cast<int32_t>(a.v[i]);
  }
  static void store(uint32_t* p, const I& a) {
    for (size_t i = 0; i < kLanes; ++i)
      p[i] = a.v[i];
  }

  /// The second where either is not a number.
  static F min(const F& a, const F& b) {
    return F::map(a, b, [](float x, float y) { return x < y ? x : y; });
  }
  static F max(const F& a, const F& b) {
    return F::map(a, b, [](float x, float y) { return x > y ? x : y; });
  }
  static I min(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return signed_of(x) < signed_of(y) ? x : y; });
  }
  static I max(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return signed_of(x) > signed_of(y) ? x : y; });
  }
  static F sqrt(const F& a) {
    F r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = __builtin_sqrtf(a.v[i]);
    return r;
  }
  static I greater(const F& a, const F& b) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = all_if(a.v[i] > b.v[i]);
    return r;
  }
  static I at_least(const F& a, const F& b) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = all_if(a.v[i] >= b.v[i]);
    return r;
  }
  static I greater(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return all_if(signed_of(x) > signed_of(y)); });
  }
  static I equal(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return all_if(x == y); });
  }
  /// a & ~mask
  static I and_not(const I& mask, const I& a) {
    return I::map(mask, a, [](uint32_t x, uint32_t y) { return ~x & y; });
  }
  template <int kBits>
  static I shift_left(const I& a) {
    return I::map(a, a, [](uint32_t x, uint32_t) { return x << kBits; });
  }
  /// Arithmetic: rounds down.
  template <int kBits>
  static I shift_right(const I& a) {
    return I::map(a, a, [](uint32_t x, uint32_t) { return static_cast<uint32_t>(signed_of(x) >> kBits); });
  }

  static F to_float(const I& a) {
    F r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = static_cast<float>(signed_of(a.v[i]));
    return r;
  }
  /// Towards zero. What a lane holds whose number does not fit 32 bits is each type's own affair.
  static I truncate(const F& a) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = whole(static_cast<double>(a.v[i]));
    return r;
  }
  /// To nearest, ties to even; else as truncate.
  static I round(const F& a) {
    I r;
    for (size_t i = 0; i < kLanes; ++i) {
      const double rounder = 6755399441055744.0;  // 1.5 * 2^52 leaves no bits below 1
      r.v[i] = whole((static_cast<double>(a.v[i]) + rounder) - rounder);
    }
    return r;
  }
  static I bits(const F& a) {
    I r;
    __builtin_memcpy(&r, &a, sizeof r);
    return r;
  }
  static F from_bits(const I& a) {
    F r;
    __builtin_memcpy(&r, &a, sizeof r);
    return r;
  }

  static I sign_mask(const I& a) { return shift_right<31>(a); }
  static F select(const I& mask, const F& yes, const F& no) {
    F r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = signed_of(mask.v[i]) < 0 ? yes.v[i] : no.v[i];
    return r;
  }
  static I select(const I& mask, const I& yes, const I& no) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = signed_of(mask.v[i]) < 0 ? yes.v[i] : no.v[i];
    return r;
  }
  /// Bit i is lane i's sign.
  static uint32_t signs(const I& a) {
    uint32_t r = 0;
    for (size_t i = 0; i < kLanes; ++i)
      r |= (a.v[i] >> 31U) << i;
    return r;
  }

  /// Two 16-bit numbers in each lane.
  static I pair(const I& low, const I& high) {
    return I::map(low, high, [](uint32_t x, uint32_t y) { return join(x, y); });
  }
  /// low * low + high * high of signed 16-bit pairs.
  static I dot(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return product(x, y) + product(x >> 16U, y >> 16U); });
  }

  /// The lesser and the greater of signed 16-bit pairs, half by half; sums, differences and products, wrapping.
  static I min16(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) {
      return join(signed16(x) < signed16(y) ? x : y, signed16(x >> 16U) < signed16(y >> 16U) ? x >> 16U : y >> 16U);
    });
  }
  static I max16(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) {
      return join(signed16(x) > signed16(y) ? x : y, signed16(x >> 16U) > signed16(y >> 16U) ? x >> 16U : y >> 16U);
    });
  }
  static I add16(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return join(x + y, (x >> 16U) + (y >> 16U)); });
  }
  static I subtract16(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return join(x - y, (x >> 16U) - (y >> 16U)); });
  }
  static I multiply16(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return join(x * y, (x >> 16U) * (y >> 16U)); });
  }
  /// One half in the place of both.
  static I low_halves(const I& a) {
    return I::map(a, a, [](uint32_t x, uint32_t) { return join(x, x); });
  }
  static I high_halves(const I& a) {
    return I::map(a, a, [](uint32_t x, uint32_t) { return join(x >> 16U, x >> 16U); });
  }
  /// Both halves as unsigned numbers.
  template <int kBits>
  static I shift_right16(const I& a) {
    return I::map(a, a, [](uint32_t x, uint32_t) { return join((x & 0xFFFFU) >> kBits, x >> (16U + kBits)); });
  }

  /// Where the sign of `outside` is clear and z is greater than `stored`, which must not be negative, `stored` becomes
  /// z. Returns where.
  static I keep_greater(const I& outside, const F& z, F& stored) {
    const I visible = and_not(sign_mask(outside), greater(z, stored));
    stored = select(visible, z, stored);
    return visible;
  }

  /// Lanes 0-3 from p, lanes 4-7 from p + stride.
  static F load_2x4(const float* p, size_t stride) {
    F r;
    for (size_t i = 0; i < 4; ++i) {
      r.v[i] = p[i];
      r.v[i + 4] = p[stride + i];
    }
    return r;
  }
  static I load_2x4(const uint32_t* p, size_t stride) {
    I r;
    for (size_t i = 0; i < 4; ++i) {
      r.v[i] = p[i];
      r.v[i + 4] = p[stride + i];
    }
    return r;
  }
  static void store_2x4(float* p, size_t stride, const F& a) {
    for (size_t i = 0; i < 4; ++i) {
      p[i] = a.v[i];
      p[stride + i] = a.v[i + 4];
    }
  }
  static void store_2x4(uint32_t* p, size_t stride, const I& a) {
    for (size_t i = 0; i < 4; ++i) {
      p[i] = a.v[i];
      p[stride + i] = a.v[i + 4];
    }
  }

  /// kSamples numbers from memory, again and again in all lanes.
  template <size_t kSamples>
  static F repeat(const float* p) {
    F r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = p[i % kSamples];
    return r;
  }
  template <size_t kSamples>
  static I repeat(const int32_t* p) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = static_cast<uint32_t>(p[i % kSamples]);
    return r;
  }
  /// Each lane kSamples times, one after the other.
  template <size_t kSamples>
  static void expand(const I& a, I (&out)[kSamples]) {
    for (size_t i = 0; i < kLanes * kSamples; ++i)
      out[i / kLanes].v[i % kLanes] = a.v[i / kSamples];
  }
  /// Of eight times kSamples numbers in memory the first of each kSamples, the second, ...
  template <size_t kSamples>
  static void split(const uint32_t* p, I (&out)[kSamples]) {
    for (size_t i = 0; i < kLanes * kSamples; ++i)
      out[i % kSamples].v[i / kSamples] = p[i];
  }
  /// Whether kSamples numbers of each pixel are the same for all eight pixels; `pixels` are the first of each then.
  template <size_t kSamples>
  static bool alike(const uint32_t* p, I& pixels) {
    bool same = true;
    for (size_t i = 0; i < kLanes * kSamples; ++i)
      same = same && p[i] == p[i / kSamples * kSamples];
    for (size_t i = 0; i < kLanes; ++i)
      pixels.v[i] = p[i * kSamples];
    return same;
  }
  /// Colours of kLanes / 2 pixels, four 16-bit numbers each, as words 0xDDCCBBAA for words_of_samples; the numbers are
  /// 0 to 255.
  static I pack_colours(const I& colours) {
    I r{};
    for (size_t i = 0; i < kLanes / 2; ++i) {
      const uint32_t low = colours.v[i * 2];
      const uint32_t high = colours.v[i * 2 + 1];
      r.v[i] = (low & 0xFFU) | (low >> 16U) << 8U | (high & 0xFFU) << 16U | (high >> 16U) << 24U;
    }
    return r;
  }
  /// Of those pixels' samples, kSamples each, one pixel's behind the other's: the words of vector kVector.
  template <size_t kSamples, size_t kVector>
  static I words_of_samples(const I& packed) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = packed.v[(kVector * kLanes + i) / kSamples];
    return r;
  }
  /// Four distances, as SmallGroup has its crossings.
  struct Crossings {
    float v[4];
  };
  static Crossings load_crossings(const float* p) { return {{p[0], p[1], p[2], p[3]}}; }
  static Crossings sum(const Crossings& a, const Crossings& b) {
    return {{a.v[0] + b.v[0], a.v[1] + b.v[1], a.v[2] + b.v[2], a.v[3] + b.v[3]}};
  }
  /// What they are held above for rows from pixel 0 to `width` - 1.
  static Crossings least_crossings(int32_t width) { return {{-1.0F, static_cast<float>(1 - width), 0.0F, 0.0F}}; }
  /// The first pixel of a row behind both left crossings, at most kTileWidth + 1, and, negative, the last one before
  /// both right ones.
  static void pixels_between(const Crossings& a, const Crossings& least, int32_t& first, int32_t& minus_last) {
    const auto held = [](float x, float y, float low, float high) {
      const float more = x > y ? x : y;
      const float above = more > low ? more : low;
      return above < high ? above : high;
    };
    first = static_cast<int32_t>(held(a.v[0], a.v[2], least.v[0], 64.0F) + 1.0F);
    minus_last = static_cast<int32_t>(held(a.v[1], a.v[3], least.v[1], 1.0F));
  }
  /// Lanes for the samples of pixels side by side: a type with the part of this contract that fill_samples.h uses, and
  /// with at least kSamples lanes.
  template <size_t>
  static Scalar sample_lanes();

  /// Lane i of a, b, c, d: the four floats at base + number[i] * stride.
  static void gather_quads(const float* base, const uint32_t* number, size_t stride, F& a, F& b, F& c, F& d) {
    for (size_t i = 0; i < kLanes; ++i) {
      const float* p = base + size_t{number[i]} * stride;
      a.v[i] = p[0];
      b.v[i] = p[1];
      c.v[i] = p[2];
      d.v[i] = p[3];
    }
  }
  static void gather_quads(const uint32_t* base, const uint32_t* number, I& a, I& b, I& c, I& d) {
    for (size_t i = 0; i < kLanes; ++i) {
      uint32_t words[4];
      __builtin_memcpy(words, base + size_t{number[i]} * 4, sizeof words);
      a.v[i] = words[0];
      b.v[i] = words[1];
      c.v[i] = words[2];
      d.v[i] = words[3];
    }
  }
  static void gather_pairs(const float* base, const uint32_t* number, size_t stride, F& a, F& b) {
    for (size_t i = 0; i < kLanes; ++i) {
      const float* p = base + size_t{number[i]} * stride;
      a.v[i] = p[0];
      b.v[i] = p[1];
    }
  }
  /// Lane i of a, b goes to out + 2 * i.
  static void scatter_pairs(float* out, const F& a, const F& b) {
    for (size_t i = 0; i < kLanes; ++i) {
      out[2 * i] = a.v[i];
      out[2 * i + 1] = b.v[i];
    }
  }
  /// Lane i of a, b, c, d goes to out + 4 * i.
  static void scatter_quads(float* out, const F& a, const F& b, const F& c, const F& d) {
    for (size_t i = 0; i < kLanes; ++i) {
      out[4 * i] = a.v[i];
      out[4 * i + 1] = b.v[i];
      out[4 * i + 2] = c.v[i];
      out[4 * i + 3] = d.v[i];
    }
  }
  /// Lane i of a, b, c, d goes to four words, those of the lanes in `kept` one after another from out on. Up to the 32
  /// words from out on are written.
  static void store_kept(uint32_t* out, uint32_t kept, const I& a, const I& b, const I& c, const I& d) {
    for (size_t i = 0; i < kLanes; ++i) {
      if ((kept >> i & 1U) == 0U) continue;
      const uint32_t words[4] = {a.v[i], b.v[i], c.v[i], d.v[i]};
      __builtin_memcpy(out, words, sizeof words);
      out += 4;
    }
  }
  /// Lane i of a, b, c: the three numbers at p + 3 * i.
  static void load_triples(const uint32_t* p, I& a, I& b, I& c) {
    for (size_t i = 0; i < kLanes; ++i) {
      a.v[i] = p[3 * i];
      b.v[i] = p[3 * i + 1];
      c.v[i] = p[3 * i + 2];
    }
  }
  static void load_triples(const float* p, F& a, F& b, F& c) {
    for (size_t i = 0; i < kLanes; ++i) {
      a.v[i] = p[3 * i];
      b.v[i] = p[3 * i + 1];
      c.v[i] = p[3 * i + 2];
    }
  }

 private:
  static uint32_t whole(double x) {
    return x > -2147483649.0 && x < 2147483648.0 ? static_cast<uint32_t>(static_cast<int32_t>(x)) : 0x80000000U;
  }
  static int32_t signed_of(uint32_t x) { return static_cast<int32_t>(x); }
  static int32_t signed16(uint32_t x) { return static_cast<int16_t>(static_cast<uint16_t>(x)); }
  static uint32_t join(uint32_t low, uint32_t high) { return (low & 0xFFFFU) | (high << 16U); }
  static uint32_t all_if(bool condition) { return condition ? 0xFFFFFFFFU : 0U; }
  static uint32_t product(uint32_t x, uint32_t y) { return static_cast<uint32_t>(signed16(x) * signed16(y)); }
};

}  // namespace auslan::raster
