// SPDX-License-Identifier: Apache-2.0
#include "lanes_sse2.h"
#include "tile_stage.h"
#include "triangle_stage.h"
#include "vertex_stage.h"

namespace auslan::raster {

constinit const KernelTable kSse2Kernel = kernel_table<Sse2, VertexStage<Sse2>, TriangleStage<Sse2>>();

}  // namespace auslan::raster
