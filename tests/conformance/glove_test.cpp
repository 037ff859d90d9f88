// SPDX-License-Identifier: Apache-2.0
// Signs of the lexicon beside recordings of a native signer (M. W. Kadous' Auslan signs, two gloves with trackers): how
// far they differ, sign by sign, and whether a simple recogniser takes one for the other.
#include "glove.h"

#include "kinematics/elementary.h"
#include "shipped.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace auslan::glove {
namespace {

/// The words of the recordings and the entries that mean the same sign.
constexpr std::array<std::pair<const char*, const char*>, 48> kSigns = {{{"I", "I"},
                                                                         {"alive", "ALIVE"},
                                                                         {"answer", "ANSWER"},
                                                                         {"building", "BUILDING"},
                                                                         {"buy", "BUY"},
                                                                         {"change_mind_", "CHANGE-MIND"},
                                                                         {"computer_PC_", "COMPUTER"},
                                                                         {"crazy", "CRAZY"},
                                                                         {"danger", "DANGER"},
                                                                         {"deaf", "DEAF"},
                                                                         {"different", "DIFFERENT"},
                                                                         {"draw", "DRAW"},
                                                                         {"drink", "DRINK"},
                                                                         {"exit", "EXIT"},
                                                                         {"forget", "FORGET"},
                                                                         {"girl", "GIRL"},
                                                                         {"glove", "GLOVE"},
                                                                         {"happy", "HAPPY"},
                                                                         {"hello", "HELLO"},
                                                                         {"his_hers", "HIS-HER"},
                                                                         {"hot", "HOT"},
                                                                         {"joke", "JOKE"},
                                                                         {"lose", "LOSE"},
                                                                         {"love", "LOVE"},
                                                                         {"make", "MAKE"},
                                                                         {"mine", "MY"},
                                                                         {"money", "MONEY"},
                                                                         {"paper", "PAPER"},
                                                                         {"pen", "PEN"},
                                                                         {"please", "PLEASE"},
                                                                         {"polite", "POLITE"},
                                                                         {"read", "READ"},
                                                                         {"sad", "SAD"},
                                                                         {"share", "SHARE"},
                                                                         {"sorry", "SORRY-NORTH"},
                                                                         {"spend", "SPEND"},
                                                                         {"surprise", "SURPRISE"},
                                                                         {"take", "TAKE"},
                                                                         {"temper", "TEMPER"},
                                                                         {"think", "THINK"},
                                                                         {"tray", "TRAY"},
                                                                         {"us", "WE"},
                                                                         {"wait_notyet_", "NOT-YET"},
                                                                         {"what", "WHAT"},
                                                                         {"where", "WHERE"},
                                                                         {"who", "WHO"},
                                                                         {"wrong", "WRONG"},
                                                                         {"zero", "ZERO"}}};
constexpr double kRate = 25.0;  // what the motion of the recordings suggests; they say 100
constexpr int kSamples = 24;    // of each sign, evenly over its time

/// Signs that stay as they are although the recordings differ, and why.
constexpr std::array<std::pair<const char*, const char*>, 6> kDifferent = {
    {{"deaf", "the recordings go on from the ear to the mouth; dictionaries give the ear alone"},
     {"drink",
      "the recordings tip the cup sideways, which turns the hand before the nose; the mimed cup stands upright"},
     {"hot", "the recordings keep the fingers to the left, for which this figure lifts its elbow to the shoulder"},
     {"make", "the recordings have a flat hand on the other; dictionaries give fists"},
     {"us", "the recordings end with the palm turned out, for which this figure lifts its elbow above the shoulder"},
     {"zero", "photographs show the ring upright; the recordings have it loose, half palm down"}}};

// What counts as a disagreement.
constexpr double kPlaceOff = 0.12;      // metres on the average of the way
constexpr double kDirectionOff = 50.0;  // degrees on the average
constexpr double kBendOff = 0.4;        // of the ranks of all bends, on the average

struct Take {
  std::string name;  ///< the recording's word, or that of the entry
  std::string session;
  std::vector<Frame> frames;  ///< without rest, kSamples of them
  std::array<bool, 2> active{};
  double duration = 0.0;  ///< frames before they were brought to kSamples
};

std::filesystem::path folder() {
  const char* named = std::getenv("AUSLANJAM_SAMPLE_CAPTURE");
  if (named != nullptr) return std::filesystem::path(named) / "glove";
  return std::filesystem::path(AUSLANJAM_SOURCE_DIR) / "../shared/capture/glove";
}

Frame between(const Frame& a, const Frame& b, double share) {
  Frame frame = a;
  for (size_t side = 0; side < 2; ++side) {
    frame[side].place += share * (b[side].place - a[side].place);
    frame[side].fingers += share * (b[side].fingers - a[side].fingers);
    frame[side].palm += share * (b[side].palm - a[side].palm);
    for (size_t i = 0; i < 5; ++i)
      frame[side].bends[i] += share * (b[side].bends[i] - a[side].bends[i]);
  }
  return frame;
}

Take take_of(const std::string& name, const std::string& session, const std::vector<Frame>& all) {
  Take take{name, session, {}, {takes_part(all, Side::kLeft), takes_part(all, Side::kRight)}, 0.0};
  const std::vector<Frame> frames = without_rest(all);
  take.duration = static_cast<double>(frames.size());
  for (int i = 0; i < kSamples; ++i) {
    const double at = static_cast<double>(frames.size() - 1) * i / (kSamples - 1);
    const auto index = std::min(static_cast<size_t>(at), frames.size() - 1);
    take.frames.push_back(
        between(frames[index], frames[std::min(index + 1, frames.size() - 1)], at - static_cast<double>(index)));
  }
  return take;
}

Vec3 mean_place(const std::vector<const Take*>& takes, size_t side) {
  Vec3 sum(0.0);
  double count = 0.0;
  for (const Take* take : takes)
    for (const Frame& frame : take->frames) {
      sum += frame[side].place;
      count += 1.0;
    }
  return count > 0.0 ? sum / count : sum;
}

double spread(const std::vector<const Take*>& takes, size_t side) {
  const Vec3 mean = mean_place(takes, side);
  double sum = 0.0, count = 0.0;
  for (const Take* take : takes)
    for (const Frame& frame : take->frames) {
      const Vec3 off = frame[side].place - mean;
      sum += glm::dot(off, off);
      count += 1.0;
    }
  return std::sqrt(sum / count);
}

/// Recordings and entries in one frame: one shift for each hand of each session, one scale for all.
struct Material {
  std::vector<Take> recordings;
  std::map<std::string, Take> entries;  ///< by the recording's word
  double scale = 1.0;
};

/// Each bend becomes its rank among all of its sensor: 0 the straightest, 1 the most bent.
void rank_bends(const std::vector<Take*>& takes) {
  for (size_t side = 0; side < 2; ++side)
    for (size_t digit = 0; digit < 5; ++digit) {
      std::vector<double> all;
      for (const Take* take : takes)
        for (const Frame& frame : take->frames)
          if (take->active[side]) all.push_back(frame[side].bends[digit]);
      std::ranges::sort(all);
      if (all.empty()) continue;
      for (Take* take : takes)
        for (Frame& frame : take->frames) {
          double& bend = frame[side].bends[digit];
          // The middle of those that are as bent.
          const auto [low, high] = std::equal_range(all.begin(), all.end(), bend);
          bend = (static_cast<double>(low - all.begin()) + static_cast<double>(high - all.begin())) /
                 (2.0 * static_cast<double>(all.size()));
        }
    }
}

const Material* material() {
  static const Material* made = []() -> Material* {
    const auto recorded = read_glove_folder(folder());
    if (!recorded) {
      ADD_FAILURE() << to_string(recorded.error());
      return nullptr;
    }
    auto* all = new Material;
    for (const Recording& recording : *recorded)
      all->recordings.push_back(take_of(recording.word, recording.session, recording.frames));
    for (const auto& [word, gloss] : kSigns)
      all->entries[word] = take_of(word, "", synthesised(gloss, kRate));
    // The same signs on both sides, those in which both sides use the hand.
    double of_recordings = 0.0, of_entries = 0.0;
    std::map<std::pair<std::string, size_t>, Vec3> shifts;
    std::set<std::string> sessions;
    for (const Take& take : all->recordings)
      sessions.insert(take.session);
    for (const std::string& session : sessions)
      for (size_t side = 0; side < 2; ++side) {
        std::vector<const Take*> ours, theirs;
        for (const Take& take : all->recordings) {
          const auto entry = all->entries.find(take.name);
          if (take.session != session || entry == all->entries.end()) continue;
          if (!take.active[side] || !entry->second.active[side]) continue;
          theirs.push_back(&take);
          ours.push_back(&entry->second);
        }
        if (ours.empty()) continue;
        shifts[{session, side}] = mean_place(ours, side) - mean_place(theirs, side);
        if (side == static_cast<size_t>(Side::kRight)) {
          of_recordings += spread(theirs, side);
          of_entries += spread(ours, side);
        }
      }
    all->scale = of_entries / of_recordings;
    for (Take& take : all->recordings)
      for (Frame& frame : take.frames)
        for (size_t side = 0; side < 2; ++side)
          frame[side].place += shifts[{take.session, side}];
    std::vector<Take*> takes;
    for (Take& take : all->recordings)
      takes.push_back(&take);
    rank_bends(takes);
    takes.clear();
    for (auto& [word, take] : all->entries)
      takes.push_back(&take);
    rank_bends(takes);
    return all;
  }();
  return made;
}

// What is as far apart as another: a hand's breadth, half a right angle, a third of all bends.
constexpr double kPlaceUnit = 0.08, kDirectionUnit = 0.77, kBendUnit = 0.33;
// One hand rests and the other takes part.
constexpr double kOtherHandSet = 6.0;

double square(const Vec3& v) {
  return glm::dot(v, v);
}

/// Of two frames; the left hand counts where it takes part in both.
double cost(const Frame& a, const Frame& b, const std::array<bool, 2>& both) {
  double sum = 0.0;
  for (size_t side = 0; side < 2; ++side) {
    if (!both[side]) continue;
    const Hand &one = a[side], &two = b[side];
    sum += square(one.place - two.place) / (kPlaceUnit * kPlaceUnit);
    sum += (square(one.fingers - two.fingers) + square(one.palm - two.palm)) / (kDirectionUnit * kDirectionUnit);
    // The thumb's bend says little of where it is.
    for (size_t digit = 1; digit < 5; ++digit) {
      const double off = (one.bends[digit] - two.bends[digit]) / kBendUnit;
      sum += 0.25 * off * off;
    }
  }
  return sum;
}

/// Dynamic time warping within a band of a quarter of the sign; the pairs of the best way, and its mean cost.
struct Warp {
  double cost = 0.0;
  std::vector<std::pair<size_t, size_t>> pairs;
};
Warp warped(const Take& a, const Take& b) {
  constexpr size_t n = kSamples;
  constexpr double kFar = 1e18;
  constexpr size_t kBand = n / 4;
  const std::array<bool, 2> both = {a.active[0] && b.active[0], a.active[1] && b.active[1]};
  std::array<std::array<double, n + 1>, n + 1> sum;
  for (auto& row : sum)
    row.fill(kFar);
  sum[0][0] = 0.0;
  for (size_t i = 1; i <= n; ++i)
    for (size_t j = i > kBand ? i - kBand : 1; j <= std::min(n, i + kBand); ++j)
      sum[i][j] =
          cost(a.frames[i - 1], b.frames[j - 1], both) + std::min({sum[i - 1][j - 1], sum[i - 1][j], sum[i][j - 1]});
  Warp warp;
  for (size_t i = n, j = n; i > 0 && j > 0;) {
    warp.pairs.emplace_back(i - 1, j - 1);
    const double diagonal = sum[i - 1][j - 1], up = sum[i - 1][j], left = sum[i][j - 1];
    if (diagonal <= up && diagonal <= left) {
      --i;
      --j;
    } else if (up <= left) {
      --i;
    } else {
      --j;
    }
  }
  warp.cost = sum[n][n] / static_cast<double>(warp.pairs.size());
  for (size_t side = 0; side < 2; ++side)
    if (a.active[side] != b.active[side]) warp.cost += kOtherHandSet;
  return warp;
}

double degrees_between(const Vec3& a, const Vec3& b) {
  const double size = std::sqrt(square(a) * square(b));
  return size > 0.0 ? arc_cosine(std::clamp(glm::dot(a, b) / size, -1.0, 1.0)) / kDegree : 0.0;
}

/// The mean over the warped pairs, as text of a table.
struct Difference {
  double place = 0.0, fingers = 0.0, palm = 0.0, bends = 0.0;  ///< metres, degrees, degrees, share of the ranks
  Vec3 off{0.0};                                               ///< of the entry from the recording, metres
};
Difference difference(const Take& entry, const Take& recording, size_t side) {
  Difference mean;
  const Warp warp = warped(entry, recording);
  const double share = 1.0 / static_cast<double>(warp.pairs.size());
  for (const auto& [i, j] : warp.pairs) {
    const Hand &one = entry.frames[i][side], &two = recording.frames[j][side];
    mean.place += share * std::sqrt(square(one.place - two.place));
    mean.off += share * (one.place - two.place);
    mean.fingers += share * degrees_between(one.fingers, two.fingers);
    mean.palm += share * degrees_between(one.palm, two.palm);
    for (size_t digit = 1; digit < 5; ++digit)
      mean.bends += share * 0.25 * std::abs(one.bends[digit] - two.bends[digit]);
  }
  return mean;
}

#define AUSLAN_NEEDS_GLOVES() \
  if (!std::filesystem::exists(folder())) GTEST_SKIP() << "the recordings are not there: " << folder()

TEST(Glove, HostileRowsAreRefusedWithTheirPlace) {
  const std::string row = "0\t0\t0\t.5\t.5\t.5\t0\t0\t0\t0\t0\t0\t0\t0\t.5\t.5\t.5\t1\t1\t1\t1\t1";
  EXPECT_EQ(parse_glove(row + "\n" + row + "\n", "f")->size(), 2U);
  for (const std::string& bad : {row + "\n1 2 3", row + "\n" + row + " 7", row + "\n" + row.substr(1) + "x",
                                 row + "\nnan" + row.substr(1), row + "\n1e999" + row.substr(1)}) {
    const auto frames = parse_glove(bad, "f");
    ASSERT_FALSE(frames) << bad;
    EXPECT_EQ(frames.error().place, "f:2");
  }
  EXPECT_FALSE(parse_glove("", "f"));
}

TEST(Glove, AnglesAreReadAsTheyAreDescribed) {
  const auto hands = [](const std::string& roll, const std::string& pitch, const std::string& yaw) {
    const std::string hand = "0.1 0.2 0.3 " + roll + " " + pitch + " " + yaw + " 0 0 0 0 0 ";
    return parse_glove(hand + hand, "f").value()[0];
  };
  const auto near = [](const Vec3& a, const Vec3& b) { return square(a - b) < 1e-12; };
  const auto side = static_cast<size_t>(Side::kRight);
  const Hand level = hands(".5", ".5", ".5")[side];
  EXPECT_TRUE(near(level.fingers, {0, 0, 1}));
  EXPECT_TRUE(near(level.palm, {0, -1, 0}));
  EXPECT_TRUE(near(level.place, {-0.1, 0.2, -0.3}));
  EXPECT_TRUE(near(hands(".5", "1", ".5")[side].fingers, {0, 1, 0})) << "pitch + is fingers up";
  EXPECT_TRUE(near(hands(".5", ".5", ".75")[side].fingers, {1, 0, 0})) << "yaw + is to the left";
  EXPECT_TRUE(near(hands(".25", ".5", ".5")[side].palm, {1, 0, 0})) << "a right hand supinates with roll -";
  EXPECT_TRUE(near(hands(".75", ".5", ".5")[0].palm, {-1, 0, 0})) << "a left hand with roll +";
}

TEST(Glove, TheSignersOwnSessionsAreToldApart) {
  AUSLAN_NEEDS_GLOVES();
  const Material* all = material();
  ASSERT_NE(all, nullptr);
  int first = 0;
  for (const Take& query : all->recordings) {
    const Take* best = nullptr;
    double least = 1e18;
    for (const Take& other : all->recordings) {
      if (other.session == query.session) continue;
      const double found = warped(query, other).cost;
      if (found >= least) continue;
      least = found;
      best = &other;
    }
    if (best != nullptr && best->name == query.name) ++first;
  }
  std::printf("%zu recordings against the other sessions: the same sign is nearest for %d\n", all->recordings.size(),
              first);
  EXPECT_GE(first, static_cast<int>(0.9 * static_cast<double>(all->recordings.size())));
}

TEST(Glove, EntriesAreTakenForTheRecordedSigns) {
  AUSLAN_NEEDS_GLOVES();
  const Material* all = material();
  ASSERT_NE(all, nullptr);
  int first = 0, among_five = 0;
  std::printf("Rank of the recorded sign among 48, and what is nearer (one scale for all would be %.2f)\n", all->scale);
  for (const auto& [word, gloss] : kSigns) {
    const Take& entry = all->entries.at(word);
    std::map<std::string, double> nearest;
    for (const Take& recording : all->recordings) {
      const double found = warped(entry, recording).cost;
      const auto [at, fresh] = nearest.emplace(recording.name, found);
      if (!fresh) at->second = std::min(at->second, found);
    }
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, distance] : nearest)
      order.emplace_back(distance, name);
    std::ranges::sort(order);
    const auto rank =
        std::ranges::find(order, std::string(word), &std::pair<double, std::string>::second) - order.begin() + 1;
    if (rank == 1) ++first;
    if (rank <= 5) ++among_five;
    std::printf("  %-14s %-12s %2td %.1f", word, gloss, rank, nearest[word]);
    for (std::ptrdiff_t i = 0; i < std::min<std::ptrdiff_t>(rank - 1, 3); ++i)
      std::printf("  %s %.1f", order[static_cast<size_t>(i)].second.c_str(), order[static_cast<size_t>(i)].first);
    std::printf("\n");
  }
  std::printf("%d of 48 first, %d among the first five\n", first, among_five);
  EXPECT_GE(first, 29) << "60 %";
  EXPECT_GE(among_five, 41) << "85 %";
}

