// SPDX-License-Identifier: Apache-2.0
// Every allocation of a test program and of the libraries it loads, in bytes. It replaces operator new: included by one
// source of a program only.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <malloc.h>
#include <new>

namespace auslan::test {

inline std::atomic<size_t> live_bytes{0};
inline std::atomic<size_t> peak_bytes{0};

inline void* counted(size_t size) {
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  const size_t live = live_bytes += malloc_usable_size(memory);
  if (live > peak_bytes) peak_bytes = live;
  return memory;
}

inline void uncounted(void* memory) noexcept {
  if (memory != nullptr) live_bytes -= malloc_usable_size(memory);
  std::free(memory);
}

}  // namespace auslan::test

void* operator new(size_t size) {
  return auslan::test::counted(size);
}
void* operator new[](size_t size) {
  return auslan::test::counted(size);
}
void* operator new(size_t size, const std::nothrow_t&) noexcept {
  try {
    return auslan::test::counted(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  auslan::test::uncounted(memory);
}
void operator delete(void* memory) noexcept {
  auslan::test::uncounted(memory);
}
void operator delete[](void* memory) noexcept {
  auslan::test::uncounted(memory);
}
void operator delete(void* memory, size_t) noexcept {
  auslan::test::uncounted(memory);
}
void operator delete[](void* memory, size_t) noexcept {
  auslan::test::uncounted(memory);
}
