// SPDX-License-Identifier: Apache-2.0
#include "hand_fit.h"

#include "kinematics/elementary.h"
#include "kinematics/rotation.h"
#include "synthesis/signer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace auslan {
namespace {

constexpr int kIterations = 24, kPatience = 7;  // rounds without progress
constexpr double kProgress = 0.0003;            // metres
constexpr double kDeepest = 0.25;               // no part of a body is thicker than twice this, metres
constexpr double kTells = 0.003;                // metres that a point has to be off to tell of its neighbours
constexpr double kAhead = 0.03;                 // metres
constexpr double kFarthest = 0.06;              // from what is to be touched, metres
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
constexpr double kTouches = 0.0007, kGoodEnough = 0.0008;  // metres

constexpr size_t kFree = 6;
using Row = std::array<double, kFree>;  // of a shift (metres) and a turn (metres by kTurnLength)

struct NormalEquations {
  std::array<Row, 6> matrix{};
  Row right{};

  void add(const Row& row, double residual, double weight) {
    for (size_t i = 0; i < kFree; ++i) {
      for (size_t j = 0; j < kFree; ++j)
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

/// A distance that was found before: nothing comes nearer to a surface than by the way that it has gone.
struct Remembered {
  Vec3 at{0.0};  ///< in the solid's frame
  double distance = -1.0;
  bool still_beyond(double reach, const Vec3& now) const {
    const double spare = distance - reach - 1e-9;
    if (spare <= 0.0) return false;
    const Vec3 way = now - at;
    return glm::dot(way, way) < spare * spare;
  }
};

/// Places whose distance tells that others near them are far enough.
class Tellers {
 public:
  void add(const Remembered& one) {
    if (count_ < all_.size()) all_[count_++] = one;
  }
  bool tell_beyond(double reach, const Vec3& now) const {
    const std::span<const Remembered> those = std::span(all_).first(count_);
    return std::ranges::any_of(those, [&](const Remembered& one) { return one.still_beyond(reach, now); });
  }

 private:
  std::array<Remembered, 16> all_;
  size_t count_ = 0;
};

/// What is remembered of a patch and an obstacle while both keep their form and the obstacle its place.
struct Memory {
  Remembered centre;
  std::vector<Remembered> points;
};

/// Calls `deep(point index, distance to the surface, way out)` for the points of a patch that are nearer to the
/// surface than `limit` (metres, negative inside), which may shrink meanwhile. `centres`: of patches that were asked
/// about this obstacle before.
template <class Deep>
void each_point_below(const double& limit, const PlacedPatch& placed, const Obstacle& obstacle, Memory* memory,
                      Tellers& centres, const Deep& deep) {
  const double need = placed.patch->radius + limit;
  const Quat& turn = obstacle.world_from_solid.rotation;
  const Quat back = glm::conjugate(turn);
  const auto in_solid = [&](const Vec3& point) {
    return back * (apply(placed.world_from_patch, point) - obstacle.world_from_solid.position);
  };
  const auto beside = [&](const Vec3& local, double reach) {
    const Vec3 low = obstacle.solid->low() - reach, high = obstacle.solid->high() + reach;
    return local.x < low.x || local.y < low.y || local.z < low.z || local.x > high.x || local.y > high.y ||
           local.z > high.z;
  };
  const Vec3 centre = in_solid(placed.patch->centre);
  if (beside(centre, need)) return;
  if (memory != nullptr && memory->centre.still_beyond(need, centre)) return;
  if (centres.tell_beyond(need, centre)) return;
  // A point is no nearer to the surface than the centre is, less the way between the two. The centre is asked a little
  // farther than it has to be: that tells of others.
  const double within = std::max(need, 0.0) + kAhead;
  auto middle = obstacle.solid->nearest(centre, within);
  if (!middle && !beside(centre, -placed.patch->radius)) {
    middle = obstacle.solid->nearest(centre, kDeepest);
    if (!middle) return;
  }
  const Remembered known{centre, middle ? middle->distance : within};
  if (memory != nullptr) memory->centre = known;
  if (known.distance > kTells) centres.add(known);
  if (known.distance > need) return;
  const std::span<const Site> points = placed.points();
  if (memory != nullptr) memory->points.resize(points.size());
  Tellers tellers;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 apart = points[i].position - placed.patch->centre;
    const double way = std::sqrt(glm::dot(apart, apart));
    if (known.distance - way > limit) continue;
    const Vec3 local = in_solid(points[i].position);
    if (beside(local, std::max(limit, 0.0))) continue;
    if (memory != nullptr && memory->points[i].still_beyond(limit, local)) continue;
    if (tellers.tell_beyond(limit, local)) continue;
    const auto nearest = obstacle.solid->nearest(local, std::abs(known.distance) + way + 1e-6);
    if (!nearest) continue;
    if (memory != nullptr) memory->points[i] = {local, nearest->distance};
    if (nearest->distance > limit + kTells) tellers.add({local, nearest->distance});
    if (nearest->distance < limit) deep(i, nearest->distance, turn * nearest->normal);
  }
}

struct Touch {
  Vec3 point{0.0};  ///< wrist frame
  double distance = kFarthest;
  Vec3 out{0.0};  ///< world
};

Touch nearest_touch(const Transform& wrist, const HandFitGoal& goal) {
  Touch best;
  bool found = false;
  const auto consider = [&](const Vec3& point, double distance, const Vec3& out) {
    if (found && distance >= best.distance) return;
    found = true;
    best = {point, distance, out};
  };
  for (const Vec3& point : goal.region) {
    const Vec3 world = apply(wrist, point);
    if (goal.mirror && goal.mirror->touched)
      consider(point, world.x * goal.mirror->side, Vec3(goal.mirror->side, 0, 0));
    for (const Obstacle& obstacle : goal.obstacles) {
      if (!obstacle.touched) continue;
      // Of points that press in, any will do.
      if (found && best.distance <= 0.0) return best;
      const double within = found ? best.distance : kFarthest;
      const Vec3 apart = world - obstacle.centre;
      const double reach = obstacle.radius + within;
      if (glm::dot(apart, apart) > reach * reach) continue;
      const Quat& turn = obstacle.world_from_solid.rotation;
      const auto nearest =
          obstacle.solid->nearest(glm::conjugate(turn) * (world - obstacle.world_from_solid.position), within);
      if (nearest && nearest->distance < kFarthest) consider(point, nearest->distance, turn * nearest->normal);
    }
  }
  if (!found) best.point = goal.pivot;
  return best;
}

}  // namespace

Obstacle make_obstacle(const Solid& solid, const Transform& world_from_solid, double allowed, bool touched) {
  Obstacle obstacle{&solid, world_from_solid, Vec3(0.0), 0.0, allowed, touched};
  obstacle.centre = apply(world_from_solid, 0.5 * (solid.low() + solid.high()));
  obstacle.radius = 0.5 * length(solid.high() - solid.low());
  return obstacle;
}

HandFit fit_hand(const Transform& world_from_wrist, double swivel, std::span<const SurfacePatch> hand,
                 const HandFitGoal& goal) {
  Transform wrist = world_from_wrist;
  HandFit best;
  double least = 1e9, excess = 0.0;
  int improved = 0;
  std::vector<Memory> memory(hand.size() * goal.obstacles.size());
  for (int iteration = 0; iteration <= kIterations; ++iteration) {
    struct Deep {
      Row row;
      double depth;
    };
    std::vector<Deep> deep;
    double deepest = 0.0;
    const auto too_deep = [&](const Vec3& point, double depth, const Vec3& out) {
      deep.push_back({row_along(out, wrist.rotation * point), depth});
      deepest = std::max(deepest, depth);
    };
    for (size_t o = 0; o < goal.obstacles.size(); ++o) {
      const double limit = -goal.obstacles[o].allowed;
      Tellers centres;
      for (size_t p = 0; p < hand.size(); ++p)
        each_point_below(limit, {&hand[p], wrist}, goal.obstacles[o], &memory[p * goal.obstacles.size() + o], centres,
                         [&](size_t i, double distance, const Vec3& out) {
                           too_deep(hand[p].points[i].position, limit - distance, out);
                         });
    }
    if (goal.mirror) {
      for (const SurfacePatch& patch : hand) {
        for (const Site& point : patch.points) {
          const double depth = -apply(wrist, point.position).x * goal.mirror->side - goal.mirror->allowed;
          if (depth > 0.0) too_deep(point.position, depth, Vec3(goal.mirror->side, 0, 0));
        }
      }
    }
    const bool contact = !goal.region.empty();
    Touch touch;
    if (contact) touch = nearest_touch(wrist, goal);
    const double gap = contact ? touch.distance : 0.0;
    const Vec3 lean = rotation_vector(wrist.rotation * glm::conjugate(goal.wanted));
    const double leaning = length(lean);
    const double slide = length(apply(wrist, goal.pivot) - goal.target);
    // What matters in the end, in metres: a degree counts like a third of a millimetre.
    const double cost = std::min(deepest, kFarIn) + kExcessLength * excess + 2.0 * std::max(0.0, gap - kTouches) +
                        0.02 * leaning + 0.2 * std::max(0.0, leaning - goal.free_lean) +
                        0.3 * std::max(0.0, slide - kFreeSlide);
    if (cost < least - kProgress) improved = iteration;
    if (cost < least) {
      least = cost;
      best = {wrist, swivel, touch.point, gap, deepest, cost};
    }
    if (iteration == kIterations || cost < kGoodEnough || iteration - improved > kPatience) break;

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
    const double scale =
        std::min({1.0, kLongestShift / std::max(length(shift), 1e-9), kLargestTurn / std::max(length(turn), 1e-9)});
    wrist.position += scale * shift;
    wrist.rotation = renormalised(from_rotation_vector(scale * turn) * wrist.rotation);
    excess = goal.admit(contact ? touch.point : goal.pivot, wrist, swivel);
  }
  return best;
}

Depth depth_in(std::span<const PlacedPatch> patches, std::span<const Obstacle> obstacles) {
  Depth worst;
  for (const Obstacle& obstacle : obstacles) {
    double limit = -obstacle.allowed - worst.metres;
    Tellers centres;
    for (const PlacedPatch& patch : patches)
      each_point_below(limit, patch, obstacle, nullptr, centres, [&](size_t, double distance, const Vec3& out) {
        worst = {-obstacle.allowed - distance, out};
        limit = distance;
      });
  }
  return worst;
}

}  // namespace auslan
