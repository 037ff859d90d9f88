// SPDX-License-Identifier: Apache-2.0
// A scene through OpenGL into memory (OSMesa), as a program that chose Mesa instead of the rasteriser would draw it.
#pragma once

#include "scene.h"

#include <GL/osmesa.h>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace auslan::bench {

/// One context for the life of the process; Mesa takes the driver from the environment (GALLIUM_DRIVER). Vertices are
/// uploaded once; every frame clears, lights each vertex in the vertex shader (linear light, then sRGB, interpolated
/// encoded, as raster has it), draws one mesh at a time and waits for the last pixel. With 4 samples it draws into a
/// multisampled renderbuffer and resolves that with a blit. The pixels end in the caller's memory in both cases.
class GlScene {
 public:
  /// Ends the program with a message where there is no OpenGL 3.3 with clip control, or no `samples`.
  GlScene(const Scene& scene, int width, int height, int samples);
  ~GlScene();
  GlScene(const GlScene&) = delete;
  GlScene& operator=(const GlScene&) = delete;

  void draw(bool moved);
  /// Of the last draw, as raster/image.h has them.
  std::span<const uint32_t> pixels() const { return pixels_; }

  static std::string driver();

 private:
  struct Mesh {
    unsigned array = 0;
    unsigned buffers[4] = {};
    int indices = 0;
    float world_from_mesh[2][16] = {};  ///< at rest, moved
  };

  int width_;
  int height_;
  std::vector<uint32_t> pixels_;
  std::vector<Mesh> meshes_;
  unsigned program_ = 0;
  int world_from_mesh_ = -1;
  float clear_[3] = {};
  unsigned multisampled_ = 0;  ///< framebuffer, 0 for one sample
  unsigned surfaces_[2] = {};
};

}  // namespace auslan::bench
