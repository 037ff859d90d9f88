// SPDX-License-Identifier: Apache-2.0
#include "synthesis/signer.h"

#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/limits.h"
#include "kinematics/rotation.h"
#include "kinematics/surface.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace auslan {
namespace {

// An offset along a palm or forearm keeps the hand on it: no farther than this from its centre, metres.
constexpr double kPalmReach = 0.045;
// A hand that is `near` a place keeps this distance, metres.
constexpr double kNearDistance = 0.015;
// Where the natural elbow would put the forearm into the trunk, the arm swings about the line from shoulder to wrist
// until it is clear. Radii in metres.
constexpr double kElbowRadius = 0.045, kWristRadius = 0.028;
constexpr int kSwivelSteps = 28;
constexpr double kSwivelStep = 5.0 * kDegree;

// A hand whose stated direction would break the joint limits leans, as people's hands do: strain (radians beyond the
// limits) counts this much more than leaning, and no hand leans farther than it could be mistaken for another of the 26
// directions, which lie 45 degrees apart.
constexpr double kStrainWeight = 3.0, kComfort = 2.0 * kDegree, kLargestLean = 40.0 * kDegree;
constexpr double kFirstLean = 12.0 * kDegree, kLastLean = 1.0 * kDegree;
constexpr int kLeanRounds = 2;

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

Transform parent_of_shoulder(const Skeleton& skeleton, Side side) {
  const ArmNodes nodes = arm_nodes(skeleton, side);
  return {kIdentity, skeleton.rest_position(skeleton.node(nodes.shoulder).parent)};
}

/// The part that a hand touches with where the entry does not say: a pointing hand its tip, a broad one the palm when
/// that faces the place, else the fingertips.
HandPart default_part(const Handshape& handshape, bool palm_faces) {
  if (handshape.selected == "index") return HandPart::kIndexTip;
  if (handshape.selected == "middle") return HandPart::kMiddleTip;
  if (handshape.selected == "little") return HandPart::kLittleTip;
  if (handshape.selected == "thumb") return HandPart::kThumbTip;
  if (handshape.selected == "index+middle") return HandPart::kIndexMiddleTips;
  if (handshape.selected == "index+thumb") return HandPart::kThumbIndexTips;
  return palm_faces ? HandPart::kPalm : HandPart::kFingertips;
}

bool is_broad(Location location) {
  switch (location) {
    case Location::kOtherPalm:
    case Location::kOtherBack:
    case Location::kOtherWristBack:
    case Location::kOtherWristInner:
    case Location::kOtherForearmBack:
    case Location::kOtherForearmInner:
    case Location::kOtherUlnar:
      return true;
    default:
      return false;
  }
}

}  // namespace

HandAngles hand_angles(const Handshape& handshape) {
  HandAngles angles;
  for (size_t i = 0; i < 4; ++i) {
    const FingerAngles& finger = handshape.fingers[i];
    angles.fingers[i] = {finger.mcp * kDegree, finger.pip * kDegree, finger.dip * kDegree, finger.abduction * kDegree};
  }
  const ThumbAngles& thumb = handshape.thumb;
  angles.thumb = {thumb.radial_abduction * kDegree, thumb.palmar_abduction * kDegree, thumb.opposition,
                  thumb.mp * kDegree, thumb.ip * kDegree};
  return angles;
}

HandState mirrored(const HandState& state) {
  HandState image = state;
  const Quat& q = state.wrist.rotation;
  image.wrist.rotation = Quat(q.w, q.x, -q.y, -q.z);
  image.wrist.position.x = -state.wrist.position.x;
  return image;
}

Signer::Signer(const Figure& figure, const FigureTraits& traits, BodySites body, std::array<HandSites, 2> hands)
    : figure_(&figure),
      traits_(traits),
      body_(std::move(body)),
      hands_(std::move(hands)),
      trunk_(figure.segments[static_cast<size_t>(figure.skeleton.find("spine_base"))]),
      trunk_place_(figure.skeleton.rest_position(figure.skeleton.find("spine_base"))),
      frames_{rest_hand_frame(figure.skeleton, Side::kLeft), rest_hand_frame(figure.skeleton, Side::kRight)} {}

