// SPDX-License-Identifier: Apache-2.0
#include "kernels/lanes_avx2.h"
#include "raster_lanes.h"

namespace auslan::raster {

void do_avx2_operations(const LaneInput& in, LaneResults& out) {
  do_lane_operations<Avx2>(in, out);
}

}  // namespace auslan::raster
