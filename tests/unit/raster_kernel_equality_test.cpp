// SPDX-License-Identifier: Apache-2.0
// Every kernel, with any number of threads, draws the picture of the scalar kernel with one thread, byte for byte.
#include "raster_bisect.h"
#include "raster_screen.h"
#include "raster_soup.h"

#include <deque>

namespace auslan::raster {
namespace {

constexpr int kThreadCounts[] = {1, 2, 3, 8};
constexpr int kSampleCounts[] = {1, 2, 4, 8};

class KernelEquality : public testing::TestWithParam<Kernel> {
 protected:
  void SetUp() override {
    for (const int threads : kThreadCounts)
      tried_.emplace_back(threads, GetParam());
  }

  // With each number of threads: the pixels and the counts of the scalar kernel with one.
  void expect_same(const std::string& scene, std::span<const SceneDraw> draws, const FrameSize& size) {
    draw_list(plain_, draws, size, wanted_);
    for (size_t i = 0; i < tried_.size(); ++i) {
      const std::string label = std::string(name_of(GetParam())) + "_" + std::to_string(kThreadCounts[i]) +
                                "_threads_" + std::to_string(size.samples) + "_samples_" + scene;
      draw_list(tried_[i], draws, size, drawn_);
      if (wanted_ != drawn_) {
        // Bisection draws a list again and again, so it is left to those that differ.
        ADD_FAILURE() << same_pictures(kept_pictures(), label, draws, size, source_of(plain_, draws, size),
                                       source_of(tried_[i], draws, size))
                             .message()
                      << "\n"
                      << label << " (when nothing is found above, this renderer does not repeat itself)";
        return;
      }
      const DrawStats& a = plain_.stats();
      const DrawStats& b = tried_[i].stats();
      EXPECT_EQ(a.submitted, b.submitted) << label;
      EXPECT_EQ(a.rejected, b.rejected) << label;
      EXPECT_EQ(a.culled, b.culled) << label;
      EXPECT_EQ(a.drawn, b.drawn) << label;
      EXPECT_EQ(a.clipped, b.clipped) << label;
    }
  }

  Renderer plain_{1, Kernel::kScalar};
  std::deque<Renderer> tried_;
  std::vector<uint32_t> wanted_, drawn_;
};
ON_EVERY_KERNEL(KernelEquality);

TEST_P(KernelEquality, TheFixedScene) {
  const Scene scene;
  for (const int samples : kSampleCounts) {
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
      const FrameSize size{320, 180, samples};
      expect_same(shading == Shading::kFlat ? "flat_scene" : "gouraud_scene",
                  scene_draws(scene, size.width, size.height, shading), size);
    }
  }
}

// Several draws, so that chunks of work of different meshes meet in one tile; sizes that no tile divides.
TEST_P(KernelEquality, RandomSoups) {
  uint64_t drawn = 0;
  uint64_t rejected = 0;
  uint64_t clipped = 0;
  constexpr auto kSeeds = static_cast<uint64_t>(cases(24));
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    const int width = 30 + static_cast<int>(seed * 37 % 250);
    const int height = 20 + static_cast<int>(seed * 53 % 170);
    const Soup soup = make_soup(7000 + seed, width, height, 6, 400);
    for (const int samples : kSampleCounts) {
      expect_same("soup_" + std::to_string(seed), soup.draws, {width, height, samples});
    }
    drawn += plain_.stats().drawn;
    rejected += plain_.stats().rejected;
    clipped += plain_.stats().clipped;
    if (HasFailure()) return;
  }
  // The soups hold what they are meant to hold.
  EXPECT_GT(drawn, 100 * kSeeds);
  EXPECT_GT(rejected, 3 * kSeeds);
  EXPECT_GT(clipped, 10 * kSeeds);
}

// One mesh of many thousand triangles is cut into chunks of work; the last one is not full.
TEST_P(KernelEquality, LargeMeshes) {
  Random random(7100);
  const SceneMesh sphere = make_box(41, true);  // 2 * 6 * 41 * 41 triangles
  const SceneMesh soup = soup_mesh(random, 5003, 5000);
  for (const int samples : {1, 4}) {
    for (const Shading shading : {Shading::kFlat, Shading::kGouraud}) {
      const FrameSize size{257, 193, samples};
      std::vector<SceneDraw> draws;
      const Camera camera = scene_camera(size.width, size.height);
      draws.push_back({sphere.view(), glm::mat4(1.0F), shading, CullMode::kBack, camera, scene_lighting()});
      draws.push_back({soup.view(), scene_place(0.3F, 0.3F, 0.3F, 0.0F, 0.0F, 0.8F), shading, CullMode::kNone, camera,
                       scene_lighting()});
      expect_same("large_meshes", draws, size);
    }
  }
}

TEST_P(KernelEquality, FramesFromOnePixelToTheLargest) {
  const Soup soup = make_soup(7200, 64, 64, 4, 300);
  const FrameSize sizes[] = {{1, 1, 8},   {1, 1, 1},   {3, 200, 2},           {200, 3, 4},          {64, 64, 1},
                             {65, 63, 8}, {128, 1, 1}, {kMaxImageSize, 2, 1}, {2, kMaxImageSize, 2}};
  for (const FrameSize& size : sizes) {
    expect_same("soup_of_" + std::to_string(size.width) + "x" + std::to_string(size.height), soup.draws, size);
  }
}

// Whatever was drawn before leaves no trace.
TEST_P(KernelEquality, AWarmRendererDrawsAsAColdOne) {
  for (uint64_t seed = 0; seed < 6; ++seed) {
    const FrameSize size{100, 90, kSampleCounts[seed % 4]};
    const Soup soup = make_soup(7300 + seed, size.width, size.height, 3, 300);
    for (size_t i = 0; i < tried_.size(); ++i) {
      draw_list(tried_[i], soup.draws, size, wanted_);
      Renderer cold(kThreadCounts[i], GetParam());
      draw_list(cold, soup.draws, size, drawn_);
      ASSERT_EQ(wanted_, drawn_) << seed;
    }
  }
}

TEST(Kernels, ScalarIsAlwaysThereAndNamesAreTold) {
  ASSERT_FALSE(runnable_kernels().empty());
  EXPECT_EQ(runnable_kernels().front(), Kernel::kScalar);
  EXPECT_EQ(name_of(Kernel::kScalar), "scalar");
  EXPECT_EQ(name_of(Kernel::kSse2), "sse2");
  EXPECT_EQ(name_of(Kernel::kAvx2), "avx2");
  EXPECT_EQ(name_of(Kernel::kNeon), "neon");
}

TEST(Kernels, OneThatDoesNotRunHereIsRefused) {
  for (const Kernel kernel : {Kernel::kScalar, Kernel::kSse2, Kernel::kAvx2, Kernel::kNeon}) {
    const std::vector<Kernel> here = kernels_here();
    const bool runs = std::find(here.begin(), here.end(), kernel) != here.end();
    Renderer renderer(1, kernel);
    EXPECT_EQ(renderer.begin_frame(8, 8, 1, 0), runs ? Status::kOk : Status::kBadKernel) << name_of(kernel);
  }
}

}  // namespace
}  // namespace auslan::raster