Result<Signer> Signer::build(const Figure& figure, const FigureTraits& traits) {
  auto body = BodySites::build(figure, traits.face);
  if (!body) return tl::unexpected(body.error());
  auto left = HandSites::build(figure, Side::kLeft);
  if (!left) return tl::unexpected(left.error());
  auto right = HandSites::build(figure, Side::kRight);
  if (!right) return tl::unexpected(right.error());
  return Signer(figure, traits, std::move(*body), {std::move(*left), std::move(*right)});
}

ArmPlacement Signer::place_arm(Side side, const HandState& state) const {
  const Skeleton& skeleton = figure_->skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Transform parent = parent_of_shoulder(skeleton, side);
  const ArmSolution arm = solve_arm(skeleton, side, parent, state.wrist, state.swivel);
  ArmPlacement placed;
  placed.shoulder = {parent.rotation * arm.shoulder, apply(parent, skeleton.node(nodes.shoulder).offset)};
  placed.elbow = {placed.shoulder.rotation * arm.elbow, apply(placed.shoulder, skeleton.node(nodes.elbow).offset)};
  placed.wrist = {placed.elbow.rotation * arm.wrist, apply(placed.elbow, skeleton.node(nodes.wrist).offset)};
  return placed;
}

Site Signer::other_site(Location location, HandPart touching, Side other_side, const HandState& other,
                        const Vec3& comes_from, const Vec3& offset) const {
  if (location == Location::kUpperArm || location == Location::kElbow) {
    const ArmPlacement arm = place_arm(other_side, other);
    const double along = location == Location::kUpperArm ? 0.45 : 0.97;
    const Vec3 axis = arm.elbow.position - arm.shoulder.position;
    const Vec3 middle = arm.shoulder.position + axis * along;
    // Upper arms are about as thick as a quarter of their length; the exact skin is found by a ray in the arm's own
    // frame.
    const Vec3 out = unit(comes_from - unit(axis) * glm::dot(comes_from, unit(axis)));
    const ArmNodes nodes = arm_nodes(figure_->skeleton, other_side);
    const std::array<int, 1> only = {nodes.shoulder};
    const Quat to_rest = glm::conjugate(arm.shoulder.rotation);
    const Vec3 rest_middle =
        figure_->skeleton.rest_position(nodes.shoulder) + to_rest * (middle - arm.shoulder.position);
    const Vec3 rest_out = to_rest * out;
    // The offset moves the ray across the arm, back onto the skin.
    const Vec3 slide = to_rest * (offset - out * glm::dot(offset, out));
    auto hit = cast_ray(*figure_, only, rest_middle + slide + rest_out * 0.5, -rest_out);
    if (!hit) hit = cast_ray(*figure_, only, rest_middle + rest_out * 0.5, -rest_out);
    if (!hit) return {middle + out * 0.05, out};
    return {apply(arm.shoulder, hit->position), arm.shoulder.rotation * hit->normal};
  }
  const Quat to_wrist = glm::conjugate(other.wrist.rotation);
  const Site local = hand(other_side).site_for(location, touching, other.angles, to_wrist * comes_from);
  return {apply(other.wrist, local.position), other.wrist.rotation * local.normal};
}

