// SPDX-License-Identifier: Apache-2.0
#include "kinematics/arm_ik.h"

#include "arm_geometry.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace auslan {
namespace {

// Beyond this cosine to straight down or up the reference for the swivel leans over.
constexpr double kLeanStart = 0.86602540378443864676;

// The search for a natural swivel: a grid, then a finer one about its soft minimum.
constexpr double kLowestSwivel = -60.0 * kDegree;
constexpr double kHighestSwivel = 150.0 * kDegree;
constexpr int kCoarseSteps = 42;
constexpr int kFineSteps = 16;
constexpr double kFineReach = 12.0 * kDegree;
constexpr double kPreferredSwivel = 25.0 * kDegree;
constexpr double kLimitWeight = 60.0;           // of a radian beyond a limit against one away from the preferred swivel
constexpr double kLimitMargin = 5.0 * kDegree;  // limits count from this far within, so that the minimum lies inside

// The trunk below the shoulders as an upright cylinder that the elbow's centre should stay out of, in units of the
// shoulder joint's distance from the middle: mean waist and chest with the elbow's own thickness.
constexpr double kTrunkHalfBreadth = 1.2;
constexpr double kTrunkHalfDepth = 0.95;
constexpr double kTrunkWeight = 12.0;  // low enough that the limits win

// The clavicle begins to help where the wrist is this far from the shoulder at rest, and has done all it can so much
// farther out, in lengths of the straight arm; slow enough that a hand that moves out still moves away from its
// shoulder.
constexpr double kHelpStart = 0.90, kHelpSpan = 0.16;
constexpr double kMostHelp = 14.0 * kDegree;
// Cosines to straight up: a hand that hangs leaves the clavicle alone; from here on it helps.
constexpr double kHanging = -0.6, kHelped = -0.1;

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

double smooth_step(double low, double high, double x) {
  const double t = (x - low) / (high - low);
  if (!(t > 0.0)) return 0.0;
  // Minimum jerk: continuous in acceleration.
  return t >= 1.0 ? 1.0 : t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

// trunk_from_clavicle for a wrist in the frame of the trunk.
Quat clavicle_turn(const ArmGeometry& arm, const Vec3& wrist) {
  if (!arm.clavicle_offset) return kIdentity;
  const Vec3 reach = wrist - arm.shoulder_offset;
  const double distance = length(reach);
  const double straight = arm.upper_length + arm.fore_length;
  if (!(distance > kHelpStart * straight)) return kIdentity;
  const Vec3 towards = reach / distance;
  const double share =
      smooth_step(kHelpStart, kHelpStart + kHelpSpan, distance / straight) * smooth_step(kHanging, kHelped, towards.y);
  const Vec3 axis = glm::cross(unit(arm.shoulder_offset - *arm.clavicle_offset), towards);
  return from_rotation_vector(axis * (kMostHelp * share));
}

Vec3 perpendicular_part(const Vec3& v, const Vec3& unit_axis) {
  return v - unit_axis * glm::dot(v, unit_axis);
}

// Where the elbow points at swivel 0: unit, perpendicular to `line`, in the frame of the trunk.
Vec3 swivel_reference(const Vec3& line) {
  const double steep = line.y < 0.0 ? -line.y : line.y;
  double lean = 0.0;
  if (steep > kLeanStart) {
    const double t = (steep - kLeanStart) / (1.0 - kLeanStart);
    lean = line.y * t * t * (3.0 - 2.0 * t);
  }
  const Vec3 side = perpendicular_part(Vec3(0.0, -1.0, lean), line);
  return unit(side, unit(perpendicular_part(Vec3(0.0, 0.0, 1.0), line)));
}

Transform in_frame(const Transform& world_from_frame, const Transform& world_from_thing) {
  const Quat frame_from_world = glm::conjugate(world_from_frame.rotation);
  return {frame_from_world * world_from_thing.rotation,
          frame_from_world * (world_from_thing.position - world_from_frame.position)};
}

JointLimits narrowed(JointLimits limits) {
  const auto narrow = [](double& low, double& high) {
    if (high - low < 4.0 * kLimitMargin) return;
    // A straight elbow is at its limit and at ease.
    if (low < 0.0) low += kLimitMargin;
    high -= kLimitMargin;
  };
  narrow(limits.flexion_low, limits.flexion_high);
  narrow(limits.abduction_low, limits.abduction_high);
  narrow(limits.twist_low, limits.twist_high);
  return limits;
}

struct SwivelCost {
  ArmGeometry arm;
  std::array<JointAxes, 3> axes;
  std::array<JointLimits, 3> limits;
  Transform trunk_from_wrist;

  double operator()(double swivel) const {
    const ArmSolution solution = solve_in_trunk(arm, trunk_from_wrist, swivel);
    const double beyond = squared_excess(limits[0], angles_about(axes[0], solution.shoulder)) +
                          squared_excess(limits[1], angles_about(axes[1], solution.elbow)) +
                          squared_excess(limits[2], angles_about(axes[2], solution.wrist));
    const double away = swivel - kPreferredSwivel;
    return kLimitWeight * beyond + kTrunkWeight * square_inside_trunk(solution) + away * away;
  }

  // 0 outside, 1 on the axis of the trunk well below the shoulders; once differentiable.
  double square_inside_trunk(const ArmSolution& solution) const {
    const Vec3 upper = solution.clavicle * (solution.shoulder * arm.upper_bone);
    if (!(upper.y < 0.0)) return 0.0;
    const double unit_length = arm.shoulder_offset.x < 0.0 ? -arm.shoulder_offset.x : arm.shoulder_offset.x;
    if (!(unit_length > 0.0)) return 0.0;
    const Vec3 elbow = (arm.shoulder_place(solution.clavicle) + upper * arm.upper_length) / unit_length;
    const double x = elbow.x / kTrunkHalfBreadth;
    const double z = (elbow.z - arm.shoulder_offset.z / unit_length) / kTrunkHalfDepth;
    const double inside = 1.0 - std::sqrt(x * x + z * z);
    return inside > 0.0 ? inside * inside * upper.y * upper.y : 0.0;
  }
};

// Mean of the grid from low to high, weighted by exp(-cost / temperature).
template <int kSteps>
double soft_minimum(const SwivelCost& cost, double low, double high, double temperature) {
  std::array<double, static_cast<size_t>(kSteps) + 1> costs{};
  double least = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double value = cost(low + (high - low) * i / kSteps);
    costs[static_cast<size_t>(i)] = value;
    if (i == 0 || value < least) least = value;
  }
  double total = 0.0;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double weight = exponential((least - costs[static_cast<size_t>(i)]) / temperature);
    total += weight;
    sum += weight * (low + (high - low) * i / kSteps);
  }
  return sum / total;
}

}  // namespace

