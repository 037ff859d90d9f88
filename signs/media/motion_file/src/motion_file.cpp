// SPDX-License-Identifier: Apache-2.0
#include "media/motion_file.h"

#include "sinks.h"

#include <array>
#include <charconv>
#include <cmath>

namespace auslan {

namespace {

template <typename T>
void append_shortest(std::string& text, T value) {
  std::array<char, 40> digits{};
  // -0 and 0 are the same number and should be the same text.
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == T{0} ? T{0} : value).ptr;
  text.append(digits.data(), static_cast<size_t>(end - digits.data()));
}

bool ends_in(const std::string& path, std::string_view suffix) {
  if (path.size() <= suffix.size()) return false;
  for (size_t i = 0; i < suffix.size(); ++i) {
    const char c = path[path.size() - suffix.size() + i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != suffix[i]) return false;
  }
  return true;
}

/// Length of the UTF-8 sequence at the front of a non-empty text, or 0 when it is not UTF-8.
size_t utf8_length(std::string_view text) {
  const auto byte = [&text](size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                        : first >= 0xE0 && first <= 0xEF ? 3
                        : first >= 0xF0 && first <= 0xF4 ? 4
                                                         : 0;
  if (length == 0 || text.size() < length) return 0;
  for (size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates, beyond the last plane: told by the second byte.
  const unsigned second = byte(1);
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || (first == 0xF0 && second < 0x90) ||
      (first == 0xF4 && second > 0x8F))
    return 0;
  return length;
}

bool is_finite(const Transform& transform) {
  const Quat& q = transform.rotation;
  const Vec3& p = transform.position;
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) && std::isfinite(p.x) &&
         std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

void append_number(std::string& text, double value) {
  append_shortest(text, value);
}
void append_number(std::string& text, float value) {
  append_shortest(text, value);
}

void append_json_string(std::string& text, std::string_view value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  text += '"';
  while (!value.empty()) {
    const size_t length = utf8_length(value);
    const char c = value.front();
    if (length == 0) {
      text += "\xEF\xBF\xBD";
    } else if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      text += "\\u00";
      text += kDigits[static_cast<unsigned char>(c) >> 4];
      text += kDigits[static_cast<unsigned char>(c) & 15];
    } else {
      text.append(value.substr(0, length));
    }
    value.remove_prefix(length == 0 ? 1 : length);
  }
  text += '"';
}

Result<void> check_motion_frame(const std::string& path, const Skeleton& skeleton, double time, const Pose& pose,
                                std::span<const Transform> world_from_node) {
  const auto count = static_cast<size_t>(skeleton.size());
  if (pose.rotation.size() != count || world_from_node.size() != count)
    return fail(ErrorCode::kUsage, path + ": a frame does not have one rotation for each node of the skeleton");
  bool finite = std::isfinite(time) && is_finite({kIdentity, pose.root_translation});
  for (const Transform& transform : world_from_node)
    finite = finite && is_finite(transform);
  for (const Quat& rotation : pose.rotation)
    finite = finite && is_finite({rotation, Vec3(0.0)});
  for (const float weight : pose.face)
    finite = finite && std::isfinite(weight);
  if (!finite) return fail(ErrorCode::kUsage, path + ": a frame holds a number that is not finite");
  return {};
}

Result<std::unique_ptr<MotionSink>> open_motion(const std::string& path, const MotionHeader& header,
                                                const Skeleton& skeleton) {
  if (!std::isfinite(header.fps) || header.fps <= 0)
    return fail(ErrorCode::kUsage, path + ": a motion needs a rate above 0 frames a second");
  for (const MotionGloss& gloss : header.glosses)
    if (!std::isfinite(gloss.start) || !std::isfinite(gloss.end))
      return fail(ErrorCode::kUsage, path + ": a gloss begins or ends at a time that is not finite");
  if (ends_in(path, ".jsonl")) return open_jsonl(path, header, skeleton);
  if (ends_in(path, ".bvh")) return open_bvh(path, header, skeleton);
  return fail(ErrorCode::kUsage, "cannot tell a motion's format from \"" + path + "\"; end it in .jsonl or .bvh");
}

}  // namespace auslan
