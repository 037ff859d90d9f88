// SPDX-License-Identifier: Apache-2.0
// Fewer triangles for the same form: edges collapse in the order of how little each changes.
#pragma once

#include "kinematics/figure.h"

#include <vector>

namespace auslan::sculpt {

/// A closed mesh with what its reduction needs to know; everything per vertex.
struct Sculpture {
  Mesh mesh;  ///< metres
  /// Its mirror image across x = 0; itself where it lies on the plane, and everywhere in a mesh without symmetry.
  std::vector<uint32_t> mirror;
  std::vector<double> importance;        ///< of errors there; 1 for what is looked at
  std::vector<double> occlusion;         ///< how much of baked occlusion it takes; 0 where the face moves
  std::vector<std::vector<Vec3>> poses;  ///< millimetres: where the vertices may also be, and the form has to hold
};

/// Collapses edges onto one of their ends until the mesh has no more than `triangles`, or no collapse is left that
/// keeps it closed and unfolded. The vertices that stay keep everything they have, morphs too; a symmetric mesh stays
/// symmetric bit for bit. Errors are squared distances from the planes of the triangles, in space and colour (Garland
/// and Heckbert 1998, "Simplifying Surfaces with Color and Texture using Quadric Error Metrics"), summed over the rest
/// pose and the given ones (Mohr and Gleicher 2003, "Deformation Sensitive Decimation").
Mesh reduced(const Sculpture& sculpture, size_t triangles);

}  // namespace auslan::sculpt
