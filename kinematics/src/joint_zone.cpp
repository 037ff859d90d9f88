// SPDX-License-Identifier: Apache-2.0
#include "joint_zone.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>

namespace auslan {
namespace {

double smooth(double low, double high, double x) {
  if (x <= low) return 0.0;
  if (x >= high) return 1.0;
  const double t = (x - low) / (high - low);
  return t * t * (3.0 - 2.0 * t);
}

double norm(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

Vec3 unit(const Vec3& v) {
  return v / norm(v);
}

class Zones {
 public:
  explicit Zones(const Skeleton& skeleton) : skeleton_(skeleton) {}

  std::vector<JointZone> all() {
    head();
    for (const std::string side : {"_l", "_r"}) {
      clavicle("clavicle" + side, "shoulder" + side);
      shoulder("shoulder" + side, "elbow" + side);
      if (JointZone* elbow = limb("elbow" + side, "wrist" + side)) {
        const double half = 0.15 * distance("elbow" + side, "wrist" + side);
        elbow->bend = Ramp{-half, half};
      }
      // The forearm's twist is over before the wrist, which bends only.
      if (JointZone* wrist = bone("elbow" + side, "wrist" + side)) {
        const double forearm = distance("elbow" + side, "wrist" + side);
        wrist->bend = wrist->twist = Ramp{-0.075 * forearm, 0.075 * forearm};
      }
      for (const std::string finger : {"index", "middle", "ring", "little"})
        digit(finger + "_mp" + side, finger + "_pip" + side, finger + "_dip" + side, knuckle_gap(side));
      // The ball of the thumb moves as one: a palm that bent with it would fold.
      finger_joints("thumb_cmc" + side, "thumb_mp" + side, "thumb_ip" + side);
    }
    return std::move(zones_);
  }

 private:
  Vec3 place(const std::string& name) const { return skeleton_.rest_position(skeleton_.find(name)); }
  double distance(const std::string& a, const std::string& b) const { return norm(place(b) - place(a)); }
  double knuckle_gap(const std::string& side) const { return distance("index_mp" + side, "little_mp" + side) / 3.0; }

  // A joint whose axis leads on from the joint before it. Null where two joints are in one place.
  JointZone* bone(const std::string& before, const std::string& joint) {
    if (!(distance(before, joint) > 0.0)) return nullptr;
    zones_.push_back({});
    zones_.back().node = skeleton_.find(joint);
    zones_.back().axis = unit(place(joint) - place(before));
    return &zones_.back();
  }
  JointZone* bone_to(const std::string& joint, const std::string& next) {
    if (!(distance(joint, next) > 0.0)) return nullptr;
    zones_.push_back({});
    zones_.back().node = skeleton_.find(joint);
    zones_.back().axis = unit(place(next) - place(joint));
    return &zones_.back();
  }

  // The head's rotation is taken up along the neck.
  void head() {
    JointZone* zone = bone("neck_base", "head_base");
    if (zone == nullptr) return;
    const double neck = distance("neck_base", "head_base");
    zone->bend = zone->twist = Ramp{-0.9 * neck, -0.1 * neck};
  }

  // A limb twists along its bone.
  JointZone* limb(const std::string& joint, const std::string& next) {
    JointZone* zone = bone_to(joint, next);
    if (zone != nullptr) {
      const double length = distance(joint, next);
      zone->twist = Ramp{0.1 * length, 0.92 * length};
    }
    return zone;
  }

  // The trunk's skin goes with the clavicle along its length: all of it about the shoulder, none of it at the flank.
  void clavicle(const std::string& joint, const std::string& shoulder) {
    if (skeleton_.find(joint) == kNoNode) return;
    JointZone* zone = bone_to(joint, shoulder);
    if (zone == nullptr) return;
    const double length = distance(joint, shoulder);
    zone->bend = zone->twist = Ramp{0.0, length};
    zone->near = 0.4 * length;
    zone->far = 1.2 * length;
  }

  // The arm hangs at a right angle to rest: bent in the middle of so much the shoulder would come to a point. The ball
  // of the one segment in the other keeps it round.
  void shoulder(const std::string& joint, const std::string& next) {
    JointZone* zone = limb(joint, next);
    if (zone == nullptr) return;
    zone->bends_parent = false;
    zone->bend = Ramp{-1e3, -1e2};
  }

  void digit(const std::string& root, const std::string& middle, const std::string& last, double gap) {
    const double first_bone = distance(root, middle);
    if (JointZone* zone = bone_to(root, middle)) {
      zone->bend = zone->twist = Ramp{-0.2 * first_bone, 0.2 * first_bone};
      zone->near = 0.5 * gap;
      zone->far = gap;
    }
    finger_joints(root, middle, last);
  }

  void finger_joints(const std::string& root, const std::string& middle, const std::string& last) {
    const double first_bone = distance(root, middle);
    const double second_bone = distance(middle, last);
    if (JointZone* zone = bone_to(middle, last)) {
      const double half = 0.34 * std::min(first_bone, second_bone);
      zone->bend = zone->twist = Ramp{-half, half};
    }
    // The last bone's own length is not in the skeleton; it is about as long as the one before.
    if (JointZone* zone = bone(middle, last)) zone->bend = zone->twist = Ramp{-0.3 * second_bone, 0.3 * second_bone};
  }

  const Skeleton& skeleton_;
  std::vector<JointZone> zones_;
};

}  // namespace

double Ramp::at(double along) const {
  return smooth(low, high, along);
}

double JointZone::closeness(const Vec3& place) const {
  if (far <= 0.0) return 1.0;
  return 1.0 - smooth(near, far, norm(place - axis * glm::dot(place, axis)));
}

std::vector<JointZone> joint_zones(const Skeleton& skeleton) {
  return Zones(skeleton).all();
}

}  // namespace auslan
