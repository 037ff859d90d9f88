// SPDX-License-Identifier: Apache-2.0
// A small figure with everything that a figure can have, and the comparison of two figures bit for bit.
#pragma once

#include "kinematics/figure.h"
#include "scratch_folder.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace auslan::test {

/// The parent of a node of kNodeNames by the anatomy: a finger's first joint hangs on the wrist, the arms on neck_base.
inline int parent_of(int index) {
  const std::string_view name = kNodeNames[static_cast<size_t>(index)];
  if (index == 0) return kNoNode;
  if (name.starts_with("shoulder")) return 1;
  if (name.starts_with("index_mp") || name.starts_with("middle_mp") || name.starts_with("ring_mp") ||
      name.starts_with("little_mp"))
    return name.ends_with("_l") ? 5 : 23;
  return index - 1;
}

inline std::vector<Node> sample_nodes() {
  std::vector<Node> nodes;
  for (int i = 0; i < static_cast<int>(kNodeNames.size()); ++i)
    nodes.push_back({.name = std::string(kNodeNames[static_cast<size_t>(i)]),
                     .parent = parent_of(i),
                     // A tenth and a third have no finite binary form: they show whether decimal text loses bits.
                     .offset = Vec3(0.1 * i, 1.0 / 3.0 - i, -0.0)});
  return nodes;
}

/// A fan of `vertices` vertices in no particular shape, in all 256 code values of each colour.
inline Mesh sample_mesh(uint32_t vertices, uint32_t seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&random] { return static_cast<float>(random()) / 4294967296.0F - 0.5F; };
  Mesh mesh;
  for (uint32_t i = 0; i < vertices; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    const float z = coordinate();
    mesh.positions.emplace_back(x, y, z);
    const float length = std::sqrt(x * x + y * y + z * z);
    mesh.normals.emplace_back(x / length, y / length, z / length);
    mesh.colours.emplace_back(i % 256, (i * 7 + 3) % 256, (255 - i) % 256, 255);
    if (i >= 2) mesh.indices.insert(mesh.indices.end(), {0U, i - 1, i});
  }
  return mesh;
}

/// Empty segments, one of 300 vertices with morphs (of one vertex, of all, of none), one too large for 16-bit indices.
inline Figure sample_figure() {
  Figure figure;
  figure.name = "Sample \xC3\xA9";
  figure.skeleton = Skeleton::build(sample_nodes()).value();
  figure.segments.resize(kNodeNames.size());
  figure.segments[0] = sample_mesh(3, 1);
  figure.segments[2] = sample_mesh(300, 2);
  figure.segments[5] = sample_mesh(65536, 3);
  figure.appearances = {{"first \xC3\xA9", {1, 2, 3}, {{0, 0, 0}, {255, 128, 7}}},
                        {"second", {255, 255, 255}, {{10, 20, 30}, {40, 50, 60}}}};
  for (uint32_t i = 0; i < 300; ++i)
    figure.segments[2].paint.push_back({static_cast<uint8_t>(i % 2), static_cast<uint8_t>(i / 2 % 2),
                                        static_cast<uint8_t>(i), static_cast<uint8_t>(255 - i % 256)});
  Morph all{.channel = FaceChannel::kMouthPucker, .vertices = {}, .displacement = {}};
  for (uint32_t i = 0; i < 300; ++i) {
    all.vertices.push_back(i);
    all.displacement.emplace_back(0.1F * static_cast<float>(i), -1e-30F, 0.0F);
  }
  figure.segments[2].morphs = {
      {.channel = FaceChannel::kTongueOut, .vertices = {7, 299}, .displacement = {{0.0F, 0.0F, 0.0F}, {-0.001F, 1, 2}}},
      {.channel = FaceChannel::kJawOpen, .vertices = {}, .displacement = {}},
      std::move(all)};
  figure.segments[5].morphs = {
      {.channel = FaceChannel::kBrowInnerUp, .vertices = {65535}, .displacement = {{0.25F, 0.0F, 0.0F}}}};
  return figure;
}

/// Only the segments a broken file needs: a few hundred bytes, so that every byte can be tried.
inline Figure tiny_figure() {
  Figure figure = sample_figure();
  for (Mesh& mesh : figure.segments)
    mesh = Mesh();
  figure.segments[2] = sample_mesh(4, 4);
  figure.segments[2].paint = {{0, 0, 0, 200}, {1, 0, 255, 0}, {0, 1, 128, 255}, {1, 1, 1, 1}};
  figure.segments[2].morphs = {
      {.channel = FaceChannel::kJawOpen, .vertices = {1, 3}, .displacement = {{1.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}}}};
  return figure;
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// "" if the figures are equal bit for bit (so that -0 is not 0), else what differs.
inline std::string difference(const Figure& a, const Figure& b) {
  if (a.name != b.name) return "names " + a.name + " / " + b.name;
  if (a.skeleton.size() != b.skeleton.size() || a.segments.size() != b.segments.size()) return "numbers of nodes";
  if (a.appearances.size() != b.appearances.size()) return "numbers of appearances";
  for (size_t i = 0; i < a.appearances.size(); ++i)
    if (a.appearances[i].name != b.appearances[i].name || a.appearances[i].background != b.appearances[i].background ||
        a.appearances[i].pigments != b.appearances[i].pigments)
      return "appearance " + a.appearances[i].name;
  for (size_t i = 0; i < a.segments.size(); ++i) {
    const Node& p = a.skeleton.nodes()[i];
    const Node& q = b.skeleton.nodes()[i];
    const std::string where = " of " + p.name;
    if (p.name != q.name || p.parent != q.parent) return "name or parent" + where;
    if (std::memcmp(&p.offset, &q.offset, sizeof p.offset) != 0) return "offset" + where;
    const Mesh& m = a.segments[i];
    const Mesh& n = b.segments[i];
    if (!same_bytes(m.positions, n.positions)) return "positions" + where;
    if (!same_bytes(m.normals, n.normals)) return "normals" + where;
    if (!same_bytes(m.colours, n.colours)) return "colours" + where;
    if (!same_bytes(m.paint, n.paint)) return "paint" + where;
    if (!same_bytes(m.indices, n.indices)) return "indices" + where;
    if (m.morphs.size() != n.morphs.size()) return "number of morphs" + where;
    for (size_t k = 0; k < m.morphs.size(); ++k)
      if (m.morphs[k].channel != n.morphs[k].channel || !same_bytes(m.morphs[k].vertices, n.morphs[k].vertices) ||
          !same_bytes(m.morphs[k].displacement, n.morphs[k].displacement))
        return "morph " + std::to_string(k) + where;
  }
  return "";
}

}  // namespace auslan::test
