// SPDX-License-Identifier: Apache-2.0
#include "judge.h"

#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

// Skin that is farther is not looked for, metres.
constexpr double kFarthest = 0.1;
// A contact is approached over the last of its way, metres, within this time.
constexpr double kApproachLength = 0.015;
constexpr Tick kApproach = kTicksPerSecond / 4;
// A part that was as near to the skin before slid along it, metres.
constexpr double kSliding = 0.005;

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

double degrees_between(const Vec3& a, const Vec3& b) {
  return arc_cosine(glm::dot(unit(a), unit(b))) / kDegree;
}

/// "-12 degrees".
std::string in_degrees(double radians) {
  const double degrees = radians / kDegree;
  return std::to_string(static_cast<int>(degrees < 0.0 ? degrees - 0.5 : degrees + 0.5)) + " degrees";
}

/// The groups of the body that a place belongs to.
std::vector<BodyGroup> groups_of(Location location, Side side) {
  const bool left = side == Side::kLeft;
  if (is_on_head(location)) return {BodyGroup::kHead, BodyGroup::kTrunk};
  if (location == Location::kUpperArm || location == Location::kElbow || location == Location::kOtherElbow)
    return {left ? BodyGroup::kRightUpperArm : BodyGroup::kLeftUpperArm,
            left ? BodyGroup::kRightForearm : BodyGroup::kLeftForearm};
  // In the air there is nothing else to touch.
  if (is_on_other_hand(location) || is_in_space(location))
    return {left ? BodyGroup::kRightHand : BodyGroup::kLeftHand,
            left ? BodyGroup::kRightForearm : BodyGroup::kLeftForearm};
  return {BodyGroup::kTrunk, BodyGroup::kHead};
}

}  // namespace

Judge::Judge(const Signer& signer, const BodySolids& solids, const Score& score, Verdict& verdict)
    : signer_(signer),
      solids_(solids),
      skeleton_(signer.figure().skeleton),
      score_(score),
      performance_(signer, score, {.left_handed = false, .idle = false, .seed = 1}),
      verdict_(verdict),
      world_(static_cast<size_t>(skeleton_.size())),
      arms_{arm_nodes(skeleton_, Side::kLeft), arm_nodes(skeleton_, Side::kRight)} {}

void Judge::run() {
  over_time();
  at_targets();
  at_keys();
  strokes();
  holds();
  rates();
  mirror_image();
}

bool Judge::note(Measure measure, double value, Tick time, std::string where) {
  std::optional<Measured>& worst = verdict_.worst[static_cast<size_t>(measure)];
  const bool worse = !worst || badness(measure, value) > badness(measure, worst->value) ||
                     (badness(measure, worst->value) == 0.0 && value > worst->value);
  if (worse) worst = Measured{value, time, std::move(where), {}};
  return worse;
}

void Judge::explain(Measure measure, std::string detail) {
  verdict_.worst[static_cast<size_t>(measure)]->detail = std::move(detail);
}

void Judge::pose_at(Tick time) {
  performance_.sample(time, pose_);
  forward(skeleton_, pose_, world_);
}

bool Judge::may_touch(BodyGroup a, BodyGroup b) const {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const BodyGroup hand = side == Side::kLeft ? BodyGroup::kLeftHand : BodyGroup::kRightHand;
    if (a != hand && b != hand) continue;
    const BodyGroup met = a == hand ? b : a;
    for (const HandTarget& target : score_.targets[static_cast<size_t>(side)]) {
      if (!target.touches) continue;
      const auto groups = groups_of(target.location, side);
      if (std::find(groups.begin(), groups.end(), met) != groups.end()) return true;
    }
  }
  return false;
}

bool Judge::is_on_face() const {
  for (const auto& side : score_.targets)
    for (const HandTarget& target : side)
      if (is_on_head(target.location)) return true;
  return false;
}

bool Judge::hides(const Vec3& eye, const Vec3& point) const {
  // A finger is no thinner than this, so that steps of half of it miss none.
  constexpr double kStepLength = 0.005;
  // A hand that hides the face is before it, no farther than an arm reaches.
  constexpr double kReach = 0.6;
  const Vec3 towards = unit(eye - point);
  for (const BodyGroup hand : {BodyGroup::kLeftHand, BodyGroup::kRightHand}) {
    if (!solids_.may_cross(hand, point, point + towards * kReach, world_)) continue;
    double along = 0.01;
    while (along < kReach) {
      const auto distance = solids_.distance(hand, point + towards * along, kReach, world_);
      if (!distance) break;
      if (*distance <= 0.0) return true;
      along += std::max(kStepLength, *distance);
    }
  }
  return false;
}

