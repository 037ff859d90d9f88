// SPDX-License-Identifier: Apache-2.0
// From a mesh to triangle records: transform and light the vertices, refuse what is broken, cull, cut, project.
#include "clip.h"
#include "frame.h"
#include "raster/srgb.h"

#include <cmath>
#include <cstddef>

namespace auslan::raster {
namespace {

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool finite(const glm::mat4& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

// a * b in double, one fixed order, rounded to float once per element.
glm::dmat4 product(const glm::dmat4& a, const glm::dmat4& b) {
  glm::dmat4 result(0.0);
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      double sum = a[0][row] * b[column][0];
      sum = sum + a[1][row] * b[column][1];
      sum = sum + a[2][row] * b[column][2];
      sum = sum + a[3][row] * b[column][3];
      result[column][row] = sum;
    }
  }
  return result;
}

// The matrices of one draw.
struct Placement {
  glm::mat4 clip_from_mesh{0.0F};
  glm::vec3 normal_columns[3] = {};  ///< world normal = sum of column * component, any length
  bool mirrored = false;
};

// Normals turn with the cofactor matrix, which is right for every scale and shear and needs no inverse.
Placement place(const Camera& camera, const glm::mat4& world_from_mesh) {
  glm::dmat4 world(world_from_mesh);
  for (int column = 0; column < 4; ++column)
    world[column][3] = column == 3 ? 1.0 : 0.0;
  Placement placement;
  placement.clip_from_mesh =
      glm::mat4(product(product(glm::dmat4(camera.clip_from_view), glm::dmat4(camera.view_from_world)), world));

  double cofactor[3][3] = {};
  double size = 0.0;
  for (int c = 0; c < 3; ++c) {
    const int c1 = (c + 1) % 3;
    const int c2 = (c + 2) % 3;
    for (int r = 0; r < 3; ++r) {
      const int r1 = (r + 1) % 3;
      const int r2 = (r + 2) % 3;
      cofactor[c][r] = world[c1][r1] * world[c2][r2] - world[c1][r2] * world[c2][r1];
      size = std::abs(cofactor[c][r]) > size ? std::abs(cofactor[c][r]) : size;
    }
  }
  const double determinant =
      (world[0][0] * cofactor[0][0] + world[0][1] * cofactor[0][1]) + world[0][2] * cofactor[0][2];
  placement.mirrored = determinant < 0.0;
  const double scale = (placement.mirrored ? -1.0 : 1.0) / (size > 0.0 ? size : 1.0);
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r)
      placement.normal_columns[c][r] = static_cast<float>(cofactor[c][r] * scale);
  }
  return placement;
}

glm::vec3 world_normal(const Placement& placement, const glm::vec3& normal) {
  const glm::vec3 n = unit_or_zero(normal);
  glm::vec3 world(0.0F);
  for (int r = 0; r < 3; ++r) {
    world[r] = (placement.normal_columns[0][r] * n.x + placement.normal_columns[1][r] * n.y) +
               placement.normal_columns[2][r] * n.z;
  }
  return unit_or_zero(world);
}

uint32_t planes_outside(const Viewport& viewport, const DrawVertex& v) {
  const float guard_x = viewport.guard_x * v.w;
  const float guard_y = viewport.guard_y * v.w;
  if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(guard_x) &&
        std::isfinite(guard_y))) {
    return kBroken;
  }
  uint32_t planes = 0;
  if (v.x < -v.w) planes |= kOutLeft;
  if (v.x > v.w) planes |= kOutRight;
  if (v.y < -v.w) planes |= kOutBottom;
  if (v.y > v.w) planes |= kOutTop;
  if (v.z > v.w) planes |= kOutNear;
  if (v.z < 0.0F) planes |= kOutFar;
  if (v.x < -guard_x) planes |= kOutGuardLeft;
  if (v.x > guard_x) planes |= kOutGuardRight;
  if (v.y < -guard_y) planes |= kOutGuardBottom;
  if (v.y > guard_y) planes |= kOutGuardTop;
  return planes;
}

float transform_row(const glm::mat4& m, int row, const glm::vec3& p) {
  return ((m[0][row] * p.x + m[1][row] * p.y) + m[2][row] * p.z) + m[3][row];
}

