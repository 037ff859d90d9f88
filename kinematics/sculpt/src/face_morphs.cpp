// SPDX-License-Identifier: Apache-2.0
// How the face moves: one displacement a vertex and channel, so smooth over the skin that channels can be added up.
#include "head.h"

#include <cmath>

namespace auslan::sculpt {

namespace {

/// 1 near the mouth's line, 0 from `end` millimetres away.
double near_mouth(const Site& site, double start, double end) {
  if (site.piece == Piece::kMouthPocket) return 1.0 - smooth_step(2.0, 24.0, 0.0 - site.ring);
  return site.piece == Piece::kSkin ? 1.0 - smooth_step(start, end, site.ring) : 0.0;
}

/// Share of a left channel: the two sides of a pair add up to 1 everywhere.
double left_share(const Vec3& p) {
  return smooth_step(-14.0, 14.0, p.x);
}
double lower_lip(const Site& site) {
  return smooth_step(0.0, 0.75, 0.0 - site.up);
}
double upper_lip(const Site& site) {
  return smooth_step(0.0, 0.75, site.up);
}

/// 1 at the centre, 0 from `radius` millimetres on; skin only.
double bump(const Site& site, const Vec3& p, const Vec3& centre, double radius) {
  return site.piece == Piece::kSkin ? 1.0 - smooth_step(0.0, radius, length(p - centre)) : 0.0;
}

/// How much of the jaw's swing a vertex takes.
double jaw_share(const Site& site, const Vec3& p) {
  // A corner goes with both lips, so that they part in a parabola: a lens, as lips do, not a box.
  constexpr double kCorner = 0.42;
  const double inner = site.up * site.up;
  const double lip = site.up < 0.0 ? mix(kCorner, 1.0, inner) : kCorner * (1.0 - inner);
  switch (site.piece) {
    case Piece::kMouthPocket:
      return lip;
    case Piece::kLowerTeeth:
      return 1.0;
    case Piece::kTongue:
      return 0.92;
    case Piece::kSkin: {
      const double flesh = (1.0 - smooth_step(-46.0, 6.0, p.y)) * smooth_step(0.0, 62.0, p.z);
      return mix(lip, flesh, smooth_step(5.0, 34.0, site.ring));
    }
    default:
      return 0.0;
  }
}

/// The jaw swings round a hinge before the ears.
Vec3 jaw_swing(const Site& site, const Vec3& p, double millimetres) {
  const double share = jaw_share(site, p) * millimetres / 100.0;
  return Vec3(0.0, 0.0 - p.z, 0.55 * (p.y - 20.0)) * share;
}

/// A corner of the mouth goes and takes lips and cheek with it.
Vec3 corner(const Site& site, const Vec3& p, const Vec3& way) {
  return way * (smooth_step(-1.0, kMouthHalf + 2.0, p.x) * near_mouth(site, 6.0, 44.0));
}

/// Brow and forehead: `along` is how much each place of the brow goes, from its inner to its outer end.
Vec3 brow(const Site& site, const Vec3& p, const Vec3& way, double inner, double middle, double outer) {
  const auto share = [&](double t) {
    return t < 0.5 ? mix(inner, middle, smooth_step(0.0, 0.5, t)) : mix(middle, outer, smooth_step(0.5, 1.0, t));
  };
  if (site.piece == Piece::kBrow) return way * share(site.up);
  if (site.piece != Piece::kSkin || p.z < 0.0) return Vec3(0.0);
  const double height = smooth_step(52.0, 66.0, p.y) * (1.0 - smooth_step(74.0, 112.0, p.y));
  const double side = 1.0 - smooth_step(54.0, 72.0, p.x);
  return way * (0.8 * share(clamp01((p.x - 10.0) / 43.0)) * height * side);
}

Vec3 lid(const Site& site, double upper_deg, double lower_deg) {
  if (site.piece == Piece::kUpperLid)
    return lid_point(site, upper_deg, kUpperHidden) - lid_point(site, kUpperOpen, kUpperHidden);
  if (site.piece == Piece::kLowerLid)
    return lid_point(site, lower_deg, kLowerHidden) - lid_point(site, kLowerOpen, kLowerHidden);
  return Vec3(0.0);
}

/// Lips drawn together in a ring of the given half width, forward, opened upwards and downwards.
Vec3 round_lips(const Site& site, const Vec3& p, double inwards, double forward, double up, double down) {
  const double near = near_mouth(site, 5.0, 38.0);
  const double share = p.x / kMouthHalf;
  const double bounded = share > 1.0 ? 1.0 : (share < -1.0 ? -1.0 : share);
  const double open = site.up > 0.0 ? up * site.up : down * site.up;
  return Vec3(0.0 - inwards * bounded, open, forward) * near;
}

/// The left eye turned so many degrees up and outwards; the lids go along with its height.
Vec3 gaze(const Site& site, const Vec3& p, double eye_x, double up_deg, double out_deg) {
  if (site.piece == Piece::kUpperLid || site.piece == Piece::kLowerLid)
    return lid(site, kUpperOpen + 0.62 * up_deg, kLowerOpen + 0.24 * up_deg);
  if (site.piece != Piece::kEyeball) return Vec3(0.0);
  const Vec3 centre(eye_x, kEyeLevel, kEyeZ);
  const Vec3 arm = p - centre;
  const Angle up = angle_deg(up_deg);
  const Angle out = angle_deg(out_deg);
  const Vec3 lifted(arm.x, arm.y * up.cosine + arm.z * up.sine, arm.z * up.cosine - arm.y * up.sine);
  const Vec3 turned(lifted.x * out.cosine + lifted.z * out.sine, lifted.y, lifted.z * out.cosine - lifted.x * out.sine);
  return turned - arm;
}

Vec3 cheek_and_jaw(FaceChannel channel, const Site& site, const Vec3& p) {
  using enum FaceChannel;
  switch (channel) {
    case kNoseSneerLeft:
      return Vec3(0.6, 4.2, 0.4) * bump(site, p, {13.0, 5.0, 98.0}, 17.0) +
             Vec3(-1.0, -1.8, 0.6) * bump(site, p, {9.0, 44.0, 98.0}, 18.0) +
             Vec3(0.0, 2.6, 0.4) * (upper_lip(site) * near_mouth(site, 6.0, 22.0) * left_share(p));
    case kCheekPuffLeft:
      return Vec3(10.5, 0.0, 6.0) * bump(site, p, {43.0, -16.0, 78.0}, 44.0);
    case kCheekSuckLeft:
      return Vec3(-7.5, 0.0, -4.5) * bump(site, p, {42.0, -14.0, 80.0}, 36.0) + corner(site, p, {-2.0, 0.0, 1.0});
    case kMouthLeft:
      return Vec3(9.0, 0.6, -1.2) * near_mouth(site, 6.0, 40.0);
    case kMouthRollUpper:
      return Vec3(0.0, -1.6, -2.8) * (upper_lip(site) * near_mouth(site, 3.0, 13.0));
    case kMouthRollLower:
      return Vec3(0.0, 1.8, -2.2) * (lower_lip(site) * near_mouth(site, 3.0, 14.0));
    case kMouthShrugLower:
      return Vec3(0.0, 4.0, 1.8) * (lower_lip(site) * near_mouth(site, 9.0, 34.0)) +
             Vec3(0.0, 1.6, 0.6) * (upper_lip(site) * near_mouth(site, 5.0, 16.0));
    case kJawForward:
      return Vec3(0.0, 0.0, 7.0) * jaw_share(site, p);
    case kJawLeft:
      return Vec3(6.5, 0.0, -0.6) * jaw_share(site, p);
    case kTongueUp:
      return site.piece == Piece::kTongue ? Vec3(0.0, 11.0 * smooth_step(0.35, 1.0, site.up), 0.0) : Vec3(0.0);
    case kTongueLeft:
      return site.piece == Piece::kTongue ? Vec3(13.0 * smooth_step(0.25, 1.0, site.up), 0.0, 0.0) : Vec3(0.0);
    default:
      return Vec3(0.0);
  }
}

Vec3 mouth(FaceChannel channel, const Site& site, const Vec3& p) {
  using enum FaceChannel;
  switch (channel) {
    case kMouthPucker: {
      // The lips swell as they come together.
      Vec3 d = round_lips(site, p, 10.0, 6.5, 0.0, 0.0);
      if (site.piece == Piece::kSkin && site.ring > 0.0)
        d.y += 2.2 * site.up * near_mouth(site, 8.0, 24.0) * smooth_step(0.0, 8.0, site.ring);
      return d;
    }
    case kMouthFunnel:
      // Real lips would cover the teeth's edge: these give way to them.
      if (site.piece == Piece::kUpperTeeth) return {0.0, 3.2, -2.0};
      return round_lips(site, p, 9.0, 6.0, 2.5, 2.5) + jaw_swing(site, p, 11.0);
    case kMouthSmileLeft:
      return corner(site, p, {5.5, 7.5, -3.0}) + Vec3(1.0, 3.0, 2.0) * bump(site, p, {44.0, 12.0, 82.0}, 34.0);
    case kMouthFrownLeft:
      return corner(site, p, {1.0, -7.5, -1.0});
    case kMouthStretchLeft:
      return corner(site, p, {8.5, -1.5, -4.5});
    case kMouthPressLeft: {
      const double near = near_mouth(site, 6.0, 16.0) * left_share(p);
      const double thin = site.piece == Piece::kSkin
                              ? 0.62 * (kMouthY + kMouthLift * p.x * p.x - p.y) * (1.0 - smooth_step(20.0, 34.0, p.x))
                              : 0.0;
      return Vec3(0.0, thin, -3.6) * near + corner(site, p, {1.5, 0.0, -1.0});
    }
    case kMouthLowerDownLeft:
      return Vec3(0.0, -8.5, 0.5) * (lower_lip(site) * near_mouth(site, 8.0, 30.0) * left_share(p));
    case kMouthUpperUpLeft:
      return Vec3(0.0, 7.0, 0.5) * (upper_lip(site) * near_mouth(site, 7.0, 26.0) * left_share(p)) +
             Vec3(0.5, 2.0, 0.5) * bump(site, p, {16.0, 2.0, 98.0}, 18.0);
    case kCheekPuff: {
      const Vec3 right(0.0 - p.x, p.y, p.z);
      const Vec3 centre(43.0, -16.0, 78.0);
      return Vec3(10.5, 0.0, 6.0) * bump(site, p, centre, 44.0) +
             Vec3(-10.5, 0.0, 6.0) * bump(site, right, centre, 44.0) +
             Vec3(0.0, 0.0, 1.5) * near_mouth(site, 8.0, 24.0);
    }
    case kTongueOut: {
      if (site.piece == Piece::kTongue) {
        const double t = site.up;
        return Vec3(0.0, -3.0 * smooth_step(0.1, 0.6, t) - 6.0 * smooth_step(0.6, 1.0, t),
                    34.0 * smooth_step(0.0, 0.9, t)) +
               jaw_swing(site, p, 4.0);
      }
      return jaw_swing(site, p, 6.0) + Vec3(0.0, -3.0, 1.0) * (lower_lip(site) * near_mouth(site, 8.0, 26.0)) +
             Vec3(0.0, 1.5, 0.5) * (upper_lip(site) * near_mouth(site, 7.0, 22.0));
    }
    default:
      return cheek_and_jaw(channel, site, p);
  }
}

Vec3 mirrored(const Vec3& v) {
  return {0.0 - v.x, v.y, v.z};
}

struct Pair {
  FaceChannel left, right;
};
constexpr Pair kPairs[] = {{FaceChannel::kBrowOuterUpLeft, FaceChannel::kBrowOuterUpRight},
                           {FaceChannel::kBrowDownLeft, FaceChannel::kBrowDownRight},
                           {FaceChannel::kEyeBlinkLeft, FaceChannel::kEyeBlinkRight},
                           {FaceChannel::kEyeWideLeft, FaceChannel::kEyeWideRight},
                           {FaceChannel::kMouthSmileLeft, FaceChannel::kMouthSmileRight},
                           {FaceChannel::kMouthFrownLeft, FaceChannel::kMouthFrownRight},
                           {FaceChannel::kMouthStretchLeft, FaceChannel::kMouthStretchRight},
                           {FaceChannel::kMouthPressLeft, FaceChannel::kMouthPressRight},
                           {FaceChannel::kMouthLowerDownLeft, FaceChannel::kMouthLowerDownRight},
                           {FaceChannel::kMouthUpperUpLeft, FaceChannel::kMouthUpperUpRight},
                           {FaceChannel::kEyeLookUpLeft, FaceChannel::kEyeLookUpRight},
                           {FaceChannel::kEyeLookDownLeft, FaceChannel::kEyeLookDownRight},
                           {FaceChannel::kEyeLookInLeft, FaceChannel::kEyeLookInRight},
                           {FaceChannel::kEyeLookOutLeft, FaceChannel::kEyeLookOutRight},
                           {FaceChannel::kEyeSquintLeft, FaceChannel::kEyeSquintRight},
                           {FaceChannel::kNoseSneerLeft, FaceChannel::kNoseSneerRight},
                           {FaceChannel::kMouthLeft, FaceChannel::kMouthRight},
                           {FaceChannel::kJawLeft, FaceChannel::kJawRight},
                           {FaceChannel::kCheekPuffLeft, FaceChannel::kCheekPuffRight},
                           {FaceChannel::kCheekSuckLeft, FaceChannel::kCheekSuckRight},
                           {FaceChannel::kTongueLeft, FaceChannel::kTongueRight}};

}  // namespace

Vec3 displacement(FaceChannel channel, const Site& site, const Vec3& p, double eye_x) {
  using enum FaceChannel;
  // Eyes and brows of the left side only.
  const bool left = p.x > 0.0;
  switch (channel) {
    case kBrowInnerUp: {
      const Vec3 d = brow(site, left ? p : mirrored(p), {-0.5, 8.5, -1.0}, 1.0, 0.45, 0.0);
      return left ? d : mirrored(d);
    }
    case kBrowOuterUpLeft:
      return left ? brow(site, p, {0.0, 8.5, -1.0}, 0.15, 0.75, 1.0) : Vec3(0.0);
    case kBrowDownLeft:
      return left ? brow(site, p, {-3.0, -6.0, 0.5}, 1.0, 0.7, 0.3) : Vec3(0.0);
    case kEyeBlinkLeft:
      return left ? lid(site, -18.0, -20.0) : Vec3(0.0);
    case kEyeWideLeft:
      return left ? lid(site, 40.0, -32.0) : Vec3(0.0);
    case kEyeLookUpLeft:
      return left ? gaze(site, p, eye_x, 24.0, 0.0) : Vec3(0.0);
    case kEyeLookDownLeft:
      return left ? gaze(site, p, eye_x, -28.0, 0.0) : Vec3(0.0);
    case kEyeLookInLeft:
      return left ? gaze(site, p, eye_x, 0.0, -32.0) : Vec3(0.0);
    case kEyeLookOutLeft:
      return left ? gaze(site, p, eye_x, 0.0, 32.0) : Vec3(0.0);
    case kEyeSquintLeft:
      return left ? lid(site, 15.0, -13.0) + Vec3(0.0, 2.6, 1.0) * bump(site, p, {34.0, 18.0, 86.0}, 24.0) : Vec3(0.0);
    case kJawOpen:
      // The upper lip gives a little, so that the teeth's edge shows.
      return jaw_swing(site, p, 21.0) + Vec3(0.0, 3.4, 0.3) * (upper_lip(site) * near_mouth(site, 7.0, 22.0));
    default:
      return mouth(channel, site, p);
  }
}

std::vector<Morph> face_morphs(const Head& head, const std::function<Vec3(const Vec3&)>& stretched) {
  const std::vector<Vertex>& vertices = head.shape.vertices;
  // A vertex and its mirror image move exactly alike: one of each pair decides.
  const auto of = [&](FaceChannel channel, uint32_t i) {
    const Vec3& p = vertices[i].point;
    const Vec3 q = p + displacement(channel, head.sites[i], p, head.eye_x);
    return stretched(q) - stretched(p);
  };
  std::vector<Morph> morphs;
  for (int index = 0; index < kFaceChannelCount; ++index) {
    const auto channel = static_cast<FaceChannel>(index);
    FaceChannel source = channel;
    bool paired = false;
    bool is_right = false;
    for (const Pair& pair : kPairs) {
      if (pair.left != channel && pair.right != channel) continue;
      source = pair.left;
      paired = true;
      is_right = pair.right == channel;
    }
    Morph morph;
    morph.channel = channel;
    for (uint32_t i = 0; i < vertices.size(); ++i) {
      const uint32_t other = vertices[i].mirror;
      Vec3 d(0.0);
      if (paired) {
        d = is_right ? mirrored(of(source, other)) : of(source, i);
      } else if (vertices[i].point.x < 0.0) {
        d = mirrored(of(source, other));
      } else {
        d = of(source, i);
        if (other == i) d.x = 0.0;
      }
      // Less than a hundredth of a millimetre is not worth a vertex.
      if (length(d) < 0.01) continue;
      morph.vertices.push_back(i);
      morph.displacement.emplace_back(d * 0.001);
    }
    morphs.push_back(morph);
  }
  return morphs;
}

}  // namespace auslan::sculpt
