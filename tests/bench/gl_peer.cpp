// SPDX-License-Identifier: Apache-2.0
// A Mesa driver as a process of its own, which raster_bench talks to: the driver is chosen by the environment and once
// for the life of a process. First it prints the driver's name; then it answers one line with one line:
//   time SCENE WIDTH HEIGHT SAMPLES MOVING FRAMES     the CPU and the wall time of each frame, milliseconds
//   picture SCENE WIDTH HEIGHT SAMPLES FILE           writes the pixels (uint32_t each) and says done
#include "frame_clock.h"
#include "gl_scene.h"

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

namespace {

using namespace auslan::bench;

/// Keeps the last scene, with its buffers, for the next line that asks for the same.
class Peer {
 public:
  GlScene& ready(const std::string& scene, int width, int height, int samples) {
    const std::string key =
        scene + " " + std::to_string(width) + " " + std::to_string(height) + " " + std::to_string(samples);
    if (key != key_) {
      drawn_.reset();
      drawn_ = std::make_unique<GlScene>(load_scene(scene), width, height, samples);
      key_ = key;
      // Mesa compiles its shaders in the first frame.
      drawn_->draw(true);
      drawn_->draw(false);
    }
    return *drawn_;
  }

 private:
  std::string key_;
  std::unique_ptr<GlScene> drawn_;
};

}  // namespace

int main() {
  std::cout << GlScene::driver() << std::endl;
  Peer peer;
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream words(line);
    std::string what, scene;
    int width = 0, height = 0, samples = 0;
    words >> what >> scene >> width >> height >> samples;
    if (!words || width < 1 || height < 1 || samples < 1) {
      std::cout << "not understood: " << line << std::endl;
      return 1;
    }
    GlScene& drawn = peer.ready(scene, width, height, samples);
    if (what == "time") {
      int moving = 0, frames = 0;
      words >> moving >> frames;
      for (int i = 0; i < frames; ++i) {
        const bool moved = moving != 0 && i % 2 == 0;
        const FrameTime time = time_frame([&] { drawn.draw(moved); });
        std::cout << time.cpu_ms << ' ' << time.wall_ms << ' ';
      }
      std::cout << std::endl;
    } else {
      std::string path;
      words >> path;
      std::FILE* file = std::fopen(path.c_str(), "wb");
      if (file == nullptr) return 1;
      const auto pixels = drawn.pixels();
      const bool whole = std::fwrite(pixels.data(), sizeof(uint32_t), pixels.size(), file) == pixels.size();
      if (std::fclose(file) != 0 || !whole) return 1;
      std::cout << "done" << std::endl;
    }
  }
  return 0;
}
