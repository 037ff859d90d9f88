// SPDX-License-Identifier: Apache-2.0
// Every operation of a lane type, done once on given numbers. Each lane type is instantiated in a file of its own that
// is compiled as that type's kernel is; so there is nothing here but templates over it and plain data, and no code for
// a wider instruction set can reach another file through the linker.
#pragma once

#include <cstddef>
#include <cstdint>

namespace auslan::raster {

/// What the operations work on.
struct LaneInput {
  float a[8], b[8], c[8];    ///< any bits
  float whole[8];            ///< of a size that truncate and round take
  int32_t x[8], y[8], z[8];  ///< any bits
  uint32_t number[8];        ///< below 16
  float table[16 * 9 + 8];
};

enum class LaneKind {
  kBits,   ///< the bits must agree
  kFloat,  ///< so must these, but one NaN is as good as another: which one arithmetic gives is the processor's affair
};

struct LaneResult {
  const char* operation;
  LaneKind kind;
  uint32_t lanes[8];
};

struct LaneResults {
  static constexpr size_t kMost = 256;
  LaneResult results[kMost];
  size_t count;
};

template <class L>
struct LaneOperations {
  using F = typename L::F;
  using I = typename L::I;

  LaneResults& out;

  uint32_t* next(const char* operation, LaneKind kind) {
    LaneResult& result = out.results[out.count++];
    result.operation = operation;
    result.kind = kind;
    return result.lanes;
  }
  void keep(const char* operation, const F& value, LaneKind kind = LaneKind::kBits) {
    L::store(next(operation, kind), L::bits(value));
  }
  void keep(const char* operation, const I& value) { L::store(next(operation, LaneKind::kBits), value); }
  // A mask may be looked into by select and signs only.
  void keep_mask(const char* operation, const I& mask, const LaneInput& in) {
    keep(operation, L::select(mask, L::load(in.x), L::load(in.y)));
    keep(operation, L::select(mask, L::load(in.a), L::load(in.b)));
    uint32_t* lanes = next(operation, LaneKind::kBits);
    for (size_t i = 0; i < 8; ++i)
      lanes[i] = L::signs(mask);
  }

  void arithmetic(const LaneInput& in) {
    const F a = L::load(in.a);
    const F b = L::load(in.b);
    const F c = L::load(in.c);
    const I x = L::load(in.x);
    const I y = L::load(in.y);
    keep("load F", a);
    keep("load I", x);
    keep("set F", L::set(in.a[0]));
    keep("set I", L::set(in.x[0]));
    keep("F + F", a + b, LaneKind::kFloat);
    keep("F - F", a - b, LaneKind::kFloat);
    keep("F * F", a * b, LaneKind::kFloat);
    keep("F / F", a / b, LaneKind::kFloat);
    // Products of their own, which a compiler that may fuse would fuse.
    keep("F * F + F, rounded twice", c * a + b, LaneKind::kFloat);
    keep("F - F * F, rounded twice", a - b * c, LaneKind::kFloat);
    keep("sqrt", L::sqrt(a), LaneKind::kFloat);
    keep("min F", L::min(a, b));
    keep("max F", L::max(a, b));
    keep("I + I", x + y);
    keep("I - I", x - y);
    keep("I & I", x & y);
    keep("I | I", x | y);
    keep("I ^ I", x ^ y);
    keep("and_not", L::and_not(x, y));
    keep("min I", L::min(x, y));
    keep("max I", L::max(x, y));
    keep("shift_left 1", L::template shift_left<1>(x));
    keep("shift_left 8", L::template shift_left<8>(x));
    keep("shift_left 31", L::template shift_left<31>(x));
    keep("shift_right 1", L::template shift_right<1>(x));
    keep("shift_right 8", L::template shift_right<8>(x));
    keep("shift_right 31", L::template shift_right<31>(x));
    keep("to_float", L::to_float(x));
    keep("truncate", L::truncate(L::load(in.whole)));
    keep("round", L::round(L::load(in.whole) * L::set(0.001F)));
    keep("pair", L::pair(x, y));
    keep("dot", L::dot(x, y));
    keep("min16", L::min16(x, y));
    keep("max16", L::max16(x, y));
    keep("subtract16", L::subtract16(x, y));
    keep("add16", L::add16(x, y));
    keep("multiply16", L::multiply16(x, y));
    keep("shift_right16 1", L::template shift_right16<1>(x));
    keep("shift_right16 7", L::template shift_right16<7>(x));
    keep("from_bits", L::from_bits(x));
  }

