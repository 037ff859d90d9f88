// SPDX-License-Identifier: Apache-2.0
// `db`: the lexicon, listed, shown, searched and checked.
#include "commands.h"
#include "phonology/vocabulary.h"
#include "session.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

std::string dump(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string padded(std::string_view text, size_t width) {
  std::string out(text);
  if (out.size() < width) out.append(width - out.size(), ' ');
  return out + "  ";
}

Json summary_json(const SignSummary& entry) {
  return {{"gloss", entry.gloss},
          {"kind", entry.kind},
          {"category", entry.category},
          {"region", entry.region},
          {"hands", to_name(entry.handedness)},
          {"confidence", to_name(entry.confidence)},
          {"review", to_name(entry.review)},
          {"definition", entry.definition}};
}

std::string summary_line(const SignSummary& entry) {
  return padded(entry.gloss, 18) + padded(entry.kind, 6) + padded(entry.category, 12) + padded(entry.region, 8) +
         padded(to_name(entry.confidence), 6) + padded(to_name(entry.review), 10) + entry.definition + "\n";
}

Json posture_json(const Posture& posture) {
  Json json = {{"handshape", posture.handshape},
               {"fingers", to_name(posture.fingers)},
               {"palm", to_name(posture.palm)},
               {"location", to_name(posture.location)},
               {"offset_m", {posture.offset.x, posture.offset.y, posture.offset.z}}};
  if (posture.contact) {
    Json contact = {{"kind", to_name(posture.contact->kind)}};
    if (posture.contact->part) contact["part"] = to_name(*posture.contact->part);
    if (posture.contact->target) contact["target"] = to_name(*posture.contact->target);
    json["contact"] = contact;
  }
  return json;
}

Json sign_json(const Sign& sign, const std::vector<Keyword>& keywords) {
  Json json = {{"gloss", sign.gloss},           {"kind", sign.kind},
               {"category", sign.category},     {"region", sign.region},
               {"definition", sign.definition}, {"hands", to_name(sign.handedness)}};
  json["english"] = Json::array();
  for (const Keyword& keyword : keywords)
    if (keyword.gloss == sign.gloss)
      json["english"].push_back(
          {{"word", keyword.word}, {"part_of_speech", keyword.part_of_speech}, {"rank", keyword.rank}});
  json["dominant"] = Json::array();
  for (const Posture& posture : sign.dominant)
    json["dominant"].push_back(posture_json(posture));
  json["non_dominant"] = Json::array();
  for (const Posture& posture : sign.non_dominant)
    json["non_dominant"].push_back(posture_json(posture));
  json["movements"] = Json::array();
  for (const Movement& movement : sign.movements) {
    Json move = {
        {"kind", to_name(movement.kind)},     {"from", movement.from},           {"to", movement.to},
        {"size", to_name(movement.size)},     {"repeats", movement.repeats},     {"hands", to_name(movement.hands)},
        {"manner", to_name(movement.manner)}, {"plane", to_name(movement.plane)}};
    if (movement.direction) move["direction"] = to_name(*movement.direction);
    json["movements"].push_back(move);
  }
  const NonManual& face = sign.non_manual;
  json["non_manual"] = {{"brows", face.brows},   {"eyes", face.eyes}, {"mouth", face.mouth},
                        {"cheeks", face.cheeks}, {"head", face.head}, {"shoulders", face.shoulders},
                        {"gaze", face.gaze},     {"face", face.face}, {"mouthing", face.mouthing}};
  const Provenance& from = sign.provenance;
  json["safety_critical"] = sign.safety_critical;
  json["reviews"] = Json::array();
  for (const Review& review : sign.provenance.history)
    json["reviews"].push_back({{"by", review.by},
                               {"on", review.on},
                               {"verdict", to_name(review.verdict)},
                               {"remark", review.remark},
                               {"content", review.content}});
  json["provenance"] = {{"sources", from.sources},
                        {"form_evidence", from.form_evidence},
                        {"movement_evidence", from.movement_evidence},
                        {"confidence", to_name(from.confidence)},
                        {"review", to_name(from.review)},
                        {"reviewed_by", from.reviewed_by},
                        {"reviewed_on", from.reviewed_on}};
  return json;
}

std::string posture_line(const char* hand, size_t phase, const Posture& posture) {
  std::string line = "  " + std::string(hand) + " " + std::to_string(phase) + ": " + posture.handshape + ", fingers " +
                     to_name(posture.fingers) + ", palm " + to_name(posture.palm) + ", at " +
                     std::string(to_name(posture.location));
  if (posture.contact) {
    line += ", " + std::string(to_name(posture.contact->kind));
    if (posture.contact->part) line += " with " + std::string(to_name(*posture.contact->part));
    if (posture.contact->target) line += " on " + std::string(to_name(*posture.contact->target));
  }
  return line + "\n";
}

std::string sign_text(const Sign& sign, const std::vector<Keyword>& keywords) {
  std::string text = sign.gloss + " (" + sign.kind + (sign.category.empty() ? "" : ", " + sign.category) + ")\n";
  if (!sign.definition.empty()) text += "  " + sign.definition + "\n";
  std::string english;
  for (const Keyword& keyword : keywords)
    if (keyword.gloss == sign.gloss)
      english += (english.empty() ? "" : ", ") + keyword.word +
                 (keyword.part_of_speech.empty() ? "" : " (" + keyword.part_of_speech + ")");
  if (!english.empty()) text += "  English: " + english + "\n";
  text += "  region: " + sign.region + "; hands: " + std::string(to_name(sign.handedness)) + "\n";
  for (size_t i = 0; i < sign.dominant.size(); ++i)
    text += posture_line("dominant", i, sign.dominant[i]);
  for (size_t i = 0; i < sign.non_dominant.size(); ++i)
    text += posture_line("non-dominant", i, sign.non_dominant[i]);
  for (const Movement& movement : sign.movements) {
    text += "  movement: " + std::string(to_name(movement.kind)) + ", " + std::string(to_name(movement.size));
    if (movement.direction) text += ", " + to_name(*movement.direction);
    if (movement.repeats > 1) text += ", " + std::to_string(movement.repeats) + " times";
    text += movement.from == movement.to
                ? " at " + std::to_string(movement.from)
                : " from " + std::to_string(movement.from) + " to " + std::to_string(movement.to);
    text += "\n";
  }
  if (!sign.non_manual.mouthing.empty()) text += "  mouthing: " + sign.non_manual.mouthing + "\n";
  const Provenance& from = sign.provenance;
  if (sign.safety_critical) text += "  safety-critical: spelled in strict mode while it is doubtful\n";
  text += "  confidence: " + std::string(to_name(from.confidence)) + "; review: " + std::string(to_name(from.review));
  if (!from.reviewed_by.empty()) text += " by " + from.reviewed_by + " on " + from.reviewed_on;
  for (const Review& review : from.history)
    text += "\n  " + std::string(to_name(review.verdict)) + " by " + review.by + " on " + review.on +
            (review.remark.empty() ? "" : ": " + review.remark);
  text +=
      "\n  form rests on: " + from.form_evidence + "\n  movement rests on: " + from.movement_evidence + "\n  sources:";
  for (const std::string& source : from.sources)
    text += " " + source;
  return text + "\n";
}

Result<void> list(const Options& options, const Lexicon& lexicon) {
  ListFilter filter;
  filter.kind = options.kind;
  filter.category = options.category;
  filter.region = options.region;
  filter.handshape = options.handshape;
  if (!options.handshape.empty()) {
    const auto shape = lexicon.handshape(options.handshape);
    if (!shape) return tl::unexpected(shape.error());
    if (!*shape)
      return fail(ErrorCode::kUsage, "--handshape: there is no handshape \"" + options.handshape +
                                         "\"; they are named in assets/lexicon/handshapes.toml");
  }
  const auto read_word = [](const std::string& option, const std::string& word, auto& value) -> Result<void> {
    if (word.empty()) return {};
    using Word = typename std::remove_reference_t<decltype(value)>::value_type;
    value = from_name<Word>(word);
    if (value) return {};
    std::string all;
    for (const std::string_view name : names_of<Word>())
      (all += all.empty() ? "" : ", ") += name;
    return fail(ErrorCode::kUsage, option + ": there is no \"" + word + "\"; expected one of " + all);
  };
  if (auto good = read_word("--at", options.place, filter.location); !good) return good;
  if (auto good = read_word("--hands", options.hands, filter.handedness); !good) return good;
  if (auto good = read_word("--movement", options.movement, filter.movement); !good) return good;
  if (auto good = read_word("--review", options.review, filter.review); !good) return good;
  const auto entries = lexicon.list(filter);
  if (!entries) return tl::unexpected(entries.error());
  if (options.json) {
    Json json = Json::array();
    for (const SignSummary& entry : *entries)
      json.push_back(summary_json(entry));
    return print(dump(json));
  }
  std::string text;
  for (const SignSummary& entry : *entries)
    text += summary_line(entry);
  if (auto printed = print(text); !printed) return printed;
  remark(options, std::to_string(entries->size()) + " entries");
  return {};
}

Result<void> show(const Options& options, const Lexicon& lexicon) {
  Json json = Json::array();
  std::string text;
  for (const std::string& word : options.words) {
    std::string gloss = word;
    std::transform(gloss.begin(), gloss.end(), gloss.begin(),
                   [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); });
    auto sign = lexicon.sign(gloss);
    // Letters and numbers by their plain names, and what was typed as it stands.
    for (const std::string& other : {word, "fs:" + gloss, "num:" + gloss})
      if (sign && !*sign) sign = lexicon.sign(other);
    if (!sign) return tl::unexpected(sign.error());
    if (!*sign)
      return fail(ErrorCode::kNotFound,
                  "there is no entry " + gloss + "; look for one with `auslanjam db search WORD`");
    json.push_back(sign_json(**sign, lexicon.keywords()));
    text += sign_text(**sign, lexicon.keywords());
  }
  return print(options.json ? dump(json) : text);
}