PlacedHand Signer::place(const Posture& posture, const Handshape& handshape, Side side,
                         const OtherHand& counterpart) const {
  PlacedHand placed;
  HandState& state = placed.state;
  state.angles = hand_angles(handshape);
  const Vec3 fingers = to_vector(posture.fingers);
  const Vec3 palm = to_vector(posture.palm);
  state.wrist.rotation = orient_hand(hand_frame(side), fingers, palm);
  const Vec3 offset = posture.offset;
  const bool contact = posture.contact.has_value();
  const ContactKind kind = contact ? posture.contact->kind : ContactKind::kNear;
  placed.touching = contact && kind != ContactKind::kNear;

  // A finer target on the other hand takes precedence over the posture's own location.
  Location location = posture.location;
  if (contact && posture.contact->target) location = *posture.contact->target;
  const bool on_arm = location == Location::kUpperArm || location == Location::kElbow;
  const bool on_other = is_on_other_hand(location) || on_arm;
  const bool palm_faces = is_on_head(location) || on_other ? palm.z < -0.5 || on_other : palm.z < -0.5;
  std::optional<HandPart> named;
  if (contact) named = posture.contact->part;
  const HandPart part = named ? *named : (placed.touching ? default_part(handshape, palm_faces) : HandPart::kPalm);
  const Site local = hand(side).site(part, state.angles);
  placed.part = local.position;
  placed.location = location;

  Site site;
  if (on_other && counterpart.mirrored) {
    // The two hands meet in the middle plane.
    site = body_.site(is_in_space(posture.location) ? posture.location : Location::kNeutral, side, offset, false);
    site.position.x = on_arm ? site.position.x : 0.0;
    site.normal = Vec3(side == Side::kRight ? -1.0 : 1.0, 0, 0);
  } else if (on_other && counterpart.state != nullptr) {
    // It is touched on the side that the touching part faces.
    // An upper arm hangs beside the trunk: what reaches across comes to its front and outside.
    const Vec3 outside(side == Side::kRight ? 0.5 : -0.5, 0.0, 1.0);
    const Vec3 comes_from = on_arm ? outside : -(state.wrist.rotation * local.normal);
    site = other_site(location, part, other(side), *counterpart.state, comes_from, offset);
    if (!placed.touching) {
      if (!on_arm) site.position += offset;
    } else if (is_broad(location)) {
      Vec3 slide = offset - site.normal * glm::dot(offset, site.normal);
      const double length = std::sqrt(glm::dot(slide, slide));
      if (length > kPalmReach) slide *= kPalmReach / length;
      site.position += slide;
    }
  } else {
    site = body_.site(on_other ? Location::kNeutral : location, side, offset, placed.touching);
  }
  if (contact && kind == ContactKind::kNear) {
    // An offset leads farther out.
    placed.stand_off = kNearDistance + std::max(0.0, glm::dot(offset, site.normal));
    site.position += site.normal * kNearDistance;
  }
  placed.normal = placed.touching ? site.normal : -palm;
  state.follows_head = is_on_head(location) && (placed.touching || kind == ContactKind::kNear) ? 1.0 : 0.0;
  reach_comfortably(side, local.position, site.position, state);
  return placed;
}

double Signer::strain(Side side, const HandState& state) const {
  const Skeleton& skeleton = figure_->skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const ArmSolution arm = solve_arm(skeleton, side, parent_of_shoulder(skeleton, side), state.wrist, state.swivel);
  return limit_violation(skeleton, nodes.shoulder, arm.shoulder) + limit_violation(skeleton, nodes.elbow, arm.elbow) +
         limit_violation(skeleton, nodes.wrist, arm.wrist);
}

void Signer::reach_comfortably(Side side, const Vec3& part, const Vec3& target, HandState& state) const {
  const Quat wanted = state.wrist.rotation;
  const auto turn_to = [&](const Vec3& lean) {
    state.wrist.rotation = from_rotation_vector(lean) * wanted;
    state.wrist.position = target - state.wrist.rotation * part;
  };
  Vec3 lean(0.0);
  turn_to(lean);
  state.swivel = swivel_for(side, state.wrist);
  const auto cost = [&](const Vec3& candidate) {
    const double angle = std::sqrt(glm::dot(candidate, candidate));
    if (angle > kLargestLean) return 1e3;
    turn_to(candidate);
    return kStrainWeight * strain(side, state) + angle;
  };
  // Pattern search (Hooke & Jeeves) over the lean, with the swivel found anew after each round.
  for (int round = 0; round < kLeanRounds; ++round) {
    double least = cost(lean);
    if (least < kStrainWeight * kComfort) break;
    for (double step = kFirstLean; step > kLastLean; step *= 0.5) {
      for (bool better = true; better;) {
        better = false;
        for (int axis = 0; axis < 3; ++axis) {
          for (const double sign : {1.0, -1.0}) {
            Vec3 candidate = lean;
            candidate[axis] += sign * step;
            const double found = cost(candidate);
            if (found >= least - 1e-9) continue;
            least = found;
            lean = candidate;
            better = true;
          }
        }
      }
    }
    turn_to(lean);
    state.swivel = swivel_for(side, state.wrist);
  }
  turn_to(lean);
}

