// SPDX-License-Identifier: Apache-2.0
#include "kinematics/rotation.h"
#include "kinematics/whole_file.h"
#include "media/motion_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace auslan {

namespace {

using Json = nlohmann::json;

constexpr uint64_t kMaxFile = uint64_t{1} << 30;
constexpr size_t kMaxLine = size_t{1} << 20;
constexpr int kMaxDepth = 16;
constexpr size_t kMaxNodes = 1024;
constexpr double kMaxDistance = 1e6;  ///< metres: beyond it somebody's units are wrong
/// A unit quaternion that went through a few printed digits is still closer to unit length.
constexpr double kUnitTolerance = 1e-2;

/// Whether brackets nest within kMaxDepth: the JSON library recurses when it destroys what it read.
bool is_shallow(std::string_view line) {
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxDepth) return false;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return true;
}

std::optional<double> number_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  const double value = found->get<double>();
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// px py pz qw qx qy qz
std::optional<Transform> transform_of(const Json& value) {
  if (!value.is_array() || value.size() != 7) return std::nullopt;
  std::array<double, 7> n{};
  for (size_t i = 0; i < n.size(); ++i) {
    if (!value[i].is_number()) return std::nullopt;
    n[i] = value[i].get<double>();
    if (!std::isfinite(n[i]) || std::abs(n[i]) > kMaxDistance) return std::nullopt;
  }
  const double length = std::sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6]);
  if (std::abs(length - 1.0) > kUnitTolerance) return std::nullopt;
  // One that is unit to the last bits stays as it was written, so that a motion survives being read and written again.
  const double scale = std::abs(length - 1.0) < 1e-12 ? 1.0 : length;
  return Transform{Quat(n[3] / scale, n[4] / scale, n[5] / scale, n[6] / scale), Vec3(n[0], n[1], n[2])};
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Result<MotionClip> read() {
    if (auto header = next(); !header)
      return tl::unexpected(header.error());
    else if (auto done = read_header(*header); !done)
      return tl::unexpected(done.error());
    while (skip_empty_lines()) {
      auto line = next();
      if (!line) return tl::unexpected(line.error());
      if (auto done = read_frame(*line); !done) return tl::unexpected(done.error());
    }
    if (clip_.frames.empty()) return bad("there is no frame after the header; a motion needs at least one");
    return std::move(clip_);
  }

 private:
  tl::unexpected<Error> bad(const std::string& message, ErrorCode code = ErrorCode::kMalformed) const {
    return fail(code, message, name_ + ":" + std::to_string(line_));
  }

  /// False at the end of the text.
  bool skip_empty_lines() {
    while (!rest_.empty() && (rest_.front() == '\n' || rest_.front() == '\r')) {
      if (rest_.front() == '\n') ++line_;
      rest_.remove_prefix(1);
    }
    return !rest_.empty();
  }

  /// The next line as a JSON object.
  Result<Json> next() {
    ++line_;
    const size_t end = std::min(rest_.find('\n'), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    if (line.size() > kMaxLine) return bad("this line is longer than 1 MiB; a line holds one frame", ErrorCode::kLimit);
    if (!is_shallow(line))
      return bad("brackets nest deeper than " + std::to_string(kMaxDepth) + "; this is not a motion",
                 ErrorCode::kLimit);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    Json value = Json::parse(line, nullptr, false);
    if (!value.is_object())
      return bad("this line is not a JSON object; a motion has one object a line, as `auslanjam motion` writes it");
    return value;
  }

  Result<void> read_header(const Json& header) {
    const auto fps = number_of(header, "fps");
    if (!fps || *fps <= 0 || *fps > 10000) return bad("the first line needs \"fps\", a number above 0 and up to 10000");
    clip_.header.fps = *fps;
    const auto units = header.find("units");
    if (units != header.end() && *units != "m") return bad("\"units\" must be \"m\": convert the motion to metres");
    const auto glosses = header.find("glosses");
    if (glosses == header.end()) return {};
    if (!glosses->is_array()) return bad("\"glosses\" must be an array of {\"gloss\", \"start\", \"end\"}");
    for (const Json& gloss : *glosses) {
      const auto start = gloss.is_object() ? number_of(gloss, "start") : std::nullopt;
      const auto end = gloss.is_object() ? number_of(gloss, "end") : std::nullopt;
      if (!start || !end || !gloss.contains("gloss") || !gloss["gloss"].is_string())
        return bad("each of \"glosses\" must be {\"gloss\": text, \"start\": seconds, \"end\": seconds}");
      clip_.header.glosses.push_back({gloss["gloss"].get<std::string>(), *start, *end});
    }
    return {};
  }

  Result<void> read_frame(const Json& line) {
    MotionFrame frame;
    const auto time = number_of(line, "t");
    if (!time) return bad("a frame needs \"t\", its time in seconds");
    if (!clip_.frames.empty() && *time < clip_.frames.back().time)
      return bad("\"t\" goes back in time; put the frames in order");
    frame.time = *time;
    const auto joints = line.find("joints");
    if (joints == line.end() || !joints->is_object() || joints->empty())
      return bad("a frame needs \"joints\", an object of name: [px,py,pz,qw,qx,qy,qz]");
    if (joints->size() > kMaxNodes) return bad("more than 1024 joints in a frame", ErrorCode::kLimit);
    // The library keeps members in order of name: any two frames list them alike.
    if (clip_.frames.empty())
      for (const auto& [name, value] : joints->items())
        clip_.nodes.push_back(name);
    if (joints->size() != clip_.nodes.size())
      return bad("this frame does not have the joints of the first frame; every frame lists all of them");
    frame.world.reserve(clip_.nodes.size());
    for (const auto& [name, value] : joints->items()) {
      if (name != clip_.nodes[frame.world.size()])
        return bad("the joint \"" + name + "\" is not in the first frame; every frame lists the same joints");
      const auto transform = transform_of(value);
      if (!transform)
        return bad("the joint \"" + name + "\" must be [px,py,pz,qw,qx,qy,qz]: metres, and a quaternion of length 1");
      frame.world.push_back(*transform);
    }
    if (auto face = read_face(line, frame); !face) return face;
    clip_.frames.push_back(std::move(frame));
    return {};
  }

  Result<void> read_face(const Json& line, MotionFrame& frame) const {
    const auto face = line.find("face");
    if (face == line.end()) return {};
    if (!face->is_object()) return bad("\"face\" must be an object of channel: weight");
    for (size_t i = 0; i < kFaceChannelNames.size(); ++i) {
      const auto found = face->find(kFaceChannelNames[i]);
      if (found == face->end()) continue;
      if (!found->is_number() || !std::isfinite(found->get<double>()))
        return bad("the face channel \"" + std::string(kFaceChannelNames[i]) + "\" must be a number from 0 to 1");
      frame.face[i] = static_cast<float>(std::clamp(found->get<double>(), 0.0, 1.0));
    }
    return {};
  }

  std::string_view rest_;
  const std::string& name_;
  int64_t line_ = 0;
  MotionClip clip_;
};

}  // namespace

