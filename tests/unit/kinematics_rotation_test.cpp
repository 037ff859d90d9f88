// SPDX-License-Identifier: Apache-2.0
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace auslan {
namespace {

constexpr std::array<EulerOrder, 6> kOrders = {EulerOrder::kXYZ, EulerOrder::kXZY, EulerOrder::kYXZ,
                                               EulerOrder::kYZX, EulerOrder::kZXY, EulerOrder::kZYX};
const Vec3 kX(1.0, 0.0, 0.0);
const Vec3 kY(0.0, 1.0, 0.0);
const Vec3 kZ(0.0, 0.0, 1.0);

class Random {
 public:
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vector() {
    const double x = between(-1.0, 1.0);
    const double y = between(-1.0, 1.0);
    const double z = between(-1.0, 1.0);
    return {x, y, z};
  }
  Vec3 direction() { return unit(vector()); }
  Quat rotation() {
    const Vec3 axis = direction();
    return axis_angle(axis, between(-kPi, kPi));
  }

 private:
  std::mt19937 engine_{11};
};

double distance(const Vec3& a, const Vec3& b) {
  return std::sqrt(glm::dot(a - b, a - b));
}

Vec3 degrees(double x, double y, double z) {
  return Vec3(x, y, z) * kDegree;
}

TEST(Rotation, AxisAngleTurnsCounterClockwise) {
  EXPECT_LT(distance(axis_angle(kZ, kPi / 2.0) * kX, kY), 1e-15);
  EXPECT_LT(distance(axis_angle(kX, kPi / 2.0) * kY, kZ), 1e-15);
  EXPECT_LT(distance(axis_angle(kY, kPi / 2.0) * kZ, kX), 1e-15);
}

TEST(Rotation, VectorAndQuaternionAreInverse) {
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const double size = i % 4 == 0 ? 1e-9 : (i % 4 == 1 ? 1e-4 : 3.14);
    const Vec3 v = random.direction() * random.between(0.0, size);
    ASSERT_LT(distance(rotation_vector(from_rotation_vector(v)), v), 3e-15 + 1e-13 * size * (size > 3.0 ? 1.0 : 0.0));
    const Quat q = random.rotation();
    ASSERT_LT(angle_between(from_rotation_vector(rotation_vector(q)), q), 2e-15);
    ASSERT_LT(distance(rotation_vector(q), rotation_vector(-q)), 1e-15);
  }
}

TEST(Rotation, BetweenTakesOneDirectionToTheOtherTheShortWay) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 a = random.direction() * random.between(0.1, 9.0);
    const Vec3 b = i % 3 == 0 ? -a + random.vector() * 1e-7 : random.vector();
    const Quat q = rotation_between(a, b);
    ASSERT_LT(distance(q * unit(a), unit(b)), 1e-14);
    // The shortest rotation's axis is perpendicular to both.
    ASSERT_NEAR(glm::dot(rotation_vector(q), unit(a)), 0.0, 1e-8);
  }
}

TEST(Rotation, BetweenOppositeDirectionsTurnsAboutTheStatedAxis) {
  const Quat q = rotation_between(kX, -kX);
  EXPECT_LT(distance(q * kX, -kX), 1e-15);
  // X is least aligned with Y (before Z): X cross Y is Z.
  EXPECT_LT(distance(Vec3(q.x, q.y, q.z), kZ), 1e-15);
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 a = random.direction();
    ASSERT_LT(distance(rotation_between(a, -a) * a, -a), 1e-14);
  }
  EXPECT_EQ(rotation_between(Vec3(0.0), kX), kIdentity);
}

TEST(Rotation, AngleBetweenIsThatOfTheTurn) {
  Random random;
  for (const double angle : {0.0, 1e-9, 1e-3, 1.0, 3.0, kPi}) {
    const Quat q = random.rotation();
    const Quat turned = q * axis_angle(random.direction(), angle);
    EXPECT_NEAR(angle_between(q, turned), angle, 1e-15 + 1e-15 * angle + 2e-16);
    EXPECT_NEAR(angle_between(q, -turned), angle, 2e-15);
  }
}

TEST(Rotation, RenormalisedIsTotal) {
  const Quat q = renormalised(Quat(2.0, 0.0, 0.0, 2.0));
  EXPECT_NEAR(q.w * q.w + q.z * q.z, 1.0, 1e-15);
  EXPECT_EQ(renormalised(Quat(0.0, 0.0, 0.0, 0.0)), kIdentity);
  EXPECT_EQ(renormalised(Quat(std::nan(""), 0.0, 0.0, 0.0)), kIdentity);
}

