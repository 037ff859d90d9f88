// SPDX-License-Identifier: Apache-2.0
#include "synthesis/hand_sites.h"

#include "kinematics/rotation.h"
#include "kinematics/surface.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

constexpr size_t kThumb = 0, kIndex = 1, kMiddle = 2, kRing = 3, kLittle = 4;

Vec3 across(const Vec3& v, const Vec3& axis) {
  return v - axis * glm::dot(v, axis);
}

}  // namespace

HandSites::HandSites(const Figure& figure, Side side)
    : rig_(figure.skeleton, side), frame_(rest_hand_frame(figure.skeleton, side)) {
  const ArmNodes nodes = arm_nodes(figure.skeleton, side);
  for (size_t d = 0; d < 5; ++d)
    for (size_t j = 0; j < 3; ++j)
      bone_[d][j] = figure.skeleton.node(nodes.digits[d][j]).offset;
}

Result<HandSites> HandSites::build(const Figure& figure, Side side) {
  HandSites sites(figure, side);
  const ArmNodes nodes = arm_nodes(figure.skeleton, side);
  const Skeleton& skeleton = figure.skeleton;
  for (size_t d = 0; d < 5; ++d) {
    for (size_t j = 0; j < 3; ++j) {
      const int node = nodes.digits[d][j];
      if (figure.segments[static_cast<size_t>(node)].indices.empty())
        return fail(ErrorCode::kUnsupported, "the figure has no surface on " + skeleton.node(node).name +
                                                 ", so that signs cannot touch with it; load a figure with full hands");
    }
    const int last = nodes.digits[d][2], before = nodes.digits[d][1];
    const Vec3 bone = unit(skeleton.rest_position(last) - skeleton.rest_position(before));
    sites.tip_[d] = extreme_point(figure, last, bone).position;
    for (size_t j = 0; j < 3; ++j) {
      // Half the thickness from back to palm, half way along the phalanx.
      const int node = nodes.digits[d][j];
      const Vec3 begin = skeleton.rest_position(node);
      const Vec3 end = j < 2 ? skeleton.rest_position(nodes.digits[d][j + 1]) : begin + sites.tip_[d];
      const Vec3 middle = 0.5 * (begin + end);
      const std::array<int, 1> only = {node};
      const auto below = cast_ray(figure, only, middle + sites.frame_.palm * 0.2, -sites.frame_.palm);
      const auto above = cast_ray(figure, only, middle - sites.frame_.palm * 0.2, sites.frame_.palm);
      sites.radius_[d][j] =
          below && above ? 0.5 * std::abs(glm::dot(below->position - above->position, sites.frame_.palm)) : 0.008;
    }
  }
  const Vec3 wrist = skeleton.rest_position(nodes.wrist);
  const Vec3 centre = 0.45 * wrist + 0.55 * skeleton.rest_position(nodes.digits[kMiddle][0]);
  const std::array<int, 1> palm_only = {nodes.wrist};
  const auto below = cast_ray(figure, palm_only, centre + sites.frame_.palm * 0.2, -sites.frame_.palm);
  const auto above = cast_ray(figure, palm_only, centre - sites.frame_.palm * 0.2, sites.frame_.palm);
  if (!below || !above)
    return fail(ErrorCode::kUnsupported, "the figure's palm has no surface; load a figure with full hands");
  sites.palm_depth_ = glm::dot(below->position + wrist - centre, sites.frame_.palm);
  sites.back_depth_ = -glm::dot(above->position + wrist - centre, sites.frame_.palm);
  return sites;
}

HandSites::Posed HandSites::pose(const HandAngles& angles) const {
  const DigitRotations rotation = rig_.rotations(angles);
  Posed posed;
  for (size_t d = 0; d < 5; ++d) {
    Transform parent;
    for (size_t j = 0; j < 3; ++j) {
      parent = {parent.rotation * rotation[d][j], apply(parent, bone_[d][j])};
      posed.joint[d][j] = parent;
    }
    posed.tip[d] = apply(parent, tip_[d]);
    // The pad: on the palmar side, a little before the tip.
    posed.pad[d] = apply(parent, 0.75 * tip_[d]) + parent.rotation * (frame_.palm * (radius_[d][2] * 0.9));
  }
  return posed;
}

Site HandSites::on_digit(const Posed& posed, size_t digit, double along, const Vec3& out) const {
  const double clamped = std::clamp(along, 0.0, 2.999);
  const auto j = static_cast<size_t>(clamped);
  const double t = clamped - static_cast<double>(j);
  const Vec3 begin = posed.joint[digit][j].position;
  const Vec3 end = j < 2 ? posed.joint[digit][j + 1].position : posed.tip[digit];
  const Vec3 axis = unit(end - begin);
  const Vec3 normal = unit(across(out, axis));
  return {begin + (end - begin) * t + normal * radius_[digit][j], normal};
}

