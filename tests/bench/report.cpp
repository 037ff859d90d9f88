// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include "frame_series.h"
#include "measurement.h"
#include "peer_process.h"
#include "picture_difference.h"
#include "stage_series.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace auslan::bench {
namespace {

/// A way to draw that is in the report: the rasteriser in some form, or a peer.
struct Contender {
  std::string name;
  PeerProcess* peer = nullptr;  ///< null: the rasteriser
  raster::Kernel kernel = raster::Kernel::kScalar;
  int threads = 1;
  Redraw redraw = Redraw::kClean;
};

/// What was measured of a contender in one setting.
struct Measured {
  std::string scene;
  int width, height, samples;
  std::string contender;
  Figures figures;
};

class Report {
 public:
  explicit Report(const ReportOptions& options) : options_(options) {
    if (options.quick) patience_ = {1, 1, 1};
    start_peers();
  }

  int run();

 private:
  void start_peers();
  void compare_pictures();
  void main_table();
  void size_table();
  void redraw_table();
  void softpipe_table();
  void figure_table();
  void start_and_memory();
  void write_json();

  const Scene& scene(const std::string& name);
  std::vector<std::string> columns() const;
  std::vector<Figures> measured(const std::string& name, const Size& size, int samples,
                                const std::vector<Contender>& contenders);
  bool has_capped() const { return capped_ != nullptr; }

  ReportOptions options_;
  Patience patience_;
  std::unique_ptr<PeerProcess> llvmpipe_, capped_, softpipe_;
  raster::Kernel best_ = raster::runnable_kernels().back();
  std::map<std::string, Scene> scenes_;
  std::vector<Measured> all_;
  nlohmann::ordered_json json_;
  bool failed_ = false;
};

const char* title_of(const std::string& scene) {
  if (scene == "signer_5k") return "signer 5k";
  if (scene == "signer_22k") return "22k";
  if (scene == "signer_90k") return "90k";
  return scene == "back_to_front" ? "back to front" : scene.c_str();
}

/// Signers at 1280x720 in the main table.
Size main_size(const std::string& scene) {
  return scene.starts_with("signer") ? Size{1280, 720} : Size{1920, 1080};
}

std::string milliseconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%.0f", value);
  return text;
}

