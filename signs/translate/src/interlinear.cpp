// SPDX-License-Identifier: Apache-2.0
#include "phonology/vocabulary.h"
#include "translate/report.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utf8proc.h>
#include <utility>

namespace auslan {
namespace {

constexpr size_t kColumns = 7;
using Row = std::array<std::string, kColumns>;

/// One line without control characters; a text that is too long for a table is cut.
std::string printable(std::string_view text) {
  constexpr size_t kMost = 60;  // characters
  std::string result;
  size_t characters = 0;
  for (size_t at = 0; at < text.size();) {
    utf8proc_int32_t code = 0;
    const utf8proc_ssize_t length = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()) + at,
                                                     static_cast<utf8proc_ssize_t>(text.size() - at), &code);
    const size_t bytes = length > 0 ? static_cast<size_t>(length) : 1;
    if (++characters > kMost) return result + "\u2026";
    const utf8proc_category_t category = utf8proc_category(code);
    const bool invisible = length <= 0 || category == UTF8PROC_CATEGORY_CC || category == UTF8PROC_CATEGORY_CF ||
                           category == UTF8PROC_CATEGORY_ZL || category == UTF8PROC_CATEGORY_ZP;
    if (invisible)
      result += ' ';
    else
      result += text.substr(at, bytes);
    at += bytes;
  }
  return result;
}

size_t width_of(std::string_view text) {
  size_t width = 0;
  for (size_t at = 0; at < text.size();) {
    utf8proc_int32_t code = 0;
    const utf8proc_ssize_t length = utf8proc_iterate(reinterpret_cast<const utf8proc_uint8_t*>(text.data()) + at,
                                                     static_cast<utf8proc_ssize_t>(text.size() - at), &code);
    if (length > 0) width += static_cast<size_t>(std::max(0, utf8proc_charwidth(code)));
    at += length > 0 ? static_cast<size_t>(length) : 1;
  }
  return width;
}

std::string join(const std::vector<std::string>& words, std::string_view between) {
  std::string result;
  for (const std::string& word : words) {
    if (!result.empty()) result += between;
    result += word;
  }
  return result;
}

/// K-I-M: letters and digits without the prefix of their entries.
std::string spelled(const std::vector<std::string>& glosses) {
  std::string result;
  for (const std::string& gloss : glosses) {
    if (!result.empty()) result += '-';
    result += std::string_view(gloss).substr(gloss.rfind(':') + 1);
  }
  return printable(result);
}

std::string gloss_of(const Item& item) {
  switch (item.kind) {
    case ItemKind::kSign:
      return join(item.glosses, " ");
    case ItemKind::kSpelled:
      return spelled(item.glosses);
    case ItemKind::kNumber:
      return std::string("#").append(spelled(item.glosses));
    case ItemKind::kPause: {
      std::array<char, 32> text{};
      std::snprintf(text.data(), text.size(), "pause %.2f s", item.pause_seconds);
      return text.data();
    }
    case ItemKind::kDropped:
      return "(not signed)";
  }
  return {};
}

Row row_of(const Item& item, size_t index) {
  const bool rated = item.kind != ItemKind::kPause && item.kind != ItemKind::kDropped;
  return {std::to_string(index),
          printable(item.text),
          gloss_of(item),
          join(item.rules, " "),
          rated ? std::string(to_name(item.confidence)) : "",
          rated ? std::string(to_name(item.review)) : "",
          std::string(item.ambiguous ? "ambiguous: " : "").append(join(item.alternatives, " "))};
}

std::string span_line(const NonManualSpan& span) {
  std::string line = "  " + span.kind + " over " + std::to_string(span.from) + " to " + std::to_string(span.to);
  const std::array<std::pair<const char*, const std::string*>, 6> features = {{{"brows", &span.brows},
                                                                               {"head", &span.head},
                                                                               {"gaze", &span.gaze},
                                                                               {"mouth", &span.mouth},
                                                                               {"eyes", &span.eyes},
                                                                               {"then", &span.ending}}};
  for (const auto& feature : features)
    if (!feature.second->empty()) line += std::string(", ") + feature.first + " " + *feature.second;
  return line + "\n";
}

}  // namespace

std::string_view to_name(ItemKind kind) {
  static constexpr std::array<std::string_view, 5> kNames = {"sign", "spelled", "number", "pause", "dropped"};
  return kNames[static_cast<size_t>(kind)];
}

std::string interlinear(const Translation& translation) {
  std::vector<Row> rows = {{"#", "English", "gloss", "rules", "confidence", "review", "could also be"}};
  for (size_t i = 0; i < translation.items.size(); ++i)
    rows.push_back(row_of(translation.items[i], i));
  std::array<size_t, kColumns> widths{};
  for (const Row& row : rows)
    for (size_t c = 0; c < kColumns; ++c)
      widths[c] = std::max(widths[c], width_of(row[c]));
  std::string result;
  for (const Row& row : rows) {
    std::string line;
    for (size_t c = 0; c < kColumns; ++c) {
      line += row[c];
      line.append(widths[c] - width_of(row[c]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + "\n";
  }
  if (!translation.non_manual.empty()) result += "\nFace and head:\n";
  for (const NonManualSpan& span : translation.non_manual)
    result += span_line(span);
  if (!translation.warnings.empty()) result += "\nWarnings:\n";
  for (const std::string& warning : translation.warnings)
    result += "  " + warning + "\n";
  return result;
}

}  // namespace auslan
