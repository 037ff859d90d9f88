// SPDX-License-Identifier: Apache-2.0
#include "synthesis/signer.h"

#include "arm_sites.h"
#include "hand_fit.h"
#include "hand_starts.h"
#include "kinematics/arm_ik.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
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

// What an elbow's place costs. A hand leans freely by a little, then a degree costs as much as moving the elbow by six,
// and more from where it is nearly half way to another of the 26 directions. Of a forearm in the body, 2 mm cost as
// much as a radian of swivel, and no depth is for nothing.
constexpr double kPreferredSwivel = 25.0 * kDegree, kLowestSwivel = -60.0 * kDegree, kHighestSwivel = 150.0 * kDegree;
// An elbow farther than this from where it likes to be is seen to be raised.
constexpr double kEasySwivel = 45.0 * kDegree, kRaisedCost = 10.0;
// So is one that is lifted, whatever the swivel: an upper arm may rise to 30 degrees below the level for nothing. While
// a hand is fitted a lift by a tenth of the upper arm is as bad as three degrees of leaning.
constexpr double kEasyHeight = 0.5, kHighElbowCost = 60.0, kHighElbowLean = 0.5;
constexpr int kSwivels = 15;
constexpr double kFreeLean = 2.0 * kDegree, kTrueLean = 18.0 * kDegree;
constexpr double kLeanCost = 36.0, kFarLeanCost = 600.0, kExcessCost = 2000.0, kOffCost = 1e4, kDepthCost = 1e5,
                 kAnyDepthCost = 300.0;
constexpr double kContactLean = 12.0 * kDegree;
constexpr double kComesFrom = 0.03, kWell = 0.002;
// What is no deeper or farther off than this is seen as touching; a hand that gets nowhere sets out from farther off.
constexpr double kStillRight = 0.0028, kFarthestOut = 0.12;  // metres
// What costs more than this is not made right by tilting, metres.
constexpr double kHopeless = 0.025;
// What is sought for longer leans freely by this much and touches with what lies so much farther about the part; less
// trouble than this is none.
constexpr double kSoughtLean = 17.0 * kDegree, kFarBeside = 1.5, kUntroubled = 0.9;
constexpr double kTilt = 25.0 * kDegree;
// A hand in the air shows its direction this well where the arm can; the elbow is looked for in such steps.
constexpr double kSeenLean = 4.95 * kDegree, kSoughtStep = 2.5 * kDegree, kSoughtExcess = 2.0 * kDegree;
constexpr int kSoughtSwivels = 60;
constexpr double kShiftCost = 1000.0, kLargestShift = 0.1;  // of a hand in the air; per square metre, metres

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

/// How far about its site a part of the hand extends, metres: any point of it may be what touches.
double extent(HandPart part) {
  switch (part) {
    case HandPart::kPalm:
    case HandPart::kBack:
    case HandPart::kFingers:
      return 0.05;
    case HandPart::kRadial:
    case HandPart::kUlnar:
    case HandPart::kFingertips:
    case HandPart::kKnuckles:
      return 0.035;
    case HandPart::kFistThumbSide:
    case HandPart::kFistUlnar:
      return 0.03;
    case HandPart::kIndexMiddleTips:
    case HandPart::kThumbIndexTips:
    case HandPart::kIndexMiddle:
    case HandPart::kThumbWeb:
    case HandPart::kWrist:
    case HandPart::kIndexSide:
    case HandPart::kThumbSide:
      return 0.02;
    default:
      return 0.009;
  }
}

/// How far about a part something else counts as beside it, metres.
double beside(HandPart part) {
  return std::min(0.06, 0.02 + 1.2 * extent(part));
}
// Of the normals of a part's points and its site: the cosine that they have at least.
constexpr double kFacesAlike = 0.5, kAnyWay = -2.0;

/// Of the other arm, above the forearm.
bool is_on_upper_half(Location location) {
  return location == Location::kUpperArm || location == Location::kElbow;
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
  image.on_face.x = -state.on_face.x;
  return image;
}

