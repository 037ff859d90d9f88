// SPDX-License-Identifier: Apache-2.0
#include "raster/camera.h"

#include <cmath>
#include <limits>

namespace auslan::raster {
namespace {

struct Direction {
  double x, y, z;
};

Direction cross(const Direction& a, const Direction& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double dot(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Unit vector along `v`; `otherwise` where v is too short to have a direction.
Direction unit(const Direction& v, const Direction& otherwise) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 1e-9)) return otherwise;
  return {v.x / length, v.y / length, v.z / length};
}

bool positive(float value) {
  return std::isfinite(value) && value > 0.0F;
}

bool finite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// A camera of which the renderer rejects every draw.
Camera blind() {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return Camera{glm::mat4(nan), glm::mat4(nan)};
}

glm::mat4 make_view(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up) {
  const Direction eye_d{static_cast<double>(eye.x), static_cast<double>(eye.y), static_cast<double>(eye.z)};
  const Direction forward = unit({static_cast<double>(target.x) - eye_d.x, static_cast<double>(target.y) - eye_d.y,
                                  static_cast<double>(target.z) - eye_d.z},
                                 {0.0, 0.0, -1.0});
  const Direction wanted_up =
      unit({static_cast<double>(up.x), static_cast<double>(up.y), static_cast<double>(up.z)}, {0.0, 1.0, 0.0});
  // Any axis that is not along the view will do where `up` is: of two, the one farther from it.
  const Direction spare_axis = std::abs(forward.y) < 0.7 ? Direction{0.0, 1.0, 0.0} : Direction{0.0, 0.0, -1.0};
  const Direction spare = unit(cross(forward, spare_axis), {1.0, 0.0, 0.0});
  const Direction right = unit(cross(forward, wanted_up), spare);
  const Direction above = cross(right, forward);

  glm::mat4 view(1.0F);
  const Direction rows[3] = {right, above, {-forward.x, -forward.y, -forward.z}};
  for (int row = 0; row < 3; ++row) {
    view[0][row] = static_cast<float>(rows[row].x);
    view[1][row] = static_cast<float>(rows[row].y);
    view[2][row] = static_cast<float>(rows[row].z);
    view[3][row] = static_cast<float>(-dot(rows[row], eye_d));
  }
  return view;
}

}  // namespace

Camera look_at(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up, float cot_half_fov_y, float aspect,
               float near_plane) noexcept {
  if (!finite(eye) || !finite(target) || !finite(up)) return blind();
  if (!positive(cot_half_fov_y) || !positive(aspect) || !positive(near_plane)) return blind();
  glm::mat4 clip(0.0F);
  clip[0][0] = cot_half_fov_y / aspect;
  clip[1][1] = cot_half_fov_y;
  clip[2][3] = -1.0F;
  clip[3][2] = near_plane;
  return Camera{make_view(eye, target, up), clip};
}

Camera look_at_parallel(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up, float half_height,
                        float aspect, float near_plane, float far_plane) noexcept {
  if (!finite(eye) || !finite(target) || !finite(up)) return blind();
  if (!positive(half_height) || !positive(aspect)) return blind();
  if (!std::isfinite(near_plane) || !std::isfinite(far_plane) || !(far_plane > near_plane)) return blind();
  glm::mat4 clip(1.0F);
  clip[0][0] = 1.0F / (half_height * aspect);
  clip[1][1] = 1.0F / half_height;
  // z = (far - distance) / (far - near), distance = -view.z
  clip[2][2] = 1.0F / (far_plane - near_plane);
  clip[3][2] = far_plane / (far_plane - near_plane);
  return Camera{make_view(eye, target, up), clip};
}

}  // namespace auslan::raster
