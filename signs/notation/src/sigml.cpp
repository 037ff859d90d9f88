// SPDX-License-Identifier: Apache-2.0
// SiGML files: bounds first, then pugixml, then every sign by its kind.
#include "converter.h"
#include "element.h"
#include "notation/notation.h"
#include "token_reader.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace auslan {
namespace {

using namespace notation;

constexpr size_t kMaxSymbols = 2000;

void read_hns(Element& element, WrittenSign& sign) {
  bool manual_seen = false;
  element.each_child([&](Element& child) {
    Findings& findings = child.findings();
    if (child.name() == "hamnosys_nonmanual") {
      read_hnm(child, sign.non_manual);
    } else if (child.name() == "hamnosys_manual") {
      if (manual_seen) findings.note(child.mark(), "a second manual part is read as the next part of a compound");
      manual_seen = true;
      child.done();
      std::vector<Token> tokens;
      child.each_child([&](Element& symbol) {
        const HamSymbol* known = find_ham_symbol(symbol.name());
        if (known == nullptr) {
          findings.left_out(symbol.mark(), "the symbol " + in_quotes(symbol.name()) + " is not known and is left out");
        } else if (tokens.size() == kMaxSymbols) {
          findings.left_out(symbol.mark(),
                            "more than " + std::to_string(kMaxSymbols) + " symbols; the rest is left out");
          tokens.push_back({known, symbol.mark()});
        } else if (tokens.size() < kMaxSymbols) {
          tokens.push_back({known, symbol.mark()});
        }
        symbol.done();
      });
      if (tokens.size() > kMaxSymbols) tokens.resize(kMaxSymbols);
      for (const pugi::xml_node& text : child.node().children())
        if (text.type() == pugi::node_pcdata || text.type() == pugi::node_cdata)
          findings.left_out(child.mark(), "text between the symbols is left out: " + in_quotes(text.value()));
      read_tokens(tokens, child.mark(), sign, findings);
    } else {
      findings.left_out(child.mark(),
                        "the element " + in_quotes(child.name()) + " is not known in a sign and is left out");
    }
  });
}

void read_gestural(Element& element, WrittenSign& sign) {
  element.each_child([&](Element& child) {
    if (child.name() == "sign_nonmanual") {
      read_tiers(child, sign.non_manual);
    } else if (child.name() == "sign_manual") {
      read_manual(child, sign);
    } else {
      child.findings().left_out(child.mark(),
                                "the element " + in_quotes(child.name()) + " is not known in a sign and is left out");
    }
  });
}

/// Everything in it. Bounds on depth were checked before.
WrittenElement kept(const pugi::xml_node& node) {
  WrittenElement element;
  element.name = node.name();
  for (const pugi::xml_attribute& attribute : node.attributes())
    element.attributes.emplace_back(attribute.name(), attribute.value());
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element) {
      element.children.push_back(kept(child));
    } else if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      std::string_view text = child.value();
      constexpr std::string_view kWhite = " \t\r\n";
      const size_t first = text.find_first_not_of(kWhite);
      if (first == std::string_view::npos) continue;
      text = text.substr(first, text.find_last_not_of(kWhite) - first + 1);
      // Text that a comment parted is one text.
      if (!element.children.empty() && element.children.back().name.empty()) {
        (element.children.back().text += ' ') += text;
      } else {
        element.children.emplace_back();
        element.children.back().text = text;
      }
    }
  }
  return element;
}

/// False for what is no sign.
bool read_written(Element& element, WrittenSign& sign) {
  sign.mark = element.mark();
  sign.gloss = element.text("gloss");
  sign.pace = read_pace(element);
  element.not_carried({"duration"});
  element.text("gloss_language");
  element.text("sign_language");
  element.done();
  if (element.name() == "hns_sign") {
    read_hns(element, sign);
  } else if (element.name() == "hamgestural_sign" || element.name() == "hamgestural_segment") {
    read_gestural(element, sign);
  } else {
    return false;
  }
  return true;
}

NotatedSign read_sign(const pugi::xml_node& node, const Lines& lines) {
  Findings findings;
  Element element(node, lines, findings);
  WrittenSign sign;
  if (!read_written(element, sign)) {
    NotatedSign refused;
    refused.written = kept(node);
    refused.sign.gloss = sign.gloss.empty() ? "UNNAMED" : sign.gloss;
    findings.error(element.mark(), "the element " + in_quotes(element.name()) +
                                       " is not a sign that can be signed (expected hns_sign or hamgestural_sign)");
    refused.diagnostics = findings.take();
    return refused;
  }
  NotatedSign result = sign_of(sign, findings);
  result.written = kept(node);
  return result;
}

constexpr unsigned kParsed = pugi::parse_escapes | pugi::parse_wconv_attribute | pugi::parse_eol | pugi::parse_cdata;

}  // namespace

namespace notation {

WrittenSign written_sign(const WrittenElement& element, Findings& findings) {
  const std::string text = text_of(element);
  WrittenSign sign;
  const Lines lines(text);
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size(), kParsed, pugi::encoding_utf8)) {
    findings.error({}, "the sign cannot be read again");
    return sign;
  }
  Element root(document.document_element(), lines, findings);
  read_written(root, sign);
  return sign;
}

}  // namespace notation

Result<std::vector<NotatedSign>> parse_sigml(std::string_view text, const std::string& name) {
  if (auto broken = find_broken_bound(text, name)) return tl::unexpected(*broken);
  const Lines lines(text);
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size(), kParsed, pugi::encoding_utf8);
  if (!parsed) {
    const size_t offset = parsed.offset > 0 ? static_cast<size_t>(parsed.offset) : 0;
    return fail(ErrorCode::kMalformed, "not well-formed XML: " + std::string(parsed.description()),
                place(name, lines.mark(std::min(offset, text.size()))));
  }
  std::vector<NotatedSign> signs;
  for (const pugi::xml_node& root : document.children()) {
    if (root.type() != pugi::node_element) continue;
    const std::string_view kind = root.name();
    if (kind == "sigml") {
      for (const pugi::xml_node& child : root.children())
        if (child.type() == pugi::node_element) signs.push_back(read_sign(child, lines));
    } else {
      signs.push_back(read_sign(root, lines));
    }
  }
  if (signs.empty())
    return fail(ErrorCode::kMalformed, "no sign; expected hns_sign or hamgestural_sign elements in a sigml element",
                place(name, {}));
  return signs;
}

Result<std::vector<NotatedSign>> read_sigml(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (error || !std::filesystem::exists(status))
    return fail(ErrorCode::kNotFound, "there is no such file; check the name", path.string());
  if (!std::filesystem::is_regular_file(status))
    return fail(ErrorCode::kUnreadable, "not a file; expected SiGML", path.string());
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxSigmlBytes)
    return fail(ErrorCode::kLimit, "the file is larger than " + std::to_string(kMaxSigmlBytes) + " bytes; split it",
                path.string());
  std::ifstream file(path, std::ios::binary);
  if (!file) return fail(ErrorCode::kUnreadable, "the file cannot be opened; check its permissions", path.string());
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return fail(ErrorCode::kUnreadable, "the file cannot be read to its end", path.string());
  return parse_sigml(text, path.string());
}

}  // namespace auslan