Site HandSites::digit_place(const Posed& posed, const DigitSite& site) const {
  const auto d = static_cast<size_t>(site.digit);
  // Along the digit, and to which side of the hand's frame at rest.
  const auto at = [&](double along, const Vec3& side) {
    return on_digit(posed, d, along, posed.joint[d][static_cast<size_t>(along)].rotation * side);
  };
  constexpr double kEnd = 2.7, kMid = 1.0, kBase = 0.1, kLength = 1.5;
  const Vec3 &palm = frame_.palm, &radial = frame_.radial;
  switch (site.feature) {
    case DigitFeature::kTip:
      return {posed.tip[d], unit(posed.tip[d] - posed.joint[d][2].position)};
    case DigitFeature::kNail:
      return at(kEnd, -palm);
    case DigitFeature::kTipPad:
      return at(kEnd, palm);
    case DigitFeature::kTipRadial:
      return at(kEnd, radial);
    case DigitFeature::kTipUlnar:
      return at(kEnd, -radial);
    case DigitFeature::kMidPalmar:
      return at(kMid, palm);
    case DigitFeature::kMidDorsal:
      return at(kMid, -palm);
    case DigitFeature::kMidRadial:
      return at(kMid, radial);
    case DigitFeature::kMidUlnar:
      return at(kMid, -radial);
    case DigitFeature::kBasePalmar:
      return at(kBase, palm);
    case DigitFeature::kBaseDorsal:
      return at(kBase, -palm);
    case DigitFeature::kBaseRadial:
      return at(kBase, radial);
    case DigitFeature::kBaseUlnar:
      return at(kBase, -radial);
    case DigitFeature::kLengthPalmar:
      return at(kLength, palm);
    case DigitFeature::kLengthDorsal:
      return at(kLength, -palm);
    case DigitFeature::kLengthRadial:
      return at(kLength, radial);
    case DigitFeature::kLengthUlnar:
      return at(kLength, -radial);
  }
  return at(kEnd, palm);
}

Site HandSites::site(HandPart part, const HandAngles& angles) const {
  const Posed posed = pose(angles);
  if (const auto digit = digit_site(part)) return digit_place(posed, *digit);
  const Vec3& palm = frame_.palm;
  const Vec3& radial = frame_.radial;
  const Vec3 knuckle = posed.joint[kMiddle][0].position;
  const Vec3 centre = 0.55 * knuckle;
  const auto tip = [&](size_t d) {
    const Vec3 axis = unit(posed.tip[d] - posed.joint[d][2].position);
    return Site{posed.tip[d], axis};
  };
  const auto between = [](const Site& a, const Site& b) {
    return Site{0.5 * (a.position + b.position), unit(a.normal + b.normal)};
  };
  // The palmar direction of a finger's last phalanx.
  const auto pad_normal = [&](size_t d) { return posed.joint[d][2].rotation * palm; };
  switch (part) {
    case HandPart::kPalm:
      return {centre + palm * palm_depth_, palm};
    case HandPart::kBack:
      return {centre - palm * back_depth_, -palm};
    case HandPart::kRadial:
      return on_digit(posed, kIndex, 0.15, radial);
    case HandPart::kUlnar: {
      const Vec3 base = 0.6 * posed.joint[kLittle][0].position;
      return {base - radial * (radius_[kLittle][0] * 1.2), -radial};
    }
    case HandPart::kFingertips:
      return between(tip(kIndex), tip(kRing));
    case HandPart::kIndexTip:
      return tip(kIndex);
    case HandPart::kMiddleTip:
      return tip(kMiddle);
    case HandPart::kRingTip:
      return tip(kRing);
    case HandPart::kLittleTip:
      return tip(kLittle);
    case HandPart::kThumbTip:
      return tip(kThumb);
    case HandPart::kThumbIndexTips:
      return between(tip(kThumb), tip(kIndex));
    case HandPart::kIndexMiddleTips:
      return between(tip(kIndex), tip(kMiddle));
    case HandPart::kIndexSide:
      return on_digit(posed, kIndex, 1.3, radial);
    case HandPart::kIndexMiddle: {
      const Site a = on_digit(posed, kIndex, 1.5, pad_normal(kIndex));
      return between(a, on_digit(posed, kMiddle, 1.5, pad_normal(kMiddle)));
    }
    case HandPart::kFingers: {
      const Site a = on_digit(posed, kIndex, 1.5, posed.joint[kIndex][1].rotation * palm);
      return between(a, on_digit(posed, kRing, 1.5, posed.joint[kRing][1].rotation * palm));
    }
    case HandPart::kIndexKnuckle: {
      const Vec3 out = posed.joint[kIndex][0].rotation * -palm;
      return {posed.joint[kIndex][1].position + out * radius_[kIndex][0], out};
    }
    case HandPart::kKnuckles: {
      const Vec3 out = unit(0.6 * frame_.fingers - 0.4 * palm);
      return {knuckle + out * (radius_[kMiddle][0] * 1.2), out};
    }
    case HandPart::kWrist:
      return {palm * palm_depth_ * 0.9, palm};
    case HandPart::kFistThumbSide:
    case HandPart::kFistUlnar: {
      // The middle of the fist's end: before the knuckle, half way between the back and the folded fingers.
      const bool thumb_side = part == HandPart::kFistThumbSide;
      const size_t digit = thumb_side ? kIndex : kLittle;
      const Vec3 out = thumb_side ? radial : -radial;
      const Vec3 end = 0.64 * posed.joint[digit][0].position + palm * (0.8 * palm_depth_);
      return {end + out * radius_[digit][0], out};
    }
    case HandPart::kThumbWeb:
      return {0.5 * (posed.joint[kThumb][1].position + posed.joint[kIndex][0].position), unit(radial + frame_.fingers)};
    case HandPart::kIndexBase:
      return on_digit(posed, kIndex, 0.1, palm);
    case HandPart::kIndexMidJoint:
      return on_digit(posed, kIndex, 1.0, radial);
    case HandPart::kThumbSide:
      return on_digit(posed, kThumb, 1.5, radial);
    case HandPart::kIndexPad:
      return on_digit(posed, kIndex, 1.4, posed.joint[kIndex][1].rotation * palm);
    case HandPart::kThumbBall:
      return {0.5 * posed.joint[kThumb][1].position + 0.2 * knuckle + palm * palm_depth_, palm};
    case HandPart::kWristBack:
      return {-palm * back_depth_ - frame_.fingers * 0.01, -palm};
    case HandPart::kWristRadial:
    case HandPart::kWristUlnar: {
      // A wrist is about as wide as one and a half of its thickness.
      const Vec3 out = part == HandPart::kWristRadial ? radial : -radial;
      return {out * (0.75 * (palm_depth_ + back_depth_)) - frame_.fingers * 0.01, out};
    }
    case HandPart::kForearm:
      return {palm * (palm_depth_ + 0.01) - frame_.fingers * 0.09, palm};
    case HandPart::kDigitSites:
      break;
  }
  return {centre + palm * palm_depth_, palm};
}