std::optional<NearestSkin> Judge::nearest_of(const std::vector<BodyGroup>& groups, const Vec3& point,
                                             double within) const {
  std::optional<NearestSkin> nearest;
  for (const BodyGroup group : groups) {
    const auto found = solids_.nearest(group, point, within, world_);
    if (found && (!nearest || std::abs(found->surface.distance) < std::abs(nearest->surface.distance))) nearest = found;
  }
  return nearest;
}

void Judge::over_time() {
  const bool face_is_free = !is_on_face();
  const int head = skeleton_.find("head_base");
  const Vec3 head_rest = skeleton_.rest_position(head);
  std::array<Vec3, 3> seen = {signer_.body().site(Location::kMouth, Side::kRight, Vec3(0.0), true).position,
                              signer_.body().site(Location::kEye, Side::kLeft, Vec3(0.0), true).position,
                              signer_.body().site(Location::kEye, Side::kRight, Vec3(0.0), true).position};
  int frames = 0;
  int hidden = 0;
  Tick hidden_at = 0;
  std::array<Vec3, 2> before{};
  std::vector<Quat> turned;
  std::vector<Transform> were;
  const auto pairs = BodySolids::pairs();
  std::vector<bool> touching;
  for (const auto& [a, b] : pairs)
    touching.push_back(may_touch(a, b));
  for (Tick time = 0; time <= score_.end; time += kCheckStep) {
    pose_at(time);
    for (int node = 0; node < skeleton_.size(); ++node) {
      const Quat& rotation = pose_.rotation[static_cast<size_t>(node)];
      if (time > 0 && rotation == turned[static_cast<size_t>(node)]) continue;
      const double beyond = limit_violation(skeleton_, node, rotation) / kDegree;
      if (note(Measure::kJointLimits, beyond, time, name(node)) && beyond > 0.0)
        explain(Measure::kJointLimits, limit_detail(node));
      if (time > 0)
        note(Measure::kJointSpeed,
             angle_between(turned[static_cast<size_t>(node)], rotation) / kDegree * kChecksPerSecond, time, name(node));
    }
    turned = pose_.rotation;
    for (size_t side = 0; side < 2; ++side) {
      const Vec3 wrist = world_[static_cast<size_t>(arms_[side].wrist)].position;
      if (time > 0)
        note(Measure::kWristSpeed, length(wrist - before[side]) * kChecksPerSecond, time, name(arms_[side].wrist));
      before[side] = wrist;
    }
    note(Measure::kPenetration, 0.0, 0, "");
    for (size_t i = 0; i < pairs.size(); ++i) {
      // Only what is worse than all before it is looked for.
      const Measure measure = touching[i] ? Measure::kPressing : Measure::kPenetration;
      const auto& worst = verdict_.of(measure);
      const double floor = worst ? worst->value * 1e-3 * (1.0 - 1e-12) : 0.0;
      if (const auto found = solids_.overlap(pairs[i].first, pairs[i].second, floor, world_, were))
        note(measure, found->depth * 1e3, time, name(found->node_a) + " in " + name(found->node_b));
    }
    were = world_;
    if (!face_is_free) continue;
    const Transform& placed = world_[static_cast<size_t>(head)];
    const Vec3 eye = placed.position + Vec3(0.0, 0.0, 3.0);
    ++frames;
    for (const Vec3& point : seen) {
      if (!hides(eye, apply(placed, point - head_rest))) continue;
      ++hidden;
      hidden_at = time;
      break;
    }
  }
  if (frames > 0) note(Measure::kFaceHidden, 100.0 * hidden / frames, hidden_at, "mouth or eyes");
}

void Judge::at_targets() {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const HandTarget& target : score_.targets[static_cast<size_t>(side)]) {
      pose_at(target.end);
      posture(side, target);
      if (target.touches || target.stand_off > 0.0) contact(side, target);
      if (target.touches) approach(side, target);
    }
  }
}

void Judge::posture(Side side, const HandTarget& target) {
  const ArmNodes& arm = arms_[static_cast<size_t>(side)];
  const HandFrame& frame = signer_.hand_frame(side);
  // What the trunk's turn does to directions is not the hand's fault.
  const Quat turned = glm::conjugate(placed(skeleton_.find("spine_base")).rotation) * placed(arm.wrist).rotation;
  for (const Vec3& axis : {frame.fingers, frame.palm})
    note(Measure::kDirection, degrees_between(turned * axis, target.reached * axis), target.end,
         name(arm.wrist) + (axis == frame.fingers ? " fingers" : " palm"));
  const auto leaning = [&](const Vec3& axis, const Vec3& stated, const char* what) {
    const double degrees = degrees_between(target.reached * axis, stated);
    if (note(Measure::kLeaning, degrees, target.end, name(arm.wrist) + what) &&
        badness(Measure::kLeaning, degrees) > 0.0)
      explain(Measure::kLeaning, direction_detail(side, target));
  };
  leaning(frame.fingers, target.fingers, " fingers");
  // Of the palm only what lies across the fingers can be stated freely.
  const Vec3 fingers = unit(target.fingers);
  const Vec3 palm = target.palm - fingers * glm::dot(target.palm, fingers);
  if (glm::dot(palm, palm) > 1e-3) leaning(frame.palm, palm, " palm");
  Pose stated = pose_;
  pose_hand(skeleton_, side, target.angles, stated);
  for (const auto& digit : arm.digits)
    for (const int node : digit)
      note(Measure::kHandshape,
           angle_between(stated.rotation[static_cast<size_t>(node)], pose_.rotation[static_cast<size_t>(node)]) /
               kDegree,
           target.end, name(node));
}

