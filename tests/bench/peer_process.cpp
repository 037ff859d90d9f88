// SPDX-License-Identifier: Apache-2.0
#include "peer_process.h"

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace auslan::bench {
namespace {

/// A child with its standard input and output as streams; process -1 when it was not started.
struct Child {
  pid_t process = -1;
  std::FILE* to = nullptr;
  std::FILE* from = nullptr;
};

Child start_child(const std::vector<std::string>& arguments, const Environment& environment) {
  int down[2], up[2];
  if (pipe2(down, O_CLOEXEC) != 0) return {};
  if (pipe2(up, O_CLOEXEC) != 0) {
    close(down[0]);
    close(down[1]);
    return {};
  }
  std::vector<char*> argv;
  for (const std::string& argument : arguments)
    argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    dup2(down[0], STDIN_FILENO);
    dup2(up[1], STDOUT_FILENO);
    for (const auto& [name, value] : environment)
      setenv(name.c_str(), value.c_str(), 1);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(down[0]);
  close(up[1]);
  if (process < 0) {
    close(down[1]);
    close(up[0]);
    return {};
  }
  return {process, fdopen(down[1], "w"), fdopen(up[0], "r")};
}

bool read_line(std::FILE* from, std::string& line) {
  line.clear();
  int c = 0;
  while ((c = std::fgetc(from)) != EOF) {
    if (c == '\n') return true;
    line += static_cast<char>(c);
  }
  return false;
}

/// Closes its input, which ends it, and waits. True when it ended well.
bool finish(Child child) {
  std::fclose(child.to);
  std::fclose(child.from);
  int status = 0;
  waitpid(child.process, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string sibling_program(const std::string& name) {
  std::error_code ignored;
  return (std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / name).string();
}

std::optional<std::string> first_line_of(const std::vector<std::string>& arguments) {
  const Child child = start_child(arguments, {});
  if (child.process < 0) return std::nullopt;
  std::string line;
  const bool got = read_line(child.from, line);
  const bool ended_well = finish(child);
  if (!got || !ended_well) return std::nullopt;
  return line;
}

std::optional<PeerProcess> PeerProcess::start(const Environment& environment) {
  const std::string program = sibling_program("raster_gl_peer");
  if (access(program.c_str(), X_OK) != 0) return std::nullopt;
  // A peer that dies must not take the report with it.
  std::signal(SIGPIPE, SIG_IGN);
  const Child child = start_child({program}, environment);
  if (child.process < 0) return std::nullopt;
  PeerProcess peer;
  peer.process_ = child.process;
  peer.to_ = child.to;
  peer.from_ = child.from;
  if (!read_line(peer.from_, peer.driver_)) return std::nullopt;
  return peer;
}

PeerProcess::PeerProcess(PeerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      to_(std::exchange(other.to_, nullptr)),
      from_(std::exchange(other.from_, nullptr)),
      driver_(std::move(other.driver_)) {}

PeerProcess::~PeerProcess() {
  if (process_ >= 0) finish({process_, to_, from_});
}

bool PeerProcess::ask(const std::string& line, std::string& answer) {
  return std::fputs((line + "\n").c_str(), to_) >= 0 && std::fflush(to_) == 0 && read_line(from_, answer);
}

std::vector<FrameTime> PeerProcess::time(const std::string& scene, int width, int height, int samples, bool moving,
                                         int frames) {
  std::ostringstream line;
  line << "time " << scene << ' ' << width << ' ' << height << ' ' << samples << ' ' << (moving ? 1 : 0) << ' '
       << frames;
  std::string answer;
  std::vector<FrameTime> times;
  if (!ask(line.str(), answer)) return times;
  std::istringstream numbers(answer);
  FrameTime time;
  while (numbers >> time.cpu_ms >> time.wall_ms)
    times.push_back(time);
  return times;
}

std::vector<uint32_t> PeerProcess::picture(const std::string& scene, int width, int height, int samples) {
  std::string path = (std::filesystem::temp_directory_path() / "raster_bench.XXXXXX").string();
  const int file = mkstemp(path.data());
  if (file < 0) return {};
  close(file);
  std::ostringstream line;
  line << "picture " << scene << ' ' << width << ' ' << height << ' ' << samples << ' ' << path;
  std::vector<uint32_t> pixels(static_cast<size_t>(width) * static_cast<size_t>(height));
  std::string answer;
  bool whole = ask(line.str(), answer) && answer == "done";
  if (std::FILE* in = std::fopen(path.c_str(), "rb"); in != nullptr) {
    whole = whole && std::fread(pixels.data(), sizeof(uint32_t), pixels.size(), in) == pixels.size();
    std::fclose(in);
  }
  std::filesystem::remove(path);
  if (!whole) return {};
  for (uint32_t& pixel : pixels)
    pixel &= 0xFFFFFFU;
  return pixels;
}

}  // namespace auslan::bench
