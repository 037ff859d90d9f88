// SPDX-License-Identifier: Apache-2.0
// The built-in figure: closed segments, measured bones, two equal halves, a face that moves, colours that read.
#include "kinematics/figure_file.h"
#include "other_tables.h"
#include "sculpt/sculpt.h"

#include <cmath>
#include <glm/vector_relational.hpp>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <utility>

namespace auslan {
namespace {

const Measurements& table() {
  static const Measurements read =
      read_measurements(std::string(AUSLANJAM_SOURCE_DIR) + "/assets/figure/measurements.toml").value();
  return read;
}

const Figure& figure_of(Detail detail) {
  static const std::array<Figure, 3> made = {sculpt_figure(table(), Detail::kLow).value(),
                                             sculpt_figure(table(), Detail::kNormal).value(),
                                             sculpt_figure(table(), Detail::kHigh).value()};
  return made[static_cast<size_t>(detail)];
}

/// What holds at every level of detail.
class SculptedFigure : public testing::TestWithParam<Detail> {
 protected:
  static const Figure& figure() { return figure_of(GetParam()); }
  static const Mesh& segment(const std::string& node) {
    return figure().segments[static_cast<size_t>(figure().skeleton.find(node))];
  }
  static double bone(const char* from, const char* to) {
    const Skeleton& s = figure().skeleton;
    const Vec3 v = s.rest_position(s.find(to)) - s.rest_position(s.find(from));
    return 1000.0 * std::sqrt(glm::dot(v, v));
  }
  /// What the reduction may have moved a surface, in millimetres.
  static double tolerance() { return GetParam() == Detail::kLow ? 7.0 : 5.0; }
};
INSTANTIATE_TEST_SUITE_P(AtEachDetail, SculptedFigure, testing::Values(Detail::kLow, Detail::kNormal, Detail::kHigh),
                         [](const auto& level) { return std::string(kDetailNames[static_cast<size_t>(level.param)]); });

bool is_hand(const std::string& node) {
  return node.starts_with("wrist") || node.starts_with("thumb") || node.starts_with("index") ||
         node.starts_with("middle") || node.starts_with("ring") || node.starts_with("little");
}

TEST_P(SculptedFigure, HasAboutTheTrianglesOfItsLevelMostOfThemInHandsAndHead) {
  double all = 0, hands = 0;
  for (size_t node = 0; node < figure().segments.size(); ++node) {
    const auto triangles = static_cast<double>(figure().segments[node].indices.size() / 3);
    all += triangles;
    if (is_hand(figure().skeleton.node(static_cast<int>(node)).name)) hands += triangles;
  }
  const double head = static_cast<double>(segment("head_base").indices.size() / 3);
  const double wanted[] = {5000, 20000, 80000};
  EXPECT_NEAR(all, wanted[static_cast<size_t>(GetParam())], 0.05 * wanted[static_cast<size_t>(GetParam())]);
  EXPECT_NEAR(hands / all, 0.42, 0.04);
  EXPECT_NEAR(head / all, 0.35, 0.03);
}

TEST_P(SculptedFigure, KeepsEveryPromiseOfAFigure) {
  const auto checked = check_figure(figure());
  EXPECT_TRUE(checked) << to_string(checked.error());
}

void expect_closed(const Figure& figure) {
  for (size_t node = 0; node < figure.segments.size(); ++node) {
    const Mesh& mesh = figure.segments[node];
    const std::string& name = figure.skeleton.node(static_cast<int>(node)).name;
    ASSERT_EQ(mesh.indices.empty(), name.starts_with("clavicle")) << name;
    if (mesh.indices.empty()) continue;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    double volume = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
      ++edges[{a, b}];
      ++edges[{b, c}];
      ++edges[{c, a}];
      const glm::dvec3 p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
      volume += (p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) + p.z * (q.x * r.y - q.y * r.x)) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << name << ": an edge is used twice in the same direction";
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1U) << name << ": an edge has no triangle on its other side";
    }
    EXPECT_GT(volume, 0.0) << name << ": the surface is inside out";
  }
}

TEST_P(SculptedFigure, EverySegmentIsClosedAndWoundOutwards) {
  expect_closed(figure());
}

