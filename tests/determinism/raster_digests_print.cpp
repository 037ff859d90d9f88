// SPDX-License-Identifier: Apache-2.0
// Prints "KERNEL FRAME DIGEST" for each frame of raster_digests.txt and each kernel that runs here. Needs no test
// library: raster_digests.sh builds it for other processors and starts it on emulated ones.
#include "raster_digest.h"

#include <cstdio>
#include <exception>

int main() {
  using namespace auslan::raster;
  try {
    const TexturedScene scene;
    for (const Kernel kernel : runnable_kernels()) {
      Renderer renderer(1, kernel);
      std::vector<uint32_t> pixels;
      for (const FrameKind& kind : frame_kinds()) {
        draw_kind(renderer, scene, kind, pixels);
        std::printf("%s %s %s\n", std::string(name_of(kernel)).c_str(), kind.name().c_str(), digest(pixels).c_str());
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "raster_digests_print: %s\n", error.what());
    return 1;
  }
  return 0;
}
