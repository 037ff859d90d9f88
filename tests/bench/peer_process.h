// SPDX-License-Identifier: Apache-2.0
// A Mesa driver in a process of its own (gl_peer.cpp): the driver is chosen by the environment, once for a process.
#pragma once

#include "frame_clock.h"

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace auslan::bench {

using Environment = std::vector<std::pair<std::string, std::string>>;

/// The programs that were built beside this one.
std::string sibling_program(const std::string& name);

/// What a program prints on its first line; nothing when it cannot be started or fails.
std::optional<std::string> first_line_of(const std::vector<std::string>& arguments);

class PeerProcess {
 public:
  /// Nothing where OSMesa was not there when the benchmark was built, or does not start.
  static std::optional<PeerProcess> start(const Environment& environment);
  PeerProcess(PeerProcess&& other) noexcept;
  PeerProcess& operator=(PeerProcess&& other) = delete;
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;
  ~PeerProcess();

  /// As Mesa names it, with its vector width and version.
  const std::string& driver() const { return driver_; }

  /// Draws frames and returns their times; empty when the process is gone.
  std::vector<FrameTime> time(const std::string& scene, int width, int height, int samples, bool moving, int frames);
  /// The pixels of a frame; empty when the process is gone.
  std::vector<uint32_t> picture(const std::string& scene, int width, int height, int samples);

 private:
  PeerProcess() = default;
  bool ask(const std::string& line, std::string& answer);

  pid_t process_ = -1;
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
  std::string driver_;
};

}  // namespace auslan::bench
