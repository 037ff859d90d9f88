// SPDX-License-Identifier: Apache-2.0
#include "characters.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utf8proc.h>
#include <utility>

namespace auslan {
namespace {

const utf8proc_uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const utf8proc_uint8_t*>(text.data());
}

CharClass classify_ascii(int32_t code) {
  if ((code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z')) return CharClass::kLetter;
  if (code >= '0' && code <= '9') return CharClass::kDigit;
  switch (code) {
    case '\n':
      return CharClass::kNewline;
    case '\'':
    case '`':
      return CharClass::kApostrophe;
    case '-':
      return CharClass::kHyphen;
    case '.':
      return CharClass::kPoint;
    case '!':
      return CharClass::kStop;
    case '?':
      return CharClass::kQuestion;
    case ',':
    case ';':
    case ':':
    case '(':
    case ')':
    case '[':
    case ']':
    case '{':
    case '}':
      return CharClass::kComma;
    case '/':
      return CharClass::kSlash;
    default:
      break;
  }
  return symbol_reading(code).empty() ? CharClass::kSpace : CharClass::kSymbolWord;
}

CharClass classify(int32_t code) {
  if (code < 0x80) return classify_ascii(code);
  switch (code) {
    case 0x2018:
    case 0x2019:
    case 0x02BC:
    case 0x02BB:
    case 0xFF07:
    case 0x00B4:
    case 0x2032:
      return CharClass::kApostrophe;
    case 0x2010:
    case 0x2011:
      return CharClass::kHyphen;
    case 0x2212:
      return CharClass::kHyphen;
    case 0x2012:
    case 0x2013:
    case 0x2014:
    case 0x2015:
      return CharClass::kDash;
    case 0x3002:
    case 0xFF01:
    case 0x06D4:
    case 0x0964:
    case 0xFF0E:
    case 0x203C:
      return CharClass::kStop;
    case 0xFF1F:
    case 0x061F:
    case 0x203D:
    case 0x2047:
    case 0x2048:
    case 0x2049:
    case 0x037E:
      return CharClass::kQuestion;
    case 0x2026:
    case 0x3001:
    case 0xFF0C:
    case 0x060C:
    case 0x061B:
    case 0xFF1B:
    case 0xFF1A:
      return CharClass::kComma;
    case 0x00B7:
    case 0x2022:
    case 0x25CF:
    case 0x25AA:
      return CharClass::kComma;  // bullets
    case 0x2028:
    case 0x2029:
    case 0x0085:
      return CharClass::kNewline;
    default:
      break;
  }
  if (!symbol_reading(code).empty()) return CharClass::kSymbolWord;
  switch (utf8proc_category(code)) {
    case UTF8PROC_CATEGORY_LU:
    case UTF8PROC_CATEGORY_LL:
    case UTF8PROC_CATEGORY_LT:
    case UTF8PROC_CATEGORY_LM:
    case UTF8PROC_CATEGORY_LO:
    case UTF8PROC_CATEGORY_MN:
    case UTF8PROC_CATEGORY_MC:
    case UTF8PROC_CATEGORY_ME:
      return code >= 0xFE00 && code <= 0xFE0F ? CharClass::kIgnored : CharClass::kLetter;  // variation selectors
    case UTF8PROC_CATEGORY_ND:
      return CharClass::kDigit;
    case UTF8PROC_CATEGORY_NO:
      return CharClass::kFraction;
    case UTF8PROC_CATEGORY_CF:
      return CharClass::kIgnored;
    case UTF8PROC_CATEGORY_ZS:
    case UTF8PROC_CATEGORY_ZL:
    case UTF8PROC_CATEGORY_ZP:
    case UTF8PROC_CATEGORY_CC:
      return CharClass::kSpace;
    case UTF8PROC_CATEGORY_PD:
      return CharClass::kDash;
    case UTF8PROC_CATEGORY_PS:
    case UTF8PROC_CATEGORY_PE:
      return CharClass::kComma;
    case UTF8PROC_CATEGORY_PC:
    case UTF8PROC_CATEGORY_PI:
    case UTF8PROC_CATEGORY_PF:
    case UTF8PROC_CATEGORY_PO:
      return CharClass::kSpace;
    default:
      return CharClass::kOther;
  }
}

/// Letters of the Latin script that Unicode does not decompose.
std::string_view latin_letters(int32_t code) {
  switch (code) {
    case 0x00E6:
      return "ae";
    case 0x0153:
      return "oe";
    case 0x00F8:
      return "o";
    case 0x0142:
      return "l";
    case 0x0111:
    case 0x00F0:
      return "d";
    case 0x00FE:
      return "th";
    case 0x0131:
      return "i";
    case 0x0127:
      return "h";
    case 0x014B:
      return "ng";
    case 0x0167:
      return "t";
    default:
      return {};
  }
}

std::string map_utf8(std::string_view text, int options) {
  utf8proc_uint8_t* mapped = nullptr;
  const utf8proc_ssize_t size = utf8proc_map(bytes_of(text), static_cast<utf8proc_ssize_t>(text.size()), &mapped,
                                             static_cast<utf8proc_option_t>(options));
  if (size < 0) return std::string(text);
  std::string result(reinterpret_cast<const char*>(mapped), static_cast<size_t>(size));
  std::free(mapped);  // utf8proc_map allocates with malloc
  return result;
}

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

Result<std::vector<Character>> read_characters(std::string_view text) {
  std::vector<Character> characters;
  characters.reserve(text.size() + 1);
  size_t at = 0;
  while (at < text.size()) {
    utf8proc_int32_t code = 0;
    const utf8proc_ssize_t length =
        utf8proc_iterate(bytes_of(text) + at, static_cast<utf8proc_ssize_t>(text.size() - at), &code);
    if (length <= 0)
      return fail(ErrorCode::kMalformed,
                  "the text is not UTF-8 from here on; save or convert it as UTF-8 and try again",
                  "byte " + std::to_string(at));
    characters.push_back({code, classify(code), at});
    at += static_cast<size_t>(length);
  }
  characters.push_back({0, CharClass::kNewline, text.size()});
  return characters;
}

std::string_view symbol_reading(int32_t code) {
  switch (code) {
    case '%':
      return "percent";
    case '&':
      return "and";
    case '+':
      return "plus";
    case '=':
      return "equals";
    case '@':
      return "at";
    case '$':
      return "dollars";
    case '#':
      return "number";
    case '<':
      return "under";
    case '>':
      return "over";
    case 0x00A3:
      return "pounds";
    case 0x20AC:
      return "euros";
    case 0x00B0:
      return "degrees";
    case 0x00D7:
      return "times";
    case 0x00B1:
      return "plus-minus";
    case 0x2264:
      return "at most";
    case 0x2265:
      return "at least";
    default:
      return {};
  }
}

int digit_value(int32_t code) {
  if (code >= '0' && code <= '9') return code - '0';
  // Decimal digits of a script stand in one run of ten (Unicode stability policy); runs that touch are multiples of
  // ten.
  int before = 0;
  while (before < 60 && utf8proc_category(code - before - 1) == UTF8PROC_CATEGORY_ND)
    ++before;
  return before % 10;
}

bool is_upper(int32_t code) {
  if (code < 0x80) return code >= 'A' && code <= 'Z';
  const utf8proc_category_t category = utf8proc_category(code);
  return category == UTF8PROC_CATEGORY_LU || category == UTF8PROC_CATEGORY_LT;
}

std::string fold_case(std::string_view text) {
  std::string result;
  if (is_ascii(text)) {
    result = text;
  } else {
    std::string plain;
    for (size_t at = 0; at < text.size();) {
      utf8proc_int32_t code = 0;
      const auto length = static_cast<size_t>(std::max<utf8proc_ssize_t>(
          1, utf8proc_iterate(bytes_of(text) + at, static_cast<utf8proc_ssize_t>(text.size() - at), &code)));
      if (classify(code) == CharClass::kApostrophe)
        plain += '\'';
      else
        plain += text.substr(at, length);
      at += length;
    }
    result = map_utf8(plain, UTF8PROC_STABLE | UTF8PROC_COMPOSE | UTF8PROC_CASEFOLD | UTF8PROC_IGNORE);
  }
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string fold_letters(std::string_view text, std::vector<std::string>* lost) {
  const std::string mapped = is_ascii(text)
                                 ? std::string(text)
                                 : map_utf8(text, UTF8PROC_STABLE | UTF8PROC_DECOMPOSE | UTF8PROC_COMPAT |
                                                      UTF8PROC_CASEFOLD | UTF8PROC_STRIPMARK | UTF8PROC_IGNORE);
  std::string result;
  for (size_t at = 0; at < mapped.size();) {
    utf8proc_int32_t code = 0;
    const auto length = static_cast<size_t>(std::max<utf8proc_ssize_t>(
        1, utf8proc_iterate(bytes_of(mapped) + at, static_cast<utf8proc_ssize_t>(mapped.size() - at), &code)));
    if (code >= 'A' && code <= 'Z') {
      result += static_cast<char>(code - 'A' + 'a');
    } else if (code < 0x80 && classify_ascii(code) == CharClass::kLetter) {
      result += static_cast<char>(code);
    } else if (utf8proc_category(code) == UTF8PROC_CATEGORY_ND) {
      result += static_cast<char>('0' + digit_value(code));
    } else if (!latin_letters(code).empty()) {
      result += latin_letters(code);
    } else {
      const CharClass kind = classify(code);
      if (kind == CharClass::kLetter || kind == CharClass::kFraction || kind == CharClass::kOther) {
        std::string character = mapped.substr(at, length);
        // A word of a script without letters of ours would list each character; the first eight say enough.
        if (lost->size() < 8 && std::find(lost->begin(), lost->end(), character) == lost->end())
          lost->push_back(std::move(character));
      }
    }
    at += length;
  }
  return result;
}

}  // namespace auslan
