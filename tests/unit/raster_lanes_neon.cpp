// SPDX-License-Identifier: Apache-2.0
#include "kernels/lanes_neon.h"
#include "raster_lanes.h"

namespace auslan::raster {

void do_neon_operations(const LaneInput& in, LaneResults& out) {
  do_lane_operations<Neon>(in, out);
}

}  // namespace auslan::raster
