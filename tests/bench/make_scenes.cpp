// SPDX-License-Identifier: Apache-2.0
// Writes the signer's scenes: make_scenes FOLDER. The figure in its highest detail, posed as it signs, its segments
// simplified to 5 and 22 thousand triangles; the finest level splits each triangle of the 22 thousand into four. Not
// the levels that ship: what is measured should not change whenever the figure does.
#include "kinematics/body_model.h"
#include "scene.h"
#include "shipped.h"
#include "stage/stage.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <map>
#include <meshoptimizer.h>
#include <string>
#include <utility>
#include <vector>

namespace auslan::bench {
namespace {

constexpr uint64_t kCoarse = 5000;
constexpr uint64_t kMiddle = 22000;
// The signer's size in the picture is less than the stage's, so that at 1280x720 the middle level has the 185 thousand
// fragments of the workload on which this project's figures were set; a test counts them.
constexpr float kSmaller = 0.793F;

template <typename T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<uint32_t>& wanted) {
  std::vector<T> result;
  for (const uint32_t index : wanted)
    result.push_back(values[index]);
  return result;
}

/// Drops the vertices that no triangle uses; the others stand in the order of their first use.
void compact(SceneMesh& mesh) {
  constexpr uint32_t kUnused = ~uint32_t{0};
  std::vector<uint32_t> place(mesh.positions.size(), kUnused);
  std::vector<uint32_t> wanted;
  for (uint32_t& index : mesh.indices) {
    if (place[index] == kUnused) {
      place[index] = static_cast<uint32_t>(wanted.size());
      wanted.push_back(index);
    }
    index = place[index];
  }
  mesh.positions = picked(mesh.positions, wanted);
  mesh.normals = picked(mesh.normals, wanted);
  mesh.colours = picked(mesh.colours, wanted);
}

SceneMesh simplified(const SceneMesh& mesh, double share) {
  SceneMesh result = mesh;
  const auto target = static_cast<size_t>(share * static_cast<double>(mesh.indices.size() / 3)) * 3;
  const size_t left =
      meshopt_simplify(result.indices.data(), mesh.indices.data(), mesh.indices.size(), &mesh.positions.front().x,
                       mesh.positions.size(), sizeof(glm::vec3), target, 1.0F);
  result.indices.resize(left);
  compact(result);
  return result;
}

/// Each triangle as four, with the means of positions, normals (made unit) and colours at the middles of the edges.
SceneMesh subdivided(const SceneMesh& mesh) {
  SceneMesh result = mesh;
  result.indices.clear();
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(result.positions.size()));
    if (is_new) {
      const glm::vec3 sum = result.normals[a] + result.normals[b];
      const float length = std::sqrt((sum.x * sum.x + sum.y * sum.y) + sum.z * sum.z);
      const glm::vec3 normal = length > 1e-6F ? sum * (1.0F / length) : result.normals[a];
      glm::u8vec4 colour(255);
      for (glm::length_t i = 0; i < 3; ++i)
        colour[i] = static_cast<uint8_t>((result.colours[a][i] + result.colours[b][i] + 1) / 2);
      const glm::vec3 position = (result.positions[a] + result.positions[b]) * 0.5F;
      result.positions.push_back(position);
      result.normals.push_back(normal);
      result.colours.push_back(colour);
    }
    return entry->second;
  };
  for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const uint32_t a = mesh.indices[first];
    const uint32_t b = mesh.indices[first + 1];
    const uint32_t c = mesh.indices[first + 2];
    const uint32_t ab = middle(a, b);
    const uint32_t bc = middle(b, c);
    const uint32_t ca = middle(c, a);
    result.indices.insert(result.indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  return result;
}

/// Puts the draw list of a pose into the scene: its meshes, or only where they are a frame later.
void take_pose(const Figure& figure, BodyModel& model, const Pose& pose, bool moved, Scene& scene) {
  std::vector<Transform> world(static_cast<size_t>(figure.skeleton.size()));
  forward(figure.skeleton, pose, world);
  size_t index = 0;
  for (const PosedMesh& posed : model.pose(world, pose.face)) {
    if (moved) {
      scene.meshes[index++].moved_world_from_mesh = posed.world_from_mesh;
      continue;
    }
    SceneMesh mesh;
    mesh.positions.assign(posed.positions.begin(), posed.positions.end());
    mesh.normals.assign(posed.normals.begin(), posed.normals.end());
    mesh.colours.assign(posed.colours.begin(), posed.colours.end());
    mesh.indices.assign(posed.indices.begin(), posed.indices.end());
    mesh.world_from_mesh = posed.world_from_mesh;
    scene.meshes.push_back(std::move(mesh));
  }
}

Scene signer_scene() {
  const Figure figure = read_figure(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/signer_high.figure").value();
  Scene scene;
  scene.camera = stage_camera(figure, CameraName::kFront, 1.0F);
  scene.camera.clip_from_view[0][0] *= kSmaller;
  scene.camera.clip_from_view[1][1] *= kSmaller;
  scene.lighting = stage_lighting();
  scene.background = StageOptions().background;
  // Both hands before the body, as they are for most of a sentence.
  const Score score = score_of({"WHERE"});
  PerformanceOptions still;
  still.idle = false;
  Pose pose;
  Performance(*shipped().signer, score, still).sample(score.glosses.front().end - ticks(0.05), pose);
  const auto model = make_rigid_gouraud(figure);
  take_pose(figure, *model, pose, false, scene);
  // A frame of signing later the right forearm has turned by 4 degrees.
  Quat& elbow = pose.rotation[static_cast<size_t>(figure.skeleton.find("elbow_r"))];
  elbow = elbow * Quat(std::cos(0.035), std::sin(0.035), 0.0, 0.0);
  take_pose(figure, *model, pose, true, scene);
  return scene;
}

Scene at_detail(const Scene& scene, const std::string& name, uint64_t triangles) {
  Scene result = scene;
  result.name = name;
  const double share = static_cast<double>(triangles) / static_cast<double>(scene.triangle_count());
  if (share < 1.0)
    for (SceneMesh& mesh : result.meshes)
      mesh = simplified(mesh, share);
  return result;
}

void write(const Scene& scene, const std::string& folder) {
  write_scene(scene, folder + "/" + scene.name + ".scene");
  std::printf("%s: %llu triangles in %zu draws\n", scene.name.c_str(),
              static_cast<unsigned long long>(scene.triangle_count()), scene.meshes.size());
}

void write_all(const std::string& folder) {
  const Scene shipped_detail = signer_scene();
  std::printf("the figure has %llu triangles\n", static_cast<unsigned long long>(shipped_detail.triangle_count()));
  write(at_detail(shipped_detail, "signer_5k", kCoarse), folder);
  Scene scene = at_detail(shipped_detail, "signer_22k", kMiddle);
  write(scene, folder);
  scene.name = "signer_90k";
  for (SceneMesh& mesh : scene.meshes)
    mesh = subdivided(mesh);
  write(scene, folder);
}

}  // namespace
}  // namespace auslan::bench

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_scenes FOLDER\n");
    return 2;
  }
  try {
    auslan::bench::write_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_scenes: %s; build auslan_baked_figure and auslan_built_lexicon\n", error.what());
    return 1;
  }
  return 0;
}
