// SPDX-License-Identifier: Apache-2.0
// The stage: the one place where a posed body becomes a draw list, and the draw list pixels.
#pragma once

#include "kinematics/body_model.h"
#include "kinematics/figure.h"
#include "kinematics/pose.h"
#include "kinematics/result.h"
#include "raster/renderer.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace auslan {

/// Where the viewer stands.
enum class CameraName {
  kFront,         ///< before the signer, from the waist up with room for the signing space
  kThreeQuarter,  ///< from the signer's right front
  kSide,          ///< from the signer's right
  kSigner,        ///< over the signer's own shoulder line, as the signer sees the hands
  kHands,         ///< close to the hands in front of the chest
  kFace,          ///< close to the face
};
inline constexpr std::string_view kCameraNames[] = {"front", "three-quarter", "side", "signer", "hands", "face"};
std::optional<CameraName> camera_from_name(std::string_view name);

struct StageOptions {
  int width = 1280, height = 720;  ///< pixels, 1 to 16384
  int samples = 4;                 ///< anti-aliasing: 1, 2, 4 or 8 samples a pixel
  bool flat = false;               ///< flat shading, with the rigid flat model
  bool rigid = false;              ///< rigid segments instead of joints that bend the skin
  bool shadow = true;              ///< hands and forearms throw a shadow on body and face
  bool outline = false;            ///< a dark line round every part of the body
  CameraName camera = CameraName::kFront;
  uint32_t background = 0xC9D3D9;        ///< 0x00RRGGBB
  int threads = 1;                       ///< that share the work of a frame
  std::optional<raster::Kernel> kernel;  ///< nothing: raster::chosen_kernel(); a stage that was built names its own
};

/// The camera and the light of every stage, for what draws a figure without one (the benchmark). `aspect`: width over
/// height.
raster::Camera stage_camera(const Figure& figure, CameraName name, float aspect);
raster::Lighting stage_lighting();

class ArmShadow;
class Outline;

/// Images of a figure, by the number that PosedMesh::image names.
using Textures = std::span<const std::optional<raster::Texture>>;

/// Draws one figure. Owns a renderer and a model, so one thread at a time; any number of stages can share a figure.
class Stage {
 public:
  /// The figure must outlive the stage. kUsage for sizes, sample counts or kernels that the rasteriser does not take.
  static Result<Stage> build(const Figure& figure, const StageOptions& options);
  /// The same with a model of the caller's that the figure's skeleton moves, in place of those that the options name,
  /// and the images that its meshes name; they outlive the stage. Meshes whose image is not there show their colours,
  /// or nothing where it would cut them out.
  static Result<Stage> build(const Figure& figure, std::unique_ptr<BodyModel> model, Textures textures,
                             const StageOptions& options);
  Stage(Stage&&) noexcept;
  Stage& operator=(Stage&&) noexcept;
  ~Stage();

  /// Draws a pose into width * height pixels (0x00RRGGBB). `canvas` says what they hold: with kLastFrame only what has
  /// changed since the last render is drawn and written. Nothing is allocated after the first frame.
  void render(const Pose& pose, std::span<uint32_t> pixels, raster::Canvas canvas = raster::Canvas::kUnknown);

  const StageOptions& options() const { return options_; }
  /// The pixels that the last render wrote; valid until the next.
  std::span<const raster::PixelRect> damage() const { return renderer_.damage(); }
  /// Where the rasteriser's time went in the last render, for `auslanjam bench`.
  const raster::StageTimes& times() const { return renderer_.times(); }
  const raster::DrawStats& stats() const { return renderer_.stats(); }

 private:
  Stage(const Figure& figure, std::unique_ptr<BodyModel> model, Textures textures, const StageOptions& options);

  const Figure* figure_;
  StageOptions options_;
  std::unique_ptr<BodyModel> model_;
  Textures textures_;
  std::unique_ptr<ArmShadow> shadow_;  ///< null: none
  std::unique_ptr<Outline> outline_;   ///< null: none
  raster::Renderer renderer_;
  raster::Camera camera_;
  std::vector<Transform> world_;
};

}  // namespace auslan
