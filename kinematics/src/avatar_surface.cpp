// SPDX-License-Identifier: Apache-2.0
// The surface of a foreign figure in its rest pose, cut into the segments that the solver touches with and on.
#include "avatar_cuts.h"
#include "avatar_fit.h"
#include "kinematics/rotation.h"
#include "kinematics/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace auslan::fit {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
constexpr int kTrunk = 0, kHead = 2;
// Of legs and skirts only what a hand beside the hips could touch belongs to the trunk, metres below its node.
constexpr double kTrunkReach = 0.25;

/// The node whose segment a vertex belongs to.
int segment_of(int driver) {
  if (driver < static_cast<int>(kNodes)) return driver;
  return driver == AvatarDriver::kGround ? kTrunk : kHead;
}

/// Appends triangles of one part to segments.
class Cutter {
 public:
  Cutter(Figure& figure, const AvatarPoser::Part& part, const Skin& skin, Cuts& cuts)
      : figure_(figure),
        part_(part),
        skin_(skin),
        cuts_(cuts),
        local_(part.positions.size(), kNone),
        by_node_(kNodes) {}

  void add(std::span<const uint32_t> indices) {
    const double lowest = figure_.skeleton.rest_position(kTrunk).y - kTrunkReach;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
      const std::array<int, 3> nodes = {segment_of(skin_.driver[indices[i]]), segment_of(skin_.driver[indices[i + 1]]),
                                        segment_of(skin_.driver[indices[i + 2]])};
      const int node = nodes[1] == nodes[2] ? nodes[1] : nodes[0];
      const bool is_leg = node == kTrunk && static_cast<double>(part_.positions[indices[i]].y) < lowest;
      cuts_.add(is_leg ? kNoNode : node,
                {part_.positions[indices[i]], part_.positions[indices[i + 1]], part_.positions[indices[i + 2]]});
      if (is_leg) continue;
      by_node_[static_cast<size_t>(node)].insert(by_node_[static_cast<size_t>(node)].end(),
                                                 {indices[i], indices[i + 1], indices[i + 2]});
    }
  }

  void finish() {
    for (size_t node = 0; node < kNodes; ++node) {
      Mesh& mesh = figure_.segments[node];
      const glm::vec3 origin(figure_.skeleton.rest_position(static_cast<int>(node)));
      for (const uint32_t vertex : by_node_[node]) {
        if (local_[vertex] == kNone) {
          local_[vertex] = static_cast<uint32_t>(mesh.positions.size());
          mesh.positions.push_back(part_.positions[vertex] - origin);
          mesh.normals.push_back(part_.normals[vertex]);
          mesh.colours.emplace_back(255, 255, 255, 255);
        }
        mesh.indices.push_back(local_[vertex]);
      }
      for (const uint32_t vertex : by_node_[node])
        local_[vertex] = kNone;
    }
  }

 private:
  Figure& figure_;
  const AvatarPoser::Part& part_;
  const Skin& skin_;
  Cuts& cuts_;
  std::vector<uint32_t> local_;
  std::vector<std::vector<uint32_t>> by_node_;
};

