// SPDX-License-Identifier: Apache-2.0
#include "kinematics/elementary.h"
#include "kinematics/interpolate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

const Quat kFrom = from_euler(Vec3(0.0, 180.0, 0.0) * kDegree, kPaperOrder);
const Quat kTo = from_euler(Vec3(0.0, 270.0, 0.0) * kDegree, kPaperOrder);

// Angle turned through in each of `count` equal steps from 0 to 1.
std::vector<double> steps(const std::function<Quat(double)>& path, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i)
    angles.push_back(angle_between(path(static_cast<double>(i) / count), path(static_cast<double>(i + 1) / count)));
  return angles;
}

// (largest - smallest) / mean
double variation(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values)
    sum += v;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) * static_cast<double>(values.size()) / sum;
}

TEST(Slerp, HasConstantAngularVelocity) {
  EXPECT_LT(variation(steps([](double t) { return slerp(kFrom, kTo, t); }, 200)), 1e-12);
  const Quat far = axis_angle(unit(Vec3(1.0, 2.0, -0.5)), 3.1);
  EXPECT_LT(variation(steps([&](double t) { return slerp(kIdentity, far, t); }, 200)), 1e-12);
}

TEST(Slerp, LerpHasNot) {
  // A quarter turn by lerp is fastest in the middle, by 1 / cos(pi/8)^2 = 1.17.
  const std::vector<double> angles = steps([](double t) { return lerp_normalised(kFrom, kTo, t); }, 200);
  EXPECT_GT(variation(angles), 0.1);
  EXPECT_NEAR(angles[100] / angles[0], 1.0 / std::pow(std::cos(kPi / 8.0), 2.0), 0.01);
}

TEST(Slerp, LerpAndSlerpTakeTheSamePathTheShortWay) {
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const Quat on_lerp = lerp_normalised(kFrom, kTo, t);
    const double done = angle_between(kFrom, on_lerp) / angle_between(kFrom, kTo);
    EXPECT_LT(angle_between(slerp(kFrom, kTo, done), on_lerp), 1e-14);
    EXPECT_LT(angle_between(slerp(kFrom, -kTo, t), slerp(kFrom, kTo, t)), 1e-14);
    EXPECT_LT(angle_between(lerp_normalised(kFrom, -kTo, t), on_lerp), 1e-14);
  }
}

TEST(Slerp, MeetsItsEndsAndSmallAngles) {
  EXPECT_LT(angle_between(slerp(kFrom, kTo, 0.0), kFrom), 1e-15);
  EXPECT_LT(angle_between(slerp(kFrom, kTo, 1.0), kTo), 1e-15);
  for (const double angle : {0.0, 1e-12, 0.9e-6, 1.1e-6, 1e-3}) {
    const Quat half = slerp(kIdentity, axis_angle(Vec3(0.0, 1.0, 0.0), angle), 0.5);
    EXPECT_NEAR(angle_between(kIdentity, half), angle / 2.0, 1e-16) << angle;
  }
}

TEST(LerpEuler, TakesDifferentPathsToTheSameOrientation) {
  const Vec3 start = Vec3(0.0, 180.0, 0.0) * kDegree;
  const Quat one = lerp_euler(start, Vec3(90.0, 270.0, 90.0) * kDegree, 0.5, kPaperOrder);
  const Quat two = lerp_euler(start, Vec3(0.0, 270.0, 0.0) * kDegree, 0.5, kPaperOrder);
  EXPECT_GT(angle_between(one, two), 10.0 * kDegree);
}

TEST(MinimumJerk, IsFlashAndHogans) {
  EXPECT_EQ(minimum_jerk(-1.0), 0.0);
  EXPECT_EQ(minimum_jerk(2.0), 1.0);
  EXPECT_EQ(minimum_jerk(0.5), 0.5);
  // Peak speed 1.875 of the mean, in the middle.
  EXPECT_NEAR((minimum_jerk(0.5 + 1e-6) - minimum_jerk(0.5 - 1e-6)) / 2e-6, 1.875, 1e-9);
}

std::vector<RotationKey> wandering_keys() {
  return {{0.0, axis_angle(Vec3(1.0, 0.0, 0.0), 0.3), true},
          {0.4, axis_angle(unit(Vec3(1.0, 1.0, 0.0)), 1.4), false},
          {0.55, axis_angle(unit(Vec3(0.0, 1.0, 1.0)), 1.9), false},
          {1.2, axis_angle(unit(Vec3(-1.0, 1.0, 1.0)), 2.9), true},
          {1.3, axis_angle(unit(Vec3(-1.0, 1.0, 1.0)), 2.9), true},
          {2.0, axis_angle(unit(Vec3(-1.0, 0.2, 0.0)), 1.0), false}};
}

// Angular velocity in the world, by a central difference of the second order.
Vec3 angular_velocity(const RotationTrack& track, double time, double h) {
  return rotation_vector(track.sample(time + h) * glm::conjugate(track.sample(time - h))) / (2.0 * h);
}

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

