// SPDX-License-Identifier: Apache-2.0
#include "lanes_scalar.h"
#include "tile_stage.h"
#include "triangle_stage.h"
#include "vertex_stage.h"

namespace auslan::raster {

constinit const KernelTable kScalarKernel = kernel_table<Scalar, VertexStage<Scalar>, TriangleStage<Scalar>>();

}  // namespace auslan::raster
