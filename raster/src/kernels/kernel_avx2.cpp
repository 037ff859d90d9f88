// SPDX-License-Identifier: Apache-2.0
#include "lanes_avx2.h"
#include "tile_stage.h"
#include "triangle_stage.h"
#include "vertex_stage.h"

namespace auslan::raster {

constinit const KernelTable kAvx2Kernel = kernel_table<Avx2, VertexStage<Avx2>, TriangleStage<Avx2>>();

}  // namespace auslan::raster