TEST_P(SculptedFigure, BonesHaveTheLengthsOfTheTable) {
  EXPECT_NEAR(bone("elbow_l", "wrist_l"), table().forearm, 0.01);
  EXPECT_NEAR(bone("shoulder_l", "shoulder_r"), table().shoulder_joint_breadth, 0.01);
  const char* const joints[5][3] = {{"thumb_cmc_l", "thumb_mp_l", "thumb_ip_l"},
                                    {"index_mp_l", "index_pip_l", "index_dip_l"},
                                    {"middle_mp_l", "middle_pip_l", "middle_dip_l"},
                                    {"ring_mp_l", "ring_pip_l", "ring_dip_l"},
                                    {"little_mp_l", "little_pip_l", "little_dip_l"}};
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(bone(joints[digit][i], joints[digit][i + 1]), table().digits[digit].bones[i], 0.01)
          << joints[digit][i];
}

TEST_P(SculptedFigure, JointHeightsAreThoseOfTheTable) {
  const Skeleton& s = figure().skeleton;
  const auto height = [&s](const char* name) { return 1000.0 * s.rest_position(s.find(name)).y; };
  EXPECT_NEAR(height("spine_base"), table().hip_height, 0.01);
  EXPECT_NEAR(height("neck_base"), table().neck_base_height, 0.01);
  EXPECT_NEAR(height("shoulder_l"), table().acromial_height - table().acromion_to_shoulder_joint, 0.01);
  EXPECT_NEAR(bone("shoulder_l", "elbow_l"), table().upper_arm - table().acromion_to_shoulder_joint, 0.01);
}

TEST_P(SculptedFigure, TheHandHasTheSizeOfTheTable) {
  const Skeleton& s = figure().skeleton;
  const double to_tip_joint = s.rest_position(s.find("middle_dip_l")).x - s.rest_position(s.find("wrist_l")).x;
  double tip = 0.0;
  for (const glm::vec3& p : segment("middle_dip_l").positions)
    tip = std::max(tip, static_cast<double>(p.x));
  EXPECT_NEAR(1000.0 * (to_tip_joint + tip), table().hand_length, tolerance());
  // Breadth across the knuckles, without the thumb.
  float low = 0.0F;
  float high = 0.0F;
  for (const glm::vec3& p : segment("wrist_l").positions) {
    if (p.x < 0.070F) continue;
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  EXPECT_NEAR(1000.0F * (high - low), table().hand_breadth, tolerance());
}

TEST_P(SculptedFigure, TheSkullHasTheSizeOfTheTable) {
  // Bare skin above the ears and the bridge of the nose; what has another pigment is hair.
  const Mesh& head = segment("head_base");
  float widest = 0.0F;
  float front = 0.0F;
  float back = 0.0F;
  float top = 0.0F;
  for (size_t i = 0; i < head.positions.size(); ++i) {
    const glm::vec3& p = head.positions[i];
    if (head.paint[i].first != 0 || p.y < 0.062F) continue;
    if (p.y > 0.070F) widest = std::max(widest, p.x);
    front = std::max(front, p.z);
    back = std::min(back, p.z);
    top = std::max(top, p.y);
  }
  EXPECT_NEAR(2000.0F * widest, table().head_breadth, tolerance());
  EXPECT_NEAR(1000.0F * (front - back), table().head_length, tolerance());
  const Skeleton& s = figure().skeleton;
  EXPECT_NEAR(1000.0 * (s.rest_position(s.find("head_base")).y + static_cast<double>(top)), table().stature,
              tolerance());
}

TEST_P(SculptedFigure, ThePupilsStandApartAsInTheTable) {
  // Pupils are the darkest thing at the height of the eyes.
  const Mesh& head = segment("head_base");
  float least = 1.0F;
  float most = 0.0F;
  for (size_t i = 0; i < head.positions.size(); ++i) {
    const glm::vec3& p = head.positions[i];
    const glm::u8vec4& c = head.colours[i];
    if (p.x < 0.01F || p.z < 0.05F || std::abs(p.y - 0.050F) > 0.004F || std::max({c.x, c.y, c.z}) > 20) continue;
    least = std::min(least, p.x);
    most = std::max(most, p.x);
  }
  EXPECT_NEAR(1000.0F * (least + most), table().interpupillary, GetParam() == Detail::kLow ? 3.0 : 1.0);
}

TEST_P(SculptedFigure, NothingIsDegenerate) {
  for (size_t node = 0; node < figure().segments.size(); ++node) {
    const Mesh& mesh = figure().segments[node];
    const std::string& name = figure().skeleton.node(static_cast<int>(node)).name;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::vec3& n = mesh.normals[i];
      ASSERT_TRUE(std::isfinite(mesh.positions[i].x + mesh.positions[i].y + mesh.positions[i].z)) << name;
      ASSERT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1.0F, 1e-4F) << name;
    }
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      const glm::vec3& a = mesh.positions[mesh.indices[i]];
      const glm::vec3& b = mesh.positions[mesh.indices[i + 1]];
      const glm::vec3& c = mesh.positions[mesh.indices[i + 2]];
      ASSERT_TRUE(a != b && b != c && c != a) << name << ": triangle " << i / 3 << " has two corners in one place";
    }
  }
}