Signer::Signer(const Figure& figure, BodySites body, std::array<HandSites, 2> hands, bool seeks_longer)
    : figure_(&figure),
      seeks_longer_(seeks_longer),
      body_(std::move(body)),
      hands_(std::move(hands)),
      surface_(figure, seeks_longer),
      reach_{ArmReach(figure.skeleton, Side::kLeft), ArmReach(figure.skeleton, Side::kRight)},
      frames_{rest_hand_frame(figure.skeleton, Side::kLeft), rest_hand_frame(figure.skeleton, Side::kRight)},
      nodes_{arm_nodes(figure.skeleton, Side::kLeft), arm_nodes(figure.skeleton, Side::kRight)} {
  const Skeleton& skeleton = figure.skeleton;
  for (size_t side = 0; side < 2; ++side) {
    const ArmNodes& nodes = nodes_[side];
    trunk_[side] = skeleton.rest_position(nodes.trunk);
    std::vector<Site> lower = surface_.patch(nodes.shoulder).points;
    const Vec3 bone = skeleton.node(nodes.elbow).offset;
    std::erase_if(lower,
                  [&](const Site& point) { return glm::dot(point.position, bone) < 0.6 * glm::dot(bone, bone); });
    lower_upper_arm_[side] = in_pieces(std::move(lower));
  }
}

Result<Signer> Signer::build(const Figure& figure, const FigureTraits& traits) {
  auto body = BodySites::build(figure, traits.face);
  if (!body) return tl::unexpected(body.error());
  auto left = HandSites::build(figure, Side::kLeft);
  if (!left) return tl::unexpected(left.error());
  auto right = HandSites::build(figure, Side::kRight);
  if (!right) return tl::unexpected(right.error());
  return Signer(figure, std::move(*body), {std::move(*left), std::move(*right)}, traits.is_foreign);
}

ArmPlacement Signer::place_arm(Side side, const HandState& state, bool limited) const {
  const Skeleton& skeleton = figure_->skeleton;
  const ArmNodes& nodes = nodes_[static_cast<size_t>(side)];
  Transform above{kIdentity, trunk_[static_cast<size_t>(side)]};
  ArmSolution arm = reach(side).solve({state.wrist.rotation, state.wrist.position - above.position}, state.swivel);
  if (limited) arm = reach(side).limited(arm);
  if (nodes.clavicle != kNoNode) above = {arm.clavicle, apply(above, skeleton.node(nodes.clavicle).offset)};
  ArmPlacement placed;
  placed.shoulder = {above.rotation * arm.shoulder, apply(above, skeleton.node(nodes.shoulder).offset)};
  placed.elbow = {placed.shoulder.rotation * arm.elbow, apply(placed.shoulder, skeleton.node(nodes.elbow).offset)};
  placed.wrist = {placed.elbow.rotation * arm.wrist, apply(placed.elbow, skeleton.node(nodes.wrist).offset)};
  return placed;
}

