// SPDX-License-Identifier: Apache-2.0
#include "synthesis/utterance.h"

#include "stroke.h"

#include <algorithm>
#include <utility>

namespace auslan {
namespace {

Result<void> add_handshapes(const std::vector<Posture>& postures, const HandshapeSource& source, Utterance& utterance) {
  for (const Posture& posture : postures) {
    if (utterance.handshapes.count(posture.handshape) > 0) continue;
    auto shape = source(posture.handshape);
    if (!shape) return tl::unexpected(shape.error());
    if (!*shape)
      return fail(ErrorCode::kNotFound, "the database has no handshape \"" + posture.handshape + "\"; rebuild it");
    utterance.handshapes.emplace(posture.handshape, std::move(**shape));
  }
  return {};
}

/// The sentence of each item, and the English of each sentence: the text from its first word to the next one's.
std::vector<int> split_sentences(const Translation& translation, std::vector<std::string>& sentences) {
  std::vector<int> of_item;
  std::vector<size_t> begins;
  bool open = false;
  for (const Item& item : translation.items) {
    if (item.kind == ItemKind::kPause) {
      if (item.pause_seconds >= stroke::kSentencePause) open = false;
    } else {
      if (!open) begins.push_back(std::string::npos);
      open = true;
      if (!item.text.empty()) begins.back() = std::min(begins.back(), item.begin);
    }
    of_item.push_back(std::max(0, static_cast<int>(begins.size()) - 1));
  }
  if (begins.empty()) begins.push_back(0);
  size_t next = translation.english.size();
  sentences.assign(begins.size(), {});
  for (size_t i = begins.size(); i-- > 0;) {
    const size_t begin = std::min(begins[i], next);
    std::string text = translation.english.substr(begin, next - begin);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\n' || text.back() == '\t' || text.back() == '\r'))
      text.pop_back();
    sentences[i] = std::move(text);
    next = begin;
  }
  return of_item;
}

}  // namespace

Result<Utterance> compose(const Translation& translation, const SignSource& signs, const HandshapeSource& handshapes) {
  Utterance utterance;
  std::vector<std::pair<int, int>> units_of_item;  // first and last unit; first > last where there is none
  const std::vector<int> sentence_of = split_sentences(translation, utterance.sentences);
  for (size_t index = 0; index < translation.items.size(); ++index) {
    const Item& item = translation.items[index];
    const int first = static_cast<int>(utterance.units.size());
    if (item.kind == ItemKind::kPause) {
      Unit pause;
      pause.pause_seconds = item.pause_seconds;
      pause.sentence = sentence_of[index];
      utterance.units.push_back(std::move(pause));
    } else if (item.kind != ItemKind::kDropped) {
      for (size_t i = 0; i < item.glosses.size(); ++i) {
        const std::string& gloss = item.glosses[i];
        auto sign = signs(gloss);
        if (!sign) return tl::unexpected(sign.error());
        if (!*sign)
          return fail(ErrorCode::kNotFound, "the database has no entry " + gloss + "; list them with `db list`");
        Unit unit;
        unit.sign = std::move(**sign);
        unit.sentence = sentence_of[index];
        unit.spelled = item.kind == ItemKind::kSpelled;
        unit.first_of_word = i == 0;
        unit.label = unit.spelled ? item.text : gloss;
        if (unit.spelled) {
          if (i == 0) unit.word_letters = static_cast<int>(item.glosses.size());
          if (i == 0) unit.mouthing = item.text;
        } else {
          unit.mouthing = unit.sign->non_manual.mouthing;
        }
        unit.reviewed = unit.sign->provenance.review == ReviewState::kReviewed;
        utterance.all_reviewed = utterance.all_reviewed && unit.reviewed;
        for (const auto* postures : {&unit.sign->dominant, &unit.sign->non_dominant})
          if (const auto added = add_handshapes(*postures, handshapes, utterance); !added)
            return tl::unexpected(added.error());
        utterance.units.push_back(std::move(unit));
      }
    }
    units_of_item.emplace_back(first, static_cast<int>(utterance.units.size()) - 1);
  }
  for (const NonManualSpan& span : translation.non_manual) {
    if (span.from < 0 || span.to < span.from || static_cast<size_t>(span.to) >= units_of_item.size()) continue;
    NonManualSpan mapped = span;
    mapped.from = units_of_item[static_cast<size_t>(span.from)].first;
    mapped.to = units_of_item[static_cast<size_t>(span.to)].second;
    if (mapped.from <= mapped.to) utterance.non_manual.push_back(std::move(mapped));
  }
  return utterance;
}

Translation translation_of_glosses(const std::vector<std::string>& glosses) {
  Translation translation;
  for (const std::string& gloss : glosses) {
    Item item;
    item.glosses = {gloss};
    item.text = gloss;
    item.rules = {"gloss:given"};
    translation.english += (translation.english.empty() ? "" : " ") + gloss;
    translation.items.push_back(std::move(item));
  }
  return translation;
}

}  // namespace auslan
