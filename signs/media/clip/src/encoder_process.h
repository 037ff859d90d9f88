// SPDX-License-Identifier: Apache-2.0
// A program that eats bytes on its standard input: started without a shell, never able to kill us with SIGPIPE.
#pragma once

#include "kinematics/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <sys/types.h>
#include <vector>

namespace auslan {

/// A running program. Its output is thrown away, its error output kept. Destroying it while it runs kills it.
class EncoderProcess {
 public:
  /// `arguments[0]` is the program, looked for on the PATH. kNotFound when it cannot be started.
  static Result<EncoderProcess> start(const std::vector<std::string>& arguments);

  EncoderProcess(EncoderProcess&& other) noexcept;
  EncoderProcess& operator=(EncoderProcess&&) = delete;
  ~EncoderProcess();

  /// False when the program no longer reads.
  bool write(std::span<const uint8_t> bytes);
  /// Ends the input and waits. True when the program ended with status 0.
  bool finish();
  /// After finish(): how it ended ("exit status 1", "killed by signal 9"), and the end of what it wrote to its error
  /// output on one line.
  std::string how_it_ended() const;
  std::string last_words() const;

 private:
  EncoderProcess() = default;
  void close_input();

  pid_t pid_ = -1;
  int input_ = -1;
  int errors_ = -1;
  int status_ = 0;
};

}  // namespace auslan
