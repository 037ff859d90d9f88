// SPDX-License-Identifier: Apache-2.0
// The rasteriser's benchmark. `raster_bench` times the rasteriser alone under Google Benchmark, every scene, size,
// kernel and number of threads; `raster_bench --report` compares it with Mesa's software drivers.
#include "frame_series.h"
#include "report.h"

#include <benchmark/benchmark.h>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>

namespace auslan::bench {
namespace {

const Scene& cached_scene(const std::string& name) {
  static std::map<std::string, Scene> scenes;
  const auto found = scenes.find(name);
  return found != scenes.end() ? found->second : scenes.emplace(name, load_scene(name)).first->second;
}

/// The time that counts is the processor's with one thread, the wall's with more.
void time_series(benchmark::State& state, const std::string& scene, const SeriesOptions& options) {
  FrameSeries series(cached_scene(scene), options);
  series.draw();
  series.draw();
  double cpu_ms = 0;
  int64_t vertices = 0;
  int64_t triangles = 0;
  int64_t tiles = 0;
  for ([[maybe_unused]] auto unused : state) {
    const FrameTime time = series.draw();
    state.SetIterationTime((options.threads == 1 ? time.cpu_ms : time.wall_ms) * 1e-3);
    cpu_ms += time.cpu_ms;
    const raster::StageTimes& stages = series.renderer().times();
    vertices += stages.vertices;
    triangles += stages.triangles;
    tiles += stages.tiles;
  }
  const auto per_frame = benchmark::Counter::kAvgIterations;
  state.counters["triangles"] = static_cast<double>(cached_scene(scene).triangle_count());
  state.counters["cpu_ms"] = benchmark::Counter(cpu_ms, per_frame);
  state.counters["vertices_ms"] = benchmark::Counter(static_cast<double>(vertices) * 1e-6, per_frame);
  state.counters["triangles_ms"] = benchmark::Counter(static_cast<double>(triangles) * 1e-6, per_frame);
  state.counters["tiles_ms"] = benchmark::Counter(static_cast<double>(tiles) * 1e-6, per_frame);
}

void add(const std::string& scene, const SeriesOptions& options) {
  const std::string name = scene + "/" + std::to_string(options.width) + "x" + std::to_string(options.height) + "/" +
                           std::to_string(options.samples) + "x/" + std::string(raster::name_of(options.kernel)) + "/" +
                           (options.threads == 1 ? "1_thread" : std::to_string(options.threads) + "_threads") + "/" +
                           std::string(kRedrawNames[static_cast<size_t>(options.redraw)]);
  benchmark::RegisterBenchmark(name.c_str(),
                               [scene, options](benchmark::State& state) { time_series(state, scene, options); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

void add_all() {
  for (const char* scene : {"signer_5k", "signer_22k", "signer_90k", "fill", "back_to_front", "tiny"})
    for (const Size& size : sizes_of(scene))
      for (const int samples : {1, 4})
        for (const raster::Kernel kernel : raster::runnable_kernels())
          for (const int threads : {1, 2})
            for (const Redraw redraw : {Redraw::kFull, Redraw::kClean})
              add(scene, {size.width, size.height, samples, kernel, threads, redraw});
  for (const Size& size : sizes_of("signer_22k"))
    for (const int samples : {1, 4})
      for (const raster::Kernel kernel : raster::runnable_kernels())
        for (const Redraw redraw : {Redraw::kArm, Redraw::kStill})
          add("signer_22k", {size.width, size.height, samples, kernel, 1, redraw});
}

}  // namespace
}  // namespace auslan::bench

int main(int argc, char** argv) {
  bool report = false;
  auslan::bench::ReportOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--report") report = true;
    if (argument == "--quick") options.quick = true;
    if (argument == "--json" && i + 1 < argc) options.json = argv[i + 1];
    if (argument == "--pictures" && i + 1 < argc) options.pictures = argv[i + 1];
    if (argument == "--help")
      std::printf(
          "raster_bench --report [--quick] [--json FILE] [--pictures FOLDER]   beside Mesa's drivers, as tables\n"
          "raster_bench [option of Google Benchmark...]                        alone, as below\n\n");
  }
  if (report) return auslan::bench::run_report(options);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  auslan::bench::add_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