// Everything that one draw needs while it walks its triangles.
struct Draw {
  Frame& frame;
  const MeshView& mesh;
  Placement placement;
  CullMode cull;
  uint32_t first_vertex;  ///< screen vertex of the mesh's position 0
};

void transform_vertices(const Draw& draw, Shading shading) {
  Frame& frame = draw.frame;
  const size_t count = draw.mesh.positions.size();
  frame.draw_vertices.resize(count);
  frame.vertices.resize(draw.first_vertex + count);
  for (size_t i = 0; i < count; ++i) {
    const glm::vec3& position = draw.mesh.positions[i];
    DrawVertex& v = frame.draw_vertices[i];
    ScreenVertex& screen = frame.vertices[draw.first_vertex + i];
    v.x = transform_row(draw.placement.clip_from_mesh, 0, position);
    v.y = transform_row(draw.placement.clip_from_mesh, 1, position);
    v.z = transform_row(draw.placement.clip_from_mesh, 2, position);
    v.w = transform_row(draw.placement.clip_from_mesh, 3, position);
    v.planes = planes_outside(frame.viewport, v);
    screen = ScreenVertex{};
    if (!finite(position)) v.planes = kBroken;
    if ((v.planes & (kBroken | kCutBits)) == 0U && !project(frame.viewport, v.x, v.y, v.z, v.w, screen)) {
      v.planes = kBroken;
    }
    if (shading == Shading::kFlat) continue;
    const glm::vec3& normal = draw.mesh.normals[i];
    if (!finite(normal)) {
      v.planes = kBroken;
      continue;
    }
    const glm::vec3 light = received_light(frame.lights, world_normal(draw.placement, normal));
    const glm::u8vec4& colour = draw.mesh.colours[i];
    for (int channel = 0; channel < 3; ++channel) {
      screen.level[channel] = srgb_level_from_linear(light[channel] * linear_from_srgb(colour[channel]));
    }
  }
}

// One colour for a face: its own normal, and the mean of its vertices' surface colours in linear light.
uint32_t flat_colour(const Draw& draw, const uint32_t corner[3]) {
  const glm::vec3& a = draw.mesh.positions[corner[0]];
  const glm::vec3& b = draw.mesh.positions[corner[1]];
  const glm::vec3& c = draw.mesh.positions[corner[2]];
  const double ux = static_cast<double>(b.x) - static_cast<double>(a.x);
  const double uy = static_cast<double>(b.y) - static_cast<double>(a.y);
  const double uz = static_cast<double>(b.z) - static_cast<double>(a.z);
  const double vx = static_cast<double>(c.x) - static_cast<double>(a.x);
  const double vy = static_cast<double>(c.y) - static_cast<double>(a.y);
  const double vz = static_cast<double>(c.z) - static_cast<double>(a.z);
  const double nx = uy * vz - uz * vy;
  const double ny = uz * vx - ux * vz;
  const double nz = ux * vy - uy * vx;
  const double length = std::sqrt((nx * nx + ny * ny) + nz * nz);
  const double scale = std::isfinite(length) && length > 0.0 ? 1.0 / length : 0.0;
  const glm::vec3 normal =
      scale > 0.0 && std::isfinite(scale)
          ? glm::vec3(static_cast<float>(nx * scale), static_cast<float>(ny * scale), static_cast<float>(nz * scale))
          : glm::vec3(0.0F);
  const glm::vec3 light = received_light(draw.frame.lights, world_normal(draw.placement, normal));
  uint32_t pixel = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const float sum = (linear_from_srgb(draw.mesh.colours[corner[0]][channel]) +
                       linear_from_srgb(draw.mesh.colours[corner[1]][channel])) +
                      linear_from_srgb(draw.mesh.colours[corner[2]][channel]);
    const float level = srgb_level_from_linear(light[channel] * (sum / 3.0F));
    pixel = (pixel << 8U) | static_cast<uint32_t>(level + 0.5F);
  }
  return pixel;
}

int32_t least(int32_t a, int32_t b, int32_t c) {
  const int32_t ab = a < b ? a : b;
  return ab < c ? ab : c;
}

int32_t greatest(int32_t a, int32_t b, int32_t c) {
  const int32_t ab = a > b ? a : b;
  return ab > c ? ab : c;
}

