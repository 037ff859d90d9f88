// SPDX-License-Identifier: Apache-2.0
// Kernels: the same algorithm compiled for different instruction sets. All of them give the same bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace auslan::raster {

enum class Kernel : uint8_t {
  kScalar,  ///< plain C++, on every processor
  kSse2,    ///< every x86-64 processor
  kAvx2,    ///< x86-64 since 2013
  kNeon,    ///< every AArch64 processor
};

/// The kernels that were built and that this processor runs, slowest first; kScalar is always there.
std::span<const Kernel> runnable_kernels() noexcept;

/// "scalar", "sse2", "avx2", "neon".
std::string_view name_of(Kernel kernel) noexcept;

/// The kernel that the environment variable AUSLANJAM_KERNEL names, or, where it is not set or empty, the fastest that
/// runs here. Nothing when it names none that does.
std::optional<Kernel> chosen_kernel() noexcept;

}  // namespace auslan::raster
