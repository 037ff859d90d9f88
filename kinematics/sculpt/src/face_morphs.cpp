// SPDX-License-Identifier: Apache-2.0
// How the face moves: each channel as a displacement of the rest shape, in head space. Channels of the right side are
// the mirror images of the left ones.
#include "head.h"

#include <cmath>
#include <optional>

namespace auslan::sculpt {

namespace {

constexpr double kJawTurn = 0.27;  // radians that the jaw opens

double magnitude(double x) {
  return x < 0.0 ? -x : x;
}
double square(double x) {
  return x * x;
}
/// 1 at 0, smoothly 0 from 1 on.
double fade(double distance) {
  return 1.0 - smooth_step(0.0, 1.0, distance);
}
double oval(double dx, double dy) {
  return std::sqrt(square(dx) + square(dy));
}

class Face {
 public:
  explicit Face(const HeadSpace& space) : space_(space), field_(head_field(space)) {}

  /// The displacement at full weight. `side` is 1 where a channel of the left side acts fully, 0 on the right.
  Vec3 move(const Vertex& v, FaceChannel channel) const {
    const Vec3& p = v.point;
    const Vec3 q(magnitude(p.x), p.y, p.z);
    const double sign = p.x < 0.0 ? -1.0 : 1.0;
    const double left = smooth_step(-7.0, 7.0, p.x);
    const bool only_left = p.x > 0.0;
    switch (channel) {
      case FaceChannel::kBrowInnerUp:
        return brow(v, q, sign, 0.0, 9.5 * brow_zone(q, 13.0, 24.0));
      case FaceChannel::kBrowOuterUpLeft:
        return only_left ? brow(v, q, sign, 0.0, 8.5 * brow_zone(q, space_.eye_x + 9.0, 24.0)) : Vec3(0.0);
      case FaceChannel::kBrowDownLeft: {
        const double inner = brow_zone(q, 15.0, 22.0);
        const double all = brow_zone(q, space_.eye_x - 2.0, 30.0);
        const double amount = left * (0.65 * inner + 0.45 * all);
        Vec3 moved = brow(v, q, sign, -4.2 * inner * left, -8.5 * amount);
        moved.z += 2.2 * inner * left;
        return moved;
      }
      case FaceChannel::kEyeBlinkLeft:
        return only_left ? lids(v, q, 1.0) : Vec3(0.0);
      case FaceChannel::kEyeWideLeft:
        return only_left ? lids(v, q, -0.42) : Vec3(0.0);
      case FaceChannel::kJawOpen:
        return jaw(v, q);
      default:
        break;
    }
    if (v.part == Part::kTeeth) {
      const bool shows = channel == FaceChannel::kMouthUpperUpLeft || channel == FaceChannel::kMouthStretchLeft;
      return shows ? Vec3(0.0, -0.9 * left, 0.0) : Vec3(0.0);
    }
    if (v.part == Part::kTongue) {
      if (channel != FaceChannel::kTongueOut) return Vec3(0.0);
      const double tip = smooth_step(55.0, 88.0, p.z);
      return {p.x * -0.12 * tip, 4.6 - 7.5 * tip * tip, 12.0 + 25.0 * tip};
    }
    if (v.part != Part::kSkin || p.z < 0.0) return Vec3(0.0);
    return mouth(v, q, sign, left, channel);
  }

 private:
  double surface(double x, double y) const { return cast(field_, Vec3(x, y, 20.0), Vec3(0.0, 0.0, 1.0), 150.0).z; }
  /// Moves along the face: depth follows the surface.
  Vec3 slide(const Vec3& q, double sign, double dx, double dy) const {
    if (dx == 0.0 && dy == 0.0) return Vec3(0.0);
    return {sign * dx, dy, surface(q.x + dx, q.y + dy) - surface(q.x, q.y)};
  }

  /// 1 on the brow at `x`, fading out sideways over `width`, up to the hair and down to the lid's crease.
  static double brow_zone(const Vec3& q, double x, double width) {
    if (q.z < 20.0) return 0.0;
    const double vertical = q.y > 20.0 ? fade((q.y - 20.0) / 36.0) : smooth_step(6.5, 17.0, q.y);
    return vertical * fade(magnitude(q.x - x) / width);
  }
  Vec3 brow(const Vertex& v, const Vec3& q, double sign, double dx, double dy) const {
    if (v.part != Part::kSkin && v.part != Part::kBrow) return Vec3(0.0);
    const Vec3 moved = slide(q, sign, dx, dy);
    return {moved.x, moved.y, moved.z * 0.6};
  }

