// SPDX-License-Identifier: Apache-2.0
#include "synthesis/body_sites.h"

#include "kinematics/rotation.h"
#include "kinematics/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace auslan {
namespace {

// Heights on the face as fractions of the distance from chin (0) to the top of the head (1): the classical canon, in
// which the eyes lie half way.
constexpr double kMouth = 0.19, kNoseTip = 0.34, kCheekHeight = 0.30, kCheekbone = 0.41, kEyes = 0.50,
                 kTempleHeight = 0.56, kForehead = 0.73, kBrows = 0.58, kNoseBase = 0.31, kLip = 0.035;
// The usual distance of a hand from the chest where an entry states none, metres.
constexpr double kNeutralDistance = 0.22;
// By how much a chest reaches farther forward than the breastbone for nothing, metres: on the built-in figure it is 7
// mm.
constexpr double kFlatChest = 0.008;

}  // namespace

bool is_on_head(Location location) {
  return location <= Location::kUnderChin;
}

bool is_in_space(Location location) {
  return location >= Location::kHighNeutral && location <= Location::kContraSpace;
}

Result<BodySites> BodySites::build(const Figure& figure, const std::optional<FaceLandmarks>& face) {
  BodySites sites;
  sites.figure_ = &figure;
  const Skeleton& skeleton = figure.skeleton;
  sites.trunk_ = skeleton.find("spine_base");
  sites.neck_ = skeleton.find("neck_base");
  sites.head_ = skeleton.find("head_base");
  for (const int node : {sites.trunk_, sites.head_})
    if (figure.segments[static_cast<size_t>(node)].indices.empty())
      return fail(ErrorCode::kUnsupported, "the figure has no surface on " + skeleton.node(node).name +
                                               ", where signs must touch it; load a figure with a head and a trunk");
  const Vec3& head = skeleton.rest_position(sites.head_);
  const auto extreme = [&](int node, const Vec3& direction) {
    return skeleton.rest_position(node) + extreme_point(figure, node, direction).position;
  };
  sites.top_y_ = extreme(sites.head_, Vec3(0, 1, 0)).y;
  sites.chin_y_ = extreme(sites.head_, unit(Vec3(0, -1.0, 0.9))).y;
  sites.head_half_width_ = extreme(sites.head_, Vec3(1, 0, 0)).x - head.x;
  const double front = extreme(sites.head_, Vec3(0, 0, 1)).z;
  const double behind = extreme(sites.head_, Vec3(0, 0, -1)).z;
  sites.head_z_ = 0.5 * (front + behind);
  if (face) {
    sites.chin_y_ = face->chin_y;
    sites.top_y_ = face->top_y;
    sites.head_half_width_ = face->half_width;
    sites.head_z_ = face->middle_z;
    sites.eye_y_ = face->eye_y;
    sites.mouth_y_ = face->mouth_y;
  }
  sites.base_y_ = skeleton.rest_position(sites.trunk_).y;
  sites.shoulder_ = {skeleton.rest_position(skeleton.find("shoulder_l")),
                     skeleton.rest_position(skeleton.find("shoulder_r"))};
  sites.sternum_ = sites.site(Location::kChest, Side::kRight, Vec3(0.0), true).position;
  sites.space_z_ = std::max(sites.sternum_.z, sites.chest_front() - kFlatChest);
  return sites;
}

double BodySites::chest_front() const {
  const double trunk = shoulder_[0].y - base_y_, half = std::abs(shoulder_[0].x);
  const Vec3& origin = figure_->skeleton.rest_position(trunk_);
  double front = sternum_.z;
  for (const glm::vec3& position : figure_->segments[static_cast<size_t>(trunk_)].positions) {
    const Vec3 place = origin + Vec3(position);
    if (std::abs(place.x) < half && place.y > shoulder_[0].y - 0.55 * trunk) front = std::max(front, place.z);
  }
  return front;
}

double BodySites::face_height(double fraction) const {
  // Between the landmarks that are known, in proportion.
  double low = 0.0, high = 1.0, low_y = chin_y_, high_y = top_y_;
  const auto split = [&](double known, const std::optional<double>& y) {
    if (!y) return;
    if (fraction < known && known < high) {
      high = known;
      high_y = *y;
    } else if (fraction >= known && known > low) {
      low = known;
      low_y = *y;
    }
  };
  split(kMouth, mouth_y_);
  split(kEyes, eye_y_);
  return low_y + (fraction - low) / (high - low) * (high_y - low_y);
}

Site BodySites::cast(Location location, const Vec3& target, const Vec3& from) const {
  const std::array<int, 2> head_nodes = {head_, neck_};
  const std::array<int, 2> trunk_nodes = {trunk_, neck_};
  const Vec3 direction = unit(from);
  const Vec3 origin = target + direction * 1.0;
  const auto hit = cast_ray(*figure_, is_on_head(location) || location == Location::kNeck ? head_nodes : trunk_nodes,
                            origin, -direction);
  if (!hit) return {target, direction};
  return {figure_->skeleton.rest_position(hit->node) + hit->position, hit->normal};
}

