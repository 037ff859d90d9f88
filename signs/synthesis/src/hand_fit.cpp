// SPDX-License-Identifier: Apache-2.0
#include "hand_fit.h"

#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "synthesis/signer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace auslan {
namespace {

constexpr int kIterations = 24;
// Rounds without progress: while something is in the way or not yet touched, and else.
constexpr int kPatience = 4, kBarePatience = 2;
// After so many rounds a fit that costs so many times what it is to beat is given up.
constexpr int kFewRounds = 4;
constexpr double kFarOff = 1.5;
constexpr double kProgress = 0.0003;  // metres
constexpr double kFarthest = 0.06;    // from what is to be touched, metres
// A turn of a radian counts as much as so many metres of shift.
constexpr double kTurnLength = 0.2;
constexpr double kDamping = 0.02;
constexpr double kObstacleWeight = 4.0, kContactWeight = 6.0, kSlideWeight = 0.1;
// A radian beyond a joint's limit is as bad as so many metres.
constexpr double kExcessLength = 0.2;
constexpr double kFreeSlide = 0.015;  // over the skin, metres
// A hand leans as the notation's steps of 45 degrees let it, and beyond its freedom only when nothing else helps.
constexpr double kLeanWeight = 0.05, kFarLeanWeight = 2.0;
// Of one step.
constexpr double kLongestShift = 0.012, kLargestTurn = 4.0 * kDegree;
// Deeper than this a surface may not be what it seems: a foreign figure's loose hair has no inside.
constexpr double kFarIn = 0.1;
constexpr double kTouches = 0.0007, kGoodEnough = 0.0008, kTrouble = 0.0005;  // metres

constexpr size_t kFree = 6;
using Row = std::array<double, kFree>;  // of a shift (metres) and a turn (metres by kTurnLength)

struct NormalEquations {
  std::array<Row, 6> matrix{};  ///< symmetric: on and below the diagonal
  Row right{};

  void add(const Row& row, double residual, double weight) {
    for (size_t i = 0; i < kFree; ++i) {
      for (size_t j = 0; j <= i; ++j)
        matrix[i][j] += weight * row[i] * row[j];
      right[i] += weight * row[i] * residual;
    }
  }
  /// The step by Cholesky's decomposition; the damping makes the matrix positive definite.
  Row solve() const {
    std::array<Row, 6> l{};
    for (size_t i = 0; i < kFree; ++i) {
      for (size_t j = 0; j <= i; ++j) {
        double sum = matrix[i][j];
        for (size_t k = 0; k < j; ++k)
          sum -= l[i][k] * l[j][k];
        l[i][j] = i == j ? std::sqrt(std::max(sum, 1e-18)) : sum / l[j][j];
      }
    }
    Row step{};
    for (size_t i = 0; i < kFree; ++i) {
      double sum = right[i];
      for (size_t k = 0; k < i; ++k)
        sum -= l[i][k] * step[k];
      step[i] = sum / l[i][i];
    }
    for (size_t i = kFree; i-- > 0;) {
      double sum = step[i];
      for (size_t k = i + 1; k < kFree; ++k)
        sum -= l[k][i] * step[k];
      step[i] = sum / l[i][i];
    }
    return step;
  }
};

/// How far a point at `arm` from the wrist goes along `way` for a small shift and turn.
Row row_along(const Vec3& way, const Vec3& arm) {
  const Vec3 turn = glm::cross(arm, way) / kTurnLength;
  return {way.x, way.y, way.z, turn.x, turn.y, turn.z};
}

double length(const Vec3& v) {
  return std::sqrt(glm::dot(v, v));
}

/// A transform of many points.
struct Motion {
  glm::dmat3 turn;
  Vec3 shift;

