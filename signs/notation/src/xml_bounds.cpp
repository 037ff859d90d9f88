// SPDX-License-Identifier: Apache-2.0
#include "xml_bounds.h"

#include <algorithm>

namespace auslan::notation {
namespace {

constexpr size_t kMaxElements = 400000;
constexpr size_t kMaxAttributes = 64;

bool is_name_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == ':' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
}

/// `&name;` at `at`: one of XML's own five or a character number.
bool is_plain_reference(std::string_view text, size_t at) {
  const size_t end = text.substr(at, 12).find(';');
  if (end == std::string_view::npos) return false;
  const std::string_view name = text.substr(at + 1, end - 1);
  if (name == "amp" || name == "lt" || name == "gt" || name == "quot" || name == "apos") return true;
  if (name.size() < 2 || name[0] != '#') return false;
  const bool hex = name[1] == 'x';
  const std::string_view number = name.substr(hex ? 2 : 1);
  return !number.empty() && std::ranges::all_of(number, [hex](char c) {
    return (c >= '0' && c <= '9') || (hex && ((c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F')));
  });
}

struct Break {
  ErrorCode code;
  size_t at;
  std::string message;
};

/// Walks tag by tag. It need not know all of XML: what it lets through pugixml still judges.
std::optional<Break> walk(std::string_view text) {
  int depth = 0;
  size_t elements = 0;
  size_t i = text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
  const auto malformed = [](size_t at, std::string message) {
    return Break{ErrorCode::kMalformed, at, std::move(message)};
  };
  const auto limit = [](size_t at, std::string message) { return Break{ErrorCode::kLimit, at, std::move(message)}; };
  while (i < text.size()) {
    if (text[i] == '&' && !is_plain_reference(text, i))
      return malformed(i, "an entity that XML does not define; write the character itself, or &amp; for an ampersand");
    if (text[i] != '<') {
      ++i;
      continue;
    }
    const std::string_view rest = text.substr(i);
    const auto skip_to = [&](std::string_view end, size_t from) {
      const size_t found = text.find(end, i + from);
      return found == std::string_view::npos ? found : found + end.size();
    };
    if (rest.starts_with("<!--") || rest.starts_with("<![CDATA[") || rest.starts_with("<?")) {
      const size_t end = rest.starts_with("<!--") ? skip_to("-->", 4)
                         : rest.starts_with("<!") ? skip_to("]]>", 9)
                                                  : skip_to("?>", 2);
      if (end == std::string_view::npos)
        return malformed(i, "the text ends inside a comment or declaration; it is cut off");
      i = end;
      continue;
    }
    if (rest.starts_with("<!")) {
      const size_t end = text.find('>', i);
      const std::string_view declaration = text.substr(i, end == std::string_view::npos ? end : end - i);
      if (!declaration.starts_with("<!DOCTYPE") || declaration.find('[') != std::string_view::npos)
        return malformed(i, "a declaration of entities or elements; remove it: SiGML needs none");
      if (end == std::string_view::npos) return malformed(i, "the text ends inside a declaration; it is cut off");
      i = end + 1;
      continue;
    }
    const size_t tag = i++;
    const bool closing = i < text.size() && text[i] == '/';
    size_t attributes = 0;
    bool empty = false;
    for (;; ++i) {
      if (i >= text.size()) return malformed(tag, "the text ends inside this tag; it is cut off");
      const char c = text[i];
      if (c == '>') break;
      if (c == '<') return malformed(tag, "this tag is not closed by \">\"");
      empty = c == '/';
      if (c != '"' && c != '\'') continue;
      const size_t end = text.find(c, i + 1);
      if (end == std::string_view::npos) return malformed(i, "an attribute's quote is not closed; the text is cut off");
      if (end - i > kMaxSigmlAttributeBytes)
        return limit(i, "an attribute longer than " + std::to_string(kMaxSigmlAttributeBytes) + " bytes");
      if (++attributes > kMaxAttributes)
        return limit(tag, "a tag with more than " + std::to_string(kMaxAttributes) + " attributes");
      for (size_t k = i + 1; k < end; ++k) {
        if (text[k] == '<') return malformed(k, "a \"<\" inside an attribute; write &lt;");
        if (text[k] == '&' && !is_plain_reference(text, k))
          return malformed(k,
                           "an entity that XML does not define; write the character itself, or &amp; for an ampersand");
      }
      i = end;
    }
    ++i;
    if (closing) {
      if (--depth < 0) return malformed(tag, "an end tag without its start tag");
    } else if (!empty) {
      if (++depth > kMaxSigmlDepth) return limit(tag, "elements nested deeper than " + std::to_string(kMaxSigmlDepth));
    }
    if (++elements > kMaxElements)
      return limit(tag, "more than " + std::to_string(kMaxElements) + " tags; split the file");
    size_t name_end = tag + 1 + (closing ? 1U : 0U);
    const size_t name_start = name_end;
    while (name_end < text.size() && is_name_char(text[name_end]))
      ++name_end;
    if (name_end - name_start > 256) return limit(tag, "a tag name longer than 256 bytes");
  }
  if (depth > 0)
    return malformed(text.empty() ? 0 : text.size() - 1, "the text ends before its elements are closed; it is cut off");
  return std::nullopt;
}

}  // namespace

size_t find_invalid_utf8(std::string_view text) {
  size_t i = 0;
  while (i < text.size()) {
    const auto byte = [&](size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
    const unsigned lead = byte(i);
    if (lead < 0x80) {
      ++i;
      continue;
    }
    const size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                          : lead >= 0xE0 && lead <= 0xEF ? 3
                          : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                         : 0;
    if (length == 0 || i + length > text.size()) return i;
    unsigned code = lead & (0xFFU >> (length + 1));
    for (size_t k = 1; k < length; ++k) {
      if ((byte(i + k) & 0xC0U) != 0x80U) return i;
      code = (code << 6U) | (byte(i + k) & 0x3FU);
    }
    const bool shortest = length == 2 ? code >= 0x80 : length == 3 ? code >= 0x800 : code >= 0x10000;
    if (!shortest || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) return i;
    i += length;
  }
  return std::string_view::npos;
}

Lines::Lines(std::string_view text) {
  starts_.push_back(0);
  for (size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts_.push_back(i + 1);
}

Mark Lines::mark(size_t offset) const {
  const auto after = std::ranges::upper_bound(starts_, offset);
  const auto line = static_cast<size_t>(after - starts_.begin());
  return {static_cast<int>(line), static_cast<int>(offset - starts_[line - 1]) + 1};
}

std::string place(const std::string& name, const Mark& mark) {
  return name + ":" + std::to_string(mark.line) + ":" + std::to_string(mark.column);
}

std::optional<Error> find_broken_bound(std::string_view text, const std::string& name) {
  if (text.size() > kMaxSigmlBytes)
    return Error{ErrorCode::kLimit, "the file is larger than " + std::to_string(kMaxSigmlBytes) + " bytes; split it",
                 place(name, {})};
  std::optional<Break> broken;
  if (const size_t at = find_invalid_utf8(text); at != std::string_view::npos) {
    broken = Break{ErrorCode::kMalformed, at, "a byte that is not UTF-8; save the file as UTF-8"};
  } else if (const auto control = std::ranges::find_if(
                 text,
                 [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\r' && c != '\t'; });
             control != text.end()) {
    broken = Break{ErrorCode::kMalformed, static_cast<size_t>(control - text.begin()),
                   "a control character; expected an XML text"};
  } else {
    broken = walk(text);
  }
  if (!broken) return std::nullopt;
  return Error{broken->code, broken->message, place(name, Lines(text).mark(broken->at))};
}

}  // namespace auslan::notation
