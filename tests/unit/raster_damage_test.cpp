// SPDX-License-Identifier: Apache-2.0
// Canvas::kLastFrame: only what changed is written, and the picture is that of a full redraw, byte for byte.
#include "raster_scene.h"
#include "raster_screen.h"
#include "raster_textured.h"

#include <deque>
#include <tuple>

namespace auslan::raster {
namespace {

struct Object {
  SceneMesh mesh;
  glm::mat4 place{1.0F};
  Shading shading = Shading::kGouraud;
  CullMode cull = CullMode::kBack;
  uint64_t revision = 0;
  bool shown = true;
};

// Things in front of a camera, changed at random; `say` tells what the last change was.
struct World {
  Random random;
  std::deque<Object> objects;
  std::vector<size_t> order;
  FrameSize size{150, 130, 1, 0x203448U};
  Camera camera = scene_camera(150, 130);
  Lighting lighting = scene_lighting();
  uint64_t revisions = 0;
  std::string say = "the first frame";

  World(uint64_t seed, int samples) : random(seed) {
    size.samples = samples;
    for (size_t i = 0; i < 8; ++i) {
      Object& object = objects.emplace_back();
      object.mesh = i % 4 == 3 ? make_needles() : make_box(3 + static_cast<uint32_t>(i), i % 2 == 0);
      if (i == 5) object.mesh = make_floor();
      object.revision = i % 4 == 2 ? 0 : ++revisions;
      object.shading = i % 3 == 0 ? Shading::kFlat : Shading::kGouraud;
      object.cull = i % 4 == 3 ? CullMode::kNone : CullMode::kBack;
      move(object);
      order.push_back(i);
    }
  }

  void move(Object& object) {
    const float size_now = random.real(0.02F, 0.35F);
    const float x = random.real(-1.3F, 1.3F);
    const float y = random.real(-1.0F, 1.0F);
    const float z = random.real(-1.0F, 1.8F);
    object.place = scene_place(size_now, size_now, random.once_in(4) ? -size_now : size_now, x, 0.0F, z);
    object.place[3][1] = y;
  }

  Object& any() { return objects[random.next() % objects.size()]; }

  void recolour(Object& object) {
    for (glm::u8vec4& colour : object.mesh.colours) {
      if (random.once_in(3)) colour.y = static_cast<uint8_t>(colour.y + 40U);
    }
  }

  void change() {
    Object& object = any();
    switch (random.between(0, 16)) {
      case 0:
        say = "nothing";
        break;
      case 1:
      case 2:
        say = "an object moves";
        move(object);
        break;
      case 3:
      case 4:
        say = "an object comes or goes";
        object.shown = !object.shown;
        break;
      case 5:
        say = "an object gets other colours and a new revision";
        recolour(object);
        if (object.revision != 0) object.revision = ++revisions;
        break;
      case 6:
        say = "an object gets another form and a new revision";
        for (glm::vec3& p : object.mesh.positions)
          p.x = p.x * 0.9F;
        if (object.revision != 0) object.revision = ++revisions;
        break;
      case 7:
        say = "an object without revision gets other colours";
        recolour(objects[2]);
        break;
      case 8:
        say = "the camera moves";
        camera = look_at(glm::vec3(random.real(-0.5F, 0.5F), 0.3F, 3.0F), glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F),
                         2.0F, 1.2F, 0.05F);
        break;
      case 9:
        say = "the light changes";
        lighting.key_colour = glm::vec3(random.real(0.2F, 0.8F));
        break;
      case 10:
        say = "the background changes";
        size.background = static_cast<uint32_t>(random.next());
        break;
      case 11: {
        say = "the number of samples changes";
        const int counts[] = {1, 2, 4, 8};
        size.samples = counts[random.next() % 4];
        break;
      }
      case 12:
        say = "the size changes";
        size.width = static_cast<int>(random.between(1, 200));
        size.height = static_cast<int>(random.between(1, 160));
        break;
      case 13:
        say = "a new revision of the same contents";
        if (object.revision != 0) object.revision = ++revisions;
        break;
      case 14: {
        say = "the same contents at another place in memory";
        SceneMesh copy = object.mesh;
        std::swap(copy, object.mesh);
        break;
      }
      case 15:
        say = "another order of drawing";
        std::swap(order[0], order[1 + random.next() % (order.size() - 1)]);
        break;
      default:
        say = "another shading or culling";
        if (random.once_in(2)) {
          object.shading = object.shading == Shading::kFlat ? Shading::kGouraud : Shading::kFlat;
        } else {
          object.cull = object.cull == CullMode::kBack ? CullMode::kNone : CullMode::kBack;
        }
    }
  }

