// SPDX-License-Identifier: Apache-2.0
#include "kinematics/interpolate.h"

#include "kinematics/elementary.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

double dot(const Quat& a, const Quat& b) {
  return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

Quat weighted(const Quat& a, double wa, const Quat& b, double wb) {
  return {a.w * wa + b.w * wb, a.x * wa + b.x * wb, a.y * wa + b.y * wb, a.z * wa + b.z * wb};
}

// A rotation exp(p(t)) turns, in the frame it carries along, at right_jacobian(p) * p'. This is the inverse: the p'
// that gives an angular velocity.
Vec3 rate_of_vector(const Vec3& p, const Vec3& angular_velocity) {
  const double angle = std::sqrt(glm::dot(p, p));
  double factor = 0.0;
  if (angle < 0.02) {
    factor = 1.0 / 12.0 + angle * angle / 720.0;
  } else {
    double s = 0.0;
    double c = 0.0;
    sine_cosine(0.5 * angle, s, c);
    factor = (1.0 - 0.5 * angle * c / s) / (angle * angle);
  }
  const Vec3 once = glm::cross(p, angular_velocity);
  return angular_velocity + 0.5 * once + factor * glm::cross(p, once);
}

// From 0 to `chord` over tau in [0, 1] with the given end rates. An end that is a hold has no acceleration either,
// which raises the degree by one: cubic, quartic, quintic.
template <typename Value>
Value segment_value(const Value& chord, const Value& out_rate, const Value& in_rate, bool from_hold, bool to_hold,
                    double tau) {
  const double rest = 1.0 - tau;
  if (from_hold && to_hold) return chord * minimum_jerk(tau);
  if (from_hold) return (4.0 * chord - in_rate) * (tau * tau * tau) + (in_rate - 3.0 * chord) * (tau * tau * tau * tau);
  if (to_hold)
    return chord -
           ((4.0 * chord - out_rate) * (rest * rest * rest) + (out_rate - 3.0 * chord) * (rest * rest * rest * rest));
  return chord * (tau * tau * (3.0 - 2.0 * tau)) + out_rate * (tau * rest * rest) - in_rate * (tau * tau * rest);
}

// Index of the segment a time strictly inside the track falls into.
template <typename Key>
size_t segment_at(const std::vector<Key>& keys, double time) {
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time, [](double t, const Key& k) { return t < k.time; });
  return static_cast<size_t>(after - keys.begin()) - 1;
}

template <typename Key>
std::vector<Key> ascending(std::span<const Key> keys) {
  std::vector<Key> kept;
  kept.reserve(keys.size());
  for (const Key& key : keys) {
    if (!kept.empty() && !(key.time > kept.back().time)) {
      const double time = kept.back().time;
      kept.back() = key;
      kept.back().time = time;
    } else {
      kept.push_back(key);
    }
  }
  return kept;
}

}  // namespace

Quat lerp_normalised(const Quat& a, const Quat& b, double t) {
  return renormalised(weighted(a, 1.0 - t, b, dot(a, b) < 0.0 ? -t : t));
}

Quat slerp(const Quat& a, const Quat& b, double t) {
  const Quat near = dot(a, b) < 0.0 ? -b : b;
  const Quat difference = weighted(near, 1.0, a, -1.0);
  const Quat sum = weighted(near, 1.0, a, 1.0);
  // Half the angle of rotation; the arc tangent is accurate at both ends, where the arc cosine of the dot is not.
  const double angle = 2.0 * arc_tangent(std::sqrt(dot(difference, difference)), std::sqrt(dot(sum, sum)));
  if (angle < 0.5e-6) return lerp_normalised(a, near, t);
  const double scale = 1.0 / sine(angle);
  return renormalised(weighted(a, sine((1.0 - t) * angle) * scale, near, sine(t * angle) * scale));
}

Quat lerp_euler(const Vec3& a, const Vec3& b, double t, EulerOrder order) {
  return from_euler(a * (1.0 - t) + b * t, order);
}

