// SPDX-License-Identifier: Apache-2.0
#include "translate/audience.h"

#include "region.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace auslan {
namespace {

/// Of an entry's region; none: used in both.
std::optional<Dialect> dialect_of(std::string_view region) {
  constexpr std::array<std::string_view, 3> kNorth = {"north", "nsw", "qld"};
  constexpr std::array<std::string_view, 5> kSouth = {"south", "vic", "tas", "sa", "wa"};
  if (std::ranges::find(kNorth, region) != kNorth.end()) return Dialect::kNorth;
  if (std::ranges::find(kSouth, region) != kSouth.end()) return Dialect::kSouth;
  return std::nullopt;
}

/// How well an entry suits: 0 of the dialect, 1 used everywhere, 2 of the other one.
int distance(const EntryFacts* entry, Dialect dialect) {
  const std::optional<Dialect> own = entry != nullptr ? dialect_of(entry->region) : std::nullopt;
  if (!own) return 1;
  return *own == dialect ? 0 : 2;
}

void prefer(TranslatorData& data, Dialect dialect) {
  std::map<std::string, const EntryFacts*, std::less<>> entries;
  for (const EntryFacts& entry : data.entries)
    entries[entry.gloss] = &entry;
  const auto of = [&](const std::string& gloss) {
    const auto found = entries.find(gloss);
    return distance(found == entries.end() ? nullptr : found->second, dialect);
  };
  // The form of a gloss that suits best among those that differ in their region alone.
  std::map<std::string, std::string, std::less<>> best;
  for (const EntryFacts& entry : data.entries) {
    std::string& form = best[std::string(without_region(entry.gloss))];
    if (form.empty() || of(entry.gloss) < of(form)) form = entry.gloss;
  }
  const auto suited = [&](const std::string& gloss) {
    const auto found = best.find(without_region(gloss));
    return found != best.end() && entries.contains(gloss) && of(found->second) < of(gloss) ? found->second : gloss;
  };
  for (Phrase& phrase : data.phrases)
    for (std::string& gloss : phrase.glosses)
      gloss = suited(gloss);
  // Two forms of a word change places, so that each keeps its word.
  for (Keyword& keyword : data.keywords) {
    const std::string form = suited(keyword.gloss);
    if (form == keyword.gloss) continue;
    const auto other = std::ranges::find_if(data.keywords, [&](const Keyword& one) {
      return one.gloss == form && one.word == keyword.word && one.part_of_speech == keyword.part_of_speech;
    });
    if (other == data.keywords.end())
      keyword.gloss = form;
    else if (other->rank > keyword.rank)
      std::swap(other->rank, keyword.rank);
  }
  std::ranges::stable_sort(data.keywords, {},
                           [](const Keyword& k) { return std::tie(k.word, k.part_of_speech, k.rank); });
}

}  // namespace

std::optional<Dialect> dialect_from_name(std::string_view name) {
  if (name == "north") return Dialect::kNorth;
  if (name == "south") return Dialect::kSouth;
  return std::nullopt;
}

bool is_doubtful(const EntryFacts& entry) {
  return entry.safety_critical && entry.confidence == Confidence::kLow && entry.review != ReviewState::kReviewed;
}

void suit(TranslatorData& data, const Audience& audience) {
  if (audience.dialect) prefer(data, *audience.dialect);
  if (audience.strict) std::erase_if(data.entries, is_doubtful);
}

}  // namespace auslan