ArmGeometry arm_geometry(const Skeleton& skeleton, Side side) {
  const ArmNodes nodes = arm_nodes(skeleton, side);
  const Vec3& upper = skeleton.node(nodes.elbow).offset;
  const Vec3& fore = skeleton.node(nodes.wrist).offset;
  ArmGeometry arm;
  arm.side_sign = side == Side::kLeft ? 1.0 : -1.0;
  const Vec3 outward(arm.side_sign, 0.0, 0.0);
  arm.shoulder_offset = skeleton.node(nodes.shoulder).offset;
  if (nodes.clavicle != kNoNode) {
    arm.clavicle_offset = skeleton.node(nodes.clavicle).offset;
    arm.shoulder_offset += *arm.clavicle_offset;
  }
  arm.upper_length = length(upper);
  arm.fore_length = length(fore);
  arm.upper_bone = unit(upper, outward);
  arm.fore_bone = unit(fore, arm.upper_bone);
  // At rest the crook of the elbow faces forwards: bending brings the forearm there.
  arm.hinge = unit(glm::cross(arm.upper_bone, Vec3(0.0, 0.0, 1.0)), Vec3(0.0, -arm.side_sign, 0.0));
  return arm;
}

ArmSolution solve_in_trunk(const ArmGeometry& arm, const Transform& trunk_from_wrist, double swivel) {
  ArmSolution solution;
  solution.clavicle = clavicle_turn(arm, trunk_from_wrist.position);
  const Vec3 reach = trunk_from_wrist.position - arm.shoulder_place(solution.clavicle);
  const double wanted = length(reach);
  const Vec3 line = unit(reach, Vec3(0.0, -1.0, 0.0));
  const double farthest = arm.upper_length + arm.fore_length;
  const double difference = arm.upper_length - arm.fore_length;
  const double nearest = difference < 0.0 ? -difference : difference;
  double distance = wanted;
  if (wanted > farthest) distance = farthest;
  if (wanted < nearest) distance = nearest;
  // A wrist at full stretch that rounding puts a hair beyond it is not out of reach.
  solution.shortfall = wanted > distance ? wanted - distance : distance - wanted;
  solution.reachable = solution.shortfall <= 1e-12;
  if (solution.reachable) solution.shortfall = 0.0;

  // Upper arm and forearm in the plane of the line and the elbow; `along` is the foot of the elbow on the line.
  const double along =
      distance > 0.0 ? (distance * distance + arm.upper_length * arm.upper_length - arm.fore_length * arm.fore_length) /
                           (2.0 * distance)
                     : 0.0;
  const double square = arm.upper_length * arm.upper_length - along * along;
  const double height = square > 0.0 ? std::sqrt(square) : 0.0;
  double s = 0.0;
  double c = 0.0;
  sine_cosine(swivel * arm.side_sign, s, c);
  const Vec3 reference = swivel_reference(line);
  const Vec3 elbow_side = reference * c + glm::cross(line, reference) * s;
  const Vec3 upper = unit(line * along + elbow_side * height);
  const Vec3 fore = unit(line * (distance - along) - elbow_side * height, -elbow_side);
  const Vec3 hinge = glm::cross(elbow_side, line);

  const Quat shoulder = rotation_between_frames(arm.upper_bone, arm.hinge, upper, hinge);
  const Quat bend = rotation_between_frames(arm.fore_bone, arm.hinge, glm::conjugate(shoulder) * fore,
                                            glm::conjugate(shoulder) * hinge);
  const Quat beyond = glm::conjugate(shoulder * bend) * trunk_from_wrist.rotation;
  solution.shoulder = glm::conjugate(solution.clavicle) * shoulder;
  const Quat pronation = swing_twist(beyond, arm.fore_bone).twist;
  solution.elbow = renormalised(bend * pronation);
  solution.wrist = renormalised(glm::conjugate(pronation) * beyond);
  return solution;
}

