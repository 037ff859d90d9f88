// SPDX-License-Identifier: Apache-2.0
#include "table_reader.h"

#include <algorithm>
#include <cmath>

namespace auslan {
namespace {

constexpr size_t kMaxProblems = 1000;
constexpr size_t kMaxTextBytes = 1000;
constexpr size_t kMaxArray = 64;

std::string type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

std::string shown(std::string_view text) {
  std::string quoted = "\"";
  quoted += text.substr(0, 60);
  return quoted + (text.size() > 60 ? "…\"" : "\"");
}

}  // namespace

std::string join_choices(std::span<const std::string_view> words) {
  std::string all;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) all += i + 1 == words.size() ? " or " : ", ";
    all += words[i];
  }
  return all;
}

void ProblemList::add(long line, std::string message, ErrorCode code) {
  if (problems_.size() >= kMaxProblems) return;
  problems_.push_back({file_, line, Error{code, std::move(message), name_ + ":" + std::to_string(line)}});
}

const toml::node* TableReader::find(std::string_view key, Need need, std::string_view expected) {
  asked_.emplace(key);
  const toml::node* found = table_.get(key);
  if (found == nullptr && need == Need::kRequired)
    problems_.add(table_, what_ + ": " + std::string(key) + " is missing; expected " + std::string(expected));
  return found;
}

void TableReader::wrong_type(const toml::node& node, std::string_view key, std::string_view expected) {
  problems_.add(node,
                what_ + ": " + std::string(key) + " is " + type_name(node) + "; expected " + std::string(expected));
}

std::string TableReader::text(std::string_view key, Need need) {
  const toml::node* found = find(key, need, "a string");
  if (found == nullptr) return {};
  const auto* string = found->as_string();
  if (string == nullptr) {
    wrong_type(*found, key, "a string");
    return {};
  }
  return plain(*string, key) ? string->get() : std::string();
}

bool TableReader::plain(const toml::value<std::string>& string, std::string_view key) {
  const std::string& value = string.get();
  if (value.size() > kMaxTextBytes) {
    problems_.add(string,
                  what_ + ": " + std::string(key) + " is longer than " + std::to_string(kMaxTextBytes) + " bytes");
    return false;
  }
  if (std::ranges::any_of(value, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; })) {
    problems_.add(string,
                  what_ + ": " + std::string(key) + " holds a control character; expected plain text on one line");
    return false;
  }
  return true;
}

int TableReader::integer(std::string_view key, int fallback, int least, int most) {
  const toml::node* found = find(key, Need::kOptional, "");
  if (found == nullptr) return fallback;
  const std::string range = "an integer from " + std::to_string(least) + " to " + std::to_string(most);
  const auto* value = found->as_integer();
  if (value == nullptr) {
    wrong_type(*found, key, range);
    return fallback;
  }
  if (value->get() < least || value->get() > most) {
    problems_.add(*found,
                  what_ + ": " + std::string(key) + " is " + std::to_string(value->get()) + "; expected " + range);
    return fallback;
  }
  return static_cast<int>(value->get());
}

double TableReader::number(std::string_view key, Need need) {
  const toml::node* found = find(key, need, "a number");
  if (found == nullptr) return 0.0;
  const std::optional<double> value = found->is_number() ? found->value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) {
    wrong_type(*found, key, "a finite number");
    return 0.0;
  }
  return *value;
}

bool TableReader::flag(std::string_view key) {
  const toml::node* found = find(key, Need::kOptional, "true or false");
  if (found == nullptr) return false;
  const toml::value<bool>* value = found->as_boolean();
  if (value == nullptr) wrong_type(*found, key, "true or false");
  return value != nullptr && value->get();
}

void TableReader::fill_numbers(std::string_view key, Need need, std::span<double> values) {
  const std::string expected = "an array of " + std::to_string(values.size()) + " numbers";
  const toml::node* found = find(key, need, expected);
  if (found == nullptr) return;
  const toml::array* array = found->as_array();
  if (array == nullptr) return wrong_type(*found, key, expected);
  if (array->size() != values.size()) {
    problems_.add(*found, what_ + ": " + std::string(key) + " has " + std::to_string(array->size()) +
                              " elements; expected " + expected);
    return;
  }
  for (size_t i = 0; i < values.size(); ++i) {
    const toml::node& element = (*array)[i];
    const std::optional<double> value = element.is_number() ? element.value<double>() : std::nullopt;
    if (!value || !std::isfinite(*value)) return wrong_type(element, key, expected + ", all finite");
    values[i] = *value;
  }
}

std::vector<std::string> TableReader::texts(std::string_view key, Need need) {
  std::vector<std::string> values;
  const toml::node* found = find(key, need, "an array of strings");
  if (found == nullptr) return values;
  const toml::array* array = found->as_array();
  if (array == nullptr) {
    wrong_type(*found, key, "an array of strings");
    return values;
  }
  if (array->size() > kMaxArray) {
    problems_.add(*found,
                  what_ + ": " + std::string(key) + " has more than " + std::to_string(kMaxArray) + " elements");
    return values;
  }
  for (const toml::node& element : *array) {
    const auto* string = element.as_string();
    if (string == nullptr || string->get().empty())
      wrong_type(element, key, "an array of strings that are not empty");
    else if (plain(*string, key))
      values.push_back(string->get());
  }
  return values;
}

const toml::table* TableReader::table(std::string_view key, Need need) {
  const toml::node* found = find(key, need, "a table");
  if (found == nullptr) return nullptr;
  const toml::table* value = found->as_table();
  if (value == nullptr) wrong_type(*found, key, "a table { … }");
  return value;
}

std::vector<const toml::table*> TableReader::tables(std::string_view key, Need need) {
  std::vector<const toml::table*> values;
  const toml::node* found = find(key, need, "an array of tables");
  if (found == nullptr) return values;
  const toml::array* array = found->as_array();
  if (array == nullptr) {
    wrong_type(*found, key, "an array of tables");
    return values;
  }
  for (const toml::node& element : *array) {
    if (const toml::table* value = element.as_table(); value != nullptr)
      values.push_back(value);
    else
      wrong_type(element, key, "an array of tables");
  }
  return values;
}

std::optional<Direction> TableReader::direction(std::string_view key, Need need) {
  const std::string name = text(key, need);
  if (name.empty()) return std::nullopt;
  const std::optional<Direction> value = direction_from_name(name);
  if (!value)
    problems_.add(*node(key), what_ + ": " + std::string(key) + " is " + shown(name) +
                                  "; expected left or right, up or down, away or toward, joined by hyphens");
  return value;
}

std::string TableReader::word(std::string_view key, Need need, std::span<const std::string_view> list) {
  const std::string value = text(key, need);
  if (value.empty() || std::ranges::find(list, value) != list.end()) {
    if (value.empty() && node(key) != nullptr && node(key)->value<std::string_view>() == std::string_view())
      problems_.add(*node(key), what_ + ": " + std::string(key) + " is empty; expected " + join_choices(list));
    return value;
  }
  problems_.add(*node(key),
                what_ + ": " + std::string(key) + " is " + shown(value) + "; expected " + join_choices(list));
  return {};
}

void TableReader::finish() {
  for (const auto& [key, value] : table_) {
    if (asked_.find(key.str()) == asked_.end()) {
      std::string expected;
      for (const std::string& known : asked_)
        expected += (expected.empty() ? "" : ", ") + known;
      problems_.add(value, what_ + ": unknown key " + shown(key.str()) + "; expected one of " + expected);
    }
  }
}

}  // namespace auslan
