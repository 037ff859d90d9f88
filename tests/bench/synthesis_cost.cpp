// SPDX-License-Identifier: Apache-2.0
// synthesis_cost sentence TIMES: a sentence of eleven signs and letters, synthesised so often, for synthesis.sh to
// count. synthesis_cost corpora: every sign of the development sample by itself; prints the slowest, in processor time.
#include "corpora.h"
#include "notation/notation.h"
#include "shipped.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace auslan {
namespace {

/// Of all that the hands do: the same for the same motion.
uint64_t digest(const Score& score) {
  uint64_t sum = 14695981039346656037ULL;
  const auto add = [&sum](const auto& value) {
    unsigned char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    for (const unsigned char byte : bytes)
      sum = (sum ^ byte) * 1099511628211ULL;
  };
  const auto add_vector = [&add](const Vec3& v) {
    add(v.x);
    add(v.y);
    add(v.z);
  };
  for (const auto& track : score.hands) {
    for (const HandSegment& segment : track) {
      add(segment.begin);
      add(segment.end);
      add_vector(segment.bulge);
      add(segment.swivel_bulge);
      for (const HandState& state : {segment.from, segment.to}) {
        add_vector(state.wrist.position);
        add_vector({state.wrist.rotation.x, state.wrist.rotation.y, state.wrist.rotation.z});
        add(state.swivel);
      }
    }
  }
  return sum;
}

int sentence(int times) {
  const Utterance utterance =
      utterance_of({"HELLO", "MY", "NAME", "fs:S", "fs:A", "fs:M", "I", "NEED", "DOCTOR", "WHERE", "HURT"});
  uint64_t found = 0;
  for (int i = 0; i < times; ++i)
    found = digest(choreograph(*shipped().signer, utterance).value());
  std::printf("%016llx\n", static_cast<unsigned long long>(found));
  return 0;
}

/// Of this process, seconds.
double processor_time() {
  std::timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

int corpora(const std::string& only) {
  struct Cost {
    double seconds = 0.0;
    std::string name;
    uint64_t digest = 0;
  };
  std::vector<Cost> costs;
  shipped();
  for (const char* dictionary : {"bsl", "isl", "ngt"}) {
    for (const auto& file : testing::sigml_files(dictionary)) {
      const auto signs = read_sigml(file);
      for (const NotatedSign& notated : signs.value()) {
        Cost cost{1e9, std::string(dictionary) + " " + notated.sign.gloss};
        if (!notated.signable || (!only.empty() && cost.name != only)) continue;
        Utterance utterance;
        Unit unit;
        unit.sign = notated.sign;
        unit.label = notated.sign.gloss;
        utterance.units.push_back(std::move(unit));
        utterance.sentences = {""};
        for (const Handshape& shape : notated.handshapes)
          utterance.handshapes.emplace(shape.id, shape);
        // The least of three: what else the machine does makes a run longer, never shorter.
        for (int run = 0; run < (only.empty() ? 3 : 1); ++run) {
          const double begin = processor_time();
          cost.digest = digest(choreograph(*shipped().signer, utterance).value());
          cost.seconds = std::min(cost.seconds, processor_time() - begin);
        }
        costs.push_back(std::move(cost));
      }
    }
  }
  std::stable_sort(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.seconds > b.seconds; });
  double total = 0.0;
  uint64_t all = 0;
  for (const Cost& cost : costs) {
    total += cost.seconds;
    all += cost.digest;
  }
  for (size_t i = 0; i < costs.size() && i < 10; ++i)
    std::printf("%7.2f ms  %s\n", 1e3 * costs[i].seconds, costs[i].name.c_str());
  std::printf("%7.2f ms  mean of %zu signs, %016llx\n", 1e3 * total / static_cast<double>(costs.size()), costs.size(),
              static_cast<unsigned long long>(all));
  return costs.empty() ? 77 : 0;
}

}  // namespace
}  // namespace auslan

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    if (what == "sentence" && argc == 3) return auslan::sentence(std::atoi(argv[2]));
    if (what == "corpora" && argc <= 3) return auslan::corpora(argc == 3 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "synthesis_cost: %s; build auslan_baked_figure and auslan_built_lexicon\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: synthesis_cost sentence TIMES | corpora [\"DICTIONARY SIGN\"]\n");
  return 2;
}