double minimum_jerk(double tau) {
  if (!(tau > 0.0)) return 0.0;
  if (tau >= 1.0) return 1.0;
  return tau * tau * tau * (10.0 + tau * (6.0 * tau - 15.0));
}

RotationTrack::RotationTrack(std::span<const RotationKey> keys) : keys_(ascending(keys)) {
  if (keys_.size() < 2) return;
  const size_t count = keys_.size() - 1;
  segments_.resize(count);
  // A chord is fixed by its own rotation, so its coordinates are the same in the frames of both its keys.
  for (size_t i = 0; i < count; ++i)
    segments_[i].chord = rotation_vector(glm::conjugate(keys_[i].rotation) * keys_[i + 1].rotation);
  const auto duration = [&](size_t i) { return keys_[i + 1].time - keys_[i].time; };
  for (size_t i = 0; i <= count; ++i) {
    Vec3 velocity(0.0);
    if (keys_[i].hold) {
      velocity = Vec3(0.0);
    } else if (i == 0) {
      velocity = segments_[0].chord / duration(0);
    } else if (i == count) {
      velocity = segments_[count - 1].chord / duration(count - 1);
    } else {
      const double before = duration(i - 1);
      const double after = duration(i);
      velocity = (segments_[i - 1].chord * (after / before) + segments_[i].chord * (before / after)) / (before + after);
    }
    if (i < count) segments_[i].out_rate = velocity * duration(i);
    if (i > 0) segments_[i - 1].in_rate = rate_of_vector(segments_[i - 1].chord, velocity * duration(i - 1));
  }
}

Quat RotationTrack::sample(double time) const {
  if (keys_.empty()) return kIdentity;
  if (!(time > keys_.front().time)) return keys_.front().rotation;
  if (time >= keys_.back().time) return keys_.back().rotation;
  const size_t i = segment_at(keys_, time);
  const RotationKey& from = keys_[i];
  const RotationKey& to = keys_[i + 1];
  const Segment& segment = segments_[i];
  const Vec3 p = segment_value(segment.chord, segment.out_rate, segment.in_rate, from.hold, to.hold,
                               (time - from.time) / (to.time - from.time));
  return renormalised(from.rotation * from_rotation_vector(p));
}

ScalarTrack::ScalarTrack(std::span<const ScalarKey> keys) : keys_(ascending(keys)) {
  rates_.assign(keys_.size(), 0.0);
  const auto chord = [&](size_t i) {
    return (keys_[i + 1].value - keys_[i].value) / (keys_[i + 1].time - keys_[i].time);
  };
  for (size_t i = 0; i < keys_.size(); ++i) {
    if (keys_[i].hold || keys_.size() < 2) continue;
    if (i == 0 || i + 1 == keys_.size()) {
      rates_[i] = chord(i == 0 ? 0 : i - 1);
      continue;
    }
    const double left = chord(i - 1);
    const double right = chord(i);
    if (!(left * right > 0.0)) continue;  // a peak or a plateau: flat, so that the curve does not pass it
    const double before = keys_[i].time - keys_[i - 1].time;
    const double after = keys_[i + 1].time - keys_[i].time;
    const double mean = (left * after + right * before) / (before + after);
    // Three times the flatter chord is as steep as a monotone cubic can be (Fritsch & Carlson 1980).
    const double steepest = left > 0.0 ? 3.0 * std::min(left, right) : 3.0 * std::max(left, right);
    rates_[i] = left > 0.0 ? std::min(mean, steepest) : std::max(mean, steepest);
  }
}

double ScalarTrack::sample(double time) const {
  if (keys_.empty()) return 0.0;
  if (!(time > keys_.front().time)) return keys_.front().value;
  if (time >= keys_.back().time) return keys_.back().value;
  const size_t i = segment_at(keys_, time);
  const ScalarKey& from = keys_[i];
  const ScalarKey& to = keys_[i + 1];
  const double duration = to.time - from.time;
  return from.value + segment_value(to.value - from.value, rates_[i] * duration, rates_[i + 1] * duration, from.hold,
                                    to.hold, (time - from.time) / duration);
}

}  // namespace auslan
