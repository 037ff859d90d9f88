// SPDX-License-Identifier: Apache-2.0
#include "kernels/lanes_sse2.h"
#include "raster_lanes.h"

namespace auslan::raster {

void do_sse2_operations(const LaneInput& in, LaneResults& out) {
  do_lane_operations<Sse2>(in, out);
}

}  // namespace auslan::raster
