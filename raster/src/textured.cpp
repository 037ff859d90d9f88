// SPDX-License-Identifier: Apache-2.0
#include "textured.h"

#include "planes.h"
#include "texture_data.h"

#include <cmath>

namespace auslan::raster {
namespace {

double held(double value) {
  constexpr double kFarthest = kFarthestCoordinate;
  return value < -kFarthest ? -kFarthest : value > kFarthest ? kFarthest : value;
}

// The even number at or below a coordinate: a whole number of periods, mirrored ones too.
double period_of(float coordinate) {
  const auto value = static_cast<double>(coordinate);
  if (!(value > -16777216.0 && value < 16777216.0)) return value;  // floats of this size are even
  const auto half = static_cast<int64_t>(value * 0.5);
  return 2.0 * static_cast<double>(static_cast<double>(half) * 2.0 > value ? half - 1 : half);
}

}  // namespace

bool finite(const glm::vec2& coordinates) noexcept {
  return std::isfinite(coordinates.x) && std::isfinite(coordinates.y);
}

bool coordinates_of(const TextureUse& use, const uint32_t corner[3], double (&out)[3][2]) noexcept {
  const Wrap wrap[2] = {use.wrap_u, use.wrap_v};
  bool good = true;
  for (int axis = 0; axis < 2; ++axis) {
    const double start = wrap[axis] == Wrap::kClamp ? 0.0 : period_of(use.coordinates[corner[0]][axis]);
    for (int i = 0; i < 3; ++i) {
      good = good && finite(use.coordinates[corner[i]]);
      out[i][axis] = held(static_cast<double>(use.coordinates[corner[i]][axis]) - start);
    }
  }
  return good;
}

void dress(const TextureUse& use, TexturedTriangle& triangle) noexcept {
  const Wrap wrap[2] = {use.wrap_u, use.wrap_v};
  triangle.texture = use.texture->data()->view();
  for (int axis = 0; axis < 2; ++axis) {
    triangle.repeats[axis] = wrap[axis] == Wrap::kRepeat;
    triangle.mirrors[axis] = wrap[axis] == Wrap::kMirroredRepeat;
  }
  triangle.cutoff = 0;
  if (use.alpha == AlphaMode::kOpaque) return;
  // Rounded as texels are, so that a texel of just the cut-off is drawn.
  const float cutoff = use.alpha_cutoff < 0.0F ? 0.0F : use.alpha_cutoff > 1.0F ? 2.0F : use.alpha_cutoff;
  triangle.cutoff = static_cast<int32_t>(cutoff * static_cast<float>(kTexelScale) + 0.5F) << kFilterBits;
}

void set_up_textured(const Corner& a, const Corner& b, const Corner& c, GeneralTriangle& t,
                     TexturedTriangle& out) noexcept {
  set_up_general(a, b, c, kStandInColour, t);
  t.perspective = true;
  const Slopes slopes = slopes_of(a, b, c);
  // 1/w relative to the nearest corner, so that nothing overflows.
  const float nearest = make_plane(slopes, a.inverse_w, b.inverse_w, c.inverse_w).greatest;
  const float qa = a.inverse_w / nearest;
  const float qb = b.inverse_w / nearest;
  const float qc = c.inverse_w / nearest;
  t.inverse_w = make_plane(slopes, qa, qb, qc);
  const auto over_w = [&](float va, float vb, float vc, Plane& plane, float& least, float& greatest) {
    plane = make_plane(slopes, va, vb, vc);
    least = plane.least;
    greatest = plane.greatest;
    plane = make_plane(slopes, va * qa, vb * qb, vc * qc);
  };
  for (int channel = 0; channel < 3; ++channel)
    over_w(a.level[channel], b.level[channel], c.level[channel], t.level[channel], t.least[channel],
           t.greatest[channel]);
  for (int axis = 0; axis < 2; ++axis)
    over_w(a.coordinate[axis], b.coordinate[axis], c.coordinate[axis], out.coordinate[axis], out.least[axis],
           out.greatest[axis]);
}

}  // namespace auslan::raster
