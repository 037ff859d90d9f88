// SPDX-License-Identifier: Apache-2.0
#include "glove.h"

#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "kinematics/whole_file.h"
#include "shipped.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace auslan::glove {
namespace {

constexpr size_t kColumns = 22, kColumnsOfHand = 11;
constexpr size_t kMaxFrames = 100000, kMaxBytes = size_t{1} << 24;
constexpr size_t kRestFrames = 6;

/// Angles from 0 to 1, where a half is straight ahead, level, palm down.
Hand hand_of(const double* v) {
  Hand hand;
  // The recording counts x to the signer's right and z towards the signer.
  hand.place = {-v[0], v[1], -v[2]};
  const double roll = (v[3] - 0.5) * 2.0 * kPi, pitch = (v[4] - 0.5) * kPi, yaw = (v[5] - 0.5) * 2.0 * kPi;
  hand.fingers = {sine(yaw) * cosine(pitch), sine(pitch), cosine(yaw) * cosine(pitch)};
  const Vec3 left{cosine(yaw), 0.0, -sine(yaw)};
  const Vec3 down = -glm::cross(hand.fingers, left);
  hand.palm = cosine(roll) * down - sine(roll) * left;
  std::copy_n(v + 6, 5, hand.bends.begin());
  return hand;
}

Vec3 rest_of(const std::vector<Frame>& frames, size_t side) {
  const size_t count = std::min(kRestFrames, frames.size());
  Vec3 sum(0.0);
  for (size_t i = frames.size() - count; i < frames.size(); ++i)
    sum += frames[i][side].place;
  return sum / static_cast<double>(count);
}

double apart(const Vec3& a, const Vec3& b) {
  return std::sqrt(glm::dot(a - b, a - b));
}

double farthest(const std::vector<Frame>& frames, size_t side) {
  const Vec3 rest = rest_of(frames, side);
  double most = 0.0;
  for (const Frame& frame : frames)
    most = std::max(most, apart(frame[side].place, rest));
  return most;
}

}  // namespace

Result<std::vector<Frame>> parse_glove(std::string_view text, const std::string& place) {
  std::vector<Frame> frames;
  size_t number = 0;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string at = place + ":" + std::to_string(++number);
    std::array<double, kColumns> values{};
    size_t column = 0;
    while (true) {
      line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
      if (line.empty()) break;
      if (column == kColumns) return fail(ErrorCode::kMalformed, "more than 22 columns", at);
      const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), values[column]);
      if (error != std::errc() || !std::isfinite(values[column]))
        return fail(ErrorCode::kMalformed, "column " + std::to_string(column + 1) + " is no number", at);
      ++column;
      line.remove_prefix(static_cast<size_t>(stop - line.data()));
    }
    if (column == 0) continue;
    if (column != kColumns) return fail(ErrorCode::kMalformed, std::to_string(column) + " columns; expected 22", at);
    if (frames.size() == kMaxFrames) return fail(ErrorCode::kLimit, "too many rows", at);
    Frame frame;
    frame[static_cast<size_t>(Side::kLeft)] = hand_of(values.data());
    frame[static_cast<size_t>(Side::kRight)] = hand_of(values.data() + kColumnsOfHand);
    frames.push_back(frame);
  }
  if (frames.empty()) return fail(ErrorCode::kMalformed, "no rows", place);
  return frames;
}

Result<std::vector<Recording>> read_glove_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".tsd") paths.push_back(it->path());
  if (error) return fail(ErrorCode::kUnreadable, "cannot list it (" + error.message() + ")", folder.string());
  std::ranges::sort(paths);
  std::vector<Recording> recordings;
  for (const std::filesystem::path& path : paths) {
    const Result<std::string> text = read_whole_file(path, kMaxBytes);
    if (!text) return tl::unexpected(text.error());
    Result<std::vector<Frame>> frames = parse_glove(*text, path.string());
    if (!frames) return tl::unexpected(frames.error());
    const std::string stem = path.stem().string();
    const size_t dot = stem.rfind('.');
    if (dot == std::string::npos)
      return fail(ErrorCode::kMalformed, "expected a name as WORD.SESSION.tsd", path.string());
    recordings.push_back({stem.substr(0, dot), stem.substr(dot + 1), std::move(*frames)});
  }
  return recordings;
}

std::vector<Frame> synthesised(const std::string& gloss, double rate) {
  const Signer& signer = *shipped().signer;
  const Skeleton& skeleton = shipped().figure.skeleton;
  const Performance performance(signer, score_of({gloss}), {.left_handed = false, .idle = false, .seed = 1});
  std::vector<Frame> frames;
  Pose pose;
  std::vector<Transform> world(static_cast<size_t>(skeleton.size()));
  const int count = static_cast<int>(seconds(performance.end()) * rate) + 1;
  for (int i = 0; i < count; ++i) {
    performance.sample(ticks(i / rate), pose);
    forward(skeleton, pose, world);
    Frame frame;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const ArmNodes nodes = arm_nodes(skeleton, side);
      const Transform& wrist = world[static_cast<size_t>(nodes.wrist)];
      Hand& hand = frame[static_cast<size_t>(side)];
      hand.fingers = wrist.rotation * signer.hand_frame(side).fingers;
      hand.palm = wrist.rotation * signer.hand_frame(side).palm;
      hand.place = wrist.position - kTrackerAbove * hand.palm;
      for (size_t digit = 0; digit < 5; ++digit) {
        constexpr double kWhollyBent = 250.0 * kDegree;
        double sum = 0.0;
        for (const int node : nodes.digits[digit])
          sum += angle_between(kIdentity, pose.rotation[static_cast<size_t>(node)]);
        hand.bends[digit] = std::min(1.0, sum / kWhollyBent);
      }
    }
    frames.push_back(frame);
  }
  return frames;
}

std::vector<Frame> without_rest(const std::vector<Frame>& frames) {
  constexpr double kAway = 0.4;
  const size_t side = farthest(frames, 0) > farthest(frames, 1) ? 0 : 1;
  const Vec3 rest = rest_of(frames, side);
  const double away = kAway * farthest(frames, side);
  size_t first = frames.size(), last = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    if (apart(frames[i][side].place, rest) < away) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first > last) return frames;
  return {frames.begin() + static_cast<std::ptrdiff_t>(first), frames.begin() + static_cast<std::ptrdiff_t>(last) + 1};
}

bool takes_part(const std::vector<Frame>& frames, Side side) {
  constexpr double kMoved = 0.085;  // metres
  return farthest(frames, static_cast<size_t>(side)) > kMoved;
}

}  // namespace auslan::glove