void Signer::sink(const Vec3& centre, double radius, Depth& depth) const {
  constexpr double kReach = 0.3;  // no point of a trunk lies farther below its surface, metres
  const Vec3 place = centre - trunk_place_;
  for (glm::length_t i = 0; i < 3; ++i)
    if (place[i] < trunk_.low()[i] - radius || place[i] > trunk_.high()[i] + radius) return;
  const auto nearest = trunk_.nearest(place, kReach);
  if (!nearest || radius - nearest->distance <= depth.metres) return;
  depth.metres = radius - nearest->distance;
  depth.out = nearest->normal;
}

Depth Signer::hand_depth(Side side, const HandState& state) const {
  constexpr double kFingerRadius = 0.008, kPalmRadius = 0.015;
  Depth depth;
  sink(state.wrist.position, kWristRadius, depth);
  const auto part = [&](HandPart at, double radius) {
    sink(apply(state.wrist, hand(side).site(at, state.angles).position), radius, depth);
  };
  part(HandPart::kPalm, kPalmRadius);
  for (const HandPart tip :
       {HandPart::kThumbTip, HandPart::kIndexTip, HandPart::kMiddleTip, HandPart::kLittleTip, HandPart::kIndexKnuckle})
    part(tip, kFingerRadius);
  return depth;
}

Depth Signer::forearm_depth(Side side, const HandState& state) const {
  const ArmPlacement arm = place_arm(side, state);
  Depth depth;
  for (const double along : {0.0, 0.3, 0.6, 0.9})
    sink(arm.elbow.position + (arm.wrist.position - arm.elbow.position) * along, mix(kElbowRadius, kWristRadius, along),
         depth);
  return depth;
}

double Signer::swivel_for(Side side, const Transform& world_from_wrist) const {
  const Transform parent = parent_of_shoulder(figure_->skeleton, side);
  const double natural = natural_swivel(figure_->skeleton, side, parent, world_from_wrist);
  const auto depth = [&](double swivel) {
    HandState state;
    state.wrist = world_from_wrist;
    state.swivel = swivel;
    return forearm_depth(side, state).metres;
  };
  double best = natural, least = depth(natural);
  for (int step = 1; step <= kSwivelSteps && least > traits_.trunk_gives; ++step) {
    for (const double sign : {1.0, -1.0}) {
      const double swivel = natural + sign * step * kSwivelStep;
      const double found = depth(swivel);
      if (found >= least - 1e-4) continue;
      least = found;
      best = swivel;
    }
  }
  return best;
}

HandState Signer::rest(Side side) const {
  HandState state;
  const double s = side == Side::kRight ? -1.0 : 1.0;
  // Straight down from the shoulder and a little out, the elbow just bent.
  const Skeleton& skeleton = figure_->skeleton;
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Vec3 upper = skeleton.node(nodes.elbow).offset, fore = skeleton.node(nodes.wrist).offset;
  const double reach = 0.975 * (std::sqrt(glm::dot(upper, upper)) + std::sqrt(glm::dot(fore, fore)));
  state.wrist.rotation = orient_hand(hand_frame(side), Vec3(s * 0.06, -1.0, 0.16), Vec3(-s, 0.0, -0.25));
  state.wrist.position = body_.shoulder(side) + unit(Vec3(s * 0.17, -1.0, 0.12)) * reach;
  Handshape relaxed;
  relaxed.fingers = {FingerAngles{20, 25, 15, 3}, FingerAngles{24, 28, 17, 0}, FingerAngles{27, 31, 18, 2},
                     FingerAngles{30, 34, 20, 4}};
  relaxed.thumb = {20, 20, 0.3, 12, 12};
  state.angles = hand_angles(relaxed);
  state.swivel = 0.35;
  return state;
}

}  // namespace auslan
