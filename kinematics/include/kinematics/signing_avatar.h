// SPDX-License-Identifier: Apache-2.0
// A foreign figure made ready to sign: the 39 nodes of the project's skeleton and its surface for the solver, and what
// each of its own bones follows.
//
// Nothing is copied as angles from the built-in figure: the avatar's own bones are turned into the rest pose that
// skeleton.h asks for (T-pose, palms down, fingers straight), the joints' places there are the nodes, the posed surface
// is cut into the segments. Signs are then solved on its own proportions and skin.
#pragma once

#include "kinematics/avatar.h"
#include "kinematics/face_landmarks.h"
#include "kinematics/figure.h"
#include "kinematics/result.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <string>
#include <vector>

namespace auslan {

/// What a bone of an avatar can follow: a node of the figure, by its index (those of kNodeNames), or one of these.
struct AvatarDriver {
  static constexpr int kGround = static_cast<int>(kNodeNames.size());  ///< legs and the like: they only step along
  static constexpr int kLeftEye = kGround + 1;
  static constexpr int kRightEye = kGround + 2;
  static constexpr int kJaw = kGround + 3;
  /// Upper arms and forearms twist along their length, in so many steps: of each of kTwistNodes, from none of the
  /// joint's twist to all of it.
  static constexpr int kFirstTwist = kGround + 4;
  static constexpr int kTwistSteps = 16;
  static constexpr std::array<std::string_view, 4> kTwistNodes = {"shoulder_l", "elbow_l", "shoulder_r", "elbow_r"};
  static constexpr int kCount = kFirstTwist + static_cast<int>(kTwistNodes.size()) * (kTwistSteps + 1);
};

struct SigningAvatar {
  /// Metres, looking along +Z, feet on y = 0, scaled so that the arms are as long as those of the built-in figure:
  /// places in signing space and all thresholds of the solver are lengths. The skins have more joints than the file's.
  Avatar avatar;
  /// One segment a node, of the same surface. Fingers and phalanges that the avatar lacks have stand-ins here, which
  /// are not drawn.
  Figure figure;
  std::vector<glm::dmat4> world_from_node;  ///< of the avatar's nodes in the figure's rest pose
  std::vector<int> driver;                  ///< what each of the avatar's nodes follows
  std::array<Vec3, 3> pivot{};              ///< of left eye, right eye and jaw
  std::array<bool, 3> has_bone{};           ///< of those
  FaceLandmarks face;
  double scale = 1.0;                 ///< metres of the figure for a unit of the file
  std::vector<std::string> warnings;  ///< what is missing and how it was filled
};

/// Length from shoulder to wrist that every figure is scaled to, metres.
inline constexpr double kSigningArmLength = 0.5415;

/// kUnsupported, with what is missing, for a figure without head, arms or hands, or one whose arms have no length.
/// Total otherwise: whatever else is missing is placed by proportion and told in `warnings`.
Result<SigningAvatar> fit_avatar(Avatar avatar);

}  // namespace auslan
