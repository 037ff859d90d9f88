// SPDX-License-Identifier: Apache-2.0
#include "avatar_cuts.h"

#include "avatar_fit.h"
#include "kinematics/rotation.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace auslan::fit {
namespace {

bool before(const glm::vec3& a, const glm::vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

}  // namespace

void Cuts::add(int node, const std::array<glm::vec3, 3>& corner) {
  for (size_t c = 0; c < 3; ++c) {
    const glm::vec3 &from = corner[c], &to = corner[(c + 1) % 3];
    if (before(from, to))
      edges_.push_back({from, to, node, false});
    else
      edges_.push_back({to, from, node, true});
  }
}

void Cuts::close(Figure& figure) {
  std::ranges::stable_sort(edges_, [](const Edge& a, const Edge& b) {
    return before(a.low, b.low) || (!before(b.low, a.low) && before(a.high, b.high));
  });
  std::vector<std::vector<Edge>> rims(kNodes);
  for (size_t first = 0, last = 0; first < edges_.size(); first = last) {
    for (last = first + 1;
         last < edges_.size() && edges_[last].low == edges_[first].low && edges_[last].high == edges_[first].high;)
      ++last;
    if (last != first + 2 || edges_[first].node == edges_[first + 1].node) continue;
    for (size_t i = first; i < last; ++i)
      if (edges_[i].node != kNoNode) rims[static_cast<size_t>(edges_[i].node)].push_back(edges_[i]);
  }
  for (size_t node = 0; node < kNodes; ++node)
    add_fans(rims[node], glm::vec3(figure.skeleton.rest_position(static_cast<int>(node))), figure.segments[node]);
}

void Cuts::add_fans(std::span<const Edge> edges, const glm::vec3& origin, Mesh& mesh) {
  std::vector<glm::vec3> places;
  for (const Edge& edge : edges)
    places.insert(places.end(), {edge.low, edge.high});
  std::ranges::sort(places, before);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto number = [&places](const glm::vec3& place) {
    return static_cast<size_t>(std::ranges::lower_bound(places, place, before) - places.begin());
  };
  std::vector<size_t> joined(places.size());
  std::iota(joined.begin(), joined.end(), size_t{0});
  const auto root = [&joined](size_t place) {
    while (joined[place] != place)
      place = joined[place] = joined[joined[place]];
    return place;
  };
  for (const Edge& edge : edges) {
    const auto [first, second] = std::minmax({root(number(edge.low)), root(number(edge.high))});
    joined[second] = first;
  }
  std::map<size_t, std::vector<Edge>> rims;
  for (const Edge& edge : edges)
    rims[root(number(edge.low))].push_back(edge);
  for (const auto& [place, rim] : rims)
    add_fan(rim, origin, mesh);
}

void Cuts::add_fan(std::span<const Edge> rim, const glm::vec3& origin, Mesh& mesh) {
  glm::vec3 middle(0.0F);
  for (const Edge& edge : rim)
    middle += (edge.low + edge.high) * (0.5F / static_cast<float>(rim.size()));
  for (const Edge& edge : rim) {
    const glm::vec3 &a = edge.turned ? edge.low : edge.high, &b = edge.turned ? edge.high : edge.low;
    const Vec3 out = unit(glm::cross(Vec3(b - a) * 1e3, Vec3(middle - a) * 1e3));
    for (const glm::vec3& corner : {a, b, middle}) {
      mesh.indices.push_back(static_cast<uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(corner - origin);
      mesh.normals.emplace_back(out);
      mesh.colours.emplace_back(255, 255, 255, 255);
    }
  }
}

}  // namespace auslan::fit