// Twice the area on the screen in square sub-pixels; positive when clockwise with y down.
int64_t doubled_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  return static_cast<int64_t>(b.x - a.x) * static_cast<int64_t>(c.y - a.y) -
         static_cast<int64_t>(c.x - a.x) * static_cast<int64_t>(b.y - a.y);
}

// Records a projected triangle. False when it is culled.
bool record(const Draw& draw, uint32_t i0, uint32_t i1, uint32_t i2, uint32_t colour) {
  Frame& frame = draw.frame;
  // Counter-clockwise in the world, y up, is a negative area on the screen, y down.
  if (!draw.placement.mirrored) {
    const uint32_t swap = i1;
    i1 = i2;
    i2 = swap;
  }
  const ScreenVertex& a = frame.vertices[i0];
  const ScreenVertex& b = frame.vertices[i1];
  const ScreenVertex& c = frame.vertices[i2];
  const int64_t area = doubled_area(a, b, c);
  if (area == 0 || (area < 0 && draw.cull == CullMode::kBack)) return false;
  // A pixel's samples lie within half a pixel of its centre, so these bounds leave none out.
  const int32_t first_row = least(a.y, b.y, c.y) >> kSubPixelBits;
  const int32_t last_row = greatest(a.y, b.y, c.y) >> kSubPixelBits;
  const int32_t first_column = least(a.x, b.x, c.x) >> kSubPixelBits;
  const int32_t last_column = greatest(a.x, b.x, c.x) >> kSubPixelBits;
  if (last_row < 0 || last_column < 0 || first_row >= frame.viewport.height || first_column >= frame.viewport.width) {
    return false;
  }
  TriangleRecord triangle;
  triangle.vertex[0] = i0;
  triangle.vertex[1] = area > 0 ? i1 : i2;
  triangle.vertex[2] = area > 0 ? i2 : i1;
  triangle.flat_colour = colour;
  triangle.first_row = static_cast<int16_t>(first_row > 0 ? first_row : 0);
  triangle.last_row = static_cast<int16_t>(last_row < frame.viewport.height ? last_row : frame.viewport.height - 1);
  frame.triangles.push_back(triangle);
  return true;
}

enum class Fate { kRejected, kCulled, kDrawn };

// Cuts a triangle, projects what is left and records it as a fan.
Fate draw_cut(const Draw& draw, const uint32_t corner[3], uint32_t colour) {
  Frame& frame = draw.frame;
  ClipPolygon polygon;
  polygon.count = 3;
  for (size_t i = 0; i < 3; ++i) {
    const DrawVertex& v = frame.draw_vertices[corner[i]];
    const ScreenVertex& screen = frame.vertices[draw.first_vertex + corner[i]];
    ClipVertex& to = polygon.corner[i];
    to.x = static_cast<double>(v.x);
    to.y = static_cast<double>(v.y);
    to.z = static_cast<double>(v.z);
    to.w = static_cast<double>(v.w);
    for (int channel = 0; channel < 3; ++channel)
      to.level[channel] = static_cast<double>(screen.level[channel]);
  }
  clip(polygon, frame.viewport);
  if (polygon.count < 3) return Fate::kCulled;

  const auto first = static_cast<uint32_t>(frame.vertices.size());
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& v = polygon.corner[static_cast<size_t>(i)];
    ScreenVertex screen;
    if (!project(frame.viewport, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
                 static_cast<float>(v.w), screen)) {
      frame.vertices.resize(first);
      return Fate::kRejected;
    }
    for (int channel = 0; channel < 3; ++channel)
      screen.level[channel] = static_cast<float>(v.level[channel]);
    frame.vertices.push_back(screen);
  }
  bool any = false;
  for (int i = 2; i < polygon.count; ++i) {
    const uint32_t second = first + static_cast<uint32_t>(i) - 1U;
    if (record(draw, first, second, second + 1U, colour)) any = true;
  }
  return any ? Fate::kDrawn : Fate::kCulled;
}