Site Signer::other_site(Location location, HandPart touching, Side other_side, const HandState& other,
                        const Vec3& comes_from, const Vec3& offset) const {
  if (is_on_arm(location)) {
    const auto which = static_cast<size_t>(other_side);
    return arm_site({*figure_, nodes_[which], frames_[which], place_arm(other_side, other)}, location, comes_from,
                    offset);
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
  const bool on_arm = is_on_upper_half(location);
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

  bring(side, {part, local, site, contact}, counterpart, placed);
  if (state.follows_head > 0.0) state.on_face = placed.part;
  return placed;
}

void Signer::bring(Side side, const Meeting& meeting, const OtherHand& counterpart, PlacedHand& placed) const {
  const Site &local = meeting.local, &site = meeting.site;
  HandState& state = placed.state;
  // Where the hands are each other's images the other one is kept out by the plane between them.
  const bool on_arm = is_on_upper_half(placed.location);
  const bool meets_hand = is_on_other_hand(placed.location) || on_arm;
  std::vector<Obstacle> obstacles = body_obstacles(placed.touching && !meets_hand);
  const bool touches_other = placed.touching && meets_hand;
  const bool meets_other = counterpart.state != nullptr && !counterpart.mirrored && (meets_hand || counterpart.acts);
  if (meets_other) add_other_arm(other(side), *counterpart.state, touches_other, obstacles);
  // Whatever the hand touches, the arm keeps off; unless it is the wrist that touches.
  std::vector<Obstacle> of_arm = obstacles;
  if (meeting.part != HandPart::kWrist)
    for (Obstacle& obstacle : of_arm)
      obstacle.allowed = -kKeepsOff;
  const double outside = side == Side::kRight ? -1.0 : 1.0;
  std::optional<MirrorPlane> mirror;
  if (counterpart.mirrored && site.position.x * outside > -0.01)
    mirror = MirrorPlane{outside, -(touches_other ? 0.5 * kTouchesWithin : kKeepsOff), touches_other};

  // Who reaches across to the other arm lifts the elbow.
  const double mirrored_at = mirror ? outside : 0.0;
  Wish wish{state.wrist.rotation, local.position, site.position, !meeting.contact && !counterpart.shift, on_arm,
            mirrored_at};
  if (!meeting.contact && counterpart.shift) wish.target += *counterpart.shift;
  placed.shift = settle(side, wish, of_arm, state);
  const Vec3 target = wish.target + placed.shift;
  if (counterpart.shift) placed.shift = *counterpart.shift;
  const std::vector<SurfacePatch> patches = hand_patches(side, state.angles);
  std::vector<Vec3> touching;
  if (placed.touching) touching = points_about(local, patches, extent(meeting.part), kFacesAlike);
  std::array<PlacedPatch, 16> other_points;
  if (meets_other) other_points = hand_points(other(side), *counterpart.state);
  const auto admit = [&](const Vec3& pivot, Transform& wrist, double& swivel) {
    constexpr double kEnough = 0.5 * kDegree, kStep = 5.0 * kDegree;
    const Vec3& trunk = trunk_[static_cast<size_t>(side)];
    const Vec3 place = apply(wrist, pivot) - trunk;
    // A centimetre of the forearm in something is as bad as fourteen degrees of leaning.
    const auto missing = [&](const ArmReach::Reached& reached, double trial_swivel, double enough) {
      const double of_limits =
          reached.lean + 3.0 * reached.excess + (wish.lifts ? 0.0 : kHighElbowLean * elbow_height(side, reached.arm));
      if (of_limits >= enough) return of_limits;
      HandState trial = state;
      trial.wrist = {reached.wrist.rotation, reached.wrist.position + trunk};
      trial.swivel = trial_swivel;
      const double too_deep = 1.001 * (enough - of_limits) / 25.0;
      double deepest = arm_depth(side, trial, of_arm, mirrored_at, too_deep);
      if (meets_other && deepest < too_deep) {
        std::vector<Obstacle> forearm;
        add_forearm(side, trial, forearm);
        deepest = std::max(deepest, depth_in(other_points, forearm, {deepest, too_deep}).metres);
      }
      return of_limits + 25.0 * deepest;
    };
    ArmReach::Reached best = reach(side).reach(wrist.rotation, pivot, place, swivel);
    double least = missing(best, swivel, 1e9);
    for (const double sign : {1.0, -1.0}) {
      for (int i = 0; i < 3 && least > kEnough; ++i) {
        const ArmReach::Reached next = reach(side).reach(wrist.rotation, pivot, place, swivel + sign * kStep);
        const double found = missing(next, swivel + sign * kStep, least);
        if (found >= least) break;
        best = next;
        least = found;
        swivel += sign * kStep;
      }
    }
    wrist = {best.wrist.rotation, best.wrist.position + trunk};
    return best.excess;
  };
  // It comes from outside, so that what it meets is met from the right side. Where something is in the way it tries
  // from where it is wanted.
  const double free_lean =
      std::max(kContactLean, angle_between(wish.rotation, state.wrist.rotation) + 0.5 * kContactLean);
  HandFitGoal goal{wish.rotation, free_lean, local.position, target, touching, obstacles, mirror, std::nullopt, admit};
  std::vector<SurfacePatch> met;
  std::vector<Obstacle> own;
  if (meets_other) {
    met = hand_patches(other(side), counterpart.state->angles);
    own = hand_obstacles(side, {}, state.angles, -(touches_other ? kTouchesWithin : kKeepsOff), false);
    goal.met = MetHand{counterpart.state->wrist, met, own};
  }
  Transform outside_it = state.wrist;
  if (placed.touching) outside_it.position += site.normal * kComesFrom;
  HandFit fit = fit_hand(outside_it, state.swivel, patches, goal);
  if (placed.touching && fit.cost > kWell) {
    const HandFit direct = fit_hand(state.wrist, state.swivel, patches, goal);
    if (direct.cost < fit.cost) fit = direct;
  }
  const auto is_bad = [](const HandFit& found) { return found.deepest > kStillRight || found.gap > kStillRight; };
  Vec3 way = placed.touching ? site.normal : Vec3(0.0, 0.0, 1.0);
  if (mirror) way = Vec3(outside, 0.0, 0.0);
  if (meets_other && !placed.touching)
    way = unit(
        apply(state.wrist, local.position) -
        apply(counterpart.state->wrist, hand(other(side)).site(HandPart::kPalm, counterpart.state->angles).position));
  const auto out_of_all = [&](const Quat& rotation) {
    Transform wrist{rotation, goal.target - rotation * local.position};
    wrist.position += way_out(wrist, patches, goal, way, kFarthestOut) * way;
    return wrist;
  };
  if (is_bad(fit)) {
    // Turned as it is to be, out of everything, and from there.
    const Transform free_of_all = out_of_all(wish.rotation);
    const auto from = [&](Transform wrist, double swivel) {
      const double missing = goal.admit(local.position, wrist, swivel);
      const HandFit found = fit_hand(wrist, swivel, patches, goal, missing, fit.cost);
      if (found.cost < fit.cost) fit = found;
    };
    from(free_of_all, state.swivel);
    if (placed.touching && is_bad(fit)) {
      // As it is to be turned something else of the hand is before the part that is named: that touches.
      touching = points_about(local, patches, beside(meeting.part), kAnyWay);
      goal.region = touching;
      const Transform reached = fit.wrist;
      const double swivel = fit.swivel;
      from(free_of_all, state.swivel);
      if (is_bad(fit)) from(reached, swivel);
    }
    // Tilted to either side, as far as a hand may lean.
    const Vec3 across = unit(glm::cross(way, std::abs(way.y) < 0.7 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0)));
    for (const Vec3& axis : {across, glm::cross(way, across)})
      for (const double tilt : {kTilt, -kTilt})
        if (is_bad(fit) && fit.cost < kHopeless) from(out_of_all(axis_angle(axis, tilt) * wish.rotation), state.swivel);
  }
  const auto trouble_of = [&](const HandFit& found) {
    return trouble(side, wish, placed.touching, of_arm, state, found);
  };
  if (seeks_longer_) placed.trouble = trouble_of(fit);
  if (placed.trouble > kUntroubled) {
    if (placed.touching) {
      touching = points_about(local, patches, kFarBeside * beside(meeting.part), kAnyWay);
      goal.region = touching;
    }
    goal.free_lean = kSoughtLean;
    for (const HandStart& start : hand_starts(way)) {
      if (placed.trouble <= kUntroubled) break;
      goal.target = target + start.slide;
      Transform wrist = out_of_all(start.turn * wish.rotation);
      double swivel = start.swivel;
      const double missing = goal.admit(local.position, wrist, swivel);
      const HandFit found = fit_hand(wrist, swivel, patches, goal, missing);
      const double left = trouble_of(found);
      if (left >= placed.trouble) continue;
      fit = found;
      placed.trouble = left;
    }
  }
  state.wrist = fit.wrist;
  state.swivel = fit.swivel;
  if (!placed.touching && !meets_other && !mirror) turn_true(side, wish, of_arm, state);
  // What the other hand will meet is to be where it is seen: near its limits an arm is eased into them, less each time.
  constexpr int kTimes = 3;
  for (int i = 0; i < kTimes && seeks_longer_ && !placed.touching; ++i)
    state.wrist = place_arm(side, state, true).wrist;
  if (placed.touching) {
    placed.part = fit.touching;
    if (fit.gap < kStillRight && fit.normal != Vec3(0.0)) placed.normal = fit.normal;
  }
}

