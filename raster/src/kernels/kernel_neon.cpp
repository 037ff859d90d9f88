// SPDX-License-Identifier: Apache-2.0
#include "lanes_neon.h"
#include "tile_stage.h"
#include "triangle_stage.h"
#include "vertex_stage.h"

namespace auslan::raster {

constinit const KernelTable kNeonKernel = kernel_table<Neon, VertexStage<Neon>, TriangleStage<Neon>>();

}  // namespace auslan::raster
