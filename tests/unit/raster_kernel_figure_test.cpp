// SPDX-License-Identifier: Apache-2.0
// The shipped figure, posed: every kernel with any number of threads draws it like the scalar kernel with one.
#include "kinematics/body_model.h"
#include "kinematics/figure_file.h"
#include "raster_bisect.h"
#include "raster_screen.h"

#include <deque>

namespace auslan::raster {
namespace {

// Every joint turned a little, each in a direction of its own, and the face pulled: nothing a person would do, but all
// surfaces meet the eye at other angles than in rest.
Pose random_pose(const Figure& figure, uint64_t seed) {
  Random random(seed);
  Pose pose = rest_pose(figure.skeleton);
  for (Quat& rotation : pose.rotation) {
    const double x = static_cast<double>(random.real(-0.25F, 0.25F));
    const double y = static_cast<double>(random.real(-0.25F, 0.25F));
    const double z = static_cast<double>(random.real(-0.25F, 0.25F));
    const double length = std::sqrt(1.0 + x * x + y * y + z * z);
    rotation = Quat(1.0 / length, x / length, y / length, z / length);
  }
  for (float& weight : pose.face)
    weight = random.real(0.0F, 1.0F);
  return pose;
}

class KernelFigure : public OnEveryKernel {};
ON_EVERY_KERNEL(KernelFigure);

TEST_P(KernelFigure, DrawnLikeTheScalarKernelDoes) {
  const Figure figure = read_figure(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/signer.figure").value();
  std::vector<Transform> world(static_cast<size_t>(figure.skeleton.size()));
  Renderer plain(1, Kernel::kScalar);
  std::deque<Renderer> tried;
  for (const int threads : {1, 2, 3, 8})
    tried.emplace_back(threads, GetParam());
  std::vector<uint32_t> wanted;
  std::vector<uint32_t> drawn;
  for (uint64_t seed = 0; seed < static_cast<uint64_t>(cases(3)); ++seed) {
    const Pose pose = random_pose(figure, 7500 + seed);
    forward(figure.skeleton, pose, world);
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
      const auto model = shading == Shading::kFlat ? make_rigid_flat(figure) : make_rigid_gouraud(figure);
      const glm::vec3 middle(0.0F, 1.2F, 0.0F);
      const glm::vec3 eyes[] = {glm::vec3(0.2F, 1.4F, 3.0F), glm::vec3(-1.0F, 1.3F, 1.2F), glm::vec3(0.1F, 1.5F, 0.6F)};
      std::vector<SceneDraw> draws;
      const Camera camera = look_at(eyes[seed], middle, glm::vec3(0.0F, 1.0F, 0.0F), 3.0F, 4.0F / 3.0F, 0.02F);
      for (const PosedMesh& mesh : model->pose(world, pose.face)) {
        draws.push_back({MeshView{mesh.positions, mesh.normals, mesh.colours, mesh.indices}, mesh.world_from_mesh,
                         shading, CullMode::kBack, camera, scene_lighting()});
      }
      ASSERT_GT(triangle_count(draws), 5000U) << "the figure should be there";
      for (const int samples : {1, 2, 4, 8}) {
        const FrameSize size{320, 240, samples};
        draw_list(plain, draws, size, wanted);
        ASSERT_GT(plain.stats().drawn, 500U);
        for (size_t r = 0; r < tried.size(); ++r) {
          draw_list(tried[r], draws, size, drawn);
          if (drawn == wanted) continue;
          const std::string name = std::string(name_of(GetParam())) + "_figure_" + std::to_string(r);
          FAIL() << same_pictures(kept_pictures(), name, draws, size, source_of(plain, draws, size),
                                  source_of(tried[r], draws, size))
                        .message();
        }
      }
    }
  }
}

}  // namespace
}  // namespace auslan::raster
