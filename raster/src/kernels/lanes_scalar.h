// SPDX-License-Identifier: Apache-2.0
// Eight lanes in plain C++: the contract of every lane type, and what the others are measured against.
//
// F: eight IEEE single-precision numbers. I: eight 32-bit integers that wrap. H: eight 16-bit integers that wrap.
// Masks are I too: a comparison gives one, sign_mask makes one of the lanes' signs, &, | and and_not combine them, and
// only select and signs may look into them (which bits count beside the sign is each type's own affair).
// No operation is fused or reassociated, so every lane type gives the same bits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace auslan::raster {

struct Scalar {
  static constexpr size_t kLanes = 8;
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
  struct H {
    uint16_t v[kLanes];
    template <class Operation>
    static H map(const H& a, const H& b, Operation operation) {
      H r;
      for (size_t i = 0; i < kLanes; ++i)
        r.v[i] = static_cast<uint16_t>(operation(uint32_t{a.v[i]}, uint32_t{b.v[i]}));
      return r;
    }
    friend H operator+(const H& a, const H& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x + y; });
    }
    friend H operator*(const H& a, const H& b) {
      return map(a, b, [](uint32_t x, uint32_t y) { return x * y; });
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
  /// Towards zero; numbers beyond 32 bits are not allowed.
  static I truncate(const F& a) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = static_cast<uint32_t>(static_cast<int32_t>(a.v[i]));
    return r;
  }
  /// To nearest, ties to even; numbers beyond 2^22 are not allowed.
  static I round(const F& a) {
    I r;
    for (size_t i = 0; i < kLanes; ++i) {
      const float rounder = 12582912.0F;
      r.v[i] = static_cast<uint32_t>(static_cast<int32_t>((a.v[i] + rounder) - rounder));
    }
    return r;
  }
  static I bits(const F& a) {
    I r;
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
    return I::map(low, high, [](uint32_t x, uint32_t y) { return (x & 0xFFFFU) | (y << 16U); });
  }
  /// low * low + high * high of signed 16-bit pairs.
  static I dot(const I& a, const I& b) {
    return I::map(a, b, [](uint32_t x, uint32_t y) { return product(x, y) + product(x >> 16U, y >> 16U); });
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

  /// All lanes from a word that holds the number twice.
  static H halves(uint32_t pair_of_equals) {
    H r;
    for (uint16_t& lane : r.v)
      lane = static_cast<uint16_t>(pair_of_equals);
    return r;
  }
  static H load_halves(const int16_t* p) {
    H r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = static_cast<uint16_t>(p[i]);
    return r;
  }
  static H min(const H& a, const H& b) {
    return H::map(a, b, [](uint32_t x, uint32_t y) { return signed16(x) < signed16(y) ? x : y; });
  }
  static H max(const H& a, const H& b) {
    return H::map(a, b, [](uint32_t x, uint32_t y) { return signed16(x) > signed16(y) ? x : y; });
  }
  template <int kBits>
  static H shift_left(const H& a) {
    return H::map(a, a, [](uint32_t x, uint32_t) { return x << kBits; });
  }
  /// Logical.
  template <int kBits>
  static H shift_right(const H& a) {
    return H::map(a, a, [](uint32_t x, uint32_t) { return x >> kBits; });
  }
  /// 0x00RRGGBB of channels from 0 to 255.
  static I pixels(const H& red, const H& green, const H& blue) {
    I r;
    for (size_t i = 0; i < kLanes; ++i)
      r.v[i] = (uint32_t{red.v[i]} << 16U) | (uint32_t{green.v[i]} << 8U) | blue.v[i];
    return r;
  }

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
  static void gather_pairs(const float* base, const uint32_t* number, size_t stride, F& a, F& b) {
    for (size_t i = 0; i < kLanes; ++i) {
      const float* p = base + size_t{number[i]} * stride;
      a.v[i] = p[0];
      b.v[i] = p[1];
    }
  }
  /// Eight times eight floats: lane i of all eight goes to out + 8 * i.
  static void scatter_octets(float* out, const F& a, const F& b, const F& c, const F& d, const F& e, const F& f,
                             const F& g, const F& h) {
    const F* rows[8] = {&a, &b, &c, &d, &e, &f, &g, &h};
    for (size_t i = 0; i < kLanes; ++i) {
      for (size_t k = 0; k < 8; ++k)
        out[8 * i + k] = rows[k]->v[i];
    }
  }
  /// Lane i of a, b, c: the three floats at p + 3 * i.
  static void load_triples(const float* p, F& a, F& b, F& c) {
    for (size_t i = 0; i < kLanes; ++i) {
      a.v[i] = p[3 * i];
      b.v[i] = p[3 * i + 1];
      c.v[i] = p[3 * i + 2];
    }
  }

 private:
  static int32_t signed_of(uint32_t x) { return static_cast<int32_t>(x); }
  static int32_t signed16(uint32_t x) { return static_cast<int16_t>(static_cast<uint16_t>(x)); }
  static uint32_t all_if(bool condition) { return condition ? 0xFFFFFFFFU : 0U; }
  static uint32_t product(uint32_t x, uint32_t y) { return static_cast<uint32_t>(signed16(x) * signed16(y)); }
};

}  // namespace auslan::raster
