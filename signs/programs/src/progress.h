// SPDX-License-Identifier: Apache-2.0
// A progress bar on stderr, only where stderr is a terminal and the work takes longer than a moment.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace auslan {

class Progress {
 public:
  /// `quiet`: never show anything.
  Progress(std::string label, int64_t total, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of the total are finished.
  void update(int64_t done);

 private:
  std::string label_;
  int64_t total_;
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point started_, painted_;
};

}  // namespace auslan
