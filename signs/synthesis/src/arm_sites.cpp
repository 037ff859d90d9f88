// SPDX-License-Identifier: Apache-2.0
#include "arm_sites.h"

#include "kinematics/rotation.h"
#include "kinematics/surface.h"

#include <array>
#include <cmath>
#include <optional>
#include <tuple>

namespace auslan {
namespace {

// Shares of the way from joint to joint: the middle of the upper arm that a sleeve leaves to a hand, and the half of
// the forearm next to the wrist.
constexpr double kUpperArm = 0.45, kElbow = 0.97, kForearm = 0.6;
constexpr double kFromFar = 0.5;    // metres, from where rays come
constexpr double kNoSkin = 0.045;   // metres from bone to skin where no ray meets any
constexpr double kStraight = 0.02;  // metres by which an elbow's bend has to show before its tip is where it bends to

Vec3 across(const Vec3& v, const Vec3& axis) {
  return v - axis * glm::dot(v, axis);
}

/// Where a ray towards `middle` from outside meets the segment of a node that is placed; world space.
std::optional<Site> skin(const Figure& figure, int node, const Transform& placed, const Vec3& middle, const Vec3& out) {
  const Quat to_rest = glm::conjugate(placed.rotation);
  const Vec3 rest = figure.skeleton.rest_position(node);
  const Vec3 rest_out = to_rest * out;
  const std::array<int, 1> only = {node};
  const auto hit = cast_ray(figure, only, rest + to_rest * (middle - placed.position) + rest_out * kFromFar, -rest_out);
  if (!hit) return std::nullopt;
  return Site{apply(placed, hit->position), placed.rotation * hit->normal};
}

}  // namespace

bool is_on_arm(Location location) {
  switch (location) {
    case Location::kUpperArm:
    case Location::kElbow:
    case Location::kOtherElbow:
    case Location::kOtherElbowInside:
    case Location::kOtherForearmBack:
    case Location::kOtherForearmInner:
      return true;
    default:
      return false;
  }
}

Site arm_site(const HeldArm& arm, Location location, const Vec3& comes_from, const Vec3& offset) {
  const auto& [shoulder, elbow, wrist] = arm.placed;
  const Vec3 upper = elbow.position - shoulder.position, lower = wrist.position - elbow.position;
  // The middle of the limb there, the way out of it, and whose skin it may be.
  Vec3 middle = elbow.position, out = comes_from;
  bool upper_skin = true, lower_skin = false;
  switch (location) {
    case Location::kUpperArm:
    case Location::kElbow:
      middle = shoulder.position + upper * (location == Location::kUpperArm ? kUpperArm : kElbow);
      out = unit(across(comes_from, unit(upper)));
      break;
    case Location::kOtherForearmBack:
    case Location::kOtherForearmInner: {
      const Vec3 palm = elbow.rotation * arm.hand.palm;
      middle = elbow.position + lower * kForearm;
      out = unit(across(location == Location::kOtherForearmInner ? palm : -palm, unit(lower)));
      upper_skin = false;
      lower_skin = true;
      break;
    }
    default: {
      // The tip lies where the elbow bends to; of a straight arm at the back of the upper arm, which hangs at rest.
      const Vec3 bend = unit(upper) - unit(lower);
      const Vec3 back = shoulder.rotation * Vec3(0.0, 0.0, -1.0);
      out = unit(bend + kStraight * back);
      if (location == Location::kOtherElbowInside) out = -out;
      lower_skin = true;
      break;
    }
  }
  // What slides stays on the skin, as far as there is any.
  for (const Vec3& slide : {across(offset, out), Vec3(0.0)}) {
    std::optional<Site> site;
    for (const auto& [wanted, node, placed] :
         {std::tuple{upper_skin, arm.nodes.shoulder, shoulder}, std::tuple{lower_skin, arm.nodes.elbow, elbow}}) {
      if (!wanted) continue;
      const auto hit = skin(arm.figure, node, placed, middle + slide, out);
      if (hit && (!site || glm::dot(hit->position - site->position, out) > 0.0)) site = hit;
    }
    if (site) return *site;
  }
  return {middle + out * kNoSkin, out};
}

}  // namespace auslan
