// SPDX-License-Identifier: Apache-2.0
// The software triangle rasteriser: lit triangle meshes in, sRGB pixels out, the same bytes everywhere.
//
// Coverage follows the Direct3D 11 / Vulkan rules exactly: vertices snap to 1/256 pixel (nearest, ties to even), edge
// functions are integers, pixel centres lie at half-integers, a sample on an edge belongs to the triangle only if the
// edge is a top or a left one. On the screen x runs right and y runs down. Multisampling: Direct3D's standard sample
// positions; coverage and depth per sample, colour once a pixel (at its centre, held within the range of the triangle's
// three vertices), averaged over the samples in LINEAR light. Colour: lit per vertex (Gouraud) or per face (flat) in
// linear light, encoded to sRGB levels, and interpolated in the ENCODED space; in perspective wherever the affine
// shortcut could be off by more than 1/8 of a level. Depth: reversed (camera.h), nearer wins, at equal depth the
// triangle drawn first stays.
#pragma once

#include "raster/camera.h"
#include "raster/image.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace auslan::raster {

/// An indexed triangle mesh, read during the call of draw only. Triangles wind counter-clockwise seen from outside.
struct MeshView {
  std::span<const glm::vec3> positions;  ///< mesh space
  std::span<const glm::vec3> normals;    ///< one per position, any length above 0; may be empty with Shading::kFlat
  std::span<const glm::u8vec4> colours;  ///< one per position: sRGB-encoded red, green, blue; alpha is ignored
  std::span<const uint32_t> indices;     ///< three per triangle, each below positions.size()
};

/// Two directional lights and a hemisphere. Colours are linear light (1 is full), directions point towards the light in
/// world space at any length. A direction of length 0 and everything that is not finite or is negative counts as dark.
struct Lighting {
  glm::vec3 key_direction{0.0F, 0.0F, 1.0F};
  glm::vec3 key_colour{0.0F};
  glm::vec3 fill_direction{0.0F, 0.0F, 1.0F};
  glm::vec3 fill_colour{0.0F};
  glm::vec3 ambient_sky{1.0F};     ///< what a surface that faces up (+Y) receives
  glm::vec3 ambient_ground{1.0F};  ///< what a surface that faces down receives; linear in the normal's y between them
};

enum class Shading { kFlat, kGouraud };
enum class CullMode { kBack, kNone };  ///< kNone draws back faces too, lit as their front

/// What became of the triangles since begin_frame. submitted == rejected + culled + drawn.
struct DrawStats {
  uint64_t submitted = 0;
  uint64_t rejected = 0;  ///< hostile: an index out of range, a number that is not finite, arrays of other lengths
  uint64_t culled = 0;    ///< outside the view, facing away, or without area on the 1/256 pixel grid
  uint64_t drawn = 0;     ///< went on to be filled
  uint64_t clipped = 0;   ///< those of `culled` and `drawn` that crossed a clip plane and were cut
};

enum class [[nodiscard]] Status{
    kOk,
    kBadSize,     ///< a width or height outside 1..kMaxImageSize, or a pixel span that is not width * height long
    kBadSamples,  ///< samples other than 1, 2, 4, 8
    kNoFrame,     ///< end_frame without a begin_frame that succeeded
};

/// Draws frames: begin_frame, then any number of set_camera, set_lighting, draw, then end_frame.
/// Owns its working memory and keeps it from frame to frame: after the first frame of a kind nothing is allocated.
/// One object belongs to one thread at a time; objects are independent.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Starts a frame and forgets the triangles and stats of the last one; camera and lighting stay as they were set.
  /// Sizes in pixels; `samples` per pixel; `background` as image.h has pixels (its top byte is dropped).
  Status begin_frame(int width, int height, int samples, uint32_t background);

  /// For the draws that follow. A camera with a number that is not finite makes them rejected.
  void set_camera(const Camera& camera) noexcept;
  void set_lighting(const Lighting& lighting) noexcept;

  /// Adds a mesh, placed by an affine `world_from_mesh` (its bottom row is ignored). A placement that mirrors (negative
  /// determinant) keeps outside outside.
  /// Any input is safe: the whole draw is rejected when array lengths disagree or a matrix is not finite, a triangle is
  /// rejected whole when one of its indices is out of range or one of its vertices not finite; one or two indices left
  /// over at the end count as one rejected triangle. Outside a frame it does nothing.
  void draw(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull = CullMode::kBack);

  /// Fills the triangles in the order of their draws and writes every pixel of `pixels` (width * height long). The
  /// frame is over then; after kBadSize it is still open.
  Status end_frame(std::span<uint32_t> pixels);

  const DrawStats& stats() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace auslan::raster
