// SPDX-License-Identifier: Apache-2.0
// The head, shaped in a space of its own: millimetres of a mean head (ANSUR II), origin between the eyes' level and the
// middle of the skull, Y up, Z forward. A table's head is that one stretched.
#pragma once

#include "sculpt/measurements.h"
#include "shape.h"

namespace auslan::sculpt {

struct HeadSpace {
  double eye_x = 31.45;  ///< centre of the left eye, in head space
  Vec3 stretch{1.0};     ///< breadth, height above the eyes, length: table over mean
  double stretch_down = 1.0;
};
HeadSpace head_space(const Measurements& table);
/// A point of head space in the frame of head_base, millimetres.
Vec3 place(const HeadSpace& space, const Vec3& point);

inline constexpr double kEyeZ = 66.0;  ///< centre of the eyeball
inline constexpr double kEyeRadius = 13.0;
inline constexpr double kLidRadius = 14.1;  ///< the ball that the lids lie on
inline constexpr double kEyeHalfWidth = 15.0;
inline constexpr double kMouthY = -67.6;
inline constexpr double kMouthHalfWidth = 26.0;

/// The skin of skull and face with closed lips and without an opening for the eyes; ears are parts of their own.
Field head_field(const HeadSpace& space);

/// 1 in the middle of the eye's opening, falling to 0 at its corners and beyond; x >= 0.
double eye_bulge(const HeadSpace& space, double x);
/// Where the lids' edges are at rest.
double upper_lid(const HeadSpace& space, double x);
double lower_lid(const HeadSpace& space, double x);
/// 1 in the middle of the mouth, 0 at its corners and beyond.
double mouth_bulge(double x);

/// One closed surface with slits for eyes and mouth, each a pocket.
void append_skin(Shape& shape, const HeadSpace& space, const Measurements& table);
void append_eyes(Shape& shape, const HeadSpace& space, const Measurements& table);
void append_brows(Shape& shape, const HeadSpace& space, const Measurements& table);
void append_ears(Shape& shape, const HeadSpace& space, const Measurements& table);
void append_hair(Shape& shape, const HeadSpace& space, const Measurements& table);
void append_mouth_parts(Shape& shape);

/// The columns of skin and hair: where their rays start and where they point, seen from above.
struct HeadColumn {
  double origin_x = 0.0;
  double turn_deg = 0.0;  ///< 0 forward, 180 back
};
inline constexpr int kHeadHalfColumns = 23;
HeadColumn head_column(const HeadSpace& space, int column);

/// Where a face channel at weight 1 brings each vertex of the shape, as displacements in head space.
std::vector<Vec3> channel_displacement(const Shape& shape, const HeadSpace& space, FaceChannel channel);

}  // namespace auslan::sculpt