  explicit Motion(const Transform& transform) : turn(glm::mat3_cast(transform.rotation)), shift(transform.position) {}
  Vec3 operator()(const Vec3& point) const { return turn * point + shift; }
};

Transform solid_from(const Obstacle& obstacle, const Transform& world_from_patch) {
  const Quat back = glm::conjugate(obstacle.world_from_solid.rotation);
  return {back * world_from_patch.rotation, back * (world_from_patch.position - obstacle.world_from_solid.position)};
}

/// How far the ball of a patch is at least from where any of it would be too deep, metres; negative: not known.
double clear_by(const Vec3& world_centre, const SurfacePatch& patch, const Obstacle& obstacle, const Motion& in_solid) {
  const double room = patch.radius + std::max(0.0, -obstacle.allowed);
  const Vec3 apart = world_centre - obstacle.centre;
  const double reach = room + obstacle.radius;
  const double square = glm::dot(apart, apart);
  if (square > reach * reach) return std::sqrt(square) - reach;
  return obstacle.field->solid().clearance(in_solid(patch.centre)) - room;
}

/// How far a piece of a patch has to move at least for any of it to be deeper than `depth`; 0: not known.
double clear_by(const SurfacePatch::Piece& piece, const Obstacle& obstacle, double depth, const Motion& in_solid) {
  return obstacle.field->clear_of(in_solid(piece.centre), depth - piece.radius);
}

/// How far points of a hand may have gone in all while it moved by small steps.
class Travel {
 public:
  void to(const Transform& wrist) {
    if (moving_) {
      const Quat &a = before_.rotation, &b = wrist.rotation;
      const Quat apart = glm::dot(a, b) < 0.0 ? a + b : a - b;
      shifted_ += length(wrist.position - before_.position);
      // A point goes no farther than by twice the chord of the quaternions times its distance.
      turned_ += 2.0 * std::sqrt(glm::dot(apart, apart));
    }
    before_ = wrist;
    moving_ = true;
  }
  /// Of a point so far from the wrist, metres.
  double of(double from_wrist) const { return shifted_ + turned_ * from_wrist; }

 private:
  Transform before_;
  bool moving_ = false;
  double shifted_ = 0.0, turned_ = 0.0;  ///< metres, and metres for each metre from the wrist
};

/// The points of a hand that are too deep, as the hand moves by small steps: what is clear by more than it has moved
/// since is not looked at again.
class DeepPoints {
 public:
  DeepPoints(std::span<const SurfacePatch> hand, std::span<const Obstacle> obstacles)
      : hand_(hand), obstacles_(obstacles) {
    size_t points = 0;
    size_t pieces = 0;
    for (const SurfacePatch& patch : hand) {
      points += patch.points.size();
      pieces += patch.pieces.size();
    }
    of_patch_.resize(hand.size() * obstacles.size(), 0.0);
    of_piece_.resize(pieces * obstacles.size());
    of_point_ = std::make_unique_for_overwrite<double[]>(points * obstacles.size());
  }

  /// Calls `deep(point, depth beyond what is allowed, way out)` for each.
  template <class Deep>
  void each(const Transform& wrist, const Deep& deep) {
    travel_.to(wrist);
    double* of_patch = of_patch_.data();
    OfPiece* of_piece = of_piece_.data();
    double* of_point = of_point_.get();
    const Motion in_world(wrist);
    for (const SurfacePatch& patch : hand_) {
      const double gone = travel_.of(length(patch.centre) + patch.radius);
      const Vec3 centre = in_world(patch.centre);
      for (const Obstacle& obstacle : obstacles_) {
        each_of(patch, centre, obstacle, wrist, gone, *of_patch++, of_piece, of_point, deep);
        of_piece += patch.pieces.size();
        of_point += patch.points.size();
      }
    }
  }

