// SPDX-License-Identifier: Apache-2.0
#include "kinematics/avatar_model.h"

#include "avatar_fit.h"
#include "kinematics/elementary.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace auslan {
namespace {

using enum FaceChannel;

// How far eyes turn and the jaw opens at full weight, by their bones: as the channels of the built-in figure do.
constexpr double kLookUp = 24.0 * kDegree, kLookDown = 28.0 * kDegree, kLookAside = 30.0 * kDegree;
constexpr double kJawOpens = 16.0 * kDegree;

uint8_t srgb_level(float linear) {
  const double x = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * power(x, 1.0 / 2.4) - 0.055;
  return static_cast<uint8_t>(encoded * 255.0 + 0.5);
}

uint8_t product(uint32_t a, uint32_t b) {
  return static_cast<uint8_t>((a * b + 127U) / 255U);
}

glm::u8vec4 product(const glm::u8vec4& a, const glm::u8vec4& b) {
  return {product(a.x, b.x), product(a.y, b.y), product(a.z, b.z), product(a.w, b.w)};
}

glm::vec2 placed(const ImagePlacement& placement, const glm::vec2& place) {
  return placement.origin + placement.x_axis * place.x + placement.y_axis * place.y;
}

/// Vertices of a part of the avatar that are drawn as one mesh.
struct Piece {
  size_t part = 0;
  std::vector<uint32_t> source;  ///< of each vertex: its index in the part
  std::vector<uint32_t> indices;
  std::vector<glm::u8vec4> colours;
  std::vector<glm::vec2> coordinates;  ///< empty without an image
  int image = -1;
  ImageWrap wrap_u = ImageWrap::kRepeat, wrap_v = ImageWrap::kRepeat;
  float alpha_cutoff = 0.0F;
  std::vector<glm::vec3> positions, normals;
  bool is_back = false;  ///< the back of a surface that is seen from both sides
  uint64_t revision = 1;
};

class AvatarModel final : public BodyModel {
 public:
  explicit AvatarModel(const SigningAvatar& avatar)
      : avatar_(avatar),
        poser_(avatar.avatar),
        rest_weights_(rest_pose(avatar.avatar).morph_weights),
        weights_(rest_weights_),
        driven_(AvatarDriver::kCount),
        world_(avatar.avatar.nodes.size()) {
    for (size_t n = 0; n < fit::kNodes; ++n)
      rest_.push_back(avatar.figure.skeleton.rest_position(static_cast<int>(n)));
    for (const std::string_view name : AvatarDriver::kTwistNodes) {
      const int node = avatar.figure.skeleton.find(name);
      twists_.push_back({node, unit(avatar.figure.skeleton.node(node + 1).offset)});
    }
    poser_.place(avatar.world_from_node, rest_weights_);
    const std::vector<fit::Skin> skins = fit::main_drivers(avatar.avatar, poser_.parts(), avatar.driver);
    for (size_t p = 0; p < poser_.parts().size(); ++p)
      cut(p, skins[p]);
    std::ranges::stable_sort(pieces_, {}, &std::pair<int, Piece>::first);
    // Only now: the vectors must stay where the views point.
    for (auto& [node, piece] : pieces_)
      posed_.push_back({.node = node,
                        .positions = piece.positions,
                        .normals = piece.normals,
                        .colours = piece.colours,
                        .indices = piece.indices,
                        .image = piece.image,
                        .texture_coordinates = piece.coordinates,
                        .wrap_u = piece.wrap_u,
                        .wrap_v = piece.wrap_v,
                        .alpha_cutoff = piece.alpha_cutoff});
  }

  std::span<const PosedMesh> pose(std::span<const Transform> world_from_node, const FaceWeights& face) override {
    if (!is_new(world_from_node, face)) return posed_;
    drive(world_from_node, face);
    weigh(face);
    for (size_t i = 0; i < world_.size(); ++i)
      world_[i] = driven_[static_cast<size_t>(avatar_.driver[i])] * avatar_.world_from_node[i];
    poser_.place(world_, weights_);
    for (size_t i = 0; i < pieces_.size(); ++i) {
      gather(pieces_[i].second);
      posed_[i].revision = pieces_[i].second.revision;
    }
    return posed_;
  }

 private:
  struct Twist {
    int node;
    Vec3 axis;
  };

  /// Whether the pose is another than the last one, which it then is.
  bool is_new(std::span<const Transform> world_from_node, const FaceWeights& face) {
    const auto same = [](const Transform& a, const Transform& b) {
      return a.rotation == b.rotation && a.position == b.position;
    };
    if (face == last_face_ && std::ranges::equal(world_from_node.first(fit::kNodes), last_, same)) return false;
    last_.assign(world_from_node.begin(), world_from_node.begin() + fit::kNodes);
    last_face_ = face;
    return true;
  }