/// A box about the line from a node to `end` (node frame), `half` as thick up and `side` as thick across.
void add_box(Mesh& mesh, const Vec3& end, double half, double side) {
  const Vec3 along = unit(end);
  const Vec3 up_or_forward = std::fabs(along.y) < 0.9 ? Vec3(0.0, 1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
  const Vec3 across = unit(glm::cross(along, up_or_forward));
  const Vec3 up = glm::cross(across, along);
  const auto first = static_cast<uint32_t>(mesh.positions.size());
  for (const double at : {0.0, 1.0})
    for (const double u : {-1.0, 1.0})
      for (const double v : {-1.0, 1.0}) {
        const Vec3 out = up * (u * half) + across * (v * side);
        mesh.positions.emplace_back(end * at + out);
        mesh.normals.emplace_back(unit(out, up));
        mesh.colours.emplace_back(255, 255, 255, 255);
      }
  // Counter-clockwise from outside; corners are numbered 4 * (far end) + 2 * (up) + (across).
  constexpr std::array<uint32_t, 36> kBox = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                             2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
  for (const uint32_t corner : kBox)
    mesh.indices.push_back(first + corner);
}

/// Stand-ins for hands: phalanges without a surface and palms that a ray misses.
void fill_hand(Figure& figure, Side side) {
  const ArmNodes arm = named_arm(side);
  const Skeleton& skeleton = figure.skeleton;
  const Vec3 wrist = skeleton.rest_position(arm.wrist);
  const Vec3 knuckle = skeleton.rest_position(arm.digits[2][0]);
  const double palm = length(knuckle - wrist);
  constexpr double kHalfFinger = 0.095;  // of the palm's length
  for (size_t digit = 0; digit < 5; ++digit)
    for (size_t joint = 0; joint < 3; ++joint) {
      const int node = arm.digits[digit][joint];
      Mesh& mesh = figure.segments[static_cast<size_t>(node)];
      if (!mesh.indices.empty()) continue;
      constexpr double kTipOfBone = 0.85;
      const Vec3 end =
          joint < 2 ? skeleton.node(arm.digits[digit][joint + 1]).offset : skeleton.node(node).offset * kTipOfBone;
      add_box(mesh, end, kHalfFinger * palm, kHalfFinger * palm);
    }
  const Vec3 centre = 0.45 * wrist + 0.55 * knuckle;
  const Vec3 out(0.0, 1.0, 0.0);
  const std::array<int, 1> only = {arm.wrist};
  if (cast_ray(figure, only, centre + out * 0.2, -out) && cast_ray(figure, only, centre - out * 0.2, out)) return;
  constexpr double kHalfPalm = 0.15, kHalfBreadth = 0.4;
  add_box(figure.segments[static_cast<size_t>(arm.wrist)], knuckle - wrist, kHalfPalm * palm, kHalfBreadth * palm);
}

/// The middle of the vertices that a channel of the face moves, weighted by how far; nothing where it moves none.
std::optional<Vec3> centre_of(const SigningAvatar& fitted, std::span<const AvatarPoser::Part> parts,
                              std::initializer_list<FaceChannel> channels, double x_sign) {
  Vec3 sum(0.0);
  double total = 0.0;
  for (const FaceChannel channel : channels)
    for (const MorphBind& bind : fitted.avatar.face[static_cast<size_t>(channel)].binds)
      for (const AvatarPoser::Part& part : parts) {
        if (part.mesh != bind.mesh) continue;
        const AvatarVertices& vertices =
            fitted.avatar.meshes[static_cast<size_t>(part.mesh)].vertices[static_cast<size_t>(part.vertices)];
        if (static_cast<size_t>(bind.morph) >= vertices.morphs.size()) continue;
        const AvatarMorph& morph = vertices.morphs[static_cast<size_t>(bind.morph)];
        for (size_t i = 0; i < morph.vertices.size(); ++i) {
          const Vec3 place(part.positions[morph.vertices[i]]);
          if (x_sign * place.x < 0.0) continue;
          const double weight = bind.weight * length(Vec3(morph.positions[i])) * fitted.scale;
          sum += place * weight;
          total += weight;
        }
      }
  // Less than a millimetre of one vertex is no movement.
  if (!(total > 1e-3)) return std::nullopt;
  return sum / total;
}

/// The face cut in its middle plane: of every millimetre of height, how far forward it reaches.
class Profile {
 public:
  Profile(const Mesh& head, const Vec3& origin, double bottom, double top) : bottom_(bottom) {
    front_.assign(static_cast<size_t>(std::max(1.0, (top - bottom) / kStep)) + 1, kMissing);
    for (size_t i = 0; i + 2 < head.indices.size(); i += 3) {
      std::array<Vec3, 3> crossings;
      size_t count = 0;
      for (size_t k = 0; k < 3; ++k) {
        const Vec3 a = origin + Vec3(head.positions[head.indices[i + k]]);
        const Vec3 b = origin + Vec3(head.positions[head.indices[i + (k + 1) % 3]]);
        if ((a.x < 0.0) == (b.x < 0.0)) continue;
        crossings[count++] = a + (b - a) * (a.x / (a.x - b.x));
      }
      if (count == 2) add(crossings[0], crossings[1]);
    }
  }

  static constexpr double kStep = 0.001;
  static constexpr double kMissing = -1e9;
  size_t rows() const { return front_.size(); }
  double height(size_t row) const { return bottom_ + static_cast<double>(row) * kStep; }
  double front(size_t row) const { return front_[row]; }
  double front_at(double y) const {
    const double row = std::clamp((y - bottom_) / kStep, 0.0, static_cast<double>(front_.size() - 1));
    return front_[static_cast<size_t>(row)];
  }

 private:
  void add(const Vec3& a, const Vec3& b) {
    const double low = std::min(a.y, b.y);
    const double high = std::max(a.y, b.y);
    const double last = static_cast<double>(front_.size() - 1);
    const double first_row = std::clamp(std::ceil((low - bottom_) / kStep), 0.0, last);
    for (auto row = static_cast<size_t>(first_row); row < front_.size() && height(row) <= high; ++row) {
      if (height(row) < low) continue;
      const double t = high > low ? (height(row) - a.y) / (b.y - a.y) : 0.0;
      front_[row] = std::max(front_[row], a.z + (b.z - a.z) * t);
    }
  }

  double bottom_;
  std::vector<double> front_;
};

}  // namespace

