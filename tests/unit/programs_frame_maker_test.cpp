// SPDX-License-Identifier: Apache-2.0
// A window's frames, of which only the changes are drawn, are the frames of a clip.
#include "frame_maker.h"
#include "shipped.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <ostream>
#include <span>
#include <vector>

namespace auslan {
namespace {

/// WHERE and HURT, one sentence each, with a standing start.
Show sample_show(bool reviewed) {
  const auto performance = std::make_shared<const Performance>(*shipped().signer, score_of({"WHERE", "HURT"}));
  Show show;
  show.end = performance->end();
  show.sample = [performance](Tick time, Pose& pose) { performance->sample(time, pose); };
  show.glosses = performance->score().glosses;
  show.sentences = {"Where?", "It hurts, it hurts so much that this line is a long one."};
  show.sentence_of_gloss = {0, 1};
  show.reviewed = reviewed;
  return show;
}

bool inside(std::span<const PixelRect> rects, int x, int y) {
  return std::ranges::any_of(rects, [&](const PixelRect& rect) {
    return x >= rect.x && x < rect.x + rect.width && y >= rect.y && y < rect.y + rect.height;
  });
}

struct Case {
  bool caption, reviewed, flat;
  int samples;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << (c.caption ? "captions" : "no captions") << (c.reviewed ? "" : " and a mark") << (c.flat ? ", flat, " : ", ")
       << c.samples << " samples";
}

class Frames : public testing::TestWithParam<Case> {
 protected:
  Frames() : show_(sample_show(GetParam().reviewed)) {
    options_.stage.width = 300;
    options_.stage.height = 240;
    options_.stage.samples = GetParam().samples;
    options_.stage.flat = GetParam().flat;
    options_.caption = GetParam().caption;
  }
  FrameMaker maker() const { return FrameMaker::build({.figure = &shipped().figure}, show_, options_).value(); }
  Picture picture() const { return make_picture(300, 240, 0x123456); }

  Show show_;
  FrameOptions options_;
};

TEST_P(Frames, OfAWindowAreThoseOfAClip) {
  FrameMaker of_clip = maker();
  FrameMaker of_window = maker();
  Picture expected = picture();
  Picture actual = picture();
  // Forwards, then in leaps back and forth; every third frame twice.
  std::vector<Tick> times;
  for (int i = 0; i < 40; ++i) {
    const int step = i < 30 ? i : i * 37 % 60;
    times.push_back(show_.end * step / 60);
    if (i % 3 == 0) times.push_back(times.back());
  }
  for (size_t i = 0; i < times.size(); ++i) {
    const Picture before = actual;
    const auto changed = of_window.update(times[i], actual.span());
    of_clip.make(times[i], expected.span());
    const Comparison comparison = compare(expected.view(), actual.view());
    ASSERT_TRUE(comparison.equal()) << "frame " << i << ": " << to_string(comparison);
    for (int y = 0; y < actual.height; ++y)
      for (int x = 0; x < actual.width; ++x) {
        const auto at = static_cast<size_t>(y * actual.width + x);
        ASSERT_TRUE(actual.pixels[at] == before.pixels[at] || inside(changed, x, y)) << "frame " << i;
      }
    if (i > 0 && times[i] == times[i - 1]) {
      EXPECT_TRUE(changed.empty()) << "frame " << i << " is the one before";
    }
  }
}

TEST_P(Frames, OfAWindowComeBackAfterOneOfAClip) {
  FrameMaker one = maker();
  Picture window = picture();
  one.update(0, window.span());
  Picture clip = picture();
  one.make(show_.end / 2, clip.span());
  one.update(show_.end / 2, window.span());
  EXPECT_TRUE(compare(clip.view(), window.view()).equal());
}

TEST_P(Frames, OfAWindowShowNewTextOverAFigureThatStandsStill) {
  const auto moving = show_.sample;
  show_.sample = [&moving](Tick, Pose& pose) { moving(0, pose); };
  show_.sentence_of_gloss = {0};  // and text that ends: the second gloss is of no sentence
  FrameMaker of_clip = maker();
  FrameMaker of_window = maker();
  Picture expected = picture();
  Picture actual = picture();
  for (int step = 0; step <= 30; ++step) {
    of_window.update(show_.end * step / 30, actual.span());
    of_clip.make(show_.end * step / 30, expected.span());
    const Comparison comparison = compare(expected.view(), actual.view());
    ASSERT_TRUE(comparison.equal()) << "step " << step << ": " << to_string(comparison);
  }
}

INSTANTIATE_TEST_SUITE_P(FrameMaker, Frames,
                         testing::Values(Case{false, true, false, 1}, Case{false, false, false, 4},
                                         Case{true, true, true, 1}, Case{true, false, false, 4}));

}  // namespace
}  // namespace auslan