TEST(RotationTrack, PassesThroughItsKeys) {
  const auto keys = wandering_keys();
  const RotationTrack track(keys);
  for (const RotationKey& key : keys) {
    EXPECT_LT(angle_between(track.sample(key.time), key.rotation), 1e-14);
    EXPECT_LT(angle_between(track.sample(key.time - 1e-12), key.rotation), 1e-10);
  }
  EXPECT_LT(angle_between(track.sample(-1.0), keys.front().rotation), 1e-15);
  EXPECT_LT(angle_between(track.sample(9.0), keys.back().rotation), 1e-15);
}

TEST(RotationTrack, AngularVelocityIsContinuousAcrossKeys) {
  const auto keys = wandering_keys();
  const RotationTrack track(keys);
  for (size_t i = 1; i + 1 < keys.size(); ++i) {
    double peak = 0.0;
    for (int k = -100; k <= 100; ++k)
      peak = std::max(peak, length(angular_velocity(track, keys[i].time + 1e-3 * k, 1e-5)));
    const Vec3 before = angular_velocity(track, keys[i].time - 2e-6, 1e-6);
    const Vec3 after = angular_velocity(track, keys[i].time + 2e-6, 1e-6);
    EXPECT_LT(length(after - before), 0.01 * peak) << i;
  }
}

TEST(RotationTrack, InnerKeysAreNotStops) {
  const RotationTrack track(wandering_keys());
  EXPECT_GT(length(angular_velocity(track, 0.4, 1e-6)), 1.0);
}

TEST(RotationTrack, RestsAtHoldsWithoutOvershoot) {
  const auto keys = wandering_keys();
  const RotationTrack track(keys);
  EXPECT_LT(length(angular_velocity(track, 1.25, 1e-4)), 1e-9);
  EXPECT_LT(length(angular_velocity(track, 1.2, 1e-5)), 1e-3);
  // Towards the hold the distance to it only falls.
  double before = 10.0;
  for (int i = 0; i <= 200; ++i) {
    const double left = angle_between(track.sample(0.9 + 0.3 * i / 200.0), keys[3].rotation);
    EXPECT_LE(left, before + 1e-12);
    before = left;
  }
}

TEST(RotationTrack, TwoKeysAreSlerpAndTwoHoldsMinimumJerk) {
  const std::vector<RotationKey> free = {{1.0, kFrom, false}, {3.0, kTo, false}};
  const std::vector<RotationKey> held = {{1.0, kFrom, true}, {3.0, kTo, true}};
  const RotationTrack uniform(free);
  const RotationTrack eased(held);
  for (int i = 0; i <= 50; ++i) {
    const double t = i / 50.0;
    EXPECT_LT(angle_between(uniform.sample(1.0 + 2.0 * t), slerp(kFrom, kTo, t)), 1e-14);
    EXPECT_LT(angle_between(eased.sample(1.0 + 2.0 * t), slerp(kFrom, kTo, minimum_jerk(t))), 1e-14);
  }
}

TEST(RotationTrack, IsTotal) {
  EXPECT_EQ(RotationTrack().sample(1.0), kIdentity);
  const std::vector<RotationKey> one = {{1.0, kTo, false}};
  EXPECT_LT(angle_between(RotationTrack(one).sample(7.0), kTo), 1e-15);
  const std::vector<RotationKey> twice = {{1.0, kFrom, false}, {1.0, kTo, false}, {2.0, kTo, false}};
  EXPECT_LT(angle_between(RotationTrack(twice).sample(1.0), kTo), 1e-15);
}

TEST(ScalarTrack, PassesThroughKeysAndNeverLeavesTheirRange) {
  const std::vector<ScalarKey> keys = {{0.0, 0.0, false}, {0.1, 0.05, false}, {0.5, 1.0, false},
                                       {0.6, 1.0, false}, {0.9, 0.2, true},   {1.5, 0.9, false}};
  const ScalarTrack track(keys);
  for (size_t i = 0; i + 1 < keys.size(); ++i) {
    EXPECT_NEAR(track.sample(keys[i].time), keys[i].value, 1e-14);
    const double low = std::min(keys[i].value, keys[i + 1].value);
    const double high = std::max(keys[i].value, keys[i + 1].value);
    for (int k = 0; k <= 100; ++k) {
      const double value = track.sample(keys[i].time + (keys[i + 1].time - keys[i].time) * k / 100.0);
      EXPECT_GE(value, low - 1e-14);
      EXPECT_LE(value, high + 1e-14);
    }
  }
}

TEST(ScalarTrack, RateIsContinuousAcrossKeys) {
  const std::vector<ScalarKey> keys = {{0.0, 0.0, true}, {0.3, 0.2, false}, {0.5, 0.9, false}, {1.0, 1.0, true}};
  const ScalarTrack track(keys);
  const auto rate = [&](double t) { return (track.sample(t + 1e-7) - track.sample(t - 1e-7)) / 2e-7; };
  for (const double time : {0.3, 0.5})
    EXPECT_NEAR(rate(time - 2e-7), rate(time + 2e-7), 0.01 * rate(time));
  EXPECT_GT(rate(0.3), 0.5);
  EXPECT_NEAR(rate(1.0 - 1e-6), 0.0, 1e-3);
}

}  // namespace
}  // namespace auslan
