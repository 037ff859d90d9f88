// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include "synthetic_scenes.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace auslan::bench {
namespace {

// The file: a magic number, the sizes, the arrays as they lie in memory. It never leaves the machine that wrote it.
constexpr uint64_t kMagic = 0x31454E454353414AU;

[[noreturn]] void stop(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  std::exit(1);
}

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

class SceneFile {
 public:
  SceneFile(const std::string& path, const char* mode) : path_(path), file_(std::fopen(path.c_str(), mode)) {
    if (!file_) stop("cannot open " + path + "; build the target bench_scenes, or set AUSLANJAM_BENCH_SCENES");
  }

  template <typename T>
  void put(const T* values, size_t count) {
    if (std::fwrite(values, sizeof(T), count, file_.get()) != count) stop("cannot write " + path_);
  }
  template <typename T>
  void get(T* values, size_t count) {
    if (std::fread(values, sizeof(T), count, file_.get()) != count) stop(path_ + " is cut short; build bench_scenes");
  }
  template <typename T>
  void put(const std::vector<T>& values) {
    const uint64_t size = values.size();
    put(&size, 1);
    put(values.data(), values.size());
  }
  template <typename T>
  void get(std::vector<T>& values) {
    uint64_t size = 0;
    get(&size, 1);
    if (size > uint64_t{1} << 28) stop(path_ + " is damaged; build bench_scenes");
    values.resize(static_cast<size_t>(size));
    get(values.data(), values.size());
  }

 private:
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

Scene read_scene(const std::string& name) {
  SceneFile file(scene_path(name), "rb");
  uint64_t magic = 0;
  uint64_t count = 0;
  file.get(&magic, 1);
  file.get(&count, 1);
  if (magic != kMagic || count > 4096) stop(scene_path(name) + " is not a scene; build bench_scenes");
  Scene scene;
  scene.name = name;
  file.get(&scene.camera, 1);
  file.get(&scene.lighting, 1);
  file.get(&scene.background, 1);
  scene.meshes.resize(static_cast<size_t>(count));
  for (SceneMesh& mesh : scene.meshes) {
    file.get(mesh.positions);
    file.get(mesh.normals);
    file.get(mesh.colours);
    file.get(mesh.indices);
    file.get(&mesh.world_from_mesh, 1);
    file.get(&mesh.moved_world_from_mesh, 1);
  }
  return scene;
}

}  // namespace

raster::Camera Scene::camera_for(int width, int height) const {
  raster::Camera fitted = camera;
  if (perspective) fitted.clip_from_view[0][0] *= static_cast<float>(height) / static_cast<float>(width);
  return fitted;
}

uint64_t Scene::triangle_count() const {
  uint64_t count = 0;
  for (const SceneMesh& mesh : meshes)
    count += mesh.indices.size() / 3;
  return count;
}

std::string scene_path(const std::string& name) {
  const char* folder = std::getenv("AUSLANJAM_BENCH_SCENES");
  return std::string(folder != nullptr ? folder : AUSLANJAM_BENCH_SCENES) + "/" + name + ".scene";
}

void write_scene(const Scene& scene, const std::string& path) {
  SceneFile file(path, "wb");
  const uint64_t count = scene.meshes.size();
  file.put(&kMagic, 1);
  file.put(&count, 1);
  file.put(&scene.camera, 1);
  file.put(&scene.lighting, 1);
  file.put(&scene.background, 1);
  for (const SceneMesh& mesh : scene.meshes) {
    file.put(mesh.positions);
    file.put(mesh.normals);
    file.put(mesh.colours);
    file.put(mesh.indices);
    file.put(&mesh.world_from_mesh, 1);
    file.put(&mesh.moved_world_from_mesh, 1);
  }
}

Scene load_scene(const std::string& name) {
  if (name == "fill") return make_fill(DepthOrder::kRandom);
  if (name == "back_to_front") return make_fill(DepthOrder::kBackToFront);
  if (name == "tiny") return make_tiny();
  return read_scene(name);
}

void draw_scene(raster::Renderer& renderer, const Scene& scene, int width, int height, bool moved, uint64_t revision) {
  renderer.set_camera(scene.camera_for(width, height));
  renderer.set_lighting(scene.lighting);
  for (const SceneMesh& mesh : scene.meshes)
    renderer.draw({mesh.positions, mesh.normals, mesh.colours, mesh.indices, revision},
                  moved ? mesh.moved_world_from_mesh : mesh.world_from_mesh, raster::Shading::kGouraud);
}

}  // namespace auslan::bench
