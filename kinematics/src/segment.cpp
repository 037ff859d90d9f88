// SPDX-License-Identifier: Apache-2.0
#include "segment.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace auslan {
namespace {

glm::vec3 triangle_area_vector(const std::vector<glm::vec3>& positions, const uint32_t* corner) {
  const glm::vec3 a = positions[corner[0]];
  // Scaled up so that the square of the area of a sub-millimetre triangle does not vanish.
  return glm::cross((positions[corner[1]] - a) * 1e3F, (positions[corner[2]] - a) * 1e3F);
}

}  // namespace

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
  const float square = v.x * v.x + v.y * v.y + v.z * v.z;
  return square > 1e-30F ? v * (1.0F / std::sqrt(square)) : fallback;
}

glm::mat4 matrix_of(const Transform& placement) {
  const Mat3 columns = glm::mat3_cast(placement.rotation);
  return {glm::vec4(glm::vec3(columns[0]), 0.0F), glm::vec4(glm::vec3(columns[1]), 0.0F),
          glm::vec4(glm::vec3(columns[2]), 0.0F), glm::vec4(glm::vec3(placement.position), 1.0F)};
}

Mesh with_facets(const Mesh& mesh) {
  Mesh facets;
  facets.positions.reserve(mesh.indices.size());
  facets.normals.reserve(mesh.indices.size());
  facets.colours.reserve(mesh.indices.size());
  facets.indices.reserve(mesh.indices.size());
  std::vector<std::vector<uint32_t>> copies(mesh.positions.size());
  for (size_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    const uint32_t* corner = &mesh.indices[first];
    const glm::vec3 normal = unit_or(triangle_area_vector(mesh.positions, corner), mesh.normals[corner[0]]);
    glm::u8vec4 colour(0, 0, 0, 255);
    for (glm::length_t channel = 0; channel < 3; ++channel) {
      const int sum =
          mesh.colours[corner[0]][channel] + mesh.colours[corner[1]][channel] + mesh.colours[corner[2]][channel];
      colour[channel] = static_cast<uint8_t>((sum + 1) / 3);
    }
    for (size_t i = 0; i < 3; ++i) {
      const auto copy = static_cast<uint32_t>(facets.positions.size());
      copies[corner[i]].push_back(copy);
      facets.positions.push_back(mesh.positions[corner[i]]);
      facets.normals.push_back(normal);
      facets.colours.push_back(colour);
      facets.indices.push_back(copy);
    }
  }
  for (const Morph& morph : mesh.morphs) {
    Morph spread{morph.channel, {}, {}};
    // In the order of the original vertices; ascending order is not needed here.
    for (size_t i = 0; i < morph.vertices.size(); ++i)
      for (const uint32_t copy : copies[morph.vertices[i]]) {
        spread.vertices.push_back(copy);
        spread.displacement.push_back(morph.displacement[i]);
      }
    facets.morphs.push_back(std::move(spread));
  }
  return facets;
}

Segment::Segment(int node, Mesh mesh, Normals kind) : node_(node), kind_(kind), mesh_(std::move(mesh)) {
  posed_positions_ = mesh_.positions;
  posed_normals_ = mesh_.normals;
  if (!mesh_.morphs.empty()) find_affected();
}

PosedMesh Segment::view() const {
  return {node_, posed_positions_, posed_normals_, mesh_.colours, mesh_.indices, glm::mat4(1.0F), revision_};
}

void Segment::apply(const FaceWeights& face) {
  if (mesh_.morphs.empty() || same_weights(face)) return;
  for (const uint32_t vertex : moved_)
    posed_positions_[vertex] = mesh_.positions[vertex];
  for (const Morph& morph : mesh_.morphs) {
    const float weight = face[static_cast<size_t>(morph.channel)];
    if (weight == 0.0F) continue;
    for (size_t i = 0; i < morph.vertices.size(); ++i)
      posed_positions_[morph.vertices[i]] += morph.displacement[i] * weight;
  }
  if (kind_ == Normals::kOfTriangles)
    flat_normals();
  else
    smooth_normals();
  applied_ = face;
  ++revision_;
}

bool Segment::same_weights(const FaceWeights& face) const {
  for (const Morph& morph : mesh_.morphs) {
    const auto channel = static_cast<size_t>(morph.channel);
    if (face[channel] != applied_[channel]) return false;
  }
  return true;
}

void Segment::find_affected() {
  std::vector<bool> moved(mesh_.positions.size(), false);
  for (const Morph& morph : mesh_.morphs)
    for (const uint32_t vertex : morph.vertices)
      moved[vertex] = true;
  for (size_t i = 0; i < moved.size(); ++i)
    if (moved[i]) moved_.push_back(static_cast<uint32_t>(i));

  // A vertex's normal changes with any corner of any triangle at it, and depends on all of those triangles.
  std::vector<bool> tilted(mesh_.positions.size(), false);
  const auto& indices = mesh_.indices;
  for (size_t first = 0; first + 2 < indices.size(); first += 3)
    if (moved[indices[first]] || moved[indices[first + 1]] || moved[indices[first + 2]])
      for (size_t i = 0; i < 3; ++i)
        tilted[indices[first + i]] = true;
  for (size_t i = 0; i < tilted.size(); ++i)
    if (tilted[i]) tilted_.push_back(static_cast<uint32_t>(i));
  for (size_t first = 0; first + 2 < indices.size(); first += 3)
    if (tilted[indices[first]] || tilted[indices[first + 1]] || tilted[indices[first + 2]])
      triangles_.push_back(static_cast<uint32_t>(first));
  if (kind_ == Normals::kOfVertices) {
    sums_.resize(mesh_.positions.size());
    rest_sums_.resize(mesh_.positions.size());
    sum_areas(mesh_.positions);
    rest_sums_ = sums_;
  }
}

void Segment::flat_normals() {
  for (const uint32_t first : triangles_) {
    const uint32_t* corner = &mesh_.indices[first];
    const glm::vec3 normal = unit_or(triangle_area_vector(posed_positions_, corner), mesh_.normals[corner[0]]);
    for (size_t i = 0; i < 3; ++i)
      posed_normals_[corner[i]] = normal;
  }
}

void Segment::sum_areas(const std::vector<glm::vec3>& positions) {
  for (const uint32_t vertex : tilted_)
    sums_[vertex] = glm::vec3(0.0F);
  for (const uint32_t first : triangles_) {
    const uint32_t* corner = &mesh_.indices[first];
    const glm::vec3 area = triangle_area_vector(positions, corner);
    for (size_t i = 0; i < 3; ++i)
      sums_[corner[i]] += area;
  }
  for (const uint32_t vertex : tilted_)
    sums_[vertex] = unit_or(sums_[vertex], mesh_.normals[vertex]);
}

// The change of the area-weighted normal is added to the figure's own, which may have been smoothed over a seam that
// the indices do not show: at rest the result is the figure's normal to the last bit of the sum.
void Segment::smooth_normals() {
  sum_areas(posed_positions_);
  for (const uint32_t vertex : tilted_) {
    const glm::vec3 change = sums_[vertex] - rest_sums_[vertex];
    posed_normals_[vertex] =
        change == glm::vec3(0.0F) ? mesh_.normals[vertex] : unit_or(mesh_.normals[vertex] + change, sums_[vertex]);
  }
}

}  // namespace auslan
