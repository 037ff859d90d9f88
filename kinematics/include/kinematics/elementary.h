// SPDX-License-Identifier: Apache-2.0
// The elementary functions of the path from sign to pixel. The C library's change their last bits with the processor
// and the version; these use only operations that IEEE 754 defines exactly, in one fixed order, so that every machine
// gives the same bits. Arguments are radians where they are angles. All are total: none traps, sets errno or throws.
#pragma once

namespace auslan {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180.0;  ///< radians in a degree

/// Within 4e-16 of the sine for |x| <= 1e6; 0 beyond that and for what is not finite.
double sine(double x);
/// As sine(); 1 beyond 1e6 and for what is not finite.
double cosine(double x);
/// Both at the price of little more than one.
void sine_cosine(double x, double& s, double& c);

/// The angle of the point (x, y), in [-pi, pi], within 1e-15. The sign of a zero is ignored: (0, negative) gives pi and
/// (0, 0) gives 0.
double arc_tangent(double y, double x);
/// In [0, pi], within 1e-15 of that of x; x is clamped to [-1, 1].
double arc_cosine(double x);
/// In [-pi/2, pi/2], within 1e-15 of that of x; x is clamped to [-1, 1].
double arc_sine(double x);

/// e^x within 1e-15 relative; 0 below -708, infinity above 709.78.
double exponential(double x);
/// The natural logarithm of a positive normal x, within 1e-15 * max(1, |log x|). -infinity for x <= 0.
double logarithm(double x);
/// x^y for x > 0, within (2 + |y log x|) * 1e-15 relative. 0 for x <= 0.
double power(double x, double y);

}  // namespace auslan
