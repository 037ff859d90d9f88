// SPDX-License-Identifier: Apache-2.0
#include "sculpt/sculpt.h"

#include "layout.h"
#include "occlusion.h"

#include <array>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

namespace auslan {

namespace sculpt {

TrunkJoints trunk_joints(const Measurements& table) {
  TrunkJoints joints;
  joints.spine_base = {0.0, table.hip_height, 0.0};
  joints.neck_base = {0.0, table.neck_base_height, 0.0 - table.neck_base_depth};
  joints.head_base = {0.0, table.stature - table.eye_to_vertex - kEyeLevel, 0.0};
  joints.shoulder = {0.5 * table.shoulder_joint_breadth, table.acromial_height - table.acromion_to_shoulder_joint,
                     0.0 - 0.5 * table.neck_base_depth};
  // The sternoclavicular joint, beside the notch at the top of the breastbone: the collar bone leads out and backwards
  // from there, by a fifth of its length and about level.
  joints.clavicle = {kSternoclavicular, joints.shoulder.y,
                     joints.shoulder.z + 0.2 * (joints.shoulder.x - kSternoclavicular)};
  joints.elbow = joints.shoulder + Vec3(table.upper_arm - table.acromion_to_shoulder_joint, 0.0, 0.0);
  joints.wrist = joints.elbow + Vec3(table.forearm, 0.0, 0.0);
  return joints;
}

DigitLine digit_line(const Measurements& table, int digit) {
  const DigitMeasurements& measures = table.digits[static_cast<size_t>(digit)];
  DigitLine line;
  line.direction = {1.0, 0.0, 0.0};
  line.back = {0.0, 1.0, 0.0};
  if (digit == 0) {
    const Angle out = angle_deg(table.thumb_angle_deg);
    const Angle drop = angle_deg(table.thumb_drop_deg);
    line.direction = {out.cosine * drop.cosine, -drop.sine, out.sine * drop.cosine};
    // The nail faces half up, half away from the index (HandAngles counts the thumb's flexion from there).
    const Vec3 away = normalised(Vec3(-out.sine, 0.0, out.cosine));
    const Vec3 up = glm::cross(away, line.direction);
    line.back = normalised(away + up);
  }
  line.joints[0] = measures.root;
  line.joints[1] = line.joints[0] + line.direction * measures.bones[0];
  line.joints[2] = line.joints[1] + line.direction * measures.bones[1];
  line.tip = line.joints[2] + line.direction * (measures.bones[2] + measures.tip);
  return line;
}

namespace {

/// Triangles of a segment.
struct Budget {
  size_t low, normal;
};
constexpr Budget kTrunkBudget{340, 2300}, kNeckBudget{90, 360}, kHeadBudget{1940, 6698};
constexpr Budget kUpperArmBudget{150, 560}, kForearmBudget{130, 440}, kPalmBudget{500, 1250};
constexpr Budget kPhalanxBudget{38, 200}, kTipBudget{54, 255};  // the last bone has a nail

constexpr std::array<std::array<std::string_view, 3>, 5> kDigitNodes = {{{"thumb_cmc", "thumb_mp", "thumb_ip"},
                                                                         {"index_mp", "index_pip", "index_dip"},
                                                                         {"middle_mp", "middle_pip", "middle_dip"},
                                                                         {"ring_mp", "ring_pip", "ring_dip"},
                                                                         {"little_mp", "little_pip", "little_dip"}}};

}  // namespace
}  // namespace sculpt

Result<Skeleton> sculpt_skeleton(const Measurements& table) {
  using sculpt::kDigitNodes;
  const sculpt::TrunkJoints trunk = sculpt::trunk_joints(table);
  std::vector<Node> nodes;
  const auto add = [&nodes](std::string name, int parent, const Vec3& offset_mm) {
    nodes.push_back({std::move(name), parent, offset_mm * 0.001});
    return static_cast<int>(nodes.size()) - 1;
  };
  const int spine = add("spine_base", kNoNode, trunk.spine_base);
  const int neck = add("neck_base", spine, trunk.neck_base - trunk.spine_base);
  add("head_base", neck, trunk.head_base - trunk.neck_base);
  for (const bool left : {true, false}) {
    const std::string suffix = left ? "_l" : "_r";
    const auto on_side = [left](const Vec3& v) { return left ? v : Vec3(0.0 - v.x, v.y, v.z); };
    const int clavicle = add("clavicle" + suffix, spine, on_side(trunk.clavicle - trunk.spine_base));
    const int shoulder = add("shoulder" + suffix, clavicle, on_side(trunk.shoulder - trunk.clavicle));
    const int elbow = add("elbow" + suffix, shoulder, on_side(trunk.elbow - trunk.shoulder));
    const int wrist = add("wrist" + suffix, elbow, on_side(trunk.wrist - trunk.elbow));
    for (int digit = 0; digit < 5; ++digit) {
      const sculpt::DigitLine line = sculpt::digit_line(table, digit);
      int parent = wrist;
      Vec3 origin(0.0);
      for (size_t bone = 0; bone < 3; ++bone) {
        const std::string_view name = kDigitNodes[static_cast<size_t>(digit)][bone];
        parent = add(std::string(name) + suffix, parent, on_side(line.joints[bone] - origin));
        origin = line.joints[bone];
      }
    }
  }
  return Skeleton::build(std::move(nodes));
}

Result<Figure> sculpt_figure(const Measurements& table, Detail detail) {
  Result<Skeleton> skeleton = sculpt_skeleton(table);
  if (!skeleton) return tl::unexpected<Error>(skeleton.error());
  Figure figure;
  figure.name = table.name;
  figure.skeleton = std::move(*skeleton);
  figure.segments.resize(static_cast<size_t>(figure.skeleton.size()));
  for (const TableAppearance& look : table.appearances)
    figure.appearances.push_back(sculpt::appearance_of(look));
  const auto place_of = [&figure](const std::string& node) {
    return figure.skeleton.rest_position(figure.skeleton.find(node));
  };
  const auto colour = [&figure](Mesh& mesh) {
    for (size_t i = 0; i < mesh.paint.size(); ++i)
      mesh.colours[i] = painted(mesh.paint[i], figure.appearances.front());
  };
  // What is reduced has its colours without occlusion, which is soft and needs no triangles of its own.
  const auto coloured = [&](sculpt::Sculpture made) {
    colour(made.mesh);
    return made;
  };
  const auto finished = [&](sculpt::Sculpture made, const sculpt::Budget& budget) {
    Mesh mesh = detail == Detail::kHigh ? std::move(made.mesh)
                                        : sculpt::reduced(made, detail == Detail::kLow ? budget.low : budget.normal);
    colour(mesh);
    return mesh;
  };
  const auto segment = [&figure](const std::string& name) -> Mesh& {
    return figure.segments[static_cast<size_t>(figure.skeleton.find(name))];
  };
  const auto place = [&](const std::string& name, sculpt::Sculpture made, const sculpt::Budget& budget) {
    segment(name) = finished(std::move(made), budget);
  };
  const auto place_both = [&](const std::string& name, sculpt::Sculpture made, const sculpt::Budget& budget) {
    Mesh& left = segment(name + "_l");
    left = finished(std::move(made), budget);
    segment(name + "_r") = sculpt::mirrored(left);
  };

  sculpt::Sculpture trunk = coloured(sculpt::sculpt_trunk(table)), neck = coloured(sculpt::sculpt_neck(table)),
                    head = coloured(sculpt::sculpt_head(table));
  // Trunk, neck and head stand much as at rest; what limbs and fingers hide moves, and is left to the light.
  const std::array<sculpt::Occluder, 3> upright = {
      {{&trunk, place_of("spine_base")}, {&neck, place_of("neck_base")}, {&head, place_of("head_base")}}};
  sculpt::bake_occlusion(trunk, place_of("spine_base"), std::span(upright).first(2), 60.0, 0.5);
  sculpt::bake_occlusion(neck, place_of("neck_base"), upright, 80.0, 0.6);
  sculpt::bake_occlusion(head, place_of("head_base"), std::span(upright).last(1), 45.0, 0.75);
  const auto alone = [](sculpt::Sculpture made, double reach, double strength) {
    const sculpt::Occluder itself{&made, Vec3(0.0)};
    sculpt::bake_occlusion(made, Vec3(0.0), std::span(&itself, 1), reach, strength);
    return made;
  };
  place("spine_base", std::move(trunk), sculpt::kTrunkBudget);
  place("neck_base", std::move(neck), sculpt::kNeckBudget);
  place("head_base", std::move(head), sculpt::kHeadBudget);
  place_both("shoulder", alone(coloured(sculpt::sculpt_upper_arm(table)), 40.0, 0.5), sculpt::kUpperArmBudget);
  place_both("elbow", coloured(sculpt::sculpt_forearm(table)), sculpt::kForearmBudget);
  place_both("wrist", alone(coloured(sculpt::sculpt_palm(table)), 30.0, 0.45), sculpt::kPalmBudget);
  for (int digit = 0; digit < 5; ++digit) {
    for (int bone = 0; bone < 3; ++bone) {
      const std::string_view name = sculpt::kDigitNodes[static_cast<size_t>(digit)][static_cast<size_t>(bone)];
      place_both(std::string(name), coloured(sculpt::sculpt_phalanx(table, digit, bone)),
                 bone == 2 ? sculpt::kTipBudget : sculpt::kPhalanxBudget);
    }
  }
  return figure;
}

}  // namespace auslan