 private:
  struct OfPiece {
    double clear = 0.0;
    bool has_points = false;  ///< its points have been looked at
  };
  /// `clear`: of how far the hand may have gone in all until something has to be looked at again.
  template <class Deep>
  static void each_of(const SurfacePatch& patch, const Vec3& centre, const Obstacle& obstacle, const Transform& wrist,
                      double gone, double& clear, OfPiece* of_piece, double* of_point, const Deep& deep) {
    if (gone < clear) return;
    const Motion in_solid(solid_from(obstacle, wrist));
    clear = gone + clear_by(centre, patch, obstacle, in_solid);
    if (gone < clear) return;
    for (const SurfacePatch::Piece& piece : patch.pieces) {
      OfPiece& of_this = *of_piece++;
      if (gone < of_this.clear) continue;
      double above = clear_by(piece, obstacle, obstacle.allowed, in_solid);
      of_this.clear = gone + above;
      if (above > 0.0) continue;
      if (!of_this.has_points) std::fill_n(of_point + piece.first, piece.count, 0.0);
      of_this.has_points = true;
      for (size_t i = piece.first; i < size_t{piece.first} + piece.count; ++i) {
        if (gone < of_point[i]) continue;
        const Vec3 point = in_solid(patch.points[i].position);
        const auto nearest = obstacle.field->below(point, obstacle.allowed, above);
        of_point[i] = gone + above;
        if (nearest)
          deep(patch.points[i].position, -nearest->distance - obstacle.allowed,
               obstacle.world_from_solid.rotation * nearest->normal);
      }
    }
  }

  std::span<const SurfacePatch> hand_;
  std::span<const Obstacle> obstacles_;
  std::vector<double> of_patch_;
  std::vector<OfPiece> of_piece_;
  std::unique_ptr<double[]> of_point_;
  Travel travel_;
};

struct Touch {
  Vec3 point{0.0};  ///< wrist frame
  double distance = kFarthest;
  Vec3 out{0.0};  ///< world
};

/// Which point of the region is nearest to what is to be touched, as the hand moves by small steps: what was farther
/// off than the nearest by more than it has moved since is not looked at again.
class NearestTouch {
 public:
  explicit NearestTouch(const HandFitGoal& goal) : goal_(goal), beyond_(goal.region.size(), -1e9) {}

  Touch at(const Transform& wrist) {
    travel_.to(wrist);
    Touch best;
    bool found = false;
    const size_t first = nearest_;
    for (size_t i = 0; i < goal_.region.size(); ++i) {
      // Round the region, from the point that was nearest before.
      const size_t index = (first + i) % goal_.region.size();
      const Vec3& point = goal_.region[index];
      const double gone = travel_.of(length(point));
      if (found && beyond_[index] - gone >= best.distance) continue;
      // Of points that press in, any will do.
      if (found && best.distance <= 0.0) break;
      const Touch touch = of_point(point, apply(wrist, point), found ? best.distance : kFarthest);
      beyond_[index] = gone + touch.distance;
      if (found ? touch.distance >= best.distance : touch.distance >= kFarthest) continue;
      found = true;
      best = touch;
      nearest_ = index;
    }
    if (!found) best.point = goal_.pivot;
    return best;
  }

 private:
  /// `within`: what is no nearer is as far off as that.
  Touch of_point(const Vec3& point, const Vec3& world, double within) const {
    Touch best{point, within};
    const auto consider = [&best](double distance, const Vec3& out) {
      if (distance >= best.distance) return;
      best.distance = distance;
      best.out = out;
    };
    if (goal_.mirror && goal_.mirror->touched) consider(world.x * goal_.mirror->side, Vec3(goal_.mirror->side, 0, 0));
    for (const Obstacle& obstacle : goal_.obstacles) {
      if (!obstacle.touched) continue;
      const Vec3 apart = world - obstacle.centre;
      const double reach = obstacle.radius + best.distance;
      if (best.distance <= 0.0 || glm::dot(apart, apart) > reach * reach) continue;
      const Quat& turn = obstacle.world_from_solid.rotation;
      const auto nearest = obstacle.field->solid().nearest(
          glm::conjugate(turn) * (world - obstacle.world_from_solid.position), best.distance);
      if (nearest) consider(nearest->distance, turn * nearest->normal);
    }
    return best;
  }

  const HandFitGoal& goal_;
  std::vector<double> beyond_;  ///< by how much the hand may have gone in all until a point has to be looked at again
  Travel travel_;
  size_t nearest_ = 0;
};

/// What of a hand, and of one that it meets, is too deep as it moves by small steps.
class Depths {
 public:
  Depths(std::span<const SurfacePatch> hand, const HandFitGoal& goal)
      : hand_(hand), goal_(goal), in_obstacles_(hand, goal.obstacles) {
    if (goal.met) of_met_.emplace(goal.met->patches, goal.met->own);
  }