Site HandSites::site_for(Location location, HandPart touching, const HandAngles& angles, const Vec3& towards) const {
  const Posed posed = pose(angles);
  const auto digit_site = [&](size_t d) {
    // A pointing tip meets the tip; anything broader meets the finger between its joints, on the side it comes from.
    const bool pointing = touching == HandPart::kIndexTip || touching == HandPart::kMiddleTip ||
                          touching == HandPart::kLittleTip || touching == HandPart::kThumbTip;
    if (pointing) return Site{posed.tip[d], unit(posed.tip[d] - posed.joint[d][2].position)};
    return on_digit(posed, d, d == kThumb ? 1.4 : 1.6, towards);
  };
  if (const auto digit = auslan::digit_site(location)) return digit_place(posed, *digit);
  switch (location) {
    case Location::kOtherThumbBall:
      return site(HandPart::kThumbBall, angles);
    case Location::kOtherWristRadial:
      return site(HandPart::kWristRadial, angles);
    case Location::kOtherWristUlnar:
      return site(HandPart::kWristUlnar, angles);
    case Location::kOtherBack:
      return site(HandPart::kBack, angles);
    case Location::kOtherWristBack:
      return {-frame_.palm * back_depth_ - frame_.fingers * 0.01, -frame_.palm};
    case Location::kOtherWristInner:
      return {frame_.palm * palm_depth_ * 0.9 - frame_.fingers * 0.015, frame_.palm};
    case Location::kOtherFingertips:
      return site(HandPart::kFingertips, angles);
    case Location::kOtherThumb:
      if (touching == HandPart::kIndexSide) return site(HandPart::kThumbWeb, angles);
      return digit_site(kThumb);
    case Location::kOtherIndex:
      return digit_site(kIndex);
    case Location::kOtherMiddle:
      return digit_site(kMiddle);
    case Location::kOtherRing:
      return digit_site(kRing);
    case Location::kOtherLittle:
      return digit_site(kLittle);
    case Location::kOtherUlnar:
      return site(HandPart::kUlnar, angles);
    case Location::kOtherRadial:
      return site(HandPart::kRadial, angles);
    case Location::kOtherFistTop:
      return site(HandPart::kFistThumbSide, angles);
    case Location::kHands:
      return site(touching, angles);
    default:
      return site(HandPart::kPalm, angles);
  }
}

}  // namespace auslan