  static int node_of(int driver) {
    if (driver >= AvatarDriver::kFirstTwist) {
      const int bone = (driver - AvatarDriver::kFirstTwist) / (AvatarDriver::kTwistSteps + 1);
      const ArmNodes arm = fit::named_arm(bone < 2 ? Side::kLeft : Side::kRight);
      return bone % 2 == 0 ? arm.shoulder : arm.elbow;
    }
    if (driver < AvatarDriver::kGround) return driver;
    return driver == AvatarDriver::kGround ? 0 : 2;
  }

  void cut(size_t part_index, const fit::Skin& skin) {
    const AvatarPoser::Part& part = poser_.parts()[part_index];
    const AvatarMesh& mesh = avatar_.avatar.meshes[static_cast<size_t>(part.mesh)];
    const AvatarVertices& vertices = mesh.vertices[static_cast<size_t>(part.vertices)];
    constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
    std::vector<uint32_t> local(part.positions.size(), kNone);
    for (const AvatarSurface& surface : mesh.surfaces) {
      if (surface.vertices != part.vertices || !fit::is_shown(surface)) continue;
      std::map<int, std::vector<uint32_t>> by_node;
      for (size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
        const std::array<int, 3> nodes = {node_of(skin.driver[surface.indices[i]]),
                                          node_of(skin.driver[surface.indices[i + 1]]),
                                          node_of(skin.driver[surface.indices[i + 2]])};
        std::vector<uint32_t>& list = by_node[nodes[1] == nodes[2] ? nodes[1] : nodes[0]];
        list.insert(list.end(), surface.indices.begin() + static_cast<std::ptrdiff_t>(i),
                    surface.indices.begin() + static_cast<std::ptrdiff_t>(i) + 3);
      }
      const bool has_image = surface.image >= 0 && vertices.texture_coordinates.size() == vertices.positions.size();
      const glm::u8vec4 base(srgb_level(surface.base_colour.x), srgb_level(surface.base_colour.y),
                             srgb_level(surface.base_colour.z), 255);
      for (const auto& [node, list] : by_node) {
        Piece piece;
        piece.part = part_index;
        piece.image = has_image ? surface.image : -1;
        piece.wrap_u = surface.wrap_u;
        piece.wrap_v = surface.wrap_v;
        // What lets light through is drawn where more than half of it is there. Of the image's alpha alone: what is
        // drawn has some of its own.
        constexpr float kHalfThere = 0.5F;
        const float cutoff = surface.alpha_cutoff.value_or(surface.is_transparent ? kHalfThere : 0.0F);
        piece.alpha_cutoff = cutoff > 0.0F ? cutoff / surface.base_colour.w : 0.0F;
        for (const uint32_t vertex : list) {
          if (local[vertex] == kNone) {
            local[vertex] = static_cast<uint32_t>(piece.source.size());
            piece.source.push_back(vertex);
            glm::u8vec4 colour = base;
            if (!vertices.colours.empty()) colour = product(colour, vertices.colours[vertex]);
            colour.w = 255;
            piece.colours.push_back(colour);
            if (has_image) piece.coordinates.push_back(placed(surface.placement, vertices.texture_coordinates[vertex]));
          }
          piece.indices.push_back(local[vertex]);
        }
        for (const uint32_t vertex : list)
          local[vertex] = kNone;
        piece.positions.resize(piece.source.size());
        piece.normals.resize(piece.source.size());
        if (surface.is_double_sided) pieces_.emplace_back(node, back_of(piece));
        pieces_.emplace_back(node, std::move(piece));
      }
    }
  }

  static Piece back_of(const Piece& front) {
    Piece back = front;
    back.is_back = true;
    for (size_t i = 0; i + 2 < back.indices.size(); i += 3)
      std::swap(back.indices[i + 1], back.indices[i + 2]);
    return back;
  }