std::string Judge::direction_detail(Side side, const HandTarget& target) const {
  const ArmNodes& arm = arms_[static_cast<size_t>(side)];
  const Transform& wrist = placed(arm.wrist);
  const Quat trunk = placed(skeleton_.find("spine_base")).rotation;
  // The hand as stated, what it brings to its place where it is.
  Transform stated;
  stated.rotation = trunk * orient_hand(signer_.hand_frame(side), target.fingers, target.palm);
  stated.position = apply(wrist, target.part) - stated.rotation * target.part;
  const Transform& base = placed(arm.trunk);
  double least = 1e9;
  for (double swivel = -60.0; swivel <= 150.0; swivel += 2.5) {
    const ArmSolution solved = solve_arm(skeleton_, side, base, stated, swivel * kDegree);
    if (!solved.reachable) continue;
    least = std::min(least, limit_violation(skeleton_, arm.shoulder, solved.shoulder) +
                                limit_violation(skeleton_, arm.elbow, solved.elbow) +
                                limit_violation(skeleton_, arm.wrist, solved.wrist));
  }
  if (least >= 1e9) return "as stated the place is out of reach";
  if (least <= 0.05 * kDegree) return "an arm within its limits could show it there";
  return "as stated there the arm's joints go at least " + in_degrees(least) + " too far";
}

std::string Judge::limit_detail(int node) const {
  const auto limits = joint_limits(skeleton_, node);
  if (!limits) return {};
  const JointAngles angles = joint_angles(skeleton_, node, pose_.rotation[static_cast<size_t>(node)]);
  std::string text;
  const auto add = [&](const char* what, double angle, double low, double high) {
    if (angle >= low && angle <= high) return;
    text += (text.empty() ? "" : ", ") + std::string(what) + " of " + in_degrees(angle) + " beyond " +
            in_degrees(angle < low ? low : high);
  };
  add("flexion", angles.flexion, limits->flexion_low, limits->flexion_high);
  add("abduction", angles.abduction, limits->abduction_low, limits->abduction_high);
  add("twist", angles.twist, limits->twist_low, limits->twist_high);
  return text;
}

void Judge::contact(Side side, const HandTarget& target) {
  const std::vector<BodyGroup> groups = groups_of(target.location, side);
  if (!target.touches && is_in_space(target.location)) return;
  const int wrist = arms_[static_cast<size_t>(side)].wrist;
  const auto nearest = nearest_of(groups, apply(placed(wrist), target.part), kFarthest);
  const double distance = nearest ? nearest->surface.distance : kFarthest;
  note(target.touches ? Measure::kContact : Measure::kStandOff, std::abs(distance - target.stand_off) * 1e3, target.end,
       name(wrist) + " to " + std::string(to_name(target.location)));
}

void Judge::approach(Side side, const HandTarget& target) {
  const std::vector<BodyGroup> groups = groups_of(target.location, side);
  const int wrist = arms_[static_cast<size_t>(side)].wrist;
  pose_at(target.begin);
  const auto touched = nearest_of(groups, apply(placed(wrist), target.part), kFarthest);
  if (!touched) return;
  // As the touched part sees it: it may move too.
  const auto seen = [&](const Vec3& point) {
    const Transform& from = placed(touched->node);
    return glm::conjugate(from.rotation) * (point - from.position);
  };
  const Vec3 end = seen(apply(placed(wrist), target.part));
  const Vec3 inwards = -(glm::conjugate(placed(touched->node).rotation) * touched->surface.normal);
  for (Tick time = target.begin - kCheckStep; time >= std::max<Tick>(0, target.begin - kApproach); time -= kCheckStep) {
    pose_at(time);
    const Vec3 point = apply(placed(wrist), target.part);
    const Vec3 way = end - seen(point);
    if (length(way) < kApproachLength) continue;
    // What slides along a surface has come before.
    const auto before = nearest_of(groups, point, kFarthest);
    if (before && std::abs(before->surface.distance) < kSliding) return;
    note(Measure::kApproach, degrees_between(way, inwards), time, name(wrist) + " to " + name(touched->node));
    return;
  }
}

}  // namespace auslan
