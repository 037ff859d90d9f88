// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernels/kernel.h"
#include "raster/kernel.h"

namespace auslan::raster {

/// The kernel's stages; null where it does not run here.
const KernelTable* table_of(Kernel kernel) noexcept;

}  // namespace auslan::raster
