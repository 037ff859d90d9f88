// SPDX-License-Identifier: Apache-2.0
// What `auslanjam bench` says: parts that add up, of the frames, kernel and size that were asked for. How fast anything
// is, no test says.
#include "raster/kernel.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

namespace auslan {
namespace {

constexpr const char* kStages[] = {"animate", "transform", "set_up", "raster", "present"};

Ran bench(const std::string& arguments) {
  return run("env -u DISPLAY '" AUSLANJAM_PROGRAM "' bench --size 160x120 --frames 7 " + arguments + " 2>/dev/null");
}

nlohmann::json bench_json(const std::string& arguments) {
  const Ran ran = bench("--json " + arguments);
  EXPECT_TRUE(ran.ok);
  nlohmann::json json = nlohmann::json::parse(ran.output, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << ran.output;
  return json;
}

TEST(BenchCommand, SaysWhatItMeasured) {
  const nlohmann::json json = bench_json("--aa 2 --threads 2 --kernel scalar Hello");
  EXPECT_EQ(json.at("text"), "Hello");
  EXPECT_EQ(json.at("width"), 160);
  EXPECT_EQ(json.at("height"), 120);
  EXPECT_EQ(json.at("samples"), 2);
  EXPECT_EQ(json.at("threads"), 2);
  EXPECT_EQ(json.at("kernel"), "scalar");
  EXPECT_EQ(json.at("frames"), 7);
  EXPECT_EQ(json.at("present"), "memory");
  EXPECT_GT(json.at("triangles"), 10000);
}

TEST(BenchCommand, StagesAreThePartsOfAFrame) {
  const nlohmann::json json = bench_json("");
  ASSERT_EQ(json.at("stages").size(), std::size(kStages));
  double parts = 0;
  for (const char* stage : kStages) {
    const nlohmann::json& of = json.at("stages").at(stage);
    EXPECT_GE(of.at("min_ms"), 0.0) << stage;
    EXPECT_LE(of.at("min_ms"), of.at("median_ms")) << stage;
    parts += of.at("min_ms").get<double>();
  }
  // Every frame is at least the sum of what each of its parts took at least.
  const double whole = json.at("frame").at("wall").at("min_ms");
  EXPECT_GT(parts, 0.0);
  EXPECT_LE(parts, whole * 1.000001);
  EXPECT_GT(json.at("frame").at("cpu").at("min_ms"), 0.0);
}

TEST(BenchCommand, TakesTheFastestKernelUnlessToldOtherwise) {
  const ScopedVariable unset("AUSLANJAM_KERNEL", nullptr);
  EXPECT_EQ(bench_json("").at("kernel"), raster::name_of(raster::runnable_kernels().back()));
  const ScopedVariable scalar("AUSLANJAM_KERNEL", "scalar");
  EXPECT_EQ(bench_json("").at("kernel"), "scalar");
}

TEST(BenchCommand, RefusesAKernelThatDoesNotRun) {
  EXPECT_FALSE(bench("--kernel abacus").ok);
  const ScopedVariable abacus("AUSLANJAM_KERNEL", "abacus");
  const Ran ran = run("'" AUSLANJAM_PROGRAM "' bench --frames 1 2>&1 >/dev/null");
  EXPECT_FALSE(ran.ok);
  EXPECT_NE(ran.output.find("scalar"), std::string::npos) << "it should name the kernels that run: " << ran.output;
}

TEST(BenchCommand, NamesEveryStageInItsTable) {
  const Ran ran = bench("");
  EXPECT_TRUE(ran.ok);
  for (const char* stage : kStages)
    EXPECT_NE(ran.output.find(stage), std::string::npos) << ran.output;
}

}  // namespace
}  // namespace auslan