TEST(Glove, ReportOfEachSign) {
  AUSLAN_NEEDS_GLOVES();
  const Material* all = material();
  ASSERT_NE(all, nullptr);
  std::printf(
      "Mean over the three recordings of each sign, hand by hand, after one shift for each hand of each session.\n"
      "place cm (off to the left, up, away), fingers and palm degrees, bends in ranks, time as a share of the "
      "recorded; ! place over %.0f cm, direction over %.0f degrees, bends over %.1f\n",
      kPlaceOff * 100, kDirectionOff, kBendOff);
  int disagree = 0;
  for (const auto& [word, gloss] : kSigns) {
    const Take& entry = all->entries.at(word);
    std::vector<const Take*> recordings;
    for (const Take& recording : all->recordings)
      if (recording.name == word) recordings.push_back(&recording);
    ASSERT_FALSE(recordings.empty()) << word;
    bool off = false;
    std::string line;
    double duration = 0.0;
    for (const Take* recording : recordings)
      duration += recording->duration / static_cast<double>(recordings.size());
    for (const size_t side : {static_cast<size_t>(Side::kRight), static_cast<size_t>(Side::kLeft)}) {
      size_t using_it = 0;
      for (const Take* recording : recordings)
        using_it += recording->active[side] ? 1U : 0U;
      const bool used = 2 * using_it > recordings.size();
      const char* name = side == static_cast<size_t>(Side::kRight) ? "right" : "left";
      if (used != entry.active[side]) {
        line += std::string("  ") + name + (used ? " recorded only!" : " in the entry only!");
        off = true;
        continue;
      }
      if (!used) continue;
      Difference mean;
      const double share = 1.0 / static_cast<double>(recordings.size());
      for (const Take* recording : recordings) {
        const Difference one = difference(entry, *recording, side);
        mean.place += share * one.place;
        mean.off += share * one.off;
        mean.fingers += share * one.fingers;
        mean.palm += share * one.palm;
        mean.bends += share * one.bends;
      }
      const bool place_off = square(mean.off) > kPlaceOff * kPlaceOff;
      const bool bends_off = mean.bends > kBendOff;
      const bool direction_off = mean.fingers > kDirectionOff || mean.palm > kDirectionOff;
      off = off || place_off || direction_off || bends_off;
      char text[160];
      std::snprintf(text, sizeof text, "  %s place %4.1f%s (%+.0f %+.0f %+.0f) fingers %3.0f palm %3.0f%s bends %.2f%s",
                    name, mean.place * 100, place_off ? "!" : "", mean.off.x * 100, mean.off.y * 100, mean.off.z * 100,
                    mean.fingers, mean.palm, direction_off ? "!" : "", mean.bends, bends_off ? "!" : "");
      line += text;
    }
    if (off) {
      ++disagree;
      const auto reason =
          std::ranges::find(kDifferent, std::string(word), [](const auto& one) { return std::string(one.first); });
      EXPECT_NE(reason, kDifferent.end()) << word << " differs from its recordings without a reason";
      if (reason != kDifferent.end()) line += std::string("  (") + reason->second + ")";
    }
    std::printf("%c %-14s time %.1f%s\n", off ? '!' : ' ', word, entry.duration / duration, line.c_str());
  }
  std::printf("%d of 48 disagree in place, direction or the hands that take part\n", disagree);
}

}  // namespace
}  // namespace auslan::glove
