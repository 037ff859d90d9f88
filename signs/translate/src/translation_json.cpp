// SPDX-License-Identifier: Apache-2.0
// Kept apart: the JSON library is large, and nothing else of the translator needs it.
#include "phonology/vocabulary.h"
#include "translate/report.h"

#include <nlohmann/json.hpp>

namespace auslan {

std::string to_json(const Translation& translation) {
  using Json = nlohmann::ordered_json;
  std::vector<std::vector<size_t>> spans_of(translation.items.size());
  for (size_t s = 0; s < translation.non_manual.size(); ++s)
    for (int i = translation.non_manual[s].from; i <= translation.non_manual[s].to; ++i)
      if (i >= 0 && static_cast<size_t>(i) < spans_of.size()) spans_of[static_cast<size_t>(i)].push_back(s);
  Json items = Json::array();
  for (size_t i = 0; i < translation.items.size(); ++i) {
    const Item& item = translation.items[i];
    items.push_back(Json{{"index", i},
                         {"kind", std::string(to_name(item.kind))},
                         {"text", item.text},
                         {"begin", item.begin},
                         {"end", item.end},
                         {"glosses", item.glosses},
                         {"rules", item.rules},
                         {"alternatives", item.alternatives},
                         {"ambiguous", item.ambiguous},
                         {"confidence", std::string(to_name(item.confidence))},
                         {"review", std::string(to_name(item.review))},
                         {"pause_seconds", item.pause_seconds},
                         {"non_manual", spans_of[i]}});
  }
  Json spans = Json::array();
  for (const NonManualSpan& span : translation.non_manual)
    spans.push_back(Json{{"kind", span.kind},
                         {"from", span.from},
                         {"to", span.to},
                         {"brows", span.brows},
                         {"head", span.head},
                         {"gaze", span.gaze},
                         {"mouth", span.mouth},
                         {"eyes", span.eyes},
                         {"ending", span.ending}});
  const Json document{{"english", translation.english},
                      {"items", std::move(items)},
                      {"non_manual", std::move(spans)},
                      {"warnings", translation.warnings}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace auslan
