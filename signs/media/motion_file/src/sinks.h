// SPDX-License-Identifier: Apache-2.0
// The sinks behind open_motion, and the spelling of numbers that they share.
#pragma once

#include "kinematics/atomic_file.h"
#include "media/motion_file.h"

#include <memory>
#include <string>
#include <string_view>

namespace auslan {

Result<std::unique_ptr<MotionSink>> open_jsonl(const std::string& path, const MotionHeader& header,
                                               const Skeleton& skeleton);
Result<std::unique_ptr<MotionSink>> open_bvh(const std::string& path, const MotionHeader& header,
                                             const Skeleton& skeleton);

/// The shortest decimal that reads back the same; -0 becomes 0.
void append_number(std::string& text, double value);
void append_number(std::string& text, float value);
/// With quotation marks; what is not UTF-8 becomes U+FFFD.
void append_json_string(std::string& text, std::string_view value);

/// kUsage when the frame does not belong to the skeleton or holds a number that is not finite.
Result<void> check_motion_frame(const std::string& path, const Skeleton& skeleton, double time, const Pose& pose,
                                std::span<const Transform> world_from_node);

}  // namespace auslan
