// SPDX-License-Identifier: Apache-2.0
#include "converter.h"
#include "notation/symbols.h"
#include "notation/writer.h"
#include "xml_bounds.h"

#include <algorithm>

namespace auslan {
namespace {

using notation::in_quotes;

void append_escaped(std::string& out, std::string_view text, char quote) {
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>' && quote == 0) {
      out += "&gt;";
    } else if (c == quote && quote != 0) {
      out += quote == '"' ? "&quot;" : "&apos;";
    } else if (c == '\r' || (quote != 0 && (c == '\n' || c == '\t'))) {
      // As a reference it is no white space that a reader would level.
      out += c == '\r' ? "&#13;" : c == '\n' ? "&#10;" : "&#9;";
    } else {
      out += c;
    }
  }
}

void append_element(std::string& out, const WrittenElement& element, int depth) {
  const auto indent = [&out](int levels) { out.append(static_cast<size_t>(levels), ' '); };
  indent(depth);
  out += '<';
  out += element.name;
  for (const auto& [name, value] : element.attributes) {
    const char quote = value.find('"') == std::string::npos ? '"' : '\'';
    out += ' ';
    out += name;
    out += '=';
    out += quote;
    append_escaped(out, value, quote);
    out += quote;
  }
  if (element.children.empty()) {
    out += "/>\n";
    return;
  }
  out += '>';
  // Beside text no white space may come in.
  const bool has_text = std::ranges::any_of(element.children, [](const WrittenElement& c) { return c.name.empty(); });
  if (!has_text) out += '\n';
  for (const WrittenElement& child : element.children) {
    if (child.name.empty()) {
      append_escaped(out, child.text, 0);
    } else {
      append_element(out, child, has_text ? 0 : depth + 1);
      if (has_text) out.pop_back();
    }
  }
  if (!has_text) indent(depth);
  out += "</";
  out += element.name;
  out += ">\n";
}

void append_symbol(std::string& out, const HamSymbol& symbol) {
  const char32_t code = symbol.code;
  if (code == U' ' || code == U',') {
    // As characters they part symbols from each other.
    out += ' ';
    out += symbol.name;
    out += ' ';
    return;
  }
  if (code < 0x80) {
    out += static_cast<char>(code);
    return;
  }
  // HamNoSys is in the private use area: three bytes.
  out += static_cast<char>(0xE0U | (code >> 12U));
  out += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
  out += static_cast<char>(0x80U | (code & 0x3FU));
}

}  // namespace

namespace notation {

std::string text_of(const WrittenElement& element) {
  std::string out;
  append_element(out, element, 0);
  return out;
}

}  // namespace notation

std::optional<NotationForm> form_of(const WrittenElement& written) {
  if (written.name == "hns_sign") return NotationForm::kSymbols;
  if (written.name == "hamgestural_sign" || written.name == "hamgestural_segment") return NotationForm::kGestural;
  return std::nullopt;
}

std::string write_sigml(std::span<const NotatedSign> signs) {
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<sigml>\n";
  for (const NotatedSign& sign : signs)
    append_element(out, sign.written, 0);
  return out + "</sigml>\n";
}

Result<std::string> write_hamnosys(const NotatedSign& sign) {
  if (form_of(sign.written) != NotationForm::kSymbols)
    return fail(ErrorCode::kUnsupported, "the sign " + in_quotes(sign.sign.gloss) +
                                             " is not written in HamNoSys symbols; convert it to hns first");
  std::string out;
  for (const WrittenElement& part : sign.written.children) {
    if (part.name != "hamnosys_manual") continue;
    for (const WrittenElement& symbol : part.children) {
      if (symbol.name.empty()) {
        // What is no symbol stands apart, so that it takes nothing of its neighbours.
        out += ' ';
        out += symbol.text;
        out += ' ';
      } else if (const HamSymbol* known = find_ham_symbol(symbol.name)) {
        append_symbol(out, *known);
      } else {
        return fail(ErrorCode::kUnsupported, "the symbol " + in_quotes(symbol.name) + " has no code point");
      }
    }
  }
  return out;
}

}  // namespace auslan
