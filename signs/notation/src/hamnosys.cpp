// SPDX-License-Identifier: Apache-2.0
// HamNoSys strings: code points of the private use area, or names.
#include "notation/notation.h"
#include "token_reader.h"
#include "xml_bounds.h"

namespace auslan {
namespace {

using namespace notation;

constexpr size_t kMaxSymbols = 2000;

bool is_separator(char c) {
  return c == ',' || c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ';';
}

Mark mark_at(size_t offset) {
  return {1, static_cast<int>(offset) + 1};
}

}  // namespace

Result<NotatedSign> parse_hamnosys(std::string_view utf8) {
  const std::string name = "hamnosys";
  if (utf8.size() > kMaxHamnosysBytes)
    return fail(ErrorCode::kLimit, "the string is longer than " + std::to_string(kMaxHamnosysBytes) + " bytes", name);
  if (const size_t at = find_invalid_utf8(utf8); at != std::string_view::npos)
    return fail(ErrorCode::kMalformed, "a byte that is not UTF-8", place(name, mark_at(at)));
  Findings findings;
  std::vector<Token> tokens;
  WrittenElement source;
  source.name = "hns_sign";
  source.put("gloss", "HAMNOSYS");
  WrittenElement& symbols = source.add("hamnosys_manual");
  size_t i = 0;
  while (i < utf8.size()) {
    const size_t start = i;
    const auto lead = static_cast<unsigned char>(utf8[i]);
    if (is_separator(utf8[i])) {
      ++i;
      continue;
    }
    const HamSymbol* symbol = nullptr;
    std::string_view written;
    const bool letter = (lead >= 'a' && lead <= 'z') || (lead >= 'A' && lead <= 'Z') || lead == '<';
    if (letter) {
      // A name, with or without the brackets of an element.
      size_t end = i;
      while (end < utf8.size() && !is_separator(utf8[end]) && static_cast<unsigned char>(utf8[end]) < 0x80)
        ++end;
      written = utf8.substr(i, end - i);
      i = end;
      std::string_view bare = written;
      if (bare.starts_with('<')) bare.remove_prefix(1);
      if (bare.ends_with('>')) bare.remove_suffix(1);
      if (bare.ends_with('/')) bare.remove_suffix(1);
      symbol = find_ham_symbol(bare);
    } else {
      const size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
      written = utf8.substr(i, length);
      char32_t code = length == 1 ? lead : lead & (0xFFU >> (length + 1));
      for (size_t k = 1; k < length; ++k)
        code = (code << 6U) | (static_cast<unsigned char>(utf8[i + k]) & 0x3FU);
      i += length;
      if (code == 0xFEFF) continue;
      symbol = find_ham_symbol(code);
    }
    if (symbol == nullptr) {
      findings.left_out(mark_at(start), "the symbol " + in_quotes(written) + " is not known and is left out");
      if (!symbols.children.empty() && symbols.children.back().name.empty()) {
        symbols.children.back().text += ' ';
      } else {
        symbols.add("");
      }
      symbols.children.back().text += written;
      continue;
    }
    if (tokens.size() >= kMaxSymbols)
      return fail(ErrorCode::kLimit, "more than " + std::to_string(kMaxSymbols) + " symbols",
                  place(name, mark_at(start)));
    tokens.push_back({symbol, mark_at(start)});
    symbols.add(symbol->name);
  }
  if (tokens.empty())
    return fail(ErrorCode::kMalformed,
                "no HamNoSys symbol; expected code points of HamNoSys 4 or names such as "
                "\"hamflathand,hamextfingeru,hampalml\"",
                place(name, {}));
  WrittenSign sign;
  sign.gloss = "HAMNOSYS";
  read_tokens(tokens, {}, sign, findings);
  NotatedSign result = sign_of(sign, findings);
  result.written = std::move(source);
  return result;
}

}  // namespace auslan
