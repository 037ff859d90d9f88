// SPDX-License-Identifier: Apache-2.0
#include "sinks.h"

#include <optional>
#include <utility>

namespace auslan {

namespace {

class JsonlSink final : public MotionSink {
 public:
  JsonlSink(AtomicFile file, Skeleton skeleton) : path_(file.path()), skeleton_(std::move(skeleton)) {
    file_.emplace(std::move(file));
  }

  Result<void> write(double time, const Pose& pose, std::span<const Transform> world_from_node) override {
    if (!file_) return closed();
    auto done = check_motion_frame(path_, skeleton_, time, pose, world_from_node);
    if (done) {
      spell(time, pose, world_from_node);
      done = file_->write(line_);
    }
    if (!done) file_.reset();
    ++frames_;
    return done;
  }

  Result<void> finish() override {
    if (!file_) return closed();
    auto done = frames_ > 0 ? file_->commit() : fail(ErrorCode::kUsage, path_ + ": the motion has no frame");
    file_.reset();
    return done;
  }

 private:
  Result<void> closed() const {
    return fail(ErrorCode::kUsage, path_ + ": the motion is finished, or failed before; open it again");
  }

  void spell(double time, const Pose& pose, std::span<const Transform> world_from_node) {
    line_ = "{\"t\":";
    append_number(line_, time);
    line_ += ",\"joints\":{";
    for (size_t i = 0; i < world_from_node.size(); ++i) {
      if (i > 0) line_ += ',';
      append_json_string(line_, skeleton_.nodes()[i].name);
      const Vec3& p = world_from_node[i].position;
      const Quat& q = world_from_node[i].rotation;
      char separator = '[';
      line_ += ':';
      for (const double value : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) {
        line_ += separator;
        append_number(line_, value);
        separator = ',';
      }
      line_ += ']';
    }
    line_ += "},\"face\":{";
    bool first = true;
    for (size_t i = 0; i < pose.face.size(); ++i) {
      if (pose.face[i] == 0.0F) continue;
      if (!first) line_ += ',';
      first = false;
      append_json_string(line_, kFaceChannelNames[i]);
      line_ += ':';
      append_number(line_, pose.face[i]);
    }
    line_ += "}}\n";
  }

  std::string path_;
  Skeleton skeleton_;
  std::optional<AtomicFile> file_;
  std::string line_;
  int64_t frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<MotionSink>> open_jsonl(const std::string& path, const MotionHeader& header,
                                               const Skeleton& skeleton) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  std::string line = "{\"fps\":";
  append_number(line, header.fps);
  line += ",\"units\":\"m\",\"frame\":\"y-up, +x signer's left, +z towards the viewer, world\",\"glosses\":[";
  for (size_t i = 0; i < header.glosses.size(); ++i) {
    line += i > 0 ? ",{\"gloss\":" : "{\"gloss\":";
    append_json_string(line, header.glosses[i].gloss);
    line += ",\"start\":";
    append_number(line, header.glosses[i].start);
    line += ",\"end\":";
    append_number(line, header.glosses[i].end);
    line += '}';
  }
  line += "],\"nodes\":[";
  for (int i = 0; i < skeleton.size(); ++i) {
    if (i > 0) line += ',';
    append_json_string(line, skeleton.node(i).name);
  }
  line += "]}\n";
  if (auto written = file->write(line); !written) return tl::unexpected(written.error());
  return std::make_unique<JsonlSink>(std::move(*file), skeleton);
}

}  // namespace auslan
