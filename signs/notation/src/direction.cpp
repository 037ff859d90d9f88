// SPDX-License-Identifier: Apache-2.0
#include "direction.h"

#include "kinematics/elementary.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>

namespace auslan::notation {
namespace {

constexpr double kPi = 3.14159265358979323846;

double length(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

template <typename Score>
Direction best_of_26(Score score) {
  Direction best;
  double best_score = -2;
  for (int away = 1; away >= -1; --away)
    for (int up = 1; up >= -1; --up)
      for (int left = 1; left >= -1; --left) {
        if (left == 0 && up == 0 && away == 0) continue;
        const Direction candidate{left, up, away};
        const double value = score(candidate);
        if (value > best_score + 1e-9) {
          best_score = value;
          best = candidate;
        }
      }
  return best;
}

}  // namespace

std::optional<Vec3> vector_of_letters(std::string_view letters) {
  if (letters.empty() || letters.size() > 64) return std::nullopt;
  Vec3 sum(0.0);
  for (const char letter : letters) {
    switch (letter) {
      case 'l':
        sum.x += 1;
        break;
      case 'r':
        sum.x -= 1;
        break;
      case 'u':
        sum.y += 1;
        break;
      case 'd':
        sum.y -= 1;
        break;
      case 'o':
        sum.z += 1;
        break;
      case 'i':
        sum.z -= 1;
        break;
      default:
        return std::nullopt;
    }
  }
  const double size = length(sum);
  if (size < 0.5) return std::nullopt;
  return sum / size;
}

Vec3 midway(const Vec3& a, const Vec3& b) {
  const Vec3 sum = a + b;
  const double size = length(sum);
  return size > 1e-6 ? sum / size : a;
}

Vec3 palm_of(const Vec3& letter, const Vec3& fingers) {
  const double across = fingers.z < -1e-9 ? -letter.x : letter.x;
  const double sin_pitch = std::clamp(fingers.y, -1.0, 1.0);
  const double cos_pitch = std::sqrt(fingers.x * fingers.x + fingers.z * fingers.z);
  // Straight up or down has no bearing: the hand is only pitched.
  const bool level = cos_pitch > 1e-9;
  const double sin_yaw = level ? fingers.x / cos_pitch : 0.0;
  const double cos_yaw = level ? fingers.z / cos_pitch : 1.0;
  return Vec3(cos_yaw, 0, -sin_yaw) * across + Vec3(-sin_pitch * sin_yaw, cos_pitch, -sin_pitch * cos_yaw) * letter.y;
}

Vec3 carried(const Vec3& face, const Vec3& axis) {
  const Vec3 forward(0, 0, axis.z < -1e-9 ? -1.0 : 1.0);
  const Vec3 turn = glm::cross(forward, axis);
  const double cosine = glm::dot(forward, axis);  // at least 0
  return face + glm::cross(turn, face) + glm::cross(turn, glm::cross(turn, face)) / (1.0 + cosine);
}

Direction palm_direction(const Vec3& palm, const Vec3& fingers) {
  const auto flatten = [&fingers](const Vec3& v) { return v - fingers * glm::dot(fingers, v); };
  const Vec3 wish = flatten(palm);
  const double wish_length = length(wish);
  if (wish_length < 1e-6) return to_direction(palm);
  // Of several that lie in one half-plane with the fingers, the one nearest to perpendicular.
  const Direction plain = best_of_26([&](const Direction& d) {
    const Vec3 flat = flatten(to_vector(d));
    const double size = length(flat);
    return size < 0.8 ? -1.0 : glm::dot(flat, wish) / (size * wish_length) + 1e-6 * size;
  });
  return angle_deg(flatten(to_vector(plain)), wish) < 1.0 ? plain : to_direction(wish);
}

double angle_deg(const Vec3& a, const Vec3& b) {
  const double size = length(a) * length(b);
  return size > 0 ? arc_cosine(std::clamp(glm::dot(a, b) / size, -1.0, 1.0)) * 180.0 / kPi : 0.0;
}

}  // namespace auslan::notation