  /// Calls `deep(point in the wrist's frame, depth beyond what is allowed, way out in the world)` for each point.
  template <class Deep>
  void each(const Transform& wrist, const Deep& deep) {
    in_obstacles_.each(wrist, deep);
    if (of_met_) {
      const Quat back = glm::conjugate(wrist.rotation);
      const Transform& there = goal_.met->world_from_wrist;
      const Transform from_there{back * there.rotation, back * (there.position - wrist.position)};
      of_met_->each(from_there, [&](const Vec3& point, double depth, const Vec3& out) {
        deep(apply(from_there, point), depth, -(wrist.rotation * out));
      });
    }
    if (!goal_.mirror) return;
    const auto beyond = [&](const Vec3& point) {
      return -apply(wrist, point).x * goal_.mirror->side - goal_.mirror->allowed;
    };
    for (const SurfacePatch& patch : hand_) {
      if (beyond(patch.centre) + patch.radius <= 0.0) continue;
      for (const Site& point : patch.points)
        if (const double depth = beyond(point.position); depth > 0.0)
          deep(point.position, depth, Vec3(goal_.mirror->side, 0, 0));
    }
  }

 private:
  std::span<const SurfacePatch> hand_;
  const HandFitGoal& goal_;
  DeepPoints in_obstacles_;
  std::optional<DeepPoints> of_met_;
};

}  // namespace

double way_out(const Transform& world_from_wrist, std::span<const SurfacePatch> hand, const HandFitGoal& goal,
               const Vec3& way, double farthest) {
  constexpr double kOut = 0.001, kLeast = 0.003;  // metres
  Depths depths(hand, goal);
  Transform wrist = world_from_wrist;
  double gone = 0.0;
  while (gone < farthest) {
    double deepest = 0.0;
    depths.each(wrist, [&](const Vec3&, double depth, const Vec3&) { deepest = std::max(deepest, depth); });
    if (deepest < kOut) break;
    gone = std::min(farthest, gone + std::max(deepest, kLeast));
    wrist.position = world_from_wrist.position + gone * way;
  }
  return gone;
}

Obstacle make_obstacle(const DistanceField& field, const Transform& world_from_solid, double allowed, bool touched) {
  const Solid& solid = field.solid();
  Obstacle obstacle{&field, world_from_solid, Vec3(0.0), 0.0, allowed, touched};
  obstacle.centre = apply(world_from_solid, 0.5 * (solid.low() + solid.high()));
  obstacle.radius = 0.5 * length(solid.high() - solid.low());
  return obstacle;
}