Vec3 Signer::settle(Side side, const Wish& wish, std::span<const Obstacle> obstacles, HandState& state) const {
  const ArmReach& arm = reach_[static_cast<size_t>(side)];
  const Vec3& trunk = trunk_[static_cast<size_t>(side)];
  constexpr int kCoarse = 3, kFine = 8;  // rounds
  struct Candidate {
    double swivel = 0.0, cost = 1e9;
    Transform wrist;
    bool solved = false;  ///< else the cost is the swivel's alone
  };
  const auto of_swivel = [](double swivel) {
    const double away = swivel - kPreferredSwivel, raised = std::max(0.0, std::abs(away) - kEasySwivel);
    return away * away + kRaisedCost * raised * raised;
  };
  const auto free_of_depth = [&](double swivel, const Vec3& shift, int rounds) {
    const ArmReach::Reached reached = arm.reach(wish.rotation, wish.pivot, wish.target + shift - trunk, swivel, rounds);
    Candidate candidate{swivel, 0.0, {reached.wrist.rotation, reached.wrist.position + trunk}, true};
    const double lean = std::max(0.0, reached.lean - kFreeLean), far = std::max(0.0, reached.lean - kTrueLean);
    const double high = wish.lifts ? 0.0 : elbow_height(side, reached.arm);
    candidate.cost = of_swivel(swivel) + kHighElbowCost * high * high + kLeanCost * lean * lean +
                     kFarLeanCost * far * far + kExcessCost * reached.excess * reached.excess +
                     kOffCost * reached.off * reached.off + kShiftCost * glm::dot(shift, shift);
    return candidate;
  };
  const auto with_depth = [&](Candidate candidate, double enough) {
    if (candidate.cost >= enough) return candidate;
    HandState trial = state;
    trial.wrist = candidate.wrist;
    trial.swivel = candidate.swivel;
    const double too_deep =
        1.001 * std::min(std::sqrt((enough - candidate.cost) / kDepthCost), (enough - candidate.cost) / kAnyDepthCost);
    const double depth = arm_depth(side, trial, obstacles, wish.mirrored_at, too_deep);
    candidate.cost += kDepthCost * depth * depth + kAnyDepthCost * depth;
    return candidate;
  };
  const auto best_for = [&](const Vec3& shift, double enough) {
    // What costs least so far is looked at more closely, until nothing that is left can be better.
    std::vector<Candidate> grid;
    for (int i = 0; i < kSwivels; ++i) {
      const double swivel = kLowestSwivel + (kHighestSwivel - kLowestSwivel) * i / (kSwivels - 1);
      grid.push_back({swivel, of_swivel(swivel), {}, false});
    }
    Candidate best;
    best.cost = enough;
    while (!grid.empty()) {
      const auto next = std::ranges::min_element(grid, {}, &Candidate::cost);
      if (next->cost >= best.cost) break;
      if (!next->solved) {
        *next = free_of_depth(next->swivel, shift, kCoarse);
        continue;
      }
      const Candidate found = with_depth(*next, best.cost);
      if (found.cost < best.cost) best = found;
      grid.erase(next);
    }
    if (best.cost >= enough) return best;
    for (double step = 7.0 * kDegree; step > 1.5 * kDegree; step *= 0.5) {
      for (const double sign : {1.0, -1.0}) {
        const double swivel = std::clamp(best.swivel + sign * step, kLowestSwivel, kHighestSwivel);
        if (of_swivel(swivel) >= best.cost) continue;
        const Candidate found = with_depth(free_of_depth(swivel, shift, kFine), best.cost);
        if (found.cost < best.cost) best = found;
      }
    }
    return best;
  };
  Vec3 shift(0.0);
  Candidate best = best_for(shift, 1e9);
  if (wish.free) {
    // Pattern search (Hooke & Jeeves) over the place.
    constexpr double kWorthIt = 0.35;  // the elbow's own comfort does not move the hand
    for (double step = 0.06; step > 0.025 && best.cost > kWorthIt; step *= 0.5) {
      for (bool better = true; better && best.cost > kWorthIt;) {
        better = false;
        for (glm::length_t axis = 0; axis < 3; ++axis) {
          for (const double sign : {1.0, -1.0}) {
            Vec3 candidate = shift;
            candidate[axis] += sign * step;
            if (glm::dot(candidate, candidate) > kLargestShift * kLargestShift) continue;
            const Candidate found = best_for(candidate, best.cost - 0.02);
            if (found.cost >= best.cost - 0.02) continue;
            best = found;
            shift = candidate;
            better = true;
          }
        }
      }
    }
  }
  state.wrist = best.wrist;
  state.swivel = best.swivel;
  return shift;
}

