// SPDX-License-Identifier: Apache-2.0
// `bench`: what each step from a sentence to the screen costs on this computer, frame by frame, as the window has them.
#include "commands.h"
#include "frame_maker.h"
#include "media/picture.h"
#include "media/window.h"
#include "session.h"
#include "stop_request.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace auslan {
namespace {

/// In the order in which a frame goes through them.
enum StageName { kAnimate, kTransform, kSetUp, kRaster, kPresent, kStageCount };
constexpr std::array<const char*, kStageCount> kStageNames = {"animate", "transform", "set_up", "raster", "present"};
constexpr std::array<const char*, kStageCount> kStageMeanings = {
    "score to pose, pose to placed meshes", "vertices to the screen, and their light",
    "triangles culled, cut, sorted into tiles", "tiles to pixels", ""};

double read_ms(clockid_t id) {
  timespec now{};
  clock_gettime(id, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

struct Spread {
  double least = 0, median = 0;
};
Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {values.front(), values[values.size() / 2]};
}

/// Milliseconds of every frame after the first, which has every pixel to write and memory to find.
struct Times {
  std::array<std::vector<double>, kStageCount> stages;
  std::vector<double> wall, cpu;
  double first_ms = 0;
};

/// Where frames go: a window, or a piece of memory where there is no display.
class Target {
 public:
  static Result<Target> open(const StageOptions& options) {
    Target target;
    target.memory_ = make_picture(options.width, options.height);
    if (!display_available()) return target;
    auto window = Window::open("Auslan Jam", options.width, options.height);
    if (!window) return tl::unexpected(window.error());
    target.window_.emplace(std::move(*window));
    return target;
  }

  bool is_window() const { return window_.has_value(); }

  Result<void> show(FrameView frame, std::span<const raster::PixelRect> damage) {
    if (window_) {
      window_->poll();
      changed_.clear();
      for (const raster::PixelRect& rect : damage)
        changed_.push_back({rect.x, rect.y, rect.width, rect.height});
      return window_->show_changes(frame, changed_);
    }
    for (const raster::PixelRect& rect : damage)
      for (int y = rect.y; y < rect.y + rect.height; ++y) {
        const size_t begin = static_cast<size_t>(y) * static_cast<size_t>(frame.width) + static_cast<size_t>(rect.x);
        std::copy_n(frame.pixels.begin() + static_cast<std::ptrdiff_t>(begin), rect.width,
                    memory_.pixels.begin() + static_cast<std::ptrdiff_t>(begin));
      }
    return {};
  }

 private:
  Target() = default;
  Picture memory_;
  std::optional<Window> window_;
  std::vector<PixelRect> changed_;
};

Result<Times> time_frames(const Options& options, const Show& show, Stage& stage, Target& target, int frames) {
  Picture picture = make_picture(options.stage.width, options.stage.height);
  Pose pose;
  Times times;
  const int64_t length = frame_count(show, options.fps);
  for (int i = 0; i <= frames; ++i) {
    if (stop_requested()) return stopped();
    const double cpu = read_ms(CLOCK_PROCESS_CPUTIME_ID);
    const double start = read_ms(CLOCK_MONOTONIC);
    show.sample(frame_time(i % length, options.fps), pose);
    stage.render(pose, picture.pixels, i == 0 ? raster::Canvas::kUnknown : raster::Canvas::kLastFrame);
    const double drawn = read_ms(CLOCK_MONOTONIC);
    if (auto shown = target.show(picture.view(), stage.damage()); !shown) return tl::unexpected(shown.error());
    const double end = read_ms(CLOCK_MONOTONIC);
    const double cpu_end = read_ms(CLOCK_PROCESS_CPUTIME_ID);
    if (i == 0) {
      times.first_ms = end - start;
      continue;
    }
    const raster::StageTimes& raster = stage.times();
    const double transform = static_cast<double>(raster.vertices) * 1e-6;
    const double set_up = static_cast<double>(raster.triangles) * 1e-6;
    const double tiles = static_cast<double>(raster.tiles) * 1e-6;
    times.stages[kAnimate].push_back(drawn - start - transform - set_up - tiles);
    times.stages[kTransform].push_back(transform);
    times.stages[kSetUp].push_back(set_up);
    times.stages[kRaster].push_back(tiles);
    times.stages[kPresent].push_back(end - drawn);
    times.wall.push_back(end - start);
    times.cpu.push_back(cpu_end - cpu);
  }
  return times;
}

const char* present_meaning(bool window) {
  return window ? "what changed, into the window" : "what changed, into memory: there is no display";
}

std::string as_json(const Options& options, const Stage& stage, const Times& times, bool window) {
  const auto spread = [](const std::vector<double>& values) {
    const Spread of = spread_of(values);
    return nlohmann::ordered_json{{"min_ms", of.least}, {"median_ms", of.median}};
  };
  nlohmann::ordered_json json;
  json["text"] = options.source.text.value_or("");
  json["width"] = options.stage.width;
  json["height"] = options.stage.height;
  json["samples"] = options.stage.samples;
  json["threads"] = options.stage.threads;
  json["kernel"] = raster::name_of(stage.options().kernel.value());
  json["triangles"] = stage.stats().submitted;
  json["frames"] = times.wall.size();
  json["present"] = window ? "window" : "memory";
  json["first_frame_ms"] = times.first_ms;
  json["frame"] = {{"wall", spread(times.wall)}, {"cpu", spread(times.cpu)}};
  for (size_t i = 0; i < kStageCount; ++i)
    json["stages"][kStageNames[i]] = spread(times.stages[i]);
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string as_text(const Options& options, const Stage& stage, const Times& times, bool window) {
  const StageOptions& form = options.stage;
  char line[200];
  std::snprintf(line, sizeof line, "%dx%d, %d sample%s a pixel, kernel %s, %d thread%s, %zu frames, %llu triangles\n",
                form.width, form.height, form.samples, form.samples == 1 ? "" : "s",
                std::string(raster::name_of(stage.options().kernel.value())).c_str(), form.threads,
                form.threads == 1 ? "" : "s", times.wall.size(),
                static_cast<unsigned long long>(stage.stats().submitted));
  std::string text = line;
  const auto add = [&](const char* name, const std::vector<double>& values, const char* meaning) {
    const Spread of = spread_of(values);
    std::snprintf(line, sizeof line, "%-10s %9.3f %9.3f   %s\n", name, of.least, of.median, meaning);
    text += line;
  };
  text += "ms a frame       min    median\n";
  for (size_t i = 0; i < kStageCount; ++i)
    add(kStageNames[i], times.stages[i], i == kPresent ? present_meaning(window) : kStageMeanings[i]);
  add("frame", times.wall, "all of it");
  add("cpu", times.cpu, "processor time of all threads");
  std::snprintf(line, sizeof line, "first frame %.1f ms\n", times.first_ms);
  return text + line;
}

}  // namespace

Result<void> run_bench(const Options& options) {
  Session session(options);
  const auto show = session.show();
  if (!show) return tl::unexpected(show.error());
  const auto body = session.body();
  if (!body) return tl::unexpected(body.error());
  auto stage = body->stage(session.stage());
  if (!stage) return tl::unexpected(stage.error());
  auto target = Target::open(options.stage);
  if (!target) return tl::unexpected(target.error());
  const int frames =
      options.frames > 0 ? options.frames : static_cast<int>(std::max<int64_t>(1, frame_count(*show, options.fps) - 1));
  const auto times = time_frames(options, *show, *stage, *target, frames);
  if (!times) return tl::unexpected(times.error());
  return print(options.json ? as_json(options, *stage, *times, target->is_window())
                            : as_text(options, *stage, *times, target->is_window()));
}

}  // namespace auslan