ArmSolution solve_arm(const Skeleton& skeleton, Side side, const Transform& world_from_trunk,
                      const Transform& world_from_wrist, double swivel) {
  return solve_in_trunk(arm_geometry(skeleton, side), in_frame(world_from_trunk, world_from_wrist), swivel);
}

void pose_arm(const ArmNodes& nodes, const ArmSolution& arm, Pose& pose) {
  if (nodes.clavicle != kNoNode) pose.rotation[static_cast<size_t>(nodes.clavicle)] = arm.clavicle;
  pose.rotation[static_cast<size_t>(nodes.shoulder)] = arm.shoulder;
  pose.rotation[static_cast<size_t>(nodes.elbow)] = arm.elbow;
  pose.rotation[static_cast<size_t>(nodes.wrist)] = arm.wrist;
}

double natural_swivel(const Skeleton& skeleton, Side side, const Transform& world_from_trunk,
                      const Transform& world_from_wrist) {
  const ArmGeometry arm = arm_geometry(skeleton, side);
  const SwivelCost cost{
      arm,
      {shoulder_axes(arm), elbow_axes(arm), wrist_axes(rest_hand_frame(skeleton, side), arm.side_sign)},
      {narrowed(shoulder_limits()), narrowed(elbow_limits()), narrowed(wrist_limits())},
      in_frame(world_from_trunk, world_from_wrist)};
  const double coarse = soft_minimum<kCoarseSteps>(cost, kLowestSwivel, kHighestSwivel, 0.25);
  const double fine = soft_minimum<kFineSteps>(cost, coarse - kFineReach, coarse + kFineReach, 0.02);
  if (fine < kLowestSwivel) return kLowestSwivel;
  return fine > kHighestSwivel ? kHighestSwivel : fine;
}

}  // namespace auslan