HandFit fit_hand(const Transform& world_from_wrist, double swivel, std::span<const SurfacePatch> hand,
                 const HandFitGoal& goal, double missing, double to_beat) {
  Transform wrist = world_from_wrist;
  HandFit best;
  double least = 1e9, excess = missing;
  int improved = 0;
  double least_trouble = 1e9;
  NearestTouch nearest_touch(goal);
  Depths depths(hand, goal);
  struct Deep {
    Row row;
    double depth;
  };
  std::vector<Deep> deep;
  for (int iteration = 0; iteration <= kIterations; ++iteration) {
    deep.clear();
    double deepest = 0.0;
    const auto too_deep = [&](const Vec3& point, double depth, const Vec3& out) {
      deep.push_back({row_along(out, wrist.rotation * point), depth});
      deepest = std::max(deepest, depth);
    };
    depths.each(wrist, too_deep);
    const bool contact = !goal.region.empty();
    Touch touch;
    if (contact) touch = nearest_touch.at(wrist);
    const double gap = contact ? touch.distance : 0.0;
    const Vec3 lean = rotation_vector(wrist.rotation * glm::conjugate(goal.wanted));
    const double leaning = length(lean);
    const double slide = length(apply(wrist, goal.pivot) - goal.target);
    // What matters in the end, in metres: a degree counts like a third of a millimetre.
    const double cost = std::min(deepest, kFarIn) + 0.2 * std::max(0.0, deepest - kFarIn) + kExcessLength * excess +
                        2.0 * std::max(0.0, gap - kTouches) + 0.02 * leaning +
                        0.2 * std::max(0.0, leaning - goal.free_lean) + 0.3 * std::max(0.0, slide - kFreeSlide);
    if (cost < least - kProgress) improved = iteration;
    if (cost < least) {
      least = cost;
      best = {wrist, swivel, touch.point, touch.out, gap, deepest, cost};
      least_trouble = std::max({deepest, gap - kTouches, excess * kExcessLength});
    }
    const int patience = least_trouble > kTrouble ? kPatience : kBarePatience;
    if (iteration == kIterations || cost < kGoodEnough || iteration - improved > patience) break;
    if (iteration >= kFewRounds && least > kFarOff * to_beat) break;

    NormalEquations equations;
    for (const Deep& point : deep)
      equations.add(point.row, point.depth,
                    kObstacleWeight * (point.depth == deepest ? 1.0 : 1.0 / static_cast<double>(deep.size())));
    if (contact && gap > 0.0)
      equations.add(row_along(touch.out, wrist.rotation * touch.point), 0.5 * kTouches - gap, kContactWeight);
    const Vec3 arm = wrist.rotation * goal.pivot;
    const Vec3 off = goal.target - (wrist.position + arm);
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      Vec3 way(0.0);
      way[axis] = 1.0;
      equations.add(row_along(way, arm), off[axis], kSlideWeight);
    }
    const double lean_weight = kLeanWeight + (leaning > goal.free_lean ? kFarLeanWeight : 0.0);
    for (size_t i = 0; i < kFree; ++i) {
      equations.matrix[i][i] += kDamping;
      if (i < 3) continue;
      equations.matrix[i][i] += lean_weight;
      equations.right[i] -= lean_weight * kTurnLength * lean[static_cast<glm::length_t>(i) - 3];
    }
    const Row step = equations.solve();
    Vec3 shift(step[0], step[1], step[2]);
    Vec3 turn = Vec3(step[3], step[4], step[5]) / kTurnLength;
    const double scale = std::min({1.0, std::max(kLongestShift, 0.5 * deepest) / std::max(length(shift), 1e-9),
                                   kLargestTurn / std::max(length(turn), 1e-9)});
    wrist.position += scale * shift;
    wrist.rotation = renormalised(from_rotation_vector(scale * turn) * wrist.rotation);
    excess = goal.admit(contact ? touch.point : goal.pivot, wrist, swivel);
  }
  return best;
}

Depth depth_in(std::span<const PlacedPatch> points, std::span<const Obstacle> obstacles,
               const DepthsThatMatter& matter) {
  Depth worst;
  worst.metres = matter.more_than;
  bool found = false;
  for (const PlacedPatch& placed : points) {
    const SurfacePatch& patch = *placed.patch;
    const Vec3 centre = apply(placed.place, patch.centre);
    for (const Obstacle& obstacle : obstacles) {
      const double reach = patch.radius + obstacle.radius + std::max(0.0, -obstacle.allowed);
      const Vec3 apart = centre - obstacle.centre;
      if (glm::dot(apart, apart) > reach * reach) continue;
      const Motion in_solid(solid_from(obstacle, placed.place));
      if (clear_by(centre, patch, obstacle, in_solid) > 0.0) continue;
      for (const SurfacePatch::Piece& piece : patch.pieces) {
        if (clear_by(piece, obstacle, obstacle.allowed + worst.metres, in_solid) > 0.0) continue;
        for (size_t i = piece.first; i < size_t{piece.first} + piece.count; ++i) {
          const Vec3 point = in_solid(patch.points[i].position);
          double above = 0.0;
          const auto nearest = obstacle.field->below(point, obstacle.allowed + worst.metres, above);
          if (!nearest || -nearest->distance - obstacle.allowed <= worst.metres) continue;
          worst.metres = -nearest->distance - obstacle.allowed;
          worst.out = obstacle.world_from_solid.rotation * nearest->normal;
          found = true;
          if (worst.metres >= matter.enough) return worst;
        }
      }
    }
  }
  return found ? worst : Depth{};
}

}  // namespace auslan
