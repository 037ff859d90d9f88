// SPDX-License-Identifier: Apache-2.0
// Places on and in front of the body, found on the surface of the figure that is loaded.
#pragma once

#include "kinematics/anatomy.h"
#include "kinematics/face_landmarks.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"
#include "phonology/sign.h"

#include <optional>

namespace auslan {

/// A point on a surface with its outward unit normal, in the frame that the caller states.
struct Site {
  Vec3 position{0.0};
  Vec3 normal{0.0, 0.0, 1.0};
};

/// True for places on the head, which move with it.
bool is_on_head(Location location);
/// True for places in the air in front of the body.
bool is_in_space(Location location);

/// Places of the head and trunk at rest, in world space. The figure must outlive it.
class BodySites {
 public:
  /// Measures the landmarks (chin, top of head, shoulder line) on the meshes; those of the face are `face`'s where it
  /// is given. kUnsupported where head or trunk has no mesh.
  static Result<BodySites> build(const Figure& figure, const std::optional<FaceLandmarks>& face = std::nullopt);

  /// The place for a hand of `side`, displaced by `offset` (metres, world axes). In
  /// signing space the offset is free, and one without any depth gets the usual distance from the chest. On the body,
  /// `on_surface` casts the displaced point back onto the skin along the place's own direction; otherwise the offset is
  /// added to the point on the skin. Locations on the arms and the other hand are not the body's: for them, the chest.
  Site site(Location location, Side side, const Vec3& offset, bool on_surface) const;

  /// Where the sternum is: the origin of distances in signing space.
  const Vec3& sternum() const { return sternum_; }
  const Vec3& shoulder(Side side) const { return shoulder_[static_cast<size_t>(side)]; }
  double waist_height() const { return base_y_; }

 private:
  /// The height of a fraction of the way from chin to crown.
  double face_height(double fraction) const;
  /// How far forward the trunk reaches between shoulders and stomach.
  double chest_front() const;
  /// From `origin`, in front of or beside the body, towards it: the skin, or the origin's projection where there is
  /// none.
  Site cast(Location location, const Vec3& target, const Vec3& from) const;

  const Figure* figure_ = nullptr;
  int trunk_ = 0, neck_ = 0, head_ = 0;
  double chin_y_ = 0, top_y_ = 0, head_z_ = 0, head_half_width_ = 0;
  std::optional<double> eye_y_, mouth_y_;
  double base_y_ = 0;
  std::array<Vec3, 2> shoulder_;
  Vec3 sternum_{0.0};
  double space_z_ = 0;  ///< where distances in signing space begin
};

}  // namespace auslan
