// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include "arm_shadow.h"
#include "outline.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace auslan {

raster::Lighting stage_lighting() {
  raster::Lighting lighting;
  // A key light from the viewer's upper right, so that the nose and the hands throw their shading to one side; a weak
  // fill from the other side; a rim from behind and above, which edges hair, shoulders and hands; a sky a little
  // brighter than the floor.
  lighting.key_direction = glm::vec3(0.55F, 0.75F, 0.85F);
  lighting.key_colour = glm::vec3(0.66F, 0.64F, 0.60F);
  lighting.fill_direction = glm::vec3(-0.8F, 0.15F, 0.6F);
  lighting.fill_colour = glm::vec3(0.17F, 0.18F, 0.20F);
  lighting.rim_direction = glm::vec3(-0.45F, 0.55F, -0.75F);
  lighting.rim_colour = glm::vec3(0.42F, 0.43F, 0.45F);
  lighting.ambient_sky = glm::vec3(0.34F, 0.35F, 0.37F);
  lighting.ambient_ground = glm::vec3(0.20F, 0.19F, 0.18F);
  return lighting;
}

namespace {

constexpr float kOutlineWidth = 0.0016F;  // metres

glm::vec3 to_float(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

raster::Wrap as_raster(ImageWrap wrap) {
  if (wrap == ImageWrap::kClamp) return raster::Wrap::kClamp;
  return wrap == ImageWrap::kMirroredRepeat ? raster::Wrap::kMirroredRepeat : raster::Wrap::kRepeat;
}

raster::TextureUse worn(const PosedMesh& mesh, Textures textures) {
  if (mesh.image < 0 || static_cast<size_t>(mesh.image) >= textures.size()) return {};
  const std::optional<raster::Texture>& texture = textures[static_cast<size_t>(mesh.image)];
  if (!texture) return {};
  return {.texture = &*texture,
          .coordinates = mesh.texture_coordinates,
          .wrap_u = as_raster(mesh.wrap_u),
          .wrap_v = as_raster(mesh.wrap_v),
          .alpha = mesh.alpha_cutoff > 0.0F ? raster::AlphaMode::kMask : raster::AlphaMode::kOpaque,
          .alpha_cutoff = mesh.alpha_cutoff};
}

/// The top of the head.
double highest(const Figure& figure) {
  const int node = figure.skeleton.find("head_base");
  float top = 0.0F;
  for (const glm::vec3& position : figure.segments[static_cast<size_t>(node)].positions)
    top = std::max(top, position.y);
  return figure.skeleton.rest_position(node).y + static_cast<double>(top);
}

}  // namespace

// Cameras are placed by the figure's own proportions, so that a taller signer fills the picture as a shorter one does.
raster::Camera stage_camera(const Figure& figure, CameraName name, float aspect) {
  const Skeleton& skeleton = figure.skeleton;
  const Vec3 base = skeleton.rest_position(skeleton.find("spine_base"));
  const Vec3 head = skeleton.rest_position(skeleton.find("head_base"));
  const double trunk = head.y - base.y;  // from the spine's base to the base of the skull
  const Vec3 chest(0.0, base.y + 0.62 * trunk, base.z + 0.05);
  // A head that is taller than people have it, with hat or hair, moves the picture up and the camera back.
  const double rise = highest(figure) - head.y;
  const double taller = std::max(0.0, rise - 0.4 * trunk);
  Vec3 eye, target, up(0, 1, 0);
  double cot = 3.2;  // half the vertical field of view has a tangent of 1/3.2: a portrait lens
  switch (name) {
    case CameraName::kFront:
      target = chest + Vec3(0, 0.07 * trunk + 0.5 * taller, 0);
      eye = target + Vec3(0, 0.10 * trunk, 2.85 * (trunk + taller) / 0.60);
      cot = 5.6;
      break;
    case CameraName::kThreeQuarter:
      target = chest + Vec3(0, 0.12 * trunk + 0.5 * taller, 0.1);
      eye = target + Vec3(-1.75, 0.15, 2.2) * ((trunk + taller) / 0.60);
      cot = 5.2;
      break;
    case CameraName::kSide:
      target = chest + Vec3(0, 0.12 * trunk + 0.5 * taller, 0.18);
      eye = target + Vec3(-2.85, 0.06, 0) * ((trunk + taller) / 0.60);
      cot = 5.2;
      break;
    case CameraName::kSigner:
      // Before the nose, which no signer minds.
      eye = head + Vec3(0, 0.12, 0.19);
      target = chest + Vec3(0, -0.05, 0.42);
      cot = 1.25;
      break;
    case CameraName::kHands:
      target = Vec3(0.0, base.y + 0.48 * trunk, base.z + 0.22);
      eye = target + Vec3(-0.05, 0.10, 1.6);
      cot = 6.2;
      break;
    case CameraName::kFace:
      target = head + Vec3(0, 0.06 + 0.4 * taller, 0.05);
      eye = target + Vec3(0, 0.02, 1.5 + 6.0 * taller);
      cot = 9.2;
      break;
  }
  return raster::look_at(to_float(eye), to_float(target), to_float(up), static_cast<float>(cot), aspect, 0.02F);
}

std::optional<CameraName> camera_from_name(std::string_view name) {
  for (size_t i = 0; i < std::size(kCameraNames); ++i)
    if (kCameraNames[i] == name) return static_cast<CameraName>(i);
  return std::nullopt;
}

Stage::Stage(const Figure& figure, std::unique_ptr<BodyModel> model, Textures textures, const StageOptions& options)
    : figure_(&figure),
      options_(options),
      model_(std::move(model)),
      textures_(textures),
      shadow_(options.shadow ? std::make_unique<ArmShadow>(figure.skeleton, stage_lighting().key_direction) : nullptr),
      outline_(options.outline ? std::make_unique<Outline>(kOutlineWidth) : nullptr),
      renderer_(options.threads, options.kernel.value()),
      camera_(
          stage_camera(figure, options.camera, static_cast<float>(options.width) / static_cast<float>(options.height))),
      world_(static_cast<size_t>(figure.skeleton.size())) {
  renderer_.set_camera(camera_);
  renderer_.set_lighting(stage_lighting());
}

Stage::Stage(Stage&&) noexcept = default;
Stage& Stage::operator=(Stage&&) noexcept = default;
Stage::~Stage() = default;

namespace {

/// The options with a kernel, or what is wrong with them.
Result<StageOptions> checked(const StageOptions& options) {
  const bool size_ok = options.width >= 1 && options.width <= raster::kMaxImageSize && options.height >= 1 &&
                       options.height <= raster::kMaxImageSize;
  if (!size_ok) return fail(ErrorCode::kUsage, "the picture's width and height must lie between 1 and 16384 pixels");
  if (options.samples != 1 && options.samples != 2 && options.samples != 4 && options.samples != 8)
    return fail(ErrorCode::kUsage, "anti-aliasing takes 1, 2, 4 or 8 samples a pixel");
  StageOptions chosen = options;
  if (!chosen.kernel) chosen.kernel = raster::chosen_kernel();
  const auto runnable = raster::runnable_kernels();
  if (!chosen.kernel || std::find(runnable.begin(), runnable.end(), *chosen.kernel) == runnable.end()) {
    std::string names;
    for (const raster::Kernel kernel : runnable)
      names += " " + std::string(raster::name_of(kernel));
    return fail(ErrorCode::kUsage,
                "AUSLANJAM_KERNEL names no kernel of the rasteriser that runs here; unset it, or take one of:" + names);
  }
  return chosen;
}

}  // namespace

Result<Stage> Stage::build(const Figure& figure, const StageOptions& options) {
  const auto chosen = checked(options);
  if (!chosen) return tl::unexpected(chosen.error());
  return Stage(figure,
               options.flat    ? make_rigid_flat(figure)
               : options.rigid ? make_rigid_gouraud(figure)
                               : make_skinned(figure),
               {}, *chosen);
}

Result<Stage> Stage::build(const Figure& figure, std::unique_ptr<BodyModel> model, Textures textures,
                           const StageOptions& options) {
  const auto chosen = checked(options);
  if (!chosen) return tl::unexpected(chosen.error());
  return Stage(figure, std::move(model), textures, *chosen);
}

void Stage::render(const Pose& pose, std::span<uint32_t> pixels, raster::Canvas canvas) {
  forward(figure_->skeleton, pose, world_);
  [[maybe_unused]] raster::Status status =
      renderer_.begin_frame(options_.width, options_.height, options_.samples, options_.background);
  assert(status == raster::Status::kOk);
  const raster::Shading shading = options_.flat ? raster::Shading::kFlat : raster::Shading::kGouraud;
  std::span<const PosedMesh> meshes = model_->pose(world_, pose.face);
  if (shadow_ != nullptr) meshes = shadow_->cast(world_, meshes);
  for (const PosedMesh& mesh : meshes) {
    const raster::TextureUse texture = worn(mesh, textures_);
    // Lashes and lace without the image that cuts them out would be plates.
    if (mesh.image >= 0 && mesh.alpha_cutoff > 0.0F && texture.texture == nullptr) continue;
    renderer_.draw({mesh.positions, mesh.normals, mesh.colours, mesh.indices, mesh.revision, texture},
                   mesh.world_from_mesh, shading);
  }
  if (outline_ != nullptr) {
    for (const PosedMesh& hull : outline_->around(meshes)) {
      if (hull.alpha_cutoff > 0.0F) continue;  // cut out of an image: it has no hull
      renderer_.draw({hull.positions, hull.normals, hull.colours, hull.indices, hull.revision}, hull.world_from_mesh,
                     shading);
    }
  }
  status = renderer_.end_frame(pixels, canvas);
  assert(status == raster::Status::kOk);
}

}  // namespace auslan