bool is_shown(const AvatarSurface& surface) {
  constexpr float kLeastAlpha = 0.1F;
  if (surface.is_transparent && surface.base_colour.w < kLeastAlpha) return false;
  return surface.base_colour.w >= surface.alpha_cutoff.value_or(0.0F);
}

void cut_surface(SigningAvatar& fitted, std::span<const AvatarPoser::Part> parts, std::span<const Skin> skins) {
  fitted.figure.segments.resize(kNodes);
  Cuts cuts;
  for (size_t p = 0; p < parts.size(); ++p) {
    Cutter cutter(fitted.figure, parts[p], skins[p], cuts);
    for (const AvatarSurface& surface : fitted.avatar.meshes[static_cast<size_t>(parts[p].mesh)].surfaces)
      if (surface.vertices == parts[p].vertices && is_shown(surface)) cutter.add(surface.indices);
    cutter.finish();
  }
  cuts.close(fitted.figure);
  fill_hand(fitted.figure, Side::kLeft);
  fill_hand(fitted.figure, Side::kRight);
}

void measure_face(SigningAvatar& fitted, std::span<const AvatarPoser::Part> parts) {
  using enum FaceChannel;
  const Skeleton& skeleton = fitted.figure.skeleton;
  const Mesh& head = fitted.figure.segments[kHead];
  const Vec3 base = skeleton.rest_position(kHead);
  FaceLandmarks& face = fitted.face;
  if (head.positions.empty()) return;
  double top = base.y;
  double widest = 0.0;
  for (const glm::vec3& position : head.positions) {
    top = std::max(top, base.y + static_cast<double>(position.y));
    widest = std::max(widest, std::fabs(base.x + static_cast<double>(position.x)));
  }
  // Eyes: their bones, else the middle of what blinks.
  std::optional<Vec3> eye;
  if (fitted.has_bone[0] && fitted.has_bone[1])
    eye = Vec3(0.5 * (fitted.pivot[0].x - fitted.pivot[1].x), 0.5 * (fitted.pivot[0].y + fitted.pivot[1].y), 0.0);
  if (!eye) eye = centre_of(fitted, parts, {kEyeBlinkLeft}, 1.0);
  // An eye below the base of the skull or above the crown is none.
  if (eye && !(eye->y > base.y && eye->y < top && eye->x > 1e-3)) eye.reset();

  // The chin: from the nose, which reaches farthest forward, down to where the face falls back to the neck.
  const double deepest = base.y - 0.5 * (top - base.y);
  const Profile profile(head, base, deepest, top);
  const double nose_top = eye ? eye->y : base.y + 0.6 * (top - base.y);
  size_t nose = 0;
  for (size_t row = 0; row < profile.rows() && profile.height(row) <= nose_top; ++row)
    if (profile.front(row) > profile.front(nose)) nose = row;
  constexpr double kFace = 0.55;  // of the way from the skull's base to the nose; necks reach less far forward
  const double fallen = base.z + kFace * (profile.front(nose) - base.z);
  size_t chin = nose;
  // Open lips leave a gap of some millimetres.
  constexpr size_t kGap = 15;
  for (size_t row = nose, gap = 0; row > 0 && gap < kGap; --row) {
    const bool is_face = profile.front(row) >= fallen;
    if (is_face) chin = row;
    gap = is_face ? 0 : gap + 1;
  }
  face.chin_y = profile.front(nose) > Profile::kMissing ? profile.height(chin) : base.y - 0.03;
  face.top_y = top;
  if (eye) {
    face.eye_y = std::max(eye->y, face.chin_y + 0.02);
    // Hair and hats: the crown is little farther above the eyes than the chin is below.
    constexpr double kCrown = 1.15;
    face.top_y = std::min(top, *face.eye_y + kCrown * (*face.eye_y - face.chin_y));
  }
  const double height = std::max(face.top_y - face.chin_y, 0.05);
  face.top_y = face.chin_y + height;
  // The usual head is 0.33 of its height to either side; hair makes it wider.
  constexpr double kEyeOfHalfWidth = 0.42, kWidest = 0.45;
  face.half_width = std::min(eye ? eye->x / kEyeOfHalfWidth : widest, kWidest * height);
  const double front = profile.front_at(eye ? *face.eye_y : face.chin_y + 0.5 * height);
  constexpr double kHalfDepth = 0.42;
  face.middle_z = front > Profile::kMissing ? front - kHalfDepth * height : base.z;
  const std::optional<Vec3> mouth =
      centre_of(fitted, parts, {kMouthPucker, kMouthFunnel, kMouthStretchLeft, kMouthStretchRight}, 0.0);
  const double eyes = face.eye_y.value_or(face.chin_y + 0.5 * height);
  if (mouth && mouth->y > face.chin_y + 0.1 * (eyes - face.chin_y) &&
      mouth->y < face.chin_y + 0.7 * (eyes - face.chin_y))
    face.mouth_y = mouth->y;
}

}  // namespace auslan::fit