/// Places and colours of a mesh, mirrored across x = 0 where asked.
std::multiset<std::array<float, 6>> cloud(const Mesh& mesh, bool mirror) {
  std::multiset<std::array<float, 6>> out;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::u8vec4& c = mesh.colours[i];
    // x + 0 turns a negative zero into a positive one.
    out.insert({(mirror ? 0.0F - p.x : p.x) + 0.0F, p.y, p.z, static_cast<float>(c.x), static_cast<float>(c.y),
                static_cast<float>(c.z)});
  }
  return out;
}

TEST_P(SculptedFigure, TheRightSideIsTheMirrorImageOfTheLeft) {
  for (const Node& node : figure().skeleton.nodes()) {
    if (!node.name.ends_with("_l")) continue;
    const std::string right = node.name.substr(0, node.name.size() - 1) + "r";
    EXPECT_EQ(cloud(segment(node.name), true), cloud(segment(right), false)) << node.name;
    const Skeleton& s = figure().skeleton;
    const Vec3 l = s.rest_position(s.find(node.name));
    const Vec3 r = s.rest_position(s.find(right));
    EXPECT_TRUE(l.x == -r.x && l.y == r.y && l.z == r.z) << node.name;
  }
  for (const char* middle : {"spine_base", "neck_base", "head_base"}) {
    EXPECT_EQ(cloud(segment(middle), true), cloud(segment(middle), false)) << middle;
  }
}

TEST_P(SculptedFigure, LeftAndRightFaceChannelsAreMirrorImages) {
  const Mesh& head = segment("head_base");
  const auto moved = [&head](std::string_view channel, bool mirror) {
    std::multiset<std::array<float, 6>> out;
    for (const Morph& morph : head.morphs) {
      if (kFaceChannelNames[static_cast<size_t>(morph.channel)] != channel) continue;
      for (size_t i = 0; i < morph.vertices.size(); ++i) {
        const glm::vec3& p = head.positions[morph.vertices[i]];
        const glm::vec3& d = morph.displacement[i];
        const float side = mirror ? -1.0F : 1.0F;
        out.insert({side * p.x + 0.0F, p.y, p.z, side * d.x + 0.0F, d.y, d.z});
      }
    }
    return out;
  };
  for (const std::string_view name : kFaceChannelNames) {
    if (name.ends_with("Left")) {
      const std::string right = std::string(name.substr(0, name.size() - 4)) + "Right";
      EXPECT_EQ(moved(name, true), moved(right, false)) << name;
    } else if (!name.ends_with("Right")) {
      EXPECT_EQ(moved(name, true), moved(name, false)) << name;
    }
  }
}

TEST_P(SculptedFigure, EveryFaceChannelMovesTheFace) {
  const Mesh& head = segment("head_base");
  for (int channel = 0; channel < kFaceChannelCount; ++channel) {
    float largest = 0;
    for (const Morph& morph : head.morphs)
      if (static_cast<int>(morph.channel) == channel)
        for (const glm::vec3& d : morph.displacement)
          largest = std::max(largest, std::sqrt(glm::dot(d, d)));
    EXPECT_GT(largest, 0.002F) << kFaceChannelNames[static_cast<size_t>(channel)];
  }
}

