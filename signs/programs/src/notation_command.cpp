// SPDX-License-Identifier: Apache-2.0
// `notation`: what the readers say of signs in SiGML or HamNoSys, and the same signs written in another notation.
#include "commands.h"
#include "kinematics/whole_file.h"
#include "lexicon/lexicon_text.h"
#include "notation/writer.h"
#include "session.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace auslan {
namespace {

using Json = nlohmann::ordered_json;

NotationForm form_of(const Options& options) {
  return options.notation == "gestural" ? NotationForm::kGestural : NotationForm::kSymbols;
}

/// Entries of the lexicon, with what the notation that is asked for cannot say of them.
Result<std::vector<NotatedSign>> entries(const Options& options) {
  Session session(options);
  const auto lexicon = session.lexicon();
  if (!lexicon) return tl::unexpected(lexicon.error());
  const auto handshapes = (*lexicon)->handshapes();
  if (!handshapes) return tl::unexpected(handshapes.error());
  std::vector<NotatedSign> signs;
  for (const std::string& gloss : options.source.glosses) {
    const auto sign = (*lexicon)->sign(gloss);
    if (!sign) return tl::unexpected(sign.error());
    if (!*sign)
      return fail(ErrorCode::kNotFound,
                  "the lexicon has no entry " + gloss + "; `auslanjam db search WORD` finds those there are");
    if (options.notation == "text") {
      NotatedSign plain;
      plain.sign = **sign;
      plain.signable = true;
      for (const Handshape& shape : *handshapes)
        if (std::ranges::any_of(plain.sign.dominant, [&](const Posture& p) { return p.handshape == shape.id; }) ||
            std::ranges::any_of(plain.sign.non_dominant, [&](const Posture& p) { return p.handshape == shape.id; }))
          plain.handshapes.push_back(shape);
      signs.push_back(std::move(plain));
      continue;
    }
    auto made = notate(**sign, *handshapes, form_of(options));
    if (!made) return tl::unexpected(made.error());
    for (const Diagnostic& diagnostic : made->findings)
      remark(options, gloss + ": " + diagnostic.message);
    signs.push_back(std::move(made->sign));
  }
  return signs;
}

Result<std::vector<NotatedSign>> read(const Options& options) {
  if (!options.source.glosses.empty()) return entries(options);
  if (!options.source.hamnosys) return read_sigml(*options.source.sigml_file);
  auto sign = parse_hamnosys(*options.source.hamnosys);
  if (!sign) return tl::unexpected(sign.error());
  std::vector<NotatedSign> signs;
  signs.push_back(std::move(*sign));
  return signs;
}

std::string_view name_of(Diagnostic::Grade grade) {
  return grade == Diagnostic::Grade::kError ? "error" : grade == Diagnostic::Grade::kWarning ? "warning" : "note";
}

/// What was found in each sign, and what it comes to.
Result<void> tell(const Options& options, const std::vector<NotatedSign>& signs) {
  size_t signable = 0, whole = 0;
  std::string text;
  Json list = Json::array();
  for (const NotatedSign& sign : signs) {
    const bool nothing_lost = sign.signable && nothing_left_out(sign.diagnostics);
    signable += sign.signable ? 1 : 0;
    whole += nothing_lost ? 1 : 0;
    Json findings = Json::array();
    text += sign.sign.gloss + ": " +
            (nothing_lost    ? "signed whole"
             : sign.signable ? "signed, with something left out"
                             : "cannot be signed") +
            '\n';
    for (const Diagnostic& diagnostic : sign.diagnostics) {
      text += "  " + to_string(diagnostic) + '\n';
      findings.push_back({{"line", diagnostic.line},
                          {"column", diagnostic.column},
                          {"grade", name_of(diagnostic.grade)},
                          {"left_out", diagnostic.left_out},
                          {"message", diagnostic.message}});
    }
    list.push_back({{"gloss", sign.sign.gloss},
                    {"signable", sign.signable},
                    {"whole", nothing_lost},
                    {"findings", std::move(findings)}});
  }
  text += std::to_string(signs.size()) + (signs.size() == 1 ? " sign, " : " signs, ") + std::to_string(signable) +
          " can be signed, " + std::to_string(whole) + " with nothing left out\n";
  // Text of a file may hold bytes that a JSON writer refuses; they are replaced.
  if (auto printed = print(options.json ? list.dump(2, ' ', false, Json::error_handler_t::replace) + '\n' : text);
      !printed)
    return printed;
  if (signable == signs.size()) return {};
  return fail(ErrorCode::kMalformed, std::to_string(signs.size() - signable) + " of " + std::to_string(signs.size()) +
                                         " signs cannot be signed; the findings above say why");
}

/// Everything in one notation; what it cannot say is told.
Result<std::string> written(const Options& options, const std::vector<NotatedSign>& signs) {
  if (options.notation == "text") {
    LexiconText text;
    for (const NotatedSign& sign : signs) {
      if (!sign.signable)
        return fail(ErrorCode::kUnsupported,
                    "the sign " + sign.sign.gloss + " cannot be signed, so there is no text of it");
      for (const Handshape& shape : sign.handshapes)
        if (std::find(text.handshapes.begin(), text.handshapes.end(), shape) == text.handshapes.end())
          text.handshapes.push_back(shape);
      text.signs.push_back(sign.sign);
    }
    // Without the head of the lexicon's files, which speaks of their licence.
    std::string all;
    for (const TextSource& source : write_lexicon_text(text))
      if (source.name == "handshapes.toml" || source.name.starts_with("signs/"))
        all += source.text.substr(source.text.find('\n') + 1);
    return all;
  }
  const NotationForm form = form_of(options);
  std::vector<NotatedSign> converted;
  std::string strings;
  for (const NotatedSign& sign : signs) {
    auto other = convert(sign, form);
    if (!other) return tl::unexpected(other.error());
    for (const Diagnostic& diagnostic : other->findings)
      remark(options, sign.sign.gloss + ": " + to_string(diagnostic));
    if (options.notation == "hamnosys") {
      auto string = write_hamnosys(other->sign);
      if (!string) return tl::unexpected(string.error());
      strings += *string + '\n';
    }
    converted.push_back(std::move(other->sign));
  }
  return options.notation == "hamnosys" ? strings : write_sigml(converted);
}

}  // namespace

Result<void> run_notation(const Options& options) {
  const auto signs = read(options);
  if (!signs) return tl::unexpected(signs.error());
  if (options.notation.empty()) return tell(options, *signs);
  const auto text = written(options, *signs);
  if (!text) return tl::unexpected(text.error());
  return options.output.empty() ? print(*text) : write_whole_file(options.output, *text);
}

}  // namespace auslan
