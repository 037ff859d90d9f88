// SPDX-License-Identifier: Apache-2.0
// Every compiler and processor fits and poses a foreign figure to the same bits: a digest of its skeleton and of every
// vertex in a pose that bends, twists and opens the mouth. To be replaced, after a look at the figures, where fitting
// or posing changes on purpose.
#include "box_avatar.h"
#include "kinematics/avatar_model.h"

#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

namespace auslan {
namespace {

constexpr uint64_t kDigest = 0xE59735F3B167ED10ULL;

/// FNV-1a over the bytes of numbers.
class Digest {
 public:
  template <typename T>
  void add(const T& value) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    for (const unsigned char byte : bytes)
      hash_ = (hash_ ^ byte) * 0x100000001B3ULL;
  }
  uint64_t value() const { return hash_; }

 private:
  uint64_t hash_ = 0xCBF29CE484222325ULL;
};

TEST(AvatarBytes, AreTheSameEverywhere) {
  Digest digest;
  for (const test::BoxAvatar& wanted :
       {test::BoxAvatar{.arms_below = 0.7, .fingers_bent = 0.2, .yaw = 2.0, .scale = 0.3, .place = Vec3(1.0, 2.0, 3.0)},
        test::BoxAvatar{.arms_below = -0.4, .yaw = 0.1, .pitch = 1.4}}) {
    const SigningAvatar avatar = fit_avatar(test::box_avatar(wanted)).value();
    const Skeleton& skeleton = avatar.figure.skeleton;
    Pose pose = rest_pose(skeleton);
    for (size_t n = 0; n < pose.rotation.size(); ++n)
      pose.rotation[n] = from_rotation_vector(Vec3(0.3, -0.2, 0.1) * (static_cast<double>(n % 7) - 3.0));
    pose.face[static_cast<size_t>(FaceChannel::kJawOpen)] = 0.7F;
    std::vector<Transform> world(pose.rotation.size());
    forward(skeleton, pose, world);
    for (const Node& node : skeleton.nodes())
      digest.add(node.offset);
    const auto model = make_avatar_model(avatar);
    for (const PosedMesh& mesh : model->pose(world, pose.face)) {
      for (const glm::vec3& position : mesh.positions)
        digest.add(position);
      for (const glm::vec3& normal : mesh.normals)
        digest.add(normal);
      for (const glm::u8vec4& colour : mesh.colours)
        digest.add(colour);
    }
  }
  EXPECT_EQ(digest.value(), kDigest) << std::hex << digest.value();
}

}  // namespace
}  // namespace auslan