Site BodySites::site(Location location, Side side, const Vec3& offset, bool on_surface) const {
  const double s = side == Side::kRight ? -1.0 : 1.0;  // towards the articulating side
  const double shoulder_y = shoulder_[0].y, shoulder_x = std::abs(shoulder_[0].x);
  const double trunk = shoulder_y - base_y_;
  const auto face = [&](double fraction) { return face_height(fraction); };
  const double w = head_half_width_;
  // The point aimed at and the direction from which it is seen.
  Vec3 target(0.0), from(0, 0, 1);
  switch (location) {
    case Location::kTopHead:
      target = Vec3(0, face(0.8), head_z_);
      from = Vec3(0, 1, 0.15);
      break;
    case Location::kForehead:
      target = Vec3(0, face(kForehead), head_z_);
      break;
    case Location::kEyebrow:
      target = Vec3(s * 0.42 * w, face(kBrows), head_z_);
      break;
    case Location::kTemple:
      target = Vec3(0, face(kTempleHeight), head_z_);
      from = Vec3(s * 1.0, 0, 0.75);
      break;
    case Location::kSideHead:
      target = Vec3(0, face(0.7), head_z_);
      from = Vec3(s * 1.0, 0.15, 0);
      break;
    case Location::kEye:
      target = Vec3(s * 0.42 * w, face(kEyes), head_z_);
      break;
    case Location::kCheekbone:
      target = Vec3(s * 0.35 * w, face(kCheekbone), head_z_);
      from = Vec3(s * 0.5, 0, 1);
      break;
    case Location::kNose:
      target = Vec3(0, face(kNoseTip), head_z_);
      break;
    case Location::kNostrils:
      target = Vec3(0, face(kNoseBase), head_z_);
      break;
    case Location::kFace:
      target = Vec3(0, face(kNoseTip), head_z_);
      break;
    case Location::kCheek:
      target = Vec3(s * 0.3 * w, face(kCheekHeight), head_z_);
      from = Vec3(s * 0.7, 0, 1);
      break;
    case Location::kEar:
      target = Vec3(0, face(kNoseTip + 0.06), head_z_ - 0.005);
      from = Vec3(s * 1.0, 0, 0);
      break;
    case Location::kEarlobe:
      target = Vec3(0, face(kNoseTip - 0.06), head_z_ - 0.003);
      from = Vec3(s * 1.0, 0, 0);
      break;
    case Location::kContraEar:
      target = Vec3(0, face(kNoseTip + 0.06), head_z_ - 0.005);
      from = Vec3(-s * 1.0, 0, 0);
      break;
    case Location::kUpperLip:
      target = Vec3(0, face(kMouth + kLip), head_z_);
      break;
    case Location::kLowerLip:
      target = Vec3(0, face(kMouth - kLip), head_z_);
      break;
    case Location::kTeeth:
    case Location::kTongue:
    case Location::kMouth:
      target = Vec3(0, face(kMouth), head_z_);
      break;
    case Location::kChin:
      target = Vec3(0, face(0.05), head_z_);
      break;
    case Location::kUnderChin:
      // From the front and below: from right below a ray may pass through where head and neck meet.
      target = Vec3(0, face(-0.02), head_z_ + 0.05);
      from = Vec3(0, -1, 1);
      break;
    case Location::kNeck:
      target = Vec3(0, 0.45 * chin_y_ + 0.55 * shoulder_y, head_z_);
      break;
    case Location::kShoulder:
      target = Vec3(s * 0.72 * shoulder_x, shoulder_y - 0.02, 0);
      from = Vec3(0, 0.5, 1);
      break;
    case Location::kContraShoulder:
      target = Vec3(-s * 0.72 * shoulder_x, shoulder_y - 0.02, 0);
      from = Vec3(0, 0.5, 1);
      break;
    case Location::kUpperChest:
      target = Vec3(0, shoulder_y - 0.06 * trunk, 0);
      break;
    case Location::kContraChest:
      target = Vec3(-s * 0.5 * shoulder_x, shoulder_y - 0.27 * trunk, 0);
      break;
    case Location::kStomach:
      target = Vec3(0, shoulder_y - 0.68 * trunk, 0);
      break;
    case Location::kLowerStomach:
      target = Vec3(0, shoulder_y - 0.84 * trunk, 0);
      break;
    case Location::kWaist:
      target = Vec3(s * 0.45 * shoulder_x, shoulder_y - 0.88 * trunk, 0);
      break;
    case Location::kThigh:
      target = Vec3(s * 0.6 * shoulder_x, base_y_ - 0.06, 0);
      break;
    case Location::kHighNeutral:
      target = Vec3(0, shoulder_y, 0);
      break;
    case Location::kNeutral:
      target = Vec3(0, shoulder_y - 0.45 * trunk, 0);
      break;
    case Location::kLowNeutral:
      target = Vec3(0, shoulder_y - 0.85 * trunk, 0);
      break;
    case Location::kIpsiSpace:
      target = Vec3(s * shoulder_x, shoulder_y - 0.45 * trunk, 0);
      break;
    case Location::kContraSpace:
      target = Vec3(-s * shoulder_x, shoulder_y - 0.45 * trunk, 0);
      break;
    default:
      target = Vec3(0, shoulder_y - 0.27 * trunk, 0);
      break;
  }
  if (is_in_space(location)) {
    const double distance = offset.z > 0.01 ? offset.z : kNeutralDistance;
    return {Vec3(target.x + offset.x, target.y + offset.y, space_z_ + distance), Vec3(0, 0, 1)};
  }
  if (!on_surface) {
    Site site = cast(location, target, from);
    site.position += offset;
    return site;
  }
  // Along the surface: the component of the offset that is not along the viewing direction moves the target.
  const Vec3 direction = unit(from);
  return cast(location, target + (offset - direction * glm::dot(offset, direction)), from);
}

}  // namespace auslan
