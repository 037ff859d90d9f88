// SPDX-License-Identifier: Apache-2.0
// Set-up of the long path: gradients in double precision, colours in perspective where that can be seen.
#include "planes.h"

namespace auslan::raster {
Corner corner_of(const ScreenPoint& point, const ScreenValues& values) noexcept {
  Corner corner{point.x, point.y, values.depth, values.inverse_w, {}, {}};
  for (int channel = 0; channel < 3; ++channel)
    corner.level[channel] = static_cast<float>(values.level[2 - channel]) / kLevelScale;
  return corner;
}

void set_up_general(const Corner& a, const Corner& b, const Corner& c, uint32_t colour, GeneralTriangle& out) noexcept {
  const Corner* corners[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    out.x[i] = static_cast<int32_t>(corners[i]->x);
    out.y[i] = static_cast<int32_t>(corners[i]->y);
  }
  const Slopes slopes = slopes_of(a, b, c);
  out.depth = make_plane(slopes, a.depth, b.depth, c.depth);
  out.colour = colour;
  out.perspective = false;
  if (colour != kGouraudColour) return;

  float widest = 0.0F;
  for (int channel = 0; channel < 3; ++channel) {
    const Plane plane = make_plane(slopes, a.level[channel], b.level[channel], c.level[channel]);
    out.level[channel] = plane;
    out.least[channel] = plane.least;
    out.greatest[channel] = plane.greatest;
    const float spread = plane.greatest - plane.least;
    widest = spread > widest ? spread : widest;
  }
  // The bound of the affine short cut is derived in set_up.h.
  const Plane inverse_w = make_plane(slopes, a.inverse_w, b.inverse_w, c.inverse_w);
  out.perspective = widest * (inverse_w.greatest - inverse_w.least) > 4.0F * kAffineError * inverse_w.least;
  if (!out.perspective) return;
  // 1/w relative to the nearest corner, so that nothing overflows.
  const float qa = a.inverse_w / inverse_w.greatest;
  const float qb = b.inverse_w / inverse_w.greatest;
  const float qc = c.inverse_w / inverse_w.greatest;
  out.inverse_w = make_plane(slopes, qa, qb, qc);
  for (int channel = 0; channel < 3; ++channel) {
    out.level[channel] = make_plane(slopes, a.level[channel] * qa, b.level[channel] * qb, c.level[channel] * qc);
  }
}

}  // namespace auslan::raster