Result<void> search(const Options& options, const Lexicon& lexicon) {
  std::string words;
  for (const std::string& word : options.words)
    words += (words.empty() ? "" : " ") + word;
  const auto hits = lexicon.search(words);
  if (!hits) return tl::unexpected(hits.error());
  if (options.json) {
    Json json = Json::array();
    for (const SearchHit& hit : *hits) {
      Json entry = summary_json(hit.sign);
      entry["matched"] = hit.matched;
      entry["rank"] = hit.rank;
      json.push_back(entry);
    }
    return print(dump(json));
  }
  std::string text;
  for (const SearchHit& hit : *hits)
    text += summary_line(hit.sign);
  if (auto printed = print(text); !printed) return printed;
  remark(options, hits->empty() ? "nothing found for \"" + words + "\"; it would be fingerspelled"
                                : std::to_string(hits->size()) + " found");
  return {};
}

std::string counted(const std::map<std::string, int>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + name;
  return text;
}

std::string evidence_text(const LexiconCounts& counts) {
  return "movement rests on: " + counted(counts.movement_evidence) + "\n";
}

Result<void> stats(const Options& options, const Lexicon& lexicon) {
  const auto counts = lexicon.counts();
  if (!counts) return tl::unexpected(counts.error());
  if (options.json)
    return print(dump({{"handshapes", counts->handshapes},
                       {"base_handshapes", counts->base_handshapes},
                       {"core_handshapes", counts->core_handshapes},
                       {"signs", counts->signs},
                       {"letters", counts->letters},
                       {"numbers", counts->numbers},
                       {"keywords", counts->keywords},
                       {"phrases", counts->phrases},
                       {"safety_critical", counts->safety_critical},
                       {"reviewed", counts->reviewed},
                       {"rejected", counts->rejected},
                       {"regions", counts->regions},
                       {"confidence", counts->confidences},
                       {"movement_evidence", counts->movement_evidence},
                       {"sources", counts->sources}}));
  return print(std::to_string(counts->handshapes) + " handshapes: " + std::to_string(counts->base_handshapes) +
               " base (" + std::to_string(counts->core_handshapes) + " core) and their variants\n" +
               std::to_string(counts->letters) + " letters, " + std::to_string(counts->numbers) + " numbers, " +
               std::to_string(counts->signs) + " signs (" + std::to_string(counts->safety_critical) +
               " safety-critical), " + std::to_string(counts->phrases) + " phrases, " +
               std::to_string(counts->keywords) + " English keywords\n" + std::to_string(counts->reviewed) +
               " reviewed by a Deaf signer, " + std::to_string(counts->rejected) +
               " rejected\nregion: " + counted(counts->regions) + "\nconfidence: " + counted(counts->confidences) +
               "\n" + evidence_text(*counts) + "sources named: " + counted(counts->sources) + "\n");
}