  /// What every driver does to points in the world of the figure's rest pose.
  void drive(std::span<const Transform> world_from_node, const FaceWeights& face) {
    const auto set = [&](int driver, const Quat& rotation, const Vec3& pivot, const Vec3& place) {
      driven_[static_cast<size_t>(driver)] = fit::matrix({rotation, place - rotation * pivot});
    };
    for (size_t n = 0; n < fit::kNodes; ++n)
      set(static_cast<int>(n), world_from_node[n].rotation, rest_[n], world_from_node[n].position);
    set(AvatarDriver::kGround, kIdentity, rest_[0], world_from_node[0].position);
    for (size_t t = 0; t < twists_.size(); ++t) {
      const Twist& twist = twists_[t];
      const auto node = static_cast<size_t>(twist.node);
      const auto parent = static_cast<size_t>(fit::parent_of(twist.node));
      const Quat local = glm::conjugate(world_from_node[parent].rotation) * world_from_node[node].rotation;
      const Quat swing = world_from_node[parent].rotation * swing_twist(local, twist.axis).swing;
      const double angle = twist_angle(local, twist.axis);
      for (int step = 0; step <= AvatarDriver::kTwistSteps; ++step) {
        const double share = static_cast<double>(step) / AvatarDriver::kTwistSteps;
        set(AvatarDriver::kFirstTwist + static_cast<int>(t) * (AvatarDriver::kTwistSteps + 1) + step,
            swing * axis_angle(twist.axis, angle * share), rest_[node], world_from_node[node].position);
      }
    }
    const Transform& head = world_from_node[2];
    const auto on_head = [&](int driver, const Quat& turn) {
      const Vec3& pivot = avatar_.pivot[static_cast<size_t>(driver - AvatarDriver::kLeftEye)];
      set(driver, head.rotation * turn, pivot, apply(head, pivot - rest_[2]));
    };
    on_head(AvatarDriver::kLeftEye, gaze(face, kEyeLookUpLeft, kEyeLookDownLeft, kEyeLookInLeft, kEyeLookOutLeft, 1.0));
    on_head(AvatarDriver::kRightEye,
            gaze(face, kEyeLookUpRight, kEyeLookDownRight, kEyeLookInRight, kEyeLookOutRight, -1.0));
    on_head(AvatarDriver::kJaw, axis_angle(Vec3(1.0, 0.0, 0.0), kJawOpens * undriven(face, kJawOpen)));
  }

  /// The weight of a channel that no morph target moves.
  double undriven(const FaceWeights& face, FaceChannel channel) const {
    const auto c = static_cast<size_t>(channel);
    return avatar_.avatar.face[c].binds.empty() ? static_cast<double>(face[c]) : 0.0;
  }

  Quat gaze(const FaceWeights& face, FaceChannel up, FaceChannel down, FaceChannel in, FaceChannel out,
            double side) const {
    const double pitch = kLookDown * undriven(face, down) - kLookUp * undriven(face, up);
    const double yaw = kLookAside * side * (undriven(face, out) - undriven(face, in));
    return axis_angle(Vec3(0.0, 1.0, 0.0), yaw) * axis_angle(Vec3(1.0, 0.0, 0.0), pitch);
  }

  void weigh(const FaceWeights& face) {
    for (size_t m = 0; m < weights_.size(); ++m)
      std::ranges::copy(rest_weights_[m], weights_[m].begin());
    for (size_t c = 0; c < kFaceChannelCount; ++c) {
      if (face[c] == 0.0F) continue;
      for (const MorphBind& bind : avatar_.avatar.face[c].binds)
        weights_[static_cast<size_t>(bind.mesh)][static_cast<size_t>(bind.morph)] +=
            face[c] * static_cast<float>(bind.weight);
    }
    // Several channels may share a morph target.
    for (std::vector<float>& weights : weights_)
      for (float& weight : weights)
        weight = std::clamp(weight, -1.0F, 1.0F);
  }

  void gather(Piece& piece) {
    const AvatarPoser::Part& part = poser_.parts()[piece.part];
    bool changed = false;
    for (size_t i = 0; i < piece.source.size(); ++i) {
      const glm::vec3& position = part.positions[piece.source[i]];
      const glm::vec3 normal = piece.is_back ? -part.normals[piece.source[i]] : part.normals[piece.source[i]];
      changed = changed || position != piece.positions[i] || normal != piece.normals[i];
      piece.positions[i] = position;
      piece.normals[i] = normal;
    }
    if (changed) ++piece.revision;
  }

  const SigningAvatar& avatar_;
  AvatarPoser poser_;
  std::vector<std::vector<float>> rest_weights_, weights_;
  std::vector<glm::dmat4> driven_, world_;
  std::vector<Transform> last_;
  FaceWeights last_face_{};
  std::vector<Vec3> rest_;
  std::vector<Twist> twists_;
  std::vector<std::pair<int, Piece>> pieces_;  ///< by node of the figure
  std::vector<PosedMesh> posed_;
};

}  // namespace

std::unique_ptr<BodyModel> make_avatar_model(const SigningAvatar& avatar) {
  return std::make_unique<AvatarModel>(avatar);
}

}  // namespace auslan