TEST(Rotation, SwingAndTwistComposeAndAreWhatTheyAreCalled) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const Quat q = random.rotation();
    const Vec3 axis = random.direction();
    const SwingTwist parts = swing_twist(q, axis);
    ASSERT_LT(angle_between(parts.swing * parts.twist, q), 1e-14);
    ASSERT_LT(distance(parts.twist * axis, axis), 1e-14);
    ASSERT_NEAR(glm::dot(Vec3(parts.swing.x, parts.swing.y, parts.swing.z), axis), 0.0, 1e-14);
    ASSERT_GE(parts.twist.w, 0.0);
  }
  EXPECT_NEAR(twist_angle(axis_angle(kX, -2.5), kX), -2.5, 1e-15);
  EXPECT_NEAR(twist_angle(axis_angle(kY, 0.8) * axis_angle(kX, 1.5), kX), 1.5, 1e-15);
  // A half turn about a perpendicular axis has no twist to speak of.
  EXPECT_EQ(swing_twist(Quat(0.0, 0.0, 1.0, 0.0), kX).twist, kIdentity);
}

TEST(Rotation, FramesAreTakenToEachOther) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 a0 = random.direction();
    const Vec3 b0 = random.direction();
    const Quat q = random.rotation();
    ASSERT_LT(angle_between(rotation_between_frames(a0, b0, q * a0, q * b0), q), 1e-12);
  }
}

TEST(Euler, OrdersAreIntrinsic) {
  const Vec3 angles = degrees(20.0, -50.0, 110.0);
  const Quat x = axis_angle(kX, angles.x);
  const Quat y = axis_angle(kY, angles.y);
  const Quat z = axis_angle(kZ, angles.z);
  const std::array<Quat, 6> expected = {x * y * z, x * z * y, y * x * z, y * z * x, z * x * y, z * y * x};
  for (size_t i = 0; i < kOrders.size(); ++i)
    EXPECT_LT(angle_between(from_euler(angles, kOrders[i]), expected[i]), 1e-15);
}

TEST(Euler, RoundTripsInEveryOrder) {
  Random random;
  for (const EulerOrder order : kOrders)
    for (int i = 0; i < 3000; ++i) {
      const Quat q = random.rotation();
      ASSERT_LT(angle_between(from_euler(to_euler(q, order), order), q), 1e-8);
      const Vec3 small = random.vector();
      ASSERT_LT(distance(to_euler(from_euler(small, order), order), small), 1e-13);
    }
}

TEST(Euler, RoundTripsInGimbalLock) {
  for (const EulerOrder order : kOrders)
    for (const double middle : {90.0, -90.0, 90.0 - 1e-8, 270.0}) {
      // Whichever axis is the middle one, all three angles are tried there.
      for (const Vec3& angles :
           {degrees(middle, 33.0, -71.0), degrees(33.0, middle, -71.0), degrees(33.0, -71.0, middle)}) {
        const Quat q = from_euler(angles, order);
        EXPECT_LT(angle_between(from_euler(to_euler(q, order), order), q), 1e-7);
      }
    }
}

// Section 4.2 of the paper: the end poses (90, 270, 90) and (0, 270, 0) degrees are the same orientation.
TEST(Euler, ThePapersEndPosesAreTheSameOrientationInThePapersOrder) {
  EXPECT_LT(angle_between(from_euler(degrees(90.0, 270.0, 90.0), kPaperOrder),
                          from_euler(degrees(0.0, 270.0, 0.0), kPaperOrder)),
            1e-15);
}

TEST(Euler, ThePapersEquivalenceHoldsInNoOtherOrder) {
  int holding = 0;
  for (const EulerOrder order : kOrders) {
    const double angle =
        angle_between(from_euler(degrees(90.0, 270.0, 90.0), order), from_euler(degrees(0.0, 270.0, 0.0), order));
    if (order == kPaperOrder) {
      ++holding;
    } else {
      EXPECT_GT(angle, 1.0) << static_cast<int>(order);
    }
  }
  EXPECT_EQ(holding, 1);
}

TEST(Euler, ThePapersMovementIsAQuarterTurn) {
  EXPECT_NEAR(angle_between(from_euler(degrees(0.0, 180.0, 0.0), kPaperOrder),
                            from_euler(degrees(0.0, 270.0, 0.0), kPaperOrder)),
              kPi / 2.0, 1e-15);
}

}  // namespace
}  // namespace auslan
