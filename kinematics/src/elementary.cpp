// SPDX-License-Identifier: Apache-2.0
// Argument reduction, then a Taylor polynomial on an interval short enough that the first term left out is below the
// rounding of the result. Taylor rather than minimax: the coefficients can be checked by eye, and the few operations
// more are nowhere near the cost of a frame.
#include "kinematics/elementary.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace auslan {
namespace {

// Sums of 33, 33 and 53 bits (Cody & Waite): a multiple of up to 2^20 times the first two is exact.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kLn2High = 0x1.62e42feep-1;  // 32 bits, so that a multiple below 2^11 is exact
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kTrigonometricBound = 1e6;

constexpr double inverse_factorial(int n) {
  double product = 1.0;
  for (int i = 2; i <= n; ++i)
    product *= i;
  return 1.0 / product;
}

// For |r| <= pi/4 the first term left out is below 1e-19.
double sine_kernel(double r) {
  const double r2 = r * r;
  double sum = 0.0;
  for (int n = 17; n >= 3; n -= 2) {
    static constexpr std::array<double, 8> kTerms = {
        -inverse_factorial(3),  inverse_factorial(5),  -inverse_factorial(7),  inverse_factorial(9),
        -inverse_factorial(11), inverse_factorial(13), -inverse_factorial(15), inverse_factorial(17)};
    sum = sum * r2 + kTerms[static_cast<size_t>((n - 3) / 2)];
  }
  return r + r * (r2 * sum);
}

double cosine_kernel(double r) {
  const double r2 = r * r;
  double sum = 0.0;
  for (int n = 18; n >= 4; n -= 2) {
    static constexpr std::array<double, 8> kTerms = {
        inverse_factorial(4),  -inverse_factorial(6),  inverse_factorial(8),  -inverse_factorial(10),
        inverse_factorial(12), -inverse_factorial(14), inverse_factorial(16), -inverse_factorial(18)};
    sum = sum * r2 + kTerms[static_cast<size_t>((n - 4) / 2)];
  }
  return 1.0 - (0.5 * r2 - r2 * r2 * sum);
}

// For |t| <= 1/8 the first term left out is below 1e-18.
double arc_tangent_kernel(double t) {
  const double t2 = t * t;
  double sum = 0.0;
  for (int n = 17; n >= 3; n -= 2)
    sum = sum * t2 + ((n % 4 == 1) ? 1.0 : -1.0) / n;
  return t + t * (t2 * sum);
}

// For t in [0, 1]: the nearest quarter is taken off by the addition theorem.
double arc_tangent_unit(double t) {
  static constexpr std::array<double, 5> kOfQuarters = {0.0, 0.24497866312686415417, 0.46364760900080611621,
                                                        0.64350110879328438680, 0.78539816339744830962};
  const int quarter = static_cast<int>(4.0 * t + 0.5);
  const double c = 0.25 * quarter;
  return kOfQuarters[static_cast<size_t>(quarter)] + arc_tangent_kernel((t - c) / (1.0 + t * c));
}

}  // namespace

void sine_cosine(double x, double& s, double& c) {
  if (!(x >= -kTrigonometricBound && x <= kTrigonometricBound)) {
    s = 0.0;
    c = 1.0;
    return;
  }
  const auto quadrant = static_cast<int64_t>(x * (2.0 / kPi) + (x < 0.0 ? -0.5 : 0.5));
  const auto k = static_cast<double>(quadrant);
  const double r = ((x - k * kHalfPi1) - k * kHalfPi2) - k * kHalfPi3;
  const double sr = sine_kernel(r);
  const double cr = cosine_kernel(r);
  switch (static_cast<uint64_t>(quadrant) & 3U) {
    case 0:
      s = sr;
      c = cr;
      break;
    case 1:
      s = cr;
      c = -sr;
      break;
    case 2:
      s = -sr;
      c = -cr;
      break;
    default:
      s = -cr;
      c = sr;
      break;
  }
}

double sine(double x) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(x, s, c);
  return s;
}

double cosine(double x) {
  double s = 0.0;
  double c = 0.0;
  sine_cosine(x, s, c);
  return c;
}

double arc_tangent(double y, double x) {
  const double ax = x < 0.0 ? -x : x;
  const double ay = y < 0.0 ? -y : y;
  double angle = 0.0;
  if (ay <= ax) {
    if (ax > 0.0) angle = arc_tangent_unit(ax <= std::numeric_limits<double>::max() ? ay / ax : (ay < ax ? 0.0 : 1.0));
  } else if (ay > ax) {
    angle = kPi / 2.0 - arc_tangent_unit(ax / ay);
  }
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

double arc_cosine(double x) {
  if (x >= 1.0) return 0.0;
  if (x <= -1.0) return kPi;
  return arc_tangent(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

double arc_sine(double x) {
  if (x >= 1.0) return kPi / 2.0;
  if (x <= -1.0) return -kPi / 2.0;
  return arc_tangent(x, std::sqrt((1.0 - x) * (1.0 + x)));
}

double exponential(double x) {
  if (!(x >= -708.0)) return 0.0;
  if (x > 709.78) return std::numeric_limits<double>::infinity();
  const auto exponent = static_cast<int64_t>(x * 1.4426950408889634074 + (x < 0.0 ? -0.5 : 0.5));
  const auto k = static_cast<double>(exponent);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  double sum = 0.0;
  for (int n = 13; n >= 2; --n) {
    static constexpr std::array<double, 12> kTerms = {
        inverse_factorial(2),  inverse_factorial(3),  inverse_factorial(4),  inverse_factorial(5),
        inverse_factorial(6),  inverse_factorial(7),  inverse_factorial(8),  inverse_factorial(9),
        inverse_factorial(10), inverse_factorial(11), inverse_factorial(12), inverse_factorial(13)};
    sum = sum * r + kTerms[static_cast<size_t>(n - 2)];
  }
  const double mantissa = 1.0 + (r + r * r * sum);
  // In two factors: 2^1024, which the largest results need, is not a number of the format.
  const int64_t half = exponent / 2;
  const auto power_of_two = [](int64_t e) { return std::bit_cast<double>(static_cast<uint64_t>(e + 1023) << 52U); };
  return mantissa * power_of_two(half) * power_of_two(exponent - half);
}

double logarithm(double x) {
  if (!(x > 0.0)) return -std::numeric_limits<double>::infinity();
  const auto bits = std::bit_cast<uint64_t>(x);
  auto exponent = static_cast<int64_t>(bits >> 52U) - 1023;
  if (exponent == 1024) return x;
  double m = std::bit_cast<double>((bits & 0x000fffffffffffffU) | 0x3ff0000000000000U);
  if (m > 1.4142135623730950488) {
    m *= 0.5;
    ++exponent;
  }
  // log m = 2 artanh(s), |s| <= 0.1716: the first term left out is below 1e-18 of the sum.
  const double s = (m - 1.0) / (m + 1.0);
  const double s2 = s * s;
  double sum = 0.0;
  for (int n = 21; n >= 3; n -= 2)
    sum = sum * s2 + 1.0 / n;
  const auto k = static_cast<double>(exponent);
  return k * kLn2High + (2.0 * s + (2.0 * s * (s2 * sum) + k * kLn2Low));
}

double power(double x, double y) {
  return x > 0.0 ? exponential(y * logarithm(x)) : 0.0;
}

}  // namespace auslan