void Signer::turn_true(Side side, const Wish& wish, std::span<const Obstacle> of_arm, HandState& state) const {
  const HandFrame& frame = hand_frame(side);
  const auto leans_by = [&](const HandState& trial) {
    const Quat seen = place_arm(side, trial, true).wrist.rotation;
    const auto apart = [&](const Vec3& axis) {
      return arc_cosine(std::min(1.0, glm::dot(seen * axis, wish.rotation * axis)));
    };
    return std::max(apart(frame.fingers), apart(frame.palm));
  };
  if (leans_by(state) <= kSeenLean) return;
  const Vec3& trunk = trunk_[static_cast<size_t>(side)];
  const Vec3 place = apply(state.wrist, wish.pivot) - trunk;
  const Transform as_stated{wish.rotation, place - wish.rotation * wish.pivot};
  const double first = state.swivel;
  for (int i = 1; i <= 2 * kSoughtSwivels; ++i) {
    const double swivel = first + (i % 2 == 0 ? -1.0 : 1.0) * ((i + 1) / 2) * kSoughtStep;
    // What the limits take away is about what the hand has to lean.
    if (reach(side).excess(as_stated, swivel) > 2.0 * kSeenLean) continue;
    const ArmReach::Reached reached = reach(side).reach_to_ends(wish.rotation, wish.pivot, place, swivel);
    if (reached.lean > 2.0 * kSeenLean || reached.excess > kSoughtExcess) continue;
    HandState trial = state;
    trial.wrist = {reached.wrist.rotation, reached.wrist.position + trunk};
    trial.swivel = swivel;
    if (leans_by(trial) > kSeenLean || arm_depth(side, trial, of_arm, wish.mirrored_at, kKeepsOff) > 0.0 ||
        depth_in(hand_points(side, trial), of_arm, {0.0, kKeepsOff}).metres > 0.0)
      continue;
    state = trial;
    return;
  }
}