  std::vector<SceneDraw> draws() const {
    std::vector<SceneDraw> list;
    for (const size_t i : order) {
      const Object& object = objects[i];
      if (!object.shown) continue;
      list.push_back({object.mesh.view(), object.place, object.shading, object.cull, camera, lighting});
      list.back().mesh.revision = object.revision;
    }
    return list;
  }
};

// A canvas that a renderer keeps up to date.
struct Tracked {
  Renderer renderer;
  std::vector<uint32_t> canvas;
  FrameSize drawn{};

  // Draws the next frame; true when what it did is right. While the frame is drawn every pixel of the canvas is
  // inverted, so that it shows afterwards which were written.
  void frame(std::span<const SceneDraw> draws, const FrameSize& size, const std::vector<uint32_t>& wanted,
             Canvas mode = Canvas::kLastFrame) {
    const size_t count = pixel_count(size.width, size.height);
    const bool new_size = drawn.width != size.width || drawn.height != size.height;
    if (new_size) canvas.assign(count, 0x5A5A5A5AU);
    for (uint32_t& pixel : canvas)
      pixel = ~pixel;
    draw_list(renderer, draws, size, canvas, SIZE_MAX, mode);
    std::vector<uint8_t> written(count, 0);
    for (const PixelRect& rect : renderer.damage()) {
      ASSERT_TRUE(rect.x >= 0 && rect.y >= 0 && rect.width > 0 && rect.height > 0);
      ASSERT_TRUE(rect.x + rect.width <= size.width && rect.y + rect.height <= size.height);
      for (int row = rect.y; row < rect.y + rect.height; ++row) {
        for (int column = rect.x; column < rect.x + rect.width; ++column) {
          uint8_t& mark = written[static_cast<size_t>(row * size.width + column)];
          ASSERT_EQ(mark, 0) << "rectangles overlap at " << column << ", " << row;
          mark = 1;
        }
      }
    }
    for (size_t at = 0; at < count; ++at) {
      if (written[at] == 0U) canvas[at] = ~canvas[at];
      ASSERT_EQ(canvas[at], wanted[at]) << (written[at] == 0U ? "kept " : "written ") << "pixel "
                                        << at % static_cast<size_t>(size.width) << ", "
                                        << at / static_cast<size_t>(size.width);
    }
    const bool all = mode == Canvas::kUnknown || new_size || drawn.samples != size.samples ||
                     ((drawn.background ^ size.background) & 0xFFFFFFU) != 0U;
    if (all) {
      ASSERT_EQ(static_cast<size_t>(std::count(written.begin(), written.end(), 1)), count) << "all should be written";
    }
    drawn = size;
  }
};

class Damage : public testing::TestWithParam<std::tuple<Kernel, int>> {
 protected:
  void SetUp() override { kernel_under_test() = std::get<0>(GetParam()); }
  Tracked tracked() const { return {Renderer(std::get<1>(GetParam()), std::get<0>(GetParam())), {}, {}}; }
  static size_t area(std::span<const PixelRect> rects) {
    size_t sum = 0;
    for (const PixelRect& rect : rects)
      sum += static_cast<size_t>(rect.width) * static_cast<size_t>(rect.height);
    return sum;
  }
};

TEST_P(Damage, RandomChangesGiveThePictureOfAFullRedraw) {
  Renderer full(1, std::get<0>(GetParam()));
  std::vector<uint32_t> wanted;
  for (uint64_t seed = 0; seed < static_cast<uint64_t>(cases(8)); ++seed) {
    World world(8000 + seed, seed % 2 == 0 ? 1 : 4);
    Tracked kept = tracked();
    for (int frame = 0; frame < 60; ++frame) {
      const std::vector<SceneDraw> draws = world.draws();
      draw_list(full, draws, world.size, wanted);
      const Canvas mode = world.random.once_in(12) ? Canvas::kUnknown : Canvas::kLastFrame;
      kept.frame(draws, world.size, wanted, mode);
      const DrawStats& a = full.stats();
      const DrawStats& b = kept.renderer.stats();
      EXPECT_TRUE(a.submitted == b.submitted && a.rejected == b.rejected && a.culled == b.culled &&
                  a.drawn == b.drawn && a.clipped == b.clipped);
      if (HasFailure()) {
        ADD_FAILURE() << "seed " << seed << ", frame " << frame << ": " << world.say;
        return;
      }
      world.change();
      if (world.random.once_in(4)) {
        world.change();
        world.say = "several things, the last: " + world.say;
      }
      // A frame that is begun and given up leaves no trace.
      if (world.random.once_in(8)) {
        ASSERT_EQ(kept.renderer.begin_frame(77, 33, 2, 0), Status::kOk);
        kept.renderer.draw(world.objects[0].mesh.view(), glm::mat4(1.0F), Shading::kFlat);
      }
    }
  }
}

TEST_P(Damage, AStillFrameWritesNothing) {
  for (const int samples : {1, 4}) {
    World world(8100, samples);
    for (Object& object : world.objects)
      object.revision = ++world.revisions;
    Tracked kept = tracked();
    const std::vector<SceneDraw> draws = world.draws();
    std::vector<uint32_t> wanted;
    draw_list(kept.renderer, draws, world.size, wanted);
    const DrawStats before = kept.renderer.stats();
    kept.frame(draws, world.size, wanted, Canvas::kUnknown);
    for (int frame = 0; frame < 3; ++frame) {
      kept.frame(draws, world.size, wanted);
      EXPECT_TRUE(kept.renderer.damage().empty());
      EXPECT_EQ(kept.renderer.stats().drawn, before.drawn);
      EXPECT_EQ(kept.renderer.stats().culled, before.culled);
    }
    EXPECT_GT(before.drawn, 100U);
  }
}

// Where nothing is known of a mesh it is drawn again, and the picture stays what it was.
TEST_P(Damage, MeshesWithoutRevisionAreDrawnAgain) {
  World world(8200, 1);
  for (Object& object : world.objects)
    object.revision = 0;
  Tracked kept = tracked();
  const std::vector<SceneDraw> draws = world.draws();
  std::vector<uint32_t> wanted;
  draw_list(kept.renderer, draws, world.size, wanted);
  kept.frame(draws, world.size, wanted, Canvas::kUnknown);
  kept.frame(draws, world.size, wanted);
  EXPECT_FALSE(kept.renderer.damage().empty());
}

TEST_P(Damage, ASmallThingThatMovesDamagesASmallPartOfTheFrame) {
  const SceneMesh sphere = make_box(6, true);
  const FrameSize size{512, 512, 1, 0};
  std::vector<SceneDraw> draws;
  // Clip space is the world; a ball of 20 pixels in the upper left, one that stands still in the lower right.
  for (const float place : {-0.5F, 0.5F}) {
    SceneDraw draw;
    draw.mesh = sphere.view();
    draw.mesh.revision = 1;
    draw.world_from_mesh = scene_place(0.04F, 0.04F, 0.04F, place, 0.0F, 0.5F);
    draw.world_from_mesh[3][1] = -place;
    draw.lighting = scene_lighting();
    draws.push_back(draw);
  }
  Tracked kept = tracked();
  Renderer full(1, std::get<0>(GetParam()));
  std::vector<uint32_t> wanted;
  for (int frame = 0; frame < 10; ++frame) {
    draws[0].world_from_mesh[3][0] += 0.01F;
    draw_list(full, draws, size, wanted);
    kept.frame(draws, size, wanted);
    if (HasFailure()) return;
    const size_t damaged = area(kept.renderer.damage());
    if (frame == 0) continue;
    EXPECT_GT(damaged, 300U) << "the ball covers that much";
    EXPECT_LT(damaged, size_t{512} * 512 / 10);
    for (const PixelRect& rect : kept.renderer.damage())
      EXPECT_TRUE(rect.x < 256 && rect.y < 256) << "the ball that stands still is not drawn again";
  }
}

// Each way in which a draw can come to wear something else; all meshes keep their revision.
TEST_P(Damage, AnotherTextureIsDrawnAndTheSameOneIsNot) {
  const SceneMesh box = make_box(4, false);
  const std::vector<glm::vec2> once = box_coordinates(4, 1.0F);
  const std::vector<glm::vec2> twice = box_coordinates(4, 2.0F);
  Texture one = random_picture(16, 16, 8500).texture();
  const Texture other = random_picture(16, 16, 8501).texture();
  const FrameSize size{150, 130, 4, 0};
  SceneDraw draw{box.view(),
                 scene_place(0.4F, 0.4F, 0.4F, 0.0F, 0.0F, 0.0F),
                 Shading::kGouraud,
                 CullMode::kNone,
                 scene_camera(150, 130),
                 scene_lighting()};
  draw.mesh.revision = 1;
  Tracked kept = tracked();
  Renderer full(1, std::get<0>(GetParam()));
  std::vector<uint32_t> wanted;
  std::vector<uint32_t> last;
  const auto next_frame = [&](bool changed, const char* what) {
    last = wanted;
    draw_list(full, std::span(&draw, 1), size, wanted);
    EXPECT_EQ(wanted != last, changed) << what;
    kept.frame(std::span(&draw, 1), size, wanted);
    EXPECT_EQ(kept.renderer.damage().empty(), !changed) << what;
  };
  next_frame(true, "the first frame");
  TextureUse& use = draw.mesh.texture;
  use = {&one, once};
  next_frame(true, "a texture comes");
  next_frame(false, "nothing");
  use.texture = &other;
  next_frame(true, "another texture");
  use.texture = &one;
  next_frame(true, "the first texture");
  one = random_picture(16, 16, 8502).texture();
  next_frame(true, "another texture in the place of the first");
  use.coordinates = twice;
  next_frame(true, "other coordinates");
  use.wrap_u = Wrap::kClamp;
  next_frame(true, "another wrap along u");
  use.wrap_v = Wrap::kMirroredRepeat;
  next_frame(true, "another wrap along v");
  use.alpha = AlphaMode::kMask;
  next_frame(true, "a mask");
  use.alpha_cutoff = 0.7F;
  next_frame(true, "another cut-off");
  next_frame(false, "nothing again");
  use = {};
  next_frame(true, "the texture goes");
  next_frame(false, "still none");
}

TEST_P(Damage, AnEmptyFrameAfterAFullOneIsClearedWhereItWasDrawn) {
  World world(8300, 1);
  Tracked kept = tracked();
  std::vector<uint32_t> wanted;
  const std::vector<SceneDraw> draws = world.draws();
  draw_list(kept.renderer, draws, world.size, wanted);
  kept.frame(draws, world.size, wanted, Canvas::kUnknown);
  const std::vector<uint32_t> empty(wanted.size(), world.size.background);
  kept.frame({}, world.size, empty);
  EXPECT_FALSE(kept.renderer.damage().empty());
  kept.frame({}, world.size, empty);
  EXPECT_TRUE(kept.renderer.damage().empty());
  kept.frame(draws, world.size, wanted);
}

TEST_P(Damage, TheFirstFrameWritesEverythingWhateverTheCallerSays) {
  const World world(8400, 1);
  Tracked kept = tracked();
  Renderer full(1, std::get<0>(GetParam()));
  std::vector<uint32_t> wanted;
  draw_list(full, world.draws(), world.size, wanted);
  kept.frame(world.draws(), world.size, wanted, Canvas::kLastFrame);
  EXPECT_EQ(area(kept.renderer.damage()), wanted.size());
}

INSTANTIATE_TEST_SUITE_P(Kernels, Damage, testing::Combine(testing::ValuesIn(kernels_here()), testing::Values(1, 3)),
                         [](const auto& test) {
                           return std::string(name_of(std::get<0>(test.param))) + "_" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace auslan::raster