  /// Closes (1) or opens (negative) the left eye's lids over the ball.
  Vec3 lids(const Vertex& v, const Vec3& q, double amount) const {
    if (v.part != Part::kSkin || q.z < 20.0 || v.line == Line::kEyePocket) return Vec3(0.0);
    const double open = eye_bulge(space_, q.x);
    if (open <= 0.0) return Vec3(0.0);
    const double upper = upper_lid(space_, q.x);
    const double lower = lower_lid(space_, q.x);
    double dy = 0.0;
    if (q.y > 0.0) {
      dy = -(upper - lower - 1.0 * open) * amount * fade(positive(q.y - upper) / 11.0);
      // A lid that opens wider gives its crease away, not the brow.
      if (amount < 0.0) dy = dy * fade(positive(q.y - upper) / 7.0);
    } else {
      dy = (amount > 0.0 ? 1.0 : 0.9 * amount / 0.42) * open * fade(positive(lower - q.y) / 8.0);
    }
    return slide(q, 1.0, 0.0, dy);
  }

  /// How much of the jaw's motion a point of the face follows.
  static double jaw_share(const Vertex& v, const Vec3& q) {
    if (v.part == Part::kTeeth) return 0.0;
    if (v.part == Part::kTongue) return 1.0;
    const double forward = smooth_step(-8.0, 34.0, q.z);
    const double inside = mouth_bulge(q.x);
    const double blend = 0.5 * (1.0 - inside) * (1.0 - inside) * (1.0 - inside);
    if (inside > 0.0) {
      const bool below = q.y < kMouthY;
      const double near = fade(magnitude(q.y - kMouthY) / 14.0);
      return forward * (below ? 1.0 - blend * near : blend * near);
    }
    const double width = 5.0 + 0.55 * (q.x - kMouthHalfWidth);
    return forward * smooth_step(-width, width, kMouthY - q.y);
  }
  static Vec3 jaw(const Vertex& v, const Vec3& q) {
    if (v.part == Part::kTeeth) return {0.0, -4.6, 0.0};
    if (v.part != Part::kSkin && v.part != Part::kTongue) return Vec3(0.0);
    const double share = jaw_share(v, q);
    const Vec3 lift = v.part == Part::kTongue ? Vec3(0.0, 5.0, 0.0) : Vec3(0.0);
    return lift + Vec3(0.0, -kJawTurn * (q.z - 6.0), 0.72 * kJawTurn * (q.y + 14.0)) * share;
  }

