// SPDX-License-Identifier: Apache-2.0
// Any text: read as a motion or refused with a place; what was read has frames that agree with their nodes.
#include "media/motion_file.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto clip = auslan::parse_motion_jsonl({reinterpret_cast<const char*>(data), size}, "motion");
  if (!clip) {
    if (clip.error().message.empty() || clip.error().place.empty()) std::abort();
    return 0;
  }
  if (clip->frames.empty()) std::abort();
  for (const auto& frame : clip->frames)
    if (frame.world.size() != clip->nodes.size()) std::abort();
  return 0;
}
