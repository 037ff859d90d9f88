// SPDX-License-Identifier: Apache-2.0
#include "kinematics/elementary.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace auslan {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// The reference is the C library in long double, 11 bits finer than what is tested.
double error(double got, long double exact) {
  return static_cast<double>(std::fabs(static_cast<long double>(got) - exact));
}

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

TEST(Elementary, SineAndCosineAreWithinTheirBound) {
  std::mt19937 random(1);
  for (const double range : {1.0, 10.0, 1e4, 1e6})
    for (int i = 0; i < 50000; ++i) {
      const double x = uniform(random, -range, range);
      ASSERT_LE(error(sine(x), std::sin(static_cast<long double>(x))), 4e-16) << x;
      ASSERT_LE(error(cosine(x), std::cos(static_cast<long double>(x))), 4e-16) << x;
    }
}

TEST(Elementary, SineIsAccurateNearMultiplesOfPi) {
  // Where reduction cancels most: sin(fl(n pi)) is the distance of that number from n pi.
  for (int n = 1; n <= 300000; n += 7) {
    const double x = n * kPi;
    ASSERT_LE(error(sine(x), std::sin(static_cast<long double>(x))), 1e-20 + 4e-16 * std::fabs(sine(x)) + 1e-19 * n)
        << n;
  }
}

TEST(Elementary, SineIsOddAndCosineEvenToTheLastBit) {
  std::mt19937 random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = uniform(random, 0.0, 100.0);
    ASSERT_EQ(sine(-x), -sine(x));
    ASSERT_EQ(cosine(-x), cosine(x));
  }
}

TEST(Elementary, SineCosineGivesBothAtOnce) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(1.25, s, c);
  EXPECT_EQ(s, sine(1.25));
  EXPECT_EQ(c, cosine(1.25));
  EXPECT_EQ(sine(0.0), 0.0);
  EXPECT_EQ(cosine(0.0), 1.0);
}

TEST(Elementary, SineAndCosineAreTotal) {
  for (const double x : {kInfinity, -kInfinity, kNan, 1e300}) {
    EXPECT_EQ(sine(x), 0.0);
    EXPECT_EQ(cosine(x), 1.0);
  }
}

TEST(Elementary, ArcTangentIsWithinItsBoundInAllQuadrants) {
  std::mt19937 random(3);
  for (int i = 0; i < 200000; ++i) {
    const double y = uniform(random, -1.0, 1.0) * (i % 3 == 0 ? 1e-6 : 1.0);
    const double x = uniform(random, -1.0, 1.0) * (i % 5 == 0 ? 1e-6 : 1.0);
    ASSERT_LE(error(arc_tangent(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))), 1e-15)
        << y << ' ' << x;
  }
}

TEST(Elementary, ArcTangentOfTheAxes) {
  EXPECT_EQ(arc_tangent(0.0, 0.0), 0.0);
  EXPECT_EQ(arc_tangent(0.0, 2.0), 0.0);
  EXPECT_EQ(arc_tangent(0.0, -2.0), kPi);
  EXPECT_EQ(arc_tangent(-0.0, -2.0), kPi);
  EXPECT_EQ(arc_tangent(3.0, 0.0), kPi / 2.0);
  EXPECT_EQ(arc_tangent(-3.0, 0.0), -kPi / 2.0);
  EXPECT_EQ(arc_tangent(1.0, kInfinity), 0.0);
  EXPECT_EQ(arc_tangent(kInfinity, 1.0), kPi / 2.0);
  EXPECT_EQ(arc_tangent(kInfinity, kInfinity), kPi / 4.0);
}

TEST(Elementary, ArcCosineAndArcSineAreWithinTheirBound) {
  std::mt19937 random(4);
  for (int i = 0; i < 100000; ++i) {
    const double x = i % 2 == 0 ? uniform(random, -1.0, 1.0) : 1.0 - uniform(random, 0.0, 1e-8);
    ASSERT_LE(error(arc_cosine(x), std::acos(static_cast<long double>(x))), 1e-15) << x;
    ASSERT_LE(error(arc_sine(x), std::asin(static_cast<long double>(x))), 1e-15) << x;
  }
  EXPECT_EQ(arc_cosine(1.5), 0.0);
  EXPECT_EQ(arc_cosine(-1.5), kPi);
  EXPECT_EQ(arc_sine(1.5), kPi / 2.0);
}

TEST(Elementary, ExponentialIsWithinItsRelativeBound) {
  std::mt19937 random(5);
  for (const double range : {1.0, 50.0, 700.0})
    for (int i = 0; i < 50000; ++i) {
      const double x = uniform(random, -range, range);
      const long double exact = std::exp(static_cast<long double>(x));
      ASSERT_LE(error(exponential(x), exact), 1e-15 * static_cast<double>(exact)) << x;
    }
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(exponential(1000.0), kInfinity);
  EXPECT_EQ(exponential(-1000.0), 0.0);
  EXPECT_TRUE(std::isfinite(exponential(709.7)));
}

TEST(Elementary, LogarithmIsWithinItsBound) {
  std::mt19937 random(6);
  for (const double range : {0.1, 5.0, 600.0})
    for (int i = 0; i < 50000; ++i) {
      const double x = std::exp(uniform(random, -range, range));
      const long double exact = std::log(static_cast<long double>(x));
      const double bound = 1e-15 * std::fmax(1.0, std::fabs(static_cast<double>(exact)));
      ASSERT_LE(error(logarithm(x), exact), bound) << x;
    }
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_EQ(logarithm(0.0), -kInfinity);
  EXPECT_EQ(logarithm(-1.0), -kInfinity);
}

TEST(Elementary, PowerIsWithinItsBound) {
  std::mt19937 random(7);
  for (int i = 0; i < 50000; ++i) {
    const double x = uniform(random, 1e-6, 100.0);
    const double y = uniform(random, -5.0, 5.0);
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    const double bound = (2.0 + std::fabs(y * std::log(x))) * 1e-15 * static_cast<double>(exact);
    ASSERT_LE(error(power(x, y), exact), bound) << x << ' ' << y;
  }
  EXPECT_EQ(power(0.0, 2.0), 0.0);
  EXPECT_NEAR(power(8.0, 1.0 / 3.0), 2.0, 1e-14);
}

}  // namespace
}  // namespace auslan
