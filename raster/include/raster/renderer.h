// SPDX-License-Identifier: Apache-2.0
// The software triangle rasteriser: lit triangle meshes in, sRGB pixels out, the same bytes everywhere.
//
// Coverage follows the Direct3D 11 / Vulkan rules exactly: vertices snap to 1/256 pixel (nearest, ties to even), edge
// functions are integers, pixel centres lie at half-integers, a sample on an edge belongs to the triangle only if the
// edge is a top or a left one; what reaches beyond the guard band (2^21 to 2^22 sub-pixels from the middle of the
// frame) is cut there first. On the screen x runs right and y runs down. Multisampling: Direct3D's standard sample
// positions; coverage and depth per sample, colour once a pixel (at its centre, held within the range of the triangle's
// three vertices). A pixel is the root mean square of its samples' sRGB levels, per channel, rounded to nearest, a half
// up: an average of light with a display's gamma taken as 2 (README). Colour: lit per vertex (Gouraud) or per face
// (flat) in linear light, encoded to sRGB levels, and interpolated in the ENCODED space; in perspective wherever the
// affine shortcut could be off by more than 1/4 of a level; with triangles below 120 pixels fixed-point gradients
// (1/128 of a level a pixel, counted from the middle) can add another 1/4 in x and in y. Depth: reversed (camera.h),
// nearer wins, at equal depth the triangle drawn first stays.
//
// Every kernel (kernel.h) and every number of threads gives the same bytes, under the processor's default
// floating-point modes (round to nearest, no flushing of denormal numbers).
#pragma once

#include "raster/camera.h"
#include "raster/image.h"
#include "raster/kernel.h"
#include "raster/texture.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>

namespace auslan::raster {

static_assert(glm::defaultp == glm::packed_highp,
              "the arrays of a mesh are of GLM's packed types: compile without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

/// An indexed triangle mesh. What the spans show must stay as it is from the call of draw to the end of end_frame.
/// Triangles wind counter-clockwise seen from outside.
struct MeshView {
  std::span<const glm::vec3> positions;  ///< mesh space
  std::span<const glm::vec3> normals;    ///< one per position, any length above 0; may be empty with Shading::kFlat
  std::span<const glm::u8vec4> colours;  ///< one per position: sRGB-encoded red, green, blue; alpha is ignored
  std::span<const uint32_t> indices;     ///< three per triangle, each below positions.size()
  /// 0: nothing is known. Any other number is the caller's word that, drawn with the same spans and the same number in
  /// two frames that follow each other, the mesh has the same contents in both.
  uint64_t revision = 0;
  TextureUse texture{};  ///< a picture that it wears (texture.h)
};

/// Three directional lights and a hemisphere. A surface shows its colour times the sum of what it receives: of each
/// light its colour times the cosine of the angle to it (Lambert), of the hemisphere sky and ground; what exceeds 1 is
/// cut, each channel for itself. Colours are linear light (1 is full), directions point towards the light in world
/// space at any length. A direction of length 0 and everything that is not finite or is negative counts as dark.
struct Lighting {
  glm::vec3 key_direction{0.0F, 0.0F, 1.0F};
  glm::vec3 key_colour{0.0F};
  glm::vec3 fill_direction{0.0F, 0.0F, 1.0F};
  glm::vec3 fill_colour{0.0F};
  glm::vec3 rim_direction{0.0F, 0.0F, -1.0F};  ///< commonly from behind, so that it edges a figure with light
  glm::vec3 rim_colour{0.0F};
  glm::vec3 ambient_sky{1.0F};     ///< what a surface that faces up (+Y) receives
  glm::vec3 ambient_ground{1.0F};  ///< what a surface that faces down receives; linear in the normal's y between them
};

enum class Shading { kFlat, kGouraud };
enum class CullMode { kBack, kNone };  ///< kNone draws back faces too, lit as their front

/// What became of the triangles of the last frame that ended. submitted == rejected + culled + drawn. The triangles of
/// a draw that nothing asked to be drawn again (Canvas::kLastFrame) count as they did before.
struct DrawStats {
  uint64_t submitted = 0;
  uint64_t rejected = 0;  ///< hostile: an index out of range, a number that is not finite, arrays of other lengths
  uint64_t culled = 0;    ///< outside the view, facing away, or without area or a sample on the 1/256 pixel grid
  uint64_t drawn = 0;     ///< went on to be filled
  uint64_t clipped = 0;   ///< those of `culled` and `drawn` that crossed a clip plane and were cut
};

enum class [[nodiscard]] Status{
    kOk,
    kBadSize,     ///< a width or height outside 1..kMaxImageSize, or a pixel span that is not width * height long
    kBadSamples,  ///< samples other than 1, 2, 4, 8
    kBadKernel,   ///< AUSLANJAM_KERNEL, or the constructor's caller, names a kernel that does not run here
    kNoFrame,     ///< end_frame without a begin_frame that succeeded
};

/// What the pixels hold when end_frame is called.
enum class Canvas {
  kUnknown,    ///< anything: every pixel is written
  kLastFrame,  ///< the caller's word: just what this renderer's last end_frame left in them; only changes are written.
               ///< As kUnknown where the last frame had another size, sample count or background, or there was none
};

/// Pixels from (x, y) to (x + width, y + height), the latter not included.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// Where the time of the last end_frame went, wall clock, nanoseconds.
struct StageTimes {
  int64_t vertices = 0;   ///< transform and lighting
  int64_t triangles = 0;  ///< culling, cutting, sorting into tiles
  int64_t tiles = 0;      ///< set-up of what is left, coverage, depth, colour, resolve
};

inline constexpr int kMaxThreads = 32;

/// Draws frames: begin_frame, then any number of set_camera, set_lighting, draw, then end_frame, which does the work.
/// Owns its working memory and keeps it from frame to frame: after the first frame of a kind nothing is allocated.
/// One object belongs to one thread at a time; objects are independent. One that was moved from can only be assigned to
/// or destroyed. What it reports in a Status it never throws; memory that the system refuses is std::bad_alloc.
class Renderer {
 public:
  /// `threads`: how many threads share the work, the caller's among them; held within 1..kMaxThreads.
  explicit Renderer(int threads = 1);
  /// With a kernel of one's own choice instead of chosen_kernel(). One that does not run here fails in begin_frame.
  Renderer(int threads, Kernel kernel);
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
  /// Any input is safe: the whole draw is rejected when array lengths disagree, a matrix or an alpha cut-off is not
  /// finite, or the frame would come to more than 2^27 triangles or 2^30 vertices; a triangle is rejected whole when
  /// one of its indices is out of range or one of its vertices not finite, texture coordinates included; one or two
  /// indices left over at the end count as one rejected triangle. Outside a frame it does nothing.
  void draw(const MeshView& mesh, const glm::mat4& world_from_mesh, Shading shading, CullMode cull = CullMode::kBack);

  /// Draws the triangles in the order of their draws into `pixels` (width * height long). The frame is over then; after
  /// kBadSize it is still open.
  Status end_frame(std::span<uint32_t> pixels, Canvas canvas = Canvas::kUnknown);

  /// Of the last frame that ended; nothing before the first. The pixels that it wrote, as rectangles that do not
  /// overlap; valid until end_frame.
  std::span<const PixelRect> damage() const noexcept;
  const DrawStats& stats() const noexcept;
  const StageTimes& times() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace auslan::raster