  void masks(const LaneInput& in) {
    const F a = L::load(in.a);
    const F b = L::load(in.b);
    const I x = L::load(in.x);
    const I y = L::load(in.y);
    const I z = L::load(in.z);
    keep_mask("greater F", L::greater(a, b), in);
    keep_mask("at_least F", L::at_least(a, b), in);
    keep_mask("greater I", L::greater(x, y), in);
    keep_mask("equal", L::equal(x, y), in);
    keep_mask("sign_mask", L::sign_mask(x), in);
    F stored = L::max(a, L::set(0.0F));
    keep_mask("keep_greater", L::keep_greater(x, b, stored), in);
    keep("keep_greater", stored);
    keep_mask("mask & mask", L::greater(a, b) & L::sign_mask(z), in);
    keep_mask("mask | mask", L::equal(x, y) | L::sign_mask(z), in);
    keep_mask("mask ^ mask", L::greater(x, y) ^ L::sign_mask(z), in);
    keep_mask("mask and_not mask", L::and_not(L::sign_mask(z), L::greater(a, b)), in);
  }

  void memory(const LaneInput& in) {
    const F a = L::load(in.a);
    const F b = L::load(in.b);
    uint32_t words[16];
    for (size_t i = 0; i < 16; ++i)
      words[i] = in.number[i % 8] + static_cast<uint32_t>(i);
    keep("load uint32_t", L::load(words));
    keep("load_2x4 F", L::load_2x4(in.table, 9));
    keep("load_2x4 I", L::load_2x4(words, 7));
    float row[16] = {};
    L::store(row + 1, a);
    keep_memory("store F", row);
    L::store_2x4(row, 11, b);
    keep_memory("store_2x4 F", row);
    L::store_2x4(words, 11, L::load(in.x));
    keep("store_2x4 I", L::load(words));
    keep("store_2x4 I", L::load(words + 8));
    int32_t integers[8];
    L::store(integers, L::load(in.x));
    keep("store int32_t", L::load(integers));

    F f0, f1, f2, f3;
    L::gather_quads(in.table, in.number, 9, f0, f1, f2, f3);
    keep("gather_quads", f0);
    keep("gather_quads", f1);
    keep("gather_quads", f2);
    keep("gather_quads", f3);
    I i0, i1, i2, i3;
    uint32_t numbers[64];
    for (size_t i = 0; i < 64; ++i)
      numbers[i] = in.number[i % 8] * 24U + static_cast<uint32_t>(i);
    L::gather_quads(numbers, in.number, i0, i1, i2, i3);
    keep("gather_quads I", i0);
    keep("gather_quads I", i1);
    keep("gather_quads I", i2);
    keep("gather_quads I", i3);
    const auto kept = static_cast<uint32_t>(in.z[0]) & 0xFFU;
    uint32_t stored[32];
    L::store_kept(stored, kept, i0, i1, i2, i3);
    for (size_t i = 4 * static_cast<size_t>(__builtin_popcount(kept)); i < 32; ++i)
      stored[i] = 0;
    for (size_t i = 0; i < 32; i += 8)
      keep("store_kept", L::load(stored + i));
    L::gather_pairs(in.table, in.number, 9, f0, f1);
    keep("gather_pairs", f0);
    keep("gather_pairs", f1);
    L::load_triples(in.table, f0, f1, f2);
    keep("load_triples", f0);
    keep("load_triples", f1);
    keep("load_triples", f2);
    L::load_triples(numbers, i0, i1, i2);
    keep("load_triples I", i0);
    keep("load_triples I", i1);
    keep("load_triples I", i2);
    float scattered[32];
    L::scatter_pairs(scattered, a, b);
    for (size_t i = 0; i < 16; i += 8)
      keep("scatter_pairs", L::load(scattered + i));
    L::scatter_quads(scattered, a, b, L::load(in.c), f0);
    for (size_t i = 0; i < 32; i += 8)
      keep("scatter_quads", L::load(scattered + i));
  }

 private:
  void keep_memory(const char* operation, const float* row) {
    keep(operation, L::load(row));
    keep(operation, L::load(row + 8));
  }
};

template <class L>
void do_lane_operations(const LaneInput& in, LaneResults& out) {
  out.count = 0;
  LaneOperations<L> operations{out};
  operations.arithmetic(in);
  operations.masks(in);
  operations.memory(in);
}

// In tests/unit/raster_lanes_sse2.cpp and so on, where the processor has them.
void do_sse2_operations(const LaneInput& in, LaneResults& out);
void do_avx2_operations(const LaneInput& in, LaneResults& out);
void do_neon_operations(const LaneInput& in, LaneResults& out);

}  // namespace auslan::raster
