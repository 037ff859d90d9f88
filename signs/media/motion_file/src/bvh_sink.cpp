// SPDX-License-Identifier: Apache-2.0
// BVH as Biovision's format is read everywhere: channel order is rotation order, the rest rotation is the identity. Our
// rest pose is that too, so that a joint's channels are its pose rotation and nothing has to be converted.
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "sinks.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace auslan {

namespace {

/// The format has no place for a count that is learnt at the end, so room is left and filled in.
constexpr size_t kCountDigits = 10;
/// What a leaf gets for a bone, metres: a fingertip's length. Readers draw it; it carries no motion.
constexpr double kEndSite = 0.02;

void append_triple(std::string& text, const Vec3& v) {
  append_number(text, v.x);
  text += ' ';
  append_number(text, v.y);
  text += ' ';
  append_number(text, v.z);
}

/// Node names go out as single words.
std::string word(const std::string& name) {
  std::string out = name.empty() ? "unnamed" : name;
  for (char& c : out)
    if (c == '{' || c == '}' || static_cast<unsigned char>(c) <= ' ') c = '_';
  return out;
}

/// BVH nests, so its frames list the nodes in the order of the nesting; an array with parents first need not be in it.
struct Nesting {
  explicit Nesting(const Skeleton& skeleton) : children(static_cast<size_t>(skeleton.size())) {
    for (int i = 1; i < skeleton.size(); ++i)
      children[static_cast<size_t>(skeleton.node(i).parent)].push_back(i);
  }
  std::vector<std::vector<int>> children;
};

/// Where a leaf points: on from its own bone.
Vec3 end_site(const Node& node) {
  const double length = glm::length(node.offset);
  return length > 1e-9 ? node.offset * (kEndSite / length) : Vec3(0.0, kEndSite, 0.0);
}

void spell_hierarchy(const Skeleton& skeleton, const Nesting& nesting, std::string& text, std::vector<int>& order) {
  // An explicit stack: a skeleton may be a chain of any length. -1 closes the innermost brace.
  std::vector<int> stack = {0};
  std::string indent;
  text += "HIERARCHY\n";
  while (!stack.empty()) {
    const int index = stack.back();
    stack.pop_back();
    if (index < 0) {
      indent.pop_back();
      text += indent + "}\n";
      continue;
    }
    order.push_back(index);
    const Node& node = skeleton.node(index);
    const bool root = node.parent == kNoNode;
    text += indent + (root ? "ROOT " : "JOINT ") + word(node.name) + "\n" + indent + "{\n";
    indent += '\t';
    text += indent + "OFFSET ";
    // Readers disagree on whether a root's offset is added to its position: without one they agree.
    append_triple(text, root ? Vec3(0.0) : node.offset);
    text += "\n" + indent + (root ? "CHANNELS 6 Xposition Yposition Zposition " : "CHANNELS 3 ") +
            "Zrotation Xrotation Yrotation\n";
    stack.push_back(-1);
    const auto& children = nesting.children[static_cast<size_t>(index)];
    if (children.empty()) {
      text += indent + "End Site\n" + indent + "{\n" + indent + "\tOFFSET ";
      append_triple(text, end_site(node));
      text += "\n" + indent + "}\n";
    }
    for (size_t i = children.size(); i > 0; --i)
      stack.push_back(children[i - 1]);
  }
}

class BvhSink final : public MotionSink {
 public:
  BvhSink(AtomicFile file, Skeleton skeleton, std::vector<int> order, uint64_t count_at)
      : path_(file.path()), skeleton_(std::move(skeleton)), order_(std::move(order)), count_at_(count_at) {
    file_.emplace(std::move(file));
  }

  Result<void> write(double time, const Pose& pose, std::span<const Transform> world_from_node) override {
    if (!file_) return closed();
    auto done = check_motion_frame(path_, skeleton_, time, pose, world_from_node);
    if (done) {
      spell(pose);
      done = file_->write(line_);
    }
    if (!done) file_.reset();
    ++frames_;
    return done;
  }

  Result<void> finish() override {
    if (!file_) return closed();
    Result<void> done;
    if (frames_ == 0) done = fail(ErrorCode::kUsage, path_ + ": the motion has no frame");
    std::string count = std::to_string(frames_);
    count.insert(0, kCountDigits - std::min(kCountDigits, count.size()), ' ');
    if (done) done = file_->overwrite(count_at_, count);
    if (done) done = file_->commit();
    file_.reset();
    return done;
  }

 private:
  Result<void> closed() const {
    return fail(ErrorCode::kUsage, path_ + ": the motion is finished, or failed before; open it again");
  }

  void spell(const Pose& pose) {
    line_.clear();
    for (const int index : order_) {
      const Node& node = skeleton_.node(index);
      if (node.parent == kNoNode) {
        append_triple(line_, node.offset + pose.root_translation);
        line_ += ' ';
      }
      const Vec3 radians = to_euler(pose.rotation[static_cast<size_t>(index)], EulerOrder::kZXY);
      append_triple(line_, Vec3(radians.z, radians.x, radians.y) / kDegree);
      line_ += ' ';
    }
    line_.back() = '\n';
  }

  std::string path_;
  Skeleton skeleton_;
  std::vector<int> order_;
  uint64_t count_at_;
  std::optional<AtomicFile> file_;
  std::string line_;
  int64_t frames_ = 0;
};

}  // namespace

Result<std::unique_ptr<MotionSink>> open_bvh(const std::string& path, const MotionHeader& header,
                                             const Skeleton& skeleton) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (file->temporary_path().empty())
    return fail(
        ErrorCode::kUnwritable,
        path + " is a device or a pipe, and a .bvh needs its count filled in; name a plain file, or use .jsonl");
  std::string text;
  std::vector<int> order;
  spell_hierarchy(skeleton, Nesting(skeleton), text, order);
  text += "MOTION\nFrames: ";
  const uint64_t count_at = text.size();
  text.append(kCountDigits, ' ');
  text += "\nFrame Time: ";
  append_number(text, 1.0 / header.fps);
  text += '\n';
  if (auto written = file->write(text); !written) return tl::unexpected(written.error());
  return std::make_unique<BvhSink>(std::move(*file), skeleton, std::move(order), count_at);
}

}  // namespace auslan