Result<MotionClip> parse_motion_jsonl(std::string_view text, const std::string& name) {
  if (text.size() > kMaxFile) return fail(ErrorCode::kLimit, "a motion above 1 GiB is not read; cut it in parts", name);
  return Reader(text, name).read();
}

Result<MotionClip> read_motion_jsonl(const std::string& path) {
  const auto text = read_whole_file(path, kMaxFile);
  if (!text) return tl::unexpected(text.error());
  return parse_motion_jsonl(*text, path);
}

Result<Pose> pose_from_frame(const MotionClip& clip, const MotionFrame& frame, const Skeleton& skeleton) {
  const auto transform_named = [&](std::string_view name) -> const Transform* {
    const auto found = std::find(clip.nodes.begin(), clip.nodes.end(), name);
    return found == clip.nodes.end() ? nullptr : &frame.world[static_cast<size_t>(found - clip.nodes.begin())];
  };
  if (frame.world.size() != clip.nodes.size()) return fail(ErrorCode::kMalformed, "a frame of another motion");
  for (const std::string_view name : kNodeNames)
    if (transform_named(name) == nullptr)
      return fail(ErrorCode::kMalformed, "the motion has no joint \"" + std::string(name) +
                                             "\"; a motion that is to be played needs all " +
                                             std::to_string(kNodeNames.size()) + " of them");
  Pose pose = rest_pose(skeleton);
  pose.face = frame.face;
  std::vector<Quat> world(static_cast<size_t>(skeleton.size()), kIdentity);
  for (size_t i = 0; i < world.size(); ++i) {
    const Node& node = skeleton.nodes()[i];
    const Transform* placed = transform_named(node.name);
    const Quat parent = node.parent == kNoNode ? kIdentity : world[static_cast<size_t>(node.parent)];
    if (placed != nullptr) pose.rotation[i] = renormalised(glm::conjugate(parent) * placed->rotation);
    world[i] = parent * pose.rotation[i];
    if (node.parent == kNoNode && placed != nullptr) pose.root_translation = placed->position - node.offset;
  }
  return pose;
}

}  // namespace auslan
