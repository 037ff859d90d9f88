// SPDX-License-Identifier: Apache-2.0
// Every lane type gives the bits of the scalar one, operation by operation: what the kernels' equality rests on.
#include "raster_lanes.h"

#include "kernels/lanes_scalar.h"
#include "raster_screen.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

namespace auslan::raster {
namespace {

constexpr float kSpecial[] = {0.0F,
                              -0.0F,
                              1.0F,
                              -1.0F,
                              0.5F,
                              16777216.0F,
                              std::numeric_limits<float>::denorm_min(),
                              -std::numeric_limits<float>::denorm_min(),
                              std::numeric_limits<float>::min(),
                              std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::lowest(),
                              std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN()};
constexpr int64_t kWholes[] = {
    0, 1, -1, 0x7FFF, 0x8000, -0x8000, 0xFFFF, 0x7FFFFFFF, -0x80000000LL, 0x80008000LL, 0x1000001};

int32_t any_bits(Random& random) {
  return static_cast<int32_t>(static_cast<uint32_t>(random.next()));
}

// Half of the numbers are of ordinary size, so that sums, products and comparisons are not all of strangers.
float any_float(Random& random) {
  const auto choice = random.between(0, 7);
  if (choice < 2) return kSpecial[random.between(0, std::ssize(kSpecial) - 1)];
  if (choice < 4) return std::bit_cast<float>(any_bits(random));
  return random.real(-1000.0F, 1000.0F);
}

int32_t any_integer(Random& random) {
  const auto choice = random.between(0, 3);
  if (choice == 0) return static_cast<int32_t>(kWholes[random.between(0, std::ssize(kWholes) - 1)]);
  return choice == 1 ? static_cast<int32_t>(random.between(-9, 9)) : any_bits(random);
}

// truncate takes what fits 32 bits; a thousandth of it is below 2^22, as round wants it. Some lie on ties.
float any_whole(Random& random) {
  const auto choice = random.between(0, 3);
  if (choice == 0) return static_cast<float>(random.between(-4000, 4000)) * 500.0F;
  if (choice == 1) return random.real(-2.0F, 2.0F);
  return choice == 2 ? -0.0F : random.real(-2147483520.0F, 2147483520.0F);
}

LaneInput any_input(Random& random) {
  LaneInput in;
  for (size_t i = 0; i < 8; ++i) {
    in.a[i] = any_float(random);
    in.b[i] = random.between(0, 7) == 0 ? in.a[i] : any_float(random);
    in.c[i] = any_float(random);
    in.whole[i] = any_whole(random);
    in.x[i] = any_integer(random);
    in.y[i] = random.between(0, 7) == 0 ? in.x[i] : any_integer(random);
    in.z[i] = any_integer(random);
    in.number[i] = static_cast<uint32_t>(random.between(0, 15));
  }
  for (float& entry : in.table)
    entry = any_float(random);
  return in;
}

bool agree(LaneKind kind, uint32_t one, uint32_t other) {
  const bool both_nan = std::isnan(std::bit_cast<float>(one)) && std::isnan(std::bit_cast<float>(other));
  return one == other || (kind == LaneKind::kFloat && both_nan);
}

struct LaneType {
  Kernel kernel;
  void (*operations)(const LaneInput&, LaneResults&);
};

void PrintTo(const LaneType& type, std::ostream* out) {
  *out << name_of(type.kernel);
}

class Lanes : public testing::TestWithParam<LaneType> {};

TEST_P(Lanes, GiveTheBitsOfTheScalarOnes) {
  const auto runnable = runnable_kernels();
  if (std::ranges::find(runnable, GetParam().kernel) == runnable.end())
    GTEST_SKIP() << "this processor does not run " << name_of(GetParam().kernel);
  Random random(8);
  for (int round = 0; round < 20000; ++round) {
    const LaneInput in = any_input(random);
    LaneResults expected, actual;
    do_lane_operations<Scalar>(in, expected);
    GetParam().operations(in, actual);
    ASSERT_EQ(expected.count, actual.count);
    for (size_t i = 0; i < expected.count; ++i) {
      const LaneResult& wanted = expected.results[i];
      for (size_t lane = 0; lane < 8; ++lane)
        ASSERT_TRUE(agree(wanted.kind, wanted.lanes[lane], actual.results[i].lanes[lane]))
            << wanted.operation << " in lane " << lane << " of round " << round << ": " << std::hex
            << actual.results[i].lanes[lane] << " instead of " << wanted.lanes[lane];
    }
  }
}

std::string name_of_case(const testing::TestParamInfo<LaneType>& info) {
  return std::string(name_of(info.param.kernel));
}

#if defined(__x86_64__)
INSTANTIATE_TEST_SUITE_P(Raster, Lanes,
                         testing::Values(LaneType{Kernel::kSse2, do_sse2_operations},
                                         LaneType{Kernel::kAvx2, do_avx2_operations}),
                         name_of_case);
#elif defined(__aarch64__)
INSTANTIATE_TEST_SUITE_P(Raster, Lanes, testing::Values(LaneType{Kernel::kNeon, do_neon_operations}), name_of_case);
#else
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Lanes);
#endif

}  // namespace
}  // namespace auslan::raster