double Signer::arm_depth(Side side, const HandState& state, std::span<const Obstacle> obstacles, double mirrored_at,
                         double enough) const {
  const std::array<PlacedPatch, 2> arm = arm_patches(side, state);
  double deepest = 0.0;
  if (mirrored_at != 0.0) {
    for (const PlacedPatch& part : arm) {
      const auto beyond = [&](const Vec3& point) { return kKeepsOff - mirrored_at * apply(part.place, point).x; };
      if (beyond(part.patch->centre) + part.patch->radius <= deepest) continue;
      for (const Site& point : part.patch->points)
        deepest = std::max(deepest, beyond(point.position));
    }
  }
  return deepest >= enough ? deepest : depth_in(arm, obstacles, {deepest, enough}).metres;
}

double Signer::elbow_height(Side side, const ArmSolution& arm) const {
  const Vec3& bone = figure_->skeleton.node(nodes_[static_cast<size_t>(side)].elbow).offset;
  const Vec3 upper = unit(arm.clavicle * (arm.shoulder * bone));
  return std::max(0.0, upper.y + kEasyHeight);
}

std::vector<Vec3> Signer::points_about(const Site& site, std::span<const SurfacePatch> hand, double radius,
                                       double facing) {
  std::vector<Vec3> points;
  for (const SurfacePatch& patch : hand) {
    for (const Site& point : patch.points) {
      const Vec3 apart = point.position - site.position;
      if (glm::dot(apart, apart) < radius * radius && glm::dot(point.normal, site.normal) > facing)
        points.push_back(point.position);
    }
  }
  if (points.empty()) points.push_back(site.position);
  return points;
}

HandState Signer::rest(Side side) const {
  HandState state;
  const double s = side == Side::kRight ? -1.0 : 1.0;
  // Straight down from the shoulder and a little out, the elbow just bent.
  const Skeleton& skeleton = figure_->skeleton;
  const ArmNodes& nodes = nodes_[static_cast<size_t>(side)];
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