std::string times_faster(double slow, double fast) {
  if (!(slow > 0 && fast > 0)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f×", slow / fast);
  return text;
}

void print_row(const std::string& first, const std::vector<std::string>& cells) {
  std::printf("| %s |", first.c_str());
  for (const std::string& cell : cells)
    std::printf(" %s |", cell.c_str());
  std::printf("\n");
  std::fflush(stdout);
}

void print_head(const std::string& first, const std::vector<std::string>& cells) {
  std::printf("\n");
  print_row(first, cells);
  print_row("---", std::vector<std::string>(cells.size(), "---:"));
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::unique_ptr<PeerProcess> start_peer(const char* driver, const char* caps) {
  Environment environment = {{"GALLIUM_DRIVER", driver}, {"LP_NUM_THREADS", "0"}};
  if (caps != nullptr) environment.emplace_back("GALLIUM_OVERRIDE_CPU_CAPS", caps);
  auto peer = PeerProcess::start(environment);
  return peer ? std::make_unique<PeerProcess>(std::move(*peer)) : nullptr;
}

void Report::start_peers() {
  llvmpipe_ = start_peer("llvmpipe", nullptr);
  if (llvmpipe_ == nullptr) return;
  if (kernel_of("sse2")) capped_ = start_peer("llvmpipe", "sse2");
  softpipe_ = start_peer("softpipe", nullptr);
}

const Scene& Report::scene(const std::string& name) {
  const auto found = scenes_.find(name);
  return found != scenes_.end() ? found->second : scenes_.emplace(name, load_scene(name)).first->second;
}

std::vector<std::string> Report::columns() const {
  if (options_.quick) return {"signer_5k", "fill"};
  return {"signer_5k", "signer_22k", "signer_90k", "fill", "back_to_front", "tiny"};
}

std::vector<Figures> Report::measured(const std::string& name, const Size& size, int samples,
                                      const std::vector<Contender>& contenders) {
  std::vector<std::unique_ptr<FrameSeries>> ours;
  std::vector<Engine> engines;
  for (const Contender& contender : contenders) {
    if (contender.peer != nullptr) {
      const bool moving = contender.redraw == Redraw::kArm;
      engines.push_back({contender.name, [&contender, &name, &size, samples, moving](int frames) {
                           return contender.peer->time(name, size.width, size.height, samples, moving, frames);
                         }});
      continue;
    }
    ours.push_back(std::make_unique<FrameSeries>(
        scene(name),
        SeriesOptions{size.width, size.height, samples, contender.kernel, contender.threads, contender.redraw}));
    engines.push_back({contender.name, [series = ours.back().get()](int frames) {
                         std::vector<FrameTime> times;
                         for (int i = 0; i < frames; ++i)
                           times.push_back(series->draw());
                         return times;
                       }});
  }
  const std::vector<Figures> figures = measure(engines, patience_);
  for (size_t i = 0; i < figures.size(); ++i)
    all_.push_back({name, size.width, size.height, samples, contenders[i].name, figures[i]});
  return figures;
}

void Report::compare_pictures() {
  if (llvmpipe_ == nullptr) return;
  print_head("difference from llvmpipe's picture, levels of 255", {"mean", "pixels off by more than 16"});
  for (const std::string& name : columns()) {
    const auto [width, height] = main_size(name);
    FrameSeries series(scene(name), SeriesOptions{width, height, 1, best_, 1, Redraw::kFull});
    series.draw();
    const std::vector<uint32_t> theirs = llvmpipe_->picture(name, width, height, 1);
    if (!options_.pictures.empty()) {
      failed_ |= !write_ppm(options_.pictures + "/" + name + ".ppm", series.pixels(), width);
      failed_ |= !write_ppm(options_.pictures + "/" + name + "_llvmpipe.ppm", theirs, width);
    }
    const PictureDifference difference = difference_of(series.pixels(), theirs);
    char cells[2][32];
    std::snprintf(cells[0], sizeof cells[0], "%.4f", difference.mean_level);
    std::snprintf(cells[1], sizeof cells[1], "%.4f %%", difference.share_far_off * 100);
    print_row(title_of(name), {cells[0], cells[1]});
    json_["pictures"].push_back(
        {{"scene", name}, {"mean_level", difference.mean_level}, {"share_far_off", difference.share_far_off}});
    // Vertices snap to another grid and colours round another way; a lamp or a triangle too few would be far more.
    if (!(difference.mean_level < 0.5 && difference.share_far_off < 0.01)) {
      std::printf("%s: the two pictures are not the same, so that their times do not compare\n", name.c_str());
      failed_ = true;
    }
  }
}

void Report::main_table() {
  const std::string best(raster::name_of(best_));
  std::vector<std::string> heads;
  for (const std::string& name : columns())
    heads.emplace_back(title_of(name));
  std::map<std::string, std::vector<std::string>> rows;
  std::vector<std::string> order;
  const auto put = [&](const std::string& row, const std::string& cell) {
    if (!rows.contains(row)) order.push_back(row);
    rows[row].push_back(cell);
  };
  for (const std::string& name : columns()) {
    for (const int samples : {1, 4}) {
      const std::string with = samples == 1 ? "" : ", 4×";
      std::vector<Contender> contenders = {
          {.name = best, .kernel = best_},
          {.name = best + ", every pixel written", .kernel = best_, .redraw = Redraw::kFull},
          {.name = best + ", two threads", .kernel = best_, .threads = 2}};
      const auto sse2 = kernel_of("sse2");
      size_t of_sse2 = 0, of_llvmpipe = 0, of_capped = 0;
      if (sse2 && *sse2 != best_) {
        of_sse2 = contenders.size();
        contenders.push_back({.name = "sse2", .kernel = *sse2});
        contenders.push_back({.name = "sse2, every pixel written", .kernel = *sse2, .redraw = Redraw::kFull});
      }
      if (samples == 1) contenders.push_back({.name = "scalar", .kernel = raster::Kernel::kScalar});
      if (llvmpipe_ != nullptr) {
        of_llvmpipe = contenders.size();
        contenders.push_back({.name = "llvmpipe", .peer = llvmpipe_.get()});
      }
      if (has_capped()) {
        of_capped = contenders.size();
        contenders.push_back({.name = "llvmpipe capped to SSE2", .peer = capped_.get()});
      }
      const std::vector<Figures> figures = measured(name, main_size(name), samples, contenders);
      for (size_t i = 0; i < contenders.size(); ++i)
        if (contenders[i].threads == 1) put(contenders[i].name + with, milliseconds(figures[i].cpu_ms));
      put(best + with + ", two threads, wall", milliseconds(figures[2].wall_ms));
      put("**two threads against one, wall" + with + "**", times_faster(figures[0].wall_ms, figures[2].wall_ms));
      if (of_llvmpipe > 0) {
        put("**" + best + " against llvmpipe" + with + "**",
            times_faster(figures[of_llvmpipe].cpu_ms, figures[0].cpu_ms));
        put("every pixel written, against llvmpipe" + with,
            times_faster(figures[of_llvmpipe].cpu_ms, figures[1].cpu_ms));
      }
      if (of_capped > 0 && of_sse2 > 0)
        put("**sse2 against llvmpipe capped to SSE2" + with + "**",
            times_faster(figures[of_capped].cpu_ms, figures[of_sse2].cpu_ms));
    }
    std::fprintf(stderr, "measured %s\n", name.c_str());
  }
  print_head("CPU ms a frame, one thread; signer at 1280x720, the rest at 1920x1080", heads);
  for (const std::string& row : order)
    print_row(row, rows[row]);
}

void Report::size_table() {
  const std::string best(raster::name_of(best_));
  std::vector<std::string> heads;
  std::vector<std::string> names;
  for (const std::string& name : columns())
    if (name.starts_with("signer")) {
      names.push_back(name);
      heads.emplace_back(title_of(name));
    }
  print_head("signer, " + best + ", CPU ms a frame (against llvmpipe)", heads);
  for (const Size& size : sizes_of("signer"))
    for (const int samples : {1, 4}) {
      std::vector<std::string> cells;
      for (const std::string& name : names) {
        std::vector<Contender> contenders = {{.name = best, .kernel = best_}};
        if (llvmpipe_ != nullptr) contenders.push_back({.name = "llvmpipe", .peer = llvmpipe_.get()});
        const std::vector<Figures> figures = measured(name, size, samples, contenders);
        cells.push_back(milliseconds(figures[0].cpu_ms) +
                        (llvmpipe_ == nullptr ? "" : " (" + times_faster(figures[1].cpu_ms, figures[0].cpu_ms) + ")"));
      }
      print_row(std::to_string(size.width) + "x" + std::to_string(size.height) + (samples == 1 ? "" : ", 4×"), cells);
    }
}

void Report::redraw_table() {
  const std::string name = options_.quick ? "signer_5k" : "signer_22k";
  const std::string best(raster::name_of(best_));
  print_head(std::string(title_of(name)) + " at 1280x720, " + best + ", CPU ms a frame",
             {"every pixel written", "clean tiles left", "one arm moves", "still"});
  for (const int samples : {1, 4}) {
    std::vector<Contender> contenders;
    for (const Redraw redraw : {Redraw::kFull, Redraw::kClean, Redraw::kArm, Redraw::kStill})
      contenders.push_back({.name = best + ", " + std::string(kRedrawNames[static_cast<size_t>(redraw)]),
                            .kernel = best_,
                            .redraw = redraw});
    std::vector<std::string> cells;
    for (const Figures& figures : measured(name, main_size(name), samples, contenders)) {
      char text[32];
      std::snprintf(text, sizeof text, "%.3f", figures.cpu_ms);
      cells.emplace_back(text);
    }
    print_row(samples == 1 ? "one sample" : "4×", cells);
  }
}

void Report::softpipe_table() {
  if (softpipe_ == nullptr) return;
  const std::string best(raster::name_of(best_));
  print_head("640x480, one sample, CPU ms a frame", {best, "softpipe", "ratio"});
  for (const std::string& name : columns()) {
    if (name != "signer_5k" && name != "signer_22k") continue;
    const std::vector<Figures> figures =
        measured(name, {640, 480}, 1, {{.name = best, .kernel = best_}, {.name = "softpipe", .peer = softpipe_.get()}});
    print_row(title_of(name), {milliseconds(figures[0].cpu_ms), milliseconds(figures[1].cpu_ms),
                               times_faster(figures[1].cpu_ms, figures[0].cpu_ms)});
  }
}

void Report::figure_table() {
  struct Row {
    const char* title;
    FigureForm form;
    int samples;
  };
  std::vector<raster::Kernel> kernels = {best_};
  if (const auto sse2 = kernel_of("sse2"); sse2 && *sse2 != best_) kernels.push_back(*sse2);
  print_head("the figure as it signs, score to pixels, one thread, CPU ms a frame at 1280x720",
             {"what changed", "every pixel", "triangles"});
  for (const Row& row : {Row{"plain: rigid, no shadow, one sample", FigureForm::kPlain, 1},
                         Row{"default: smooth joints, shadow, 4×", FigureForm::kDefault, 4}}) {
    for (const raster::Kernel kernel : kernels) {
      std::vector<std::unique_ptr<StageSeries>> series;
      std::vector<Engine> engines;
      for (const bool every_pixel : {false, true}) {
        series.push_back(std::make_unique<StageSeries>(StageSeriesOptions{
            .form = row.form, .samples = row.samples, .kernel = kernel, .every_pixel = every_pixel}));
        engines.push_back({row.title, [frames_of = series.back().get()](int frames) {
                             std::vector<FrameTime> times;
                             for (int i = 0; i < frames; ++i)
                               times.push_back(frames_of->draw());
                             return times;
                           }});
      }
      const std::vector<Figures> figures = measure(engines, patience_);
      const std::string kernel_name(raster::name_of(kernel));
      print_row(row.title + (", " + kernel_name), {milliseconds(figures[0].cpu_ms), milliseconds(figures[1].cpu_ms),
                                                   std::to_string(series.front()->triangle_count())});
      json_["figure"].push_back({{"form", kFigureFormNames[static_cast<size_t>(row.form)]},
                                 {"kernel", kernel_name},
                                 {"samples", row.samples},
                                 {"triangles", series.front()->triangle_count()},
                                 {"cpu_ms", figures[0].cpu_ms},
                                 {"least_cpu_ms", figures[0].least_cpu_ms},
                                 {"every_pixel_cpu_ms", figures[1].cpu_ms}});
    }
  }
}

void Report::start_and_memory() {
  print_head("the library alone, one frame of signer 22k at 1280x720",
             {"start of the process to the frame, ms", "peak memory, MB"});
  for (const int samples : {1, 4}) {
    std::vector<double> first_ms;
    long peak_kb = 0;
    for (int i = 0; i < (options_.quick ? 1 : 11); ++i) {
      const double started = read_clock(CLOCK_MONOTONIC);
      const auto line =
          first_line_of({sibling_program("raster_frames"), "signer_22k", "1280", "720", std::to_string(samples),
                         std::string(raster::name_of(best_)), "1", "clean", "1"});
      double done = 0;
      std::istringstream numbers(line.value_or(""));
      if (!(numbers >> done >> peak_kb)) {
        std::printf("raster_frames did not draw; build the target bench\n");
        failed_ = true;
        return;
      }
      first_ms.push_back(done - started);
    }
    std::ranges::sort(first_ms);
    const double middle = first_ms[first_ms.size() / 2];
    char memory[32];
    std::snprintf(memory, sizeof memory, "%.1f", static_cast<double>(peak_kb) / 1024.0);
    print_row(samples == 1 ? "one sample" : "4×", {milliseconds(middle), memory});
    json_["start"].push_back({{"samples", samples}, {"first_frame_ms", middle}, {"peak_kb", peak_kb}});
  }
}

void Report::write_json() {
  if (options_.json.empty()) return;
  json_["processor"] = processor_name();
  json_["llvmpipe"] = llvmpipe_ != nullptr ? llvmpipe_->driver() : "";
  json_["measured"] = nlohmann::ordered_json::array();
  for (const Measured& measured : all_)
    json_["measured"].push_back({{"scene", measured.scene},
                                 {"triangles", scene(measured.scene).triangle_count()},
                                 {"width", measured.width},
                                 {"height", measured.height},
                                 {"samples", measured.samples},
                                 {"engine", measured.contender},
                                 {"frames", measured.figures.frames},
                                 {"cpu_ms", measured.figures.cpu_ms},
                                 {"least_cpu_ms", measured.figures.least_cpu_ms},
                                 {"wall_ms", measured.figures.wall_ms}});
  std::ofstream out(options_.json);
  out << json_.dump(2) << '\n';
  out.close();
  if (out) return;
  std::fprintf(stderr, "cannot write %s\n", options_.json.c_str());
  failed_ = true;
}

int Report::run() {
  std::printf("%s; lower quartiles of frames that took turns\n", processor_name().c_str());
  for (const PeerProcess* peer : {llvmpipe_.get(), capped_.get(), softpipe_.get()})
    if (peer != nullptr) std::printf("%s\n", peer->driver().c_str());
  if (llvmpipe_ == nullptr) std::printf("OSMesa (libosmesa6-dev) is not here: no peers\n");
  compare_pictures();
  main_table();
  size_table();
  redraw_table();
  softpipe_table();
  figure_table();
  start_and_memory();
  write_json();
  return failed_ ? 1 : 0;
}

}  // namespace

int run_report(const ReportOptions& options) {
  return Report(options).run();
}

}  // namespace auslan::bench
