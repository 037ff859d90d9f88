// SPDX-License-Identifier: Apache-2.0
// Any bytes give a translation whose items cover the text, or an error.
#include "../support/translate_vocabulary.h"
#include "translate/report.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace auslan;
  static const Translator kTranslator = [] {
    TranslatorData known = test::vocabulary();
    known.phrases = {test::phrase("name", "My name is {NAME}.", {"MY", "NAME", "{NAME}"}),
                     test::phrase("take", "Take {NUMBER} {WORD} at {TIME}.", {"{TIME}", "{WORD}", "TAKE", "{NUMBER}"}),
                     test::phrase("where", "Where is the water?", {"WATER", "WHERE"})};
    return std::move(*Translator::build(std::move(known)));
  }();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto result = kTranslator.translate(text);
  if (!result) return 0;
  std::vector<bool> covered(size, false);
  for (const Item& item : result->items) {
    if (item.begin > item.end || item.end > size || item.text != text.substr(item.begin, item.end - item.begin))
      std::abort();
    for (size_t i = item.begin; i < item.end; ++i) {
      if (covered[i]) std::abort();
      covered[i] = true;
    }
  }
  for (size_t i = 0; i < size; ++i) {
    const bool letter =
        (data[i] >= 'a' && data[i] <= 'z') || (data[i] >= 'A' && data[i] <= 'Z') || (data[i] >= '0' && data[i] <= '9');
    if (letter && !covered[i]) std::abort();
  }
  for (const NonManualSpan& span : result->non_manual)
    if (span.from < 0 || span.to < span.from || static_cast<size_t>(span.to) >= result->items.size()) std::abort();
  if (interlinear(*result).empty() || to_json(*result).empty()) std::abort();
  return 0;
}
