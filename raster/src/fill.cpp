// SPDX-License-Identifier: Apache-2.0
// Coverage by integer edge functions (Pineda 1988), depth and colour by plane equations.
#include "fill.h"

#include <array>
#include <cstddef>

namespace auslan::raster {
namespace {

struct SampleOffset {
  int32_t x, y;  ///< from the pixel centre, sub-pixels, y down
};

// Direct3D 11's standard patterns, given there in 1/16 pixel.
template <size_t kSamples>
constexpr std::array<SampleOffset, kSamples> sample_offsets() {
  constexpr int32_t k16th = kSubPixels / 16;
  std::array<SampleOffset, kSamples> offsets{};
  if constexpr (kSamples == 2) offsets = {{{4, 4}, {-4, -4}}};
  if constexpr (kSamples == 4) offsets = {{{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}};
  if constexpr (kSamples == 8) offsets = {{{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}};
  for (SampleOffset& offset : offsets) {
    offset.x *= k16th;
    offset.y *= k16th;
  }
  return offsets;
}

// a * x + b * y + c over sub-pixel positions; not negative inside. The top-left rule is folded into c: a point exactly
// on an edge that is neither top nor left falls short by one.
struct Edge {
  int64_t a = 0, b = 0, c = 0;
};

Edge make_edge(const ScreenVertex& from, const ScreenVertex& to) {
  const int64_t dx = int64_t{to.x} - int64_t{from.x};
  const int64_t dy = int64_t{to.y} - int64_t{from.y};
  Edge edge;
  edge.a = -dy;
  edge.b = dx;
  edge.c = dy * int64_t{from.x} - dx * int64_t{from.y};
  // Clockwise with y down: a left edge runs up, a top edge is level and runs right.
  const bool top_left = dy < 0 || (dy == 0 && dx > 0);
  if (!top_left) edge.c -= 1;
  return edge;
}

// A quantity that is linear over the screen, held within the range of its three corners: exact arithmetic would never
// leave that range inside the triangle, but rounding on a sliver does, and so does a pixel centre beside the triangle.
struct Plane {
  float origin = 0.0F;  ///< at the triangle's first vertex
  float per_x = 0.0F;   ///< per sub-pixel
  float per_y = 0.0F;
  float least = 0.0F;
  float greatest = 0.0F;

  float at(float dx, float dy) const {
    const float value = (origin + dy * per_y) + dx * per_x;
    const float above = value > least ? value : least;  // in this order, so that NaN becomes `least`
    return above < greatest ? above : greatest;
  }
};

// Corner differences and area of a triangle, for its planes.
struct Slopes {
  double x1, y1, x2, y2, area;
};

Plane make_plane(const Slopes& s, float v0, float v1, float v2) {
  const double d1 = static_cast<double>(v1) - static_cast<double>(v0);
  const double d2 = static_cast<double>(v2) - static_cast<double>(v0);
  Plane plane;
  plane.origin = v0;
  plane.per_x = static_cast<float>((d1 * s.y2 - d2 * s.y1) / s.area);
  plane.per_y = static_cast<float>((d2 * s.x1 - d1 * s.x2) / s.area);
  const float low = v0 < v1 ? v0 : v1;
  const float high = v0 < v1 ? v1 : v0;
  plane.least = v2 < low ? v2 : low;
  plane.greatest = v2 > high ? v2 : high;
  return plane;
}

// The colour of a triangle at a point: one pixel value, or three planes, divided by a fourth in perspective.
struct Shade {
  uint32_t flat = 0;
  bool gouraud = false;
  bool perspective = false;
  Plane level[3];
  Plane inverse_w;
  float least[3] = {};
  float greatest[3] = {};

  uint32_t at(float dx, float dy) const {
    if (!gouraud) return flat;
    uint32_t pixel = 0;
    const float divisor = perspective ? inverse_w.at(dx, dy) : 1.0F;
    for (int channel = 0; channel < 3; ++channel) {
      float value = level[channel].at(dx, dy);
      if (perspective) {
        value = value / divisor;
        value = value > least[channel] ? value : least[channel];
        value = value < greatest[channel] ? value : greatest[channel];
      }
      pixel = (pixel << 8U) | static_cast<uint32_t>(value + 0.5F);
    }
    return pixel;
  }
};

Shade make_shade(const Slopes& slopes, uint32_t flat_colour, const ScreenVertex& a, const ScreenVertex& b,
                 const ScreenVertex& c) {
  Shade shade;
  shade.flat = flat_colour;
  shade.gouraud = flat_colour == kGouraudColour;
  if (!shade.gouraud) return shade;
  float widest = 0.0F;
  for (int channel = 0; channel < 3; ++channel) {
    const Plane plane = make_plane(slopes, a.level[channel], b.level[channel], c.level[channel]);
    shade.level[channel] = plane;
    shade.least[channel] = plane.least;
    shade.greatest[channel] = plane.greatest;
    const float spread = plane.greatest - plane.least;
    widest = spread > widest ? spread : widest;
  }
  // Taking a colour that spreads over D levels as affine, with 1/w between q and Q, is off by at most
  // D * (sqrt(Q/q) - 1) / (sqrt(Q/q) + 1) < D * (Q - q) / (4 q) levels. Below 1/8 of a level that is not worth a
  // division.
  const Plane inverse_w = make_plane(slopes, a.inverse_w, b.inverse_w, c.inverse_w);
  shade.perspective = widest * (inverse_w.greatest - inverse_w.least) > 0.5F * inverse_w.least;
  if (!shade.perspective) return shade;
  // 1/w relative to the nearest corner, so that nothing overflows.
  const float qa = a.inverse_w / inverse_w.greatest;
  const float qb = b.inverse_w / inverse_w.greatest;
  const float qc = c.inverse_w / inverse_w.greatest;
  shade.inverse_w = make_plane(slopes, qa, qb, qc);
  for (int channel = 0; channel < 3; ++channel) {
    shade.level[channel] = make_plane(slopes, a.level[channel] * qa, b.level[channel] * qb, c.level[channel] * qc);
  }
  return shade;
}

int64_t floor_div(int64_t value, int64_t positive) {
  const int64_t quotient = value / positive;
  return quotient * positive > value ? quotient - 1 : quotient;
}

// Narrows [first, last], columns, to those where start + column * step >= 0.
void narrow(int64_t start, int64_t step, int64_t& first, int64_t& last) {
  if (step > 0) {
    const int64_t bound = -floor_div(start, step);
    if (bound > first) first = bound;
  } else if (step < 0) {
    const int64_t bound = floor_div(start, -step);
    if (bound < last) last = bound;
  } else if (start < 0) {
    last = first - 1;
  }
}

int32_t min3(int32_t a, int32_t b, int32_t c) {
  const int32_t ab = a < b ? a : b;
  return ab < c ? ab : c;
}

int32_t max3(int32_t a, int32_t b, int32_t c) {
  const int32_t ab = a > b ? a : b;
  return ab > c ? ab : c;
}

// Rows wider than this are narrowed by division before they are walked.
constexpr int32_t kScanWidth = 8;

template <size_t kSamples>
void fill_samples(Band& band, const TriangleRecord& triangle, std::span<const ScreenVertex> vertices) {
  static constexpr auto kOffsets = sample_offsets<kSamples>();
  static constexpr uint32_t kAll = (uint32_t{1} << kSamples) - 1U;
  const ScreenVertex& a = vertices[triangle.vertex[0]];
  const ScreenVertex& b = vertices[triangle.vertex[1]];
  const ScreenVertex& c = vertices[triangle.vertex[2]];
  const int32_t left = min3(a.x, b.x, c.x) >> kSubPixelBits;
  const int32_t right = max3(a.x, b.x, c.x) >> kSubPixelBits;
  const int32_t first_column = left > 0 ? left : 0;
  const int32_t last_column = right < band.width ? right : band.width - 1;
  const int32_t band_last = band.first_row + band.row_count - 1;
  const int32_t first_row = triangle.first_row > band.first_row ? triangle.first_row : band.first_row;
  const int32_t last_row = triangle.last_row < band_last ? triangle.last_row : band_last;

  const Edge edges[3] = {make_edge(a, b), make_edge(b, c), make_edge(c, a)};
  // How far each edge function moves from a pixel's centre to its samples.
  int64_t offset[3][kSamples];
  int64_t nearest[3];
  int64_t farthest[3];
  for (size_t e = 0; e < 3; ++e) {
    for (size_t s = 0; s < kSamples; ++s) {
      offset[e][s] = edges[e].a * int64_t{kOffsets[s].x} + edges[e].b * int64_t{kOffsets[s].y};
      if (s == 0 || offset[e][s] < nearest[e]) nearest[e] = offset[e][s];
      if (s == 0 || offset[e][s] > farthest[e]) farthest[e] = offset[e][s];
    }
  }
  const Slopes slopes = {static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y), static_cast<double>(c.x - a.x),
                         static_cast<double>(c.y - a.y),
                         static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y) -
                             static_cast<double>(c.x - a.x) * static_cast<double>(b.y - a.y)};
  const Plane depth = make_plane(slopes, a.depth, b.depth, c.depth);
  const Shade shade = make_shade(slopes, triangle.flat_colour, a, b, c);

  for (int32_t row = first_row; row <= last_row; ++row) {
    const int32_t centre_y = row * kSubPixels + kSubPixels / 2;
    int64_t at_zero[3];  // edge functions at the centre of column 0
    for (size_t e = 0; e < 3; ++e) {
      at_zero[e] = edges[e].a * int64_t{kSubPixels / 2} + edges[e].b * int64_t{centre_y} + edges[e].c;
    }
    int64_t first = first_column;
    int64_t last = last_column;
    if (last_column - first_column > kScanWidth) {
      for (size_t e = 0; e < 3; ++e)
        narrow(at_zero[e] + farthest[e], edges[e].a * kSubPixels, first, last);
    }
    int64_t value[3];
    for (size_t e = 0; e < 3; ++e)
      value[e] = at_zero[e] + edges[e].a * kSubPixels * first;

    const size_t row_start = static_cast<size_t>(row - band.first_row) * static_cast<size_t>(band.width);
    for (int64_t column = first; column <= last; ++column) {
      uint32_t covered = 0;
      if (value[0] + nearest[0] >= 0 && value[1] + nearest[1] >= 0 && value[2] + nearest[2] >= 0) {
        covered = kAll;
      } else if (value[0] + farthest[0] >= 0 && value[1] + farthest[1] >= 0 && value[2] + farthest[2] >= 0) {
        for (size_t s = 0; s < kSamples; ++s) {
          const bool inside =
              value[0] + offset[0][s] >= 0 && value[1] + offset[1][s] >= 0 && value[2] + offset[2][s] >= 0;
          if (inside) covered |= 1U << s;
        }
      }
      for (size_t e = 0; e < 3; ++e)
        value[e] += edges[e].a * kSubPixels;
      if (covered == 0U) continue;

      const int32_t centre_x = static_cast<int32_t>(column) * kSubPixels + kSubPixels / 2;
      const size_t index = (row_start + static_cast<size_t>(column)) * kSamples;
      uint32_t visible = 0;
      for (size_t s = 0; s < kSamples; ++s) {
        if ((covered >> s & 1U) == 0U) continue;
        // Differences of sub-pixel positions are exact in a float (kGuardBand).
        const float z = depth.at(static_cast<float>(centre_x + kOffsets[s].x - a.x),
                                 static_cast<float>(centre_y + kOffsets[s].y - a.y));
        if (z > band.depth[index + s]) {
          band.depth[index + s] = z;
          visible |= 1U << s;
        }
      }
      if (visible == 0U) continue;
      const uint32_t pixel = shade.at(static_cast<float>(centre_x - a.x), static_cast<float>(centre_y - a.y));
      for (size_t s = 0; s < kSamples; ++s) {
        if ((visible >> s & 1U) != 0U) band.colour[index + s] = pixel;
      }
    }
  }
}

}  // namespace

void fill(Band& band, int samples, const TriangleRecord& triangle, std::span<const ScreenVertex> vertices) noexcept {
  switch (samples) {
    case 2:
      return fill_samples<2>(band, triangle, vertices);
    case 4:
      return fill_samples<4>(band, triangle, vertices);
    case 8:
      return fill_samples<8>(band, triangle, vertices);
    default:
      return fill_samples<1>(band, triangle, vertices);
  }
}

}  // namespace auslan::raster