Fate draw_triangle(const Draw& draw, Shading shading, const uint32_t corner[3], bool& cut) {
  const Frame& frame = draw.frame;
  const size_t count = frame.draw_vertices.size();
  if (corner[0] >= count || corner[1] >= count || corner[2] >= count) return Fate::kRejected;
  const uint32_t p0 = frame.draw_vertices[corner[0]].planes;
  const uint32_t p1 = frame.draw_vertices[corner[1]].planes;
  const uint32_t p2 = frame.draw_vertices[corner[2]].planes;
  if (((p0 | p1 | p2) & kBroken) != 0U) return Fate::kRejected;
  if ((p0 & p1 & p2 & kInvisibleBits) != 0U) return Fate::kCulled;
  const uint32_t colour = shading == Shading::kFlat ? flat_colour(draw, corner) : kGouraudColour;
  if (((p0 | p1 | p2) & kCutBits) != 0U) {
    cut = true;
    return draw_cut(draw, corner, colour);
  }
  const bool drawn =
      record(draw, draw.first_vertex + corner[0], draw.first_vertex + corner[1], draw.first_vertex + corner[2], colour);
  return drawn ? Fate::kDrawn : Fate::kCulled;
}

}  // namespace

Viewport make_viewport(int width, int height) noexcept {
  Viewport viewport;
  viewport.width = width;
  viewport.height = height;
  viewport.half_x = static_cast<float>(width * (kSubPixels / 2));
  viewport.half_y = static_cast<float>(height * (kSubPixels / 2));
  while (viewport.half_x * viewport.guard_x * 2.0F <= kGuardBand)
    viewport.guard_x *= 2.0F;
  while (viewport.half_y * viewport.guard_y * 2.0F <= kGuardBand)
    viewport.guard_y *= 2.0F;
  return viewport;
}

bool project(const Viewport& viewport, float x, float y, float z, float w, ScreenVertex& out) noexcept {
  const float inverse_w = 1.0F / w;
  const float from_centre_x = (x * inverse_w) * viewport.half_x;
  const float from_centre_y = (y * inverse_w) * viewport.half_y;
  const float depth = z * inverse_w;
  const float limit = kGuardBand + 256.0F;
  const bool inside = inverse_w > 0.0F && std::isfinite(inverse_w) && from_centre_x >= -limit &&
                      from_centre_x <= limit && from_centre_y >= -limit && from_centre_y <= limit && depth >= -1.0F &&
                      depth <= 2.0F;
  if (!inside) return false;
  // Adding 1.5 * 2^23 leaves no bits below 1, so the sum is rounded to nearest even by the addition itself.
  const float rounder = 12582912.0F;
  out.x = static_cast<int32_t>((from_centre_x + rounder) - rounder) + viewport.width * (kSubPixels / 2);
  out.y = static_cast<int32_t>((rounder - from_centre_y) - rounder) + viewport.height * (kSubPixels / 2);
  out.depth = depth;
  out.inverse_w = inverse_w;
  return true;
}

void draw_mesh(Frame& frame, const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull) {
  const size_t whole = mesh.indices.size() / 3;
  const size_t left_over = mesh.indices.size() % 3 != 0 ? 1 : 0;
  frame.stats.submitted += whole + left_over;
  frame.stats.rejected += left_over;

  const size_t count = mesh.positions.size();
  const bool normals_fit = mesh.normals.size() == count || (shading == Shading::kFlat && mesh.normals.empty());
  // Vertex and triangle numbers are 32 bits wide; a cut triangle adds at most 9 vertices.
  const uint64_t vertices_after = uint64_t{frame.vertices.size()} + count + 9U * uint64_t{whole};
  if (!normals_fit || mesh.colours.size() != count || !finite(world_from_mesh) ||
      !finite(frame.camera.clip_from_view) || !finite(frame.camera.view_from_world) || vertices_after > 0xFFFFFFFFU) {
    frame.stats.rejected += whole;
    return;
  }
  if (whole == 0) return;

  const Draw draw{frame, mesh, place(frame.camera, world_from_mesh), cull,
                  static_cast<uint32_t>(frame.vertices.size())};
  transform_vertices(draw, shading);
  for (size_t i = 0; i < whole; ++i) {
    const uint32_t corner[3] = {mesh.indices[3 * i], mesh.indices[3 * i + 1], mesh.indices[3 * i + 2]};
    bool cut = false;
    const Fate fate = draw_triangle(draw, shading, corner, cut);
    if (fate == Fate::kRejected) ++frame.stats.rejected;
    if (fate == Fate::kCulled) ++frame.stats.culled;
    if (fate == Fate::kDrawn) ++frame.stats.drawn;
    if (cut && fate != Fate::kRejected) ++frame.stats.clipped;
  }
}

}  // namespace auslan::raster