Result<void> check(const Options& options, const Lexicon& lexicon) {
  const auto findings = lexicon.check();
  const auto counts = lexicon.counts();
  if (!counts) return tl::unexpected(counts.error());
  if (options.json) {
    Json json;
    json["handshapes"] = counts->handshapes;
    json["signs"] = counts->signs;
    json["letters"] = counts->letters;
    json["numbers"] = counts->numbers;
    json["keywords"] = counts->keywords;
    json["phrases"] = counts->phrases;
    json["reviewed"] = counts->reviewed;
    json["rejected"] = counts->rejected;
    json["movement_evidence"] = counts->movement_evidence;
    json["findings"] = Json::array();
    for (const Finding& finding : findings)
      json["findings"].push_back({{"entry", finding.entry}, {"part", finding.part}, {"message", finding.message}});
    if (auto printed = print(dump(json)); !printed) return printed;
  } else {
    std::string text;
    for (const Finding& finding : findings)
      text += finding.entry + (finding.part.empty() ? "" : " " + finding.part) + ": " + finding.message + "\n";
    text += std::to_string(counts->handshapes) + " handshapes, " + std::to_string(counts->signs) + " signs, " +
            std::to_string(counts->letters) + " letters, " + std::to_string(counts->numbers) + " numbers, " +
            std::to_string(counts->keywords) + " keywords, " + std::to_string(counts->phrases) + " phrases; " +
            std::to_string(counts->reviewed) + " reviewed by a Deaf signer, " + std::to_string(findings.size()) +
            " findings\n" + evidence_text(*counts);
    if (auto printed = print(text); !printed) return printed;
  }
  if (!findings.empty())
    return fail(ErrorCode::kMalformed,
                "the database breaks its rules in " + std::to_string(findings.size()) +
                    " places (listed above); mend the text under assets/lexicon and build again");
  return {};
}

}  // namespace

Result<void> run_db(const Options& options) {
  Session session(options);
  const auto lexicon = session.lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  switch (options.command) {
    case Command::kDbList:
      return list(options, **lexicon);
    case Command::kDbShow:
      return show(options, **lexicon);
    case Command::kDbSearch:
      return search(options, **lexicon);
    case Command::kDbStats:
      return stats(options, **lexicon);
    default:
      return check(options, **lexicon);
  }
}

}  // namespace auslan