TEST_P(SculptedFigure, EveryPointOfTheHandsStandsOutFromTheShirt) {
  // WCAG 2.1: contrast is (L1 + 0.05) / (L2 + 0.05) of relative luminances.
  const auto luminance = [](double red, double green, double blue) {
    const auto linear = [](double level) {
      const double v = level / 255.0;
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
  };
  const TableAppearance& worn = table().appearances.front();
  const double shirt = luminance(worn.shirt.red, worn.shirt.green, worn.shirt.blue);
  for (const Node& node : figure().skeleton.nodes()) {
    if (!is_hand(node.name)) continue;
    double darkest = 1.0;
    for (const glm::u8vec4& c : segment(node.name).colours)
      darkest = std::min(darkest, luminance(c.x, c.y, c.z));
    EXPECT_GE((darkest + 0.05) / (shirt + 0.05), 4.5) << node.name;
  }
  // And no cloth is lighter than the table's.
  for (const glm::u8vec4& c : segment("spine_base").colours) {
    EXPECT_LE(luminance(c.x, c.y, c.z), shirt + 0.01);
  }
}

/// The mean shade of the paint in a box (millimetres), 1 as the pigments are.
double shade_in(const Mesh& mesh, const glm::vec3& low, const glm::vec3& high) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3 p = mesh.positions[i] * 1000.0F;
    if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) continue;
    sum += mesh.paint[i].shade / double{Paint::kFullShade};
    ++count;
  }
  EXPECT_GE(count, 1.0);
  return sum / count;
}

TEST_P(SculptedFigure, LessLightArrivesWhereTheBodyIsInItsOwnWay) {
  const Mesh& head = segment("head_base");
  const double cheek = shade_in(head, {25, 0, 60}, {55, 30, 130});
  EXPECT_LT(shade_in(head, {8, 38, 60}, {18, 62, 92}), cheek - 0.05) << "beside the root of the nose";
  EXPECT_LT(shade_in(head, {56, 20, -30}, {74, 60, 12}), cheek - 0.05) << "behind the ear";
  EXPECT_LT(shade_in(segment("neck_base"), {-30, 60, 30}, {30, 110, 90}), cheek - 0.05) << "under the chin";
}

// What a joint hides at rest it shows when it bends.
TEST_P(SculptedFigure, NoDarkRingsRoundTheJoints) {
  for (const char* finger : {"index_pip_l", "middle_dip_l", "ring_pip_l", "little_mp_l"})
    EXPECT_GT(shade_in(segment(finger), {-4, 4, -5}, {4, 20, 5}), 0.95) << finger;
  for (const Paint& paint : segment("elbow_l").paint)
    EXPECT_EQ(paint.shade, Paint::kFullShade);
}

TEST(SculptedTable, OtherSignersAreWholeToo) {
  for (const test::Build& build : test::other_builds()) {
    SCOPED_TRACE(build.name);
    const Measurements other = test::of_build(table(), build);
    const auto made = sculpt_figure(other);
    ASSERT_TRUE(made);
    EXPECT_TRUE(check_figure(*made));
    expect_closed(*made);
    // The knuckles are as far apart as the table has the hand broad.
    const Mesh& palm = made->segments[static_cast<size_t>(made->skeleton.find("wrist_l"))];
    float low = 0.0F, high = 0.0F;
    for (const glm::vec3& p : palm.positions) {
      if (p.x < static_cast<float>(0.070 * build.hand)) continue;
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
    EXPECT_NEAR(1000.0F * (high - low), other.hand_breadth, 5.0);
  }
}

TEST(SculptedTable, AnotherSignerIsAChangeOfNumbers) {
  Measurements taller = table();
  taller.forearm *= 1.1;
  const auto made = sculpt_figure(taller);
  ASSERT_TRUE(made);
  const Skeleton& s = made->skeleton;
  const Vec3 v = s.rest_position(s.find("wrist_r")) - s.rest_position(s.find("elbow_r"));
  EXPECT_NEAR(1000.0 * std::sqrt(glm::dot(v, v)), taller.forearm, 0.01);
}

}  // namespace
}  // namespace auslan