  Vec3 mouth(const Vertex& v, const Vec3& q, double sign, double left, FaceChannel channel) const {
    const double dx = q.x;
    const double dy = q.y - kMouthY;
    const bool below = dy < 0.0;
    // 1 on the lips, fading into cheeks, chin and the foot of the nose.
    const double lips = fade(positive(oval(dx / 30.0, dy / 13.0) - 0.75) / 0.95);
    const double middle = fade(oval(dx / 26.0, dy / 26.0));
    const double corner = fade(oval((dx - kMouthHalfWidth) / 25.0, dy / 27.0));
    const double cheek = fade(oval((dx - 40.0) / 22.0, (q.y + 36.0) / 24.0));
    const double inside = mouth_bulge(dx);
    const double up = below ? 0.0 : 1.0;
    const double down = below ? 1.0 : 0.0;
    // Parts the lips: the upper side moves by `rise`, the lower one by `fall`, both nothing at the corners.
    const auto part = [&](double rise, double fall) {
      const double reach_up = up * fade(positive(dy - 5.0) / 13.0);
      const double reach_down = down * fade(positive(-dy - 7.0) / 20.0);
      return inside * (reach_up * rise - reach_down * fall);
    };
    const bool pocket_back = v.line == Line::kMouthPocket;
    switch (channel) {
      case FaceChannel::kMouthPucker:
        return {sign * dx * -0.46 * lips, part(0.6, 0.8) + dy * 0.16 * lips, (pocket_back ? 5.0 : 9.5) * middle};
      case FaceChannel::kMouthFunnel:
        return {sign * dx * -0.36 * lips, part(4.6, 5.6), 7.0 * middle};
      case FaceChannel::kMouthSmileLeft: {
        const double raise = corner * left;
        return {sign * (8.0 * raise + 1.5 * cheek * left), 9.0 * raise + 3.0 * cheek * left,
                -4.5 * raise + 3.2 * cheek * left};
      }
      case FaceChannel::kMouthFrownLeft:
        return Vec3(sign * 1.5, -8.5, -1.0) * (corner * left) +
               Vec3(0.0, 1.6, 0.8) * (fade(oval(dx / 20.0, (dy + 9.0) / 9.0)) * left);
      case FaceChannel::kMouthStretchLeft:
        return {sign * 11.0 * corner * left, -3.0 * corner * left + part(1.2, 3.2) * left, -4.0 * corner * left};
      case FaceChannel::kMouthPressLeft: {
        const double roll = lips * left;
        return {0.0, -dy * 0.55 * roll * fade(positive(magnitude(dy) - 9.0) / 8.0), -3.4 * roll};
      }
      case FaceChannel::kMouthLowerDownLeft:
        return Vec3(0.0, part(0.0, 7.0), 1.0 * down * inside * lips) * left;
      case FaceChannel::kMouthUpperUpLeft:
        return Vec3(0.0, part(6.0, 0.0), 1.0 * up * inside * lips) * left;
      case FaceChannel::kCheekPuff: {
        const double puff = fade(oval((dx - 38.0) / 30.0, (q.y + 58.0) / 36.0));
        return Vec3(sign * 8.5, 0.0, 8.0) * puff + Vec3(0.0, 0.0, 2.0) * lips;
      }
      case FaceChannel::kTongueOut:
        return {0.0, part(2.0, 6.0), 1.0 * down * inside * lips};
      default:
        return Vec3(0.0);
    }
  }

  HeadSpace space_;
  Field field_;
};

/// The left channel whose mirror image this one is.
std::optional<FaceChannel> left_of(FaceChannel channel) {
  switch (channel) {
    case FaceChannel::kBrowOuterUpRight:
      return FaceChannel::kBrowOuterUpLeft;
    case FaceChannel::kBrowDownRight:
      return FaceChannel::kBrowDownLeft;
    case FaceChannel::kEyeBlinkRight:
      return FaceChannel::kEyeBlinkLeft;
    case FaceChannel::kEyeWideRight:
      return FaceChannel::kEyeWideLeft;
    case FaceChannel::kMouthSmileRight:
      return FaceChannel::kMouthSmileLeft;
    case FaceChannel::kMouthFrownRight:
      return FaceChannel::kMouthFrownLeft;
    case FaceChannel::kMouthStretchRight:
      return FaceChannel::kMouthStretchLeft;
    case FaceChannel::kMouthPressRight:
      return FaceChannel::kMouthPressLeft;
    case FaceChannel::kMouthLowerDownRight:
      return FaceChannel::kMouthLowerDownLeft;
    case FaceChannel::kMouthUpperUpRight:
      return FaceChannel::kMouthUpperUpLeft;
    default:
      return std::nullopt;
  }
}

bool is_left(FaceChannel channel) {
  for (int i = 0; i < kFaceChannelCount; ++i) {
    if (left_of(static_cast<FaceChannel>(i)) == channel) return true;
  }
  return false;
}

}  // namespace

std::vector<Vec3> channel_displacement(const Shape& shape, const HeadSpace& space, FaceChannel channel) {
  const Face face(space);
  const std::optional<FaceChannel> mirrored_from = left_of(channel);
  std::vector<Vec3> out(shape.vertices.size(), Vec3(0.0));
  for (size_t i = 0; i < out.size(); ++i) {
    out[i] = face.move(shape.vertices[i], mirrored_from.value_or(channel));
  }
  const std::vector<Vec3> one_sided = out;
  for (size_t i = 0; i < out.size(); ++i) {
    const size_t other = shape.vertices[i].mirror;
    const bool whole_face = !mirrored_from && !is_left(channel);
    if (mirrored_from || (whole_face && other < i)) out[i] = one_sided[other] * Vec3(-1.0, 1.0, 1.0);
    if (other == i && whole_face) out[i].x = 0.0;
  }
  return out;
}

}  // namespace auslan::sculpt
