// SPDX-License-Identifier: Apache-2.0
// Every look of the signer can be read: hands before the shirt, before the background and before the face.
#include "kinematics/anatomy.h"
#include "kinematics/arm_ik.h"
#include "kinematics/figure_file.h"
#include "stage/stage.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace auslan {
namespace {

constexpr int kSide = 480;

/// WCAG 2.1: relative luminance of an sRGB colour, and the contrast of two of them.
double luminance(double red, double green, double blue) {
  const auto linear = [](double level) {
    const double v = level / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
}
double luminance(uint32_t pixel) {
  return luminance(pixel >> 16U & 255U, pixel >> 8U & 255U, pixel & 255U);
}
double contrast(double a, double b) {
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

Figure signer() {
  return read_figure(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/signer.figure").value();
}

bool is_hand(const std::string& node) {
  for (const char* part : {"wrist", "thumb", "index", "middle", "ring", "little"})
    if (node.starts_with(part)) return true;
  return false;
}

enum class Body { kHand, kFace, kShirt, kOther };

/// The figure in one colour a part: red hands, green head, blue trunk.
Figure in_signal_colours(const Figure& figure) {
  Figure signals = figure;
  for (int node = 0; node < figure.skeleton.size(); ++node) {
    const std::string& name = figure.skeleton.node(node).name;
    glm::u8vec4 colour(0, 0, 0, 255);
    if (is_hand(name)) colour.x = 255;
    if (name == "head_base") colour.y = 255;
    if (name == "spine_base") colour.z = 255;
    auto& colours = signals.segments[static_cast<size_t>(node)].colours;
    std::fill(colours.begin(), colours.end(), colour);
  }
  return signals;
}

class FigureAppearance : public testing::TestWithParam<std::string> {
 protected:
  FigureAppearance() {
    const auto worn = put_on(figure_, GetParam());
    const glm::u8vec3& back = worn.value()->background;
    options_.width = options_.height = kSide;
    options_.samples = 1;
    options_.background = uint32_t{back.x} << 16U | uint32_t{back.y} << 8U | back.z;
  }

  /// The right hand upright at a place above the hips, its palm to the viewer or its back.
  Pose hand_at(const Vec3& place, bool palm) const {
    const Skeleton& skeleton = figure_.skeleton;
    const ArmNodes arm = arm_nodes(skeleton, Side::kRight);
    Transform trunk;
    trunk.position = skeleton.rest_position(skeleton.find("spine_base"));
    Transform wrist;
    wrist.position = trunk.position + place;
    wrist.rotation =
        orient_hand(rest_hand_frame(skeleton, Side::kRight), Vec3(0.2, 1, 0), Vec3(0, 0, palm ? 1.0 : -1.0));
    const ArmSolution solved =
        solve_arm(skeleton, Side::kRight, trunk, wrist, natural_swivel(skeleton, Side::kRight, trunk, wrist));
    EXPECT_TRUE(solved.reachable);
    Pose pose = rest_pose(skeleton);
    pose_arm(arm, solved, pose);
    return pose;
  }

  struct Seen {
    std::vector<uint32_t> pixels;
    std::vector<Body> bodies;
  };
  Seen seen(const Pose& pose) {
    Seen seen;
    seen.pixels.resize(size_t{kSide} * kSide);
    Stage::build(figure_, options_).value().render(pose, seen.pixels);
    const Figure signals = in_signal_colours(figure_);
    StageOptions plain = options_;
    plain.shadow = false;
    plain.background = 0;
    std::vector<uint32_t> parts(seen.pixels.size());
    Stage::build(signals, plain).value().render(pose, parts);
    for (const uint32_t part : parts) {
      const uint32_t red = part >> 16U & 255U, green = part >> 8U & 255U, blue = part & 255U;
      const uint32_t most = std::max({red, green, blue});
      seen.bodies.push_back(most < 20       ? Body::kOther
                            : most == red   ? Body::kHand
                            : most == green ? Body::kFace
                                            : Body::kShirt);
    }
    return seen;
  }

  static std::vector<double> luminances(const Seen& seen, Body body) {
    std::vector<double> found;
    for (size_t i = 0; i < seen.pixels.size(); ++i)
      if (seen.bodies[i] == body) found.push_back(luminance(seen.pixels[i]));
    std::sort(found.begin(), found.end());
    return found;
  }

  Figure figure_ = signer();
  StageOptions options_;
};

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const Appearance& appearance : signer().appearances)
    names.push_back(appearance.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Each, FigureAppearance, testing::ValuesIn(names()), [](const auto& name) {
  std::string letters;
  for (const char c : name.param)
    letters += c == '-' ? '_' : c;
  return letters;
});

TEST(FigureAppearances, AreSixOrMoreFromLightToDark) {
  const std::vector<Appearance> looks = signer().appearances;
  ASSERT_GE(looks.size(), 6U);
  std::vector<double> skins;
  for (const Appearance& look : looks)
    skins.push_back(luminance(look.pigments[0].x, look.pigments[0].y, look.pigments[0].z));
  std::sort(skins.begin(), skins.end());
  EXPECT_LT(skins.front(), 0.04);
  EXPECT_GT(skins.back(), 0.6);
}

TEST_P(FigureAppearance, EveryPointOfTheHandsStandsOutFromTheChest) {
  double least = 1.0, most = 0.0;
  std::vector<double> shirt;
  for (int node = 0; node < figure_.skeleton.size(); ++node) {
    const std::string& name = figure_.skeleton.node(node).name;
    const Mesh& mesh = figure_.segments[static_cast<size_t>(node)];
    for (size_t i = 0; i < mesh.colours.size(); ++i) {
      const glm::u8vec4& c = mesh.colours[i];
      if (is_hand(name)) {
        least = std::min(least, luminance(c.x, c.y, c.z));
        most = std::max(most, luminance(c.x, c.y, c.z));
      } else if (name == "spine_base" && mesh.positions[i].y > 0.1F && mesh.positions[i].y < 0.36F) {
        shirt.push_back(luminance(c.x, c.y, c.z));
      }
    }
  }
  // All of the shirt but the tenth that lies deepest in its folds.
  std::sort(shirt.begin(), shirt.end());
  const double dark = shirt[shirt.size() / 10], light = shirt.back();
  EXPECT_GE(least > light ? contrast(least, light) : contrast(most, dark), 4.5);
}

TEST_P(FigureAppearance, TheHandStandsOutFromTheShirtInThePicture) {
  for (const bool palm : {true, false}) {
    const Seen picture = seen(hand_at({-0.08, 0.22, 0.28}, palm));
    const std::vector<double> hand = luminances(picture, Body::kHand), shirt = luminances(picture, Body::kShirt);
    ASSERT_GT(hand.size(), 400U);
    ASSERT_GT(shirt.size(), 4000U);
    EXPECT_GE(contrast(hand[hand.size() / 2], shirt[shirt.size() / 2]), 4.5) << (palm ? "palm" : "back");
    // In shade or in full light: WCAG's 3:1 for what is no text.
    const bool lighter = hand[hand.size() / 2] > shirt[shirt.size() / 2];
    const double edge_of_hand = hand[lighter ? hand.size() / 10 : hand.size() * 9 / 10];
    EXPECT_GE(contrast(edge_of_hand, shirt[shirt.size() / 2]), 3.0) << (palm ? "palm" : "back");
  }
}

TEST_P(FigureAppearance, TheHandStandsOutFromTheBackground) {
  const Seen picture = seen(hand_at({-0.42, 0.30, 0.15}, true));
  const std::vector<double> hand = luminances(picture, Body::kHand);
  EXPECT_GE(contrast(hand[hand.size() / 2], luminance(options_.background)), 1.8);
}

// Skin before skin: shading and shadow have to draw the line. Across the outline of the hand, two pixels to either
// side, at least half of the places change by more than the eye's threshold several times over (a Weber fraction of 2
// %).
TEST_P(FigureAppearance, TheHandStandsOutFromTheFace) {
  for (const bool palm : {true, false}) {
    const Seen picture = seen(hand_at({-0.06, 0.50, 0.24}, palm));
    std::vector<double> steps;
    for (int row = 0; row < kSide; ++row) {
      for (int column = 2; column + 2 < kSide; ++column) {
        const auto at = static_cast<size_t>(row * kSide + column);
        for (const int way : {-1, 1}) {
          const size_t beside = at + static_cast<size_t>(way), beyond = at + static_cast<size_t>(2 * way);
          const size_t within = at - static_cast<size_t>(way);
          if (picture.bodies[at] != Body::kHand || picture.bodies[within] != Body::kHand ||
              picture.bodies[beside] != Body::kFace || picture.bodies[beyond] != Body::kFace)
            continue;
          const double inside = luminance(picture.pixels[within]), outside = luminance(picture.pixels[beyond]);
          steps.push_back(std::max(inside, outside) / std::min(inside, outside) - 1.0);
        }
      }
    }
    ASSERT_GT(steps.size(), 40U);
    std::sort(steps.begin(), steps.end());
    EXPECT_GE(steps[steps.size() / 2], 0.10) << (palm ? "palm" : "back");
  }
}

}  // namespace
}  // namespace auslan
