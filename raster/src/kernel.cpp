// SPDX-License-Identifier: Apache-2.0
#include "raster/kernel.h"

#include "kernel_choice.h"

#include <array>
#include <cstdlib>

namespace auslan::raster {
namespace {

struct Runnable {
  std::array<Kernel, 4> list{};
  size_t count = 0;
};

Runnable find_runnable() {
  Runnable found;
  const auto add = [&found](Kernel kernel) { found.list[found.count++] = kernel; };
  add(Kernel::kScalar);
#if defined(__x86_64__)
  add(Kernel::kSse2);
  if (__builtin_cpu_supports("avx2") != 0) add(Kernel::kAvx2);
#elif defined(__aarch64__)
  add(Kernel::kNeon);
#endif
  return found;
}

}  // namespace

std::span<const Kernel> runnable_kernels() noexcept {
  static const Runnable runnable = find_runnable();
  return std::span(runnable.list).first(runnable.count);
}

std::string_view name_of(Kernel kernel) noexcept {
  constexpr std::string_view kNames[] = {"scalar", "sse2", "avx2", "neon"};
  return kNames[static_cast<size_t>(kernel)];
}

std::optional<Kernel> chosen_kernel() noexcept {
  const char* wanted = std::getenv("AUSLANJAM_KERNEL");
  if (wanted == nullptr || *wanted == '\0') return runnable_kernels().back();
  for (const Kernel kernel : runnable_kernels()) {
    if (name_of(kernel) == wanted) return kernel;
  }
  return std::nullopt;
}

const KernelTable* table_of(Kernel kernel) noexcept {
  for (const Kernel runnable : runnable_kernels()) {
    if (runnable != kernel) continue;
    switch (kernel) {
#if defined(__x86_64__)
      case Kernel::kSse2:
        return &kSse2Kernel;
      case Kernel::kAvx2:
        return &kAvx2Kernel;
#elif defined(__aarch64__)
      case Kernel::kNeon:
        return &kNeonKernel;
#endif
      default:
        return &kScalarKernel;
    }
  }
  return nullptr;
}

}  // namespace auslan::raster
