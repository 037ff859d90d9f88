// SPDX-License-Identifier: Apache-2.0
#include "encoder_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ;

namespace auslan {

namespace {

constexpr off_t kLastWords = 600;

/// Files and attributes of the child. Its input is one end of a socket pair rather than a pipe, because send() can be
/// told not to raise SIGPIPE and a signal mask is nobody's business but the program's.
int spawn(const std::vector<std::string>& arguments, int input, int errors, pid_t* pid) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  if (posix_spawn_file_actions_init(&files) != 0) return ENOMEM;
  if (posix_spawnattr_init(&attributes) != 0) {
    posix_spawn_file_actions_destroy(&files);
    return ENOMEM;
  }
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigaddset(&signals, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  // Its own process group: Ctrl-C reaches us alone, and we take it down in order.
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP));
  std::vector<char*> raw;
  raw.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments)
    raw.push_back(const_cast<char*>(argument.c_str()));
  raw.push_back(nullptr);
  const int error = posix_spawnp(pid, raw[0], &files, &attributes, raw.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

Result<EncoderProcess> EncoderProcess::start(const std::vector<std::string>& arguments) {
  EncoderProcess process;
  std::array<int, 2> pair{-1, -1};
  process.errors_ = memfd_create("encoder-errors", MFD_CLOEXEC);
  if (process.errors_ < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0)
    return fail(ErrorCode::kLimit, std::string("cannot open a channel to the encoder: ") + std::strerror(errno) +
                                       "; close some files or programs");
  process.input_ = pair[0];
  shutdown(pair[1], SHUT_WR);
  const int error = spawn(arguments, pair[1], process.errors_, &process.pid_);
  close(pair[1]);
  if (error != 0) {
    process.pid_ = -1;
    return fail(ErrorCode::kNotFound, "cannot start " + arguments[0] + ": " + std::strerror(error));
  }
  return process;
}

EncoderProcess::EncoderProcess(EncoderProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      input_(std::exchange(other.input_, -1)),
      errors_(std::exchange(other.errors_, -1)),
      status_(other.status_) {}

EncoderProcess::~EncoderProcess() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    finish();
  }
  close_input();
  if (errors_ >= 0) close(errors_);
}

void EncoderProcess::close_input() {
  if (input_ >= 0) close(input_);
  input_ = -1;
}

bool EncoderProcess::write(std::span<const uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0) {
      if (errno == EINTR) continue;
      return false;
    }
    bytes = bytes.subspan(static_cast<size_t>(sent));
  }
  return true;
}

bool EncoderProcess::finish() {
  close_input();
  if (pid_ > 0) {
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
  }
  return WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

std::string EncoderProcess::how_it_ended() const {
  if (WIFSIGNALED(status_)) return "killed by signal " + std::to_string(WTERMSIG(status_));
  return "exit status " + std::to_string(WEXITSTATUS(status_));
}

std::string EncoderProcess::last_words() const {
  const off_t size = lseek(errors_, 0, SEEK_END);
  if (size <= 0) return {};
  std::string text(static_cast<size_t>(std::min(size, kLastWords)), '\0');
  const ssize_t got = pread(errors_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(got > 0 ? static_cast<size_t>(got) : 0);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r'))
    text.pop_back();
  std::string line;
  for (const char c : text) {
    if (c == '\n' || c == '\r')
      line += " | ";
    else if (static_cast<unsigned char>(c) >= ' ')
      line += c;
  }
  return line;
}

}  // namespace auslan
