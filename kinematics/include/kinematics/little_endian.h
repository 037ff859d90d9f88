// SPDX-License-Identifier: Apache-2.0
// Numbers and arrays as little-endian bytes, the order of glTF and of the baked figure, whatever the machine's own
// order.
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

namespace auslan {

namespace little_endian_detail {
/// Reverses each group of `width` bytes.
inline void reverse_groups(char* bytes, size_t size, size_t width) {
  for (size_t start = 0; start + width <= size; start += width)
    for (size_t i = 0; i < width / 2; ++i) {
      const char kept = bytes[start + i];
      bytes[start + i] = bytes[start + width - 1 - i];
      bytes[start + width - 1 - i] = kept;
    }
}
}  // namespace little_endian_detail

/// Appends `count` values, each made of numbers of `width` bytes (a glm::vec3 is three numbers of 4 bytes).
template <typename T>
void append_little_endian(std::string& bytes, const T* values, size_t count, size_t width = sizeof(T)) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (count == 0) return;
  const size_t start = bytes.size();
  bytes.resize(start + count * sizeof(T));
  std::memcpy(bytes.data() + start, values, count * sizeof(T));
  if constexpr (std::endian::native == std::endian::big)
    little_endian_detail::reverse_groups(bytes.data() + start, count * sizeof(T), width);
  static_cast<void>(width);
}

template <typename T>
void append_little_endian(std::string& bytes, T value) {
  append_little_endian(bytes, &value, 1);
}

/// The reverse; `from` holds at least count * sizeof(T) bytes and needs no alignment.
template <typename T>
void load_little_endian(const void* from, T* values, size_t count, size_t width = sizeof(T)) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (count == 0) return;
  std::memcpy(static_cast<void*>(values), from, count * sizeof(T));
  if constexpr (std::endian::native == std::endian::big)
    little_endian_detail::reverse_groups(static_cast<char*>(static_cast<void*>(values)), count * sizeof(T), width);
  static_cast<void>(width);
}

template <typename T>
T load_little_endian(const void* from) {
  T value{};
  load_little_endian(from, &value, 1);
  return value;
}

}  // namespace auslan
