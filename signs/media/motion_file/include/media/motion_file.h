// SPDX-License-Identifier: Apache-2.0
// Motion in files: .jsonl and .bvh out, .jsonl back in.
//
// .jsonl   first line {"fps":…,"units":"m","frame":"y-up, +x signer's left, +z towards the viewer, world",
//          "glosses":[{"gloss":…,"start":…,"end":…},…],"nodes":[…]}, then one line a frame
//          {"t":seconds,"joints":{"wrist_r":[px,py,pz,qw,qx,qy,qz],…},"face":{"jawOpen":0.2,…}}: every node, world
//          space, metres; face channels of weight 0 are left out. Numbers are the shortest that read back the same.
// .bvh     offsets and the root's position in METRES; angles in degrees; channels Zrotation Xrotation Yrotation, which
// is
//          the rotation Rz * Rx * Ry; the rest pose is the T-pose; an End Site at each leaf. The face is not in it.
#pragma once

#include "kinematics/pose.h"
#include "kinematics/result.h"
#include "kinematics/skeleton.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct MotionGloss {
  std::string gloss;
  double start = 0;  ///< seconds
  double end = 0;
};

struct MotionHeader {
  double fps = 25;  ///< frames a second, positive
  std::vector<MotionGloss> glosses;
};

/// Takes a motion frame by frame. As FrameSink: nothing under the target's name before finish() succeeds.
class MotionSink {
 public:
  virtual ~MotionSink() = default;
  MotionSink(const MotionSink&) = delete;
  MotionSink& operator=(const MotionSink&) = delete;

  /// `time` in seconds; `world_from_node` as forward() gives it for the pose. kUsage where sizes do not agree with the
  /// skeleton or a number is not finite.
  virtual Result<void> write(double time, const Pose& pose, std::span<const Transform> world_from_node) = 0;
  virtual Result<void> finish() = 0;

 protected:
  MotionSink() = default;
};

/// Opens the sink for a path that ends in .jsonl or .bvh (kUsage for any other). Keeps a copy of the skeleton.
Result<std::unique_ptr<MotionSink>> open_motion(const std::string& path, const MotionHeader& header,
                                                const Skeleton& skeleton);

struct MotionFrame {
  double time = 0;               ///< seconds, not before the frame in front of it
  std::vector<Transform> world;  ///< by MotionClip::nodes
  FaceWeights face{};
};

/// A motion as read.
struct MotionClip {
  MotionHeader header;
  std::vector<std::string> nodes;
  std::vector<MotionFrame> frames;  ///< at least one
};

/// Reads what open_motion wrote, or another program that keeps the contract. Unknown members are passed over, unknown
/// face channels too; weights are clamped to 0..1. kMalformed (place = file:line) for anything else; kLimit: a file
/// above 1 GiB, a line above 1 MiB, nesting above 16, more than 1024 nodes.
Result<MotionClip> read_motion_jsonl(const std::string& path);

/// The same from text in memory; `name` stands for the file in messages.
Result<MotionClip> parse_motion_jsonl(std::string_view text, const std::string& name);

/// One frame as a pose of a skeleton: local rotations from world rotations, the root placed where it was. Nodes that
/// the clip lacks keep their rest rotation; other bone lengths are the skeleton's own. kMalformed when a node of
/// kNodeNames is missing from the clip.
Result<Pose> pose_from_frame(const MotionClip& clip, const MotionFrame& frame, const Skeleton& skeleton);

}  // namespace auslan
