// SPDX-License-Identifier: Apache-2.0
// What a frame holds between begin_frame and end_frame: vertices on the sub-pixel grid, and triangles that name them.
// Everything is kept from frame to frame, so that a warm renderer allocates nothing.
#pragma once

#include "lights.h"
#include "raster/renderer.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

namespace auslan::raster {

inline constexpr int kSubPixelBits = 8;
inline constexpr int kSubPixels = 1 << kSubPixelBits;
/// Vertices lie at most this far from the centre of the frame, in sub-pixels (guard band; a few more by rounding). With
/// it every coordinate difference stays below 2^23 and 256: exact in a float, and edge functions stay below 2^49.
inline constexpr float kGuardBand = 4194304.0F;

/// A projected vertex. x and y in sub-pixels from the top-left corner of the frame, y down.
struct ScreenVertex {
  int32_t x = 0;
  int32_t y = 0;
  float depth = 0.0F;      ///< z / w, 0 (far) to 1 (near)
  float inverse_w = 0.0F;  ///< 1 / w
  float level[3] = {};     ///< lit red, green, blue: sRGB levels 0 to 255, not rounded
};

/// A vertex in clip space, in double so that cutting an edge loses nothing of the floats that it came from.
struct ClipVertex {
  double x = 0.0, y = 0.0, z = 0.0, w = 0.0;
  double level[3] = {};
};

/// Three screen vertices in the order in which their area is positive (clockwise on the screen).
struct TriangleRecord {
  uint32_t vertex[3] = {};
  uint32_t flat_colour = 0;  ///< pixel, or kGouraudColour
  int16_t first_row = 0;     ///< rows of the frame that it can touch, inclusive
  int16_t last_row = 0;
};
inline constexpr uint32_t kGouraudColour = 0xFFFFFFFFU;

/// The mapping from clip space to sub-pixels.
struct Viewport {
  int width = 0;
  int height = 0;
  float half_x = 0.0F;  ///< half the width in sub-pixels
  float half_y = 0.0F;
  float guard_x = 1.0F;  ///< |x| <= guard_x * w is inside the guard band; a power of two, so that the product is exact
  float guard_y = 1.0F;
};

Viewport make_viewport(int width, int height) noexcept;

/// Projects a clip-space point that lies inside near, far and guard planes. False where the result is not finite or
/// would leave the guard band; `out` is then unspecified. Levels are not touched.
bool project(const Viewport& viewport, float x, float y, float z, float w, ScreenVertex& out) noexcept;

/// Which planes a clip-space point lies outside of.
enum PlaneBits : uint32_t {
  kOutLeft = 1U << 0U,
  kOutRight = 1U << 1U,
  kOutBottom = 1U << 2U,
  kOutTop = 1U << 3U,
  kOutNear = 1U << 4U,
  kOutFar = 1U << 5U,
  kOutGuardLeft = 1U << 6U,
  kOutGuardRight = 1U << 7U,
  kOutGuardBottom = 1U << 8U,
  kOutGuardTop = 1U << 9U,
  kBroken = 1U << 10U,  ///< not finite
};
inline constexpr uint32_t kInvisibleBits = kOutLeft | kOutRight | kOutBottom | kOutTop | kOutNear | kOutFar;
inline constexpr uint32_t kCutBits =
    kOutNear | kOutFar | kOutGuardLeft | kOutGuardRight | kOutGuardBottom | kOutGuardTop;

/// One vertex of the mesh that is being drawn.
struct DrawVertex {
  float x = 0.0F, y = 0.0F, z = 0.0F, w = 0.0F;  ///< clip space
  uint32_t planes = 0;
};

struct Frame {
  Viewport viewport;
  int samples = 1;
  uint32_t background = 0;
  bool open = false;

  Camera camera;
  PreparedLights lights = prepare(Lighting{});
  DrawStats stats;

  std::vector<ScreenVertex> vertices;
  std::vector<TriangleRecord> triangles;
  std::vector<DrawVertex> draw_vertices;  ///< of the current draw only
};

/// Renderer::draw inside an open frame.
void draw_mesh(Frame& frame, const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull);

}  // namespace auslan::raster
