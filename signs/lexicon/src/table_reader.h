// SPDX-License-Identifier: Apache-2.0
// Strict reading of TOML tables: every access names the key and the type it expects, every surprise becomes a problem
// with its line, and keys nobody asked for are problems too.
#pragma once

#include "kinematics/result.h"
#include "phonology/vocabulary.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <vector>

namespace auslan {

/// A problem that can be ordered: the index of its file, the line, the error.
struct Problem {
  size_t file = 0;
  long line = 0;
  Error error;
};

/// Collects the problems of one file, up to a bound.
class ProblemList {
 public:
  ProblemList(std::vector<Problem>& problems, size_t file, std::string name)
      : problems_(problems), file_(file), name_(std::move(name)) {}
  void add(long line, std::string message, ErrorCode code = ErrorCode::kMalformed);
  void add(const toml::node& node, std::string message) { add(line_of(node), std::move(message)); }
  static long line_of(const toml::node& node) { return static_cast<long>(node.source().begin.line); }
  size_t file() const { return file_; }

 private:
  std::vector<Problem>& problems_;
  size_t file_;
  std::string name_;
};

enum class Need { kRequired, kOptional };

class TableReader {
 public:
  /// `what` names the table in messages: "sign HURT".
  TableReader(const toml::table& table, std::string what, ProblemList& problems)
      : table_(table), what_(std::move(what)), problems_(problems) {}

  void rename(std::string what) { what_ = std::move(what); }
  const std::string& what() const { return what_; }
  ProblemList& problems() const { return problems_; }
  long line() const { return ProblemList::line_of(table_); }

  std::string text(std::string_view key, Need need);
  int integer(std::string_view key, int fallback, int least, int most);
  double number(std::string_view key, Need need);
  /// False where the key is not there.
  bool flag(std::string_view key);
  std::vector<std::string> texts(std::string_view key, Need need);
  template <size_t N>
  std::array<double, N> numbers(std::string_view key, Need need) {
    std::array<double, N> values{};
    fill_numbers(key, need, values);
    return values;
  }
  const toml::table* table(std::string_view key, Need need);
  /// An array of tables; each element that is not one is a problem and left out.
  std::vector<const toml::table*> tables(std::string_view key, Need need);
  std::optional<Direction> direction(std::string_view key, Need need);
  /// A word of a closed list.
  std::string word(std::string_view key, Need need, std::span<const std::string_view> list);
  template <typename E>
  std::optional<E> vocabulary(std::string_view key, Need need) {
    return from_name<E>(word(key, need, names_of<E>()));
  }
  const toml::node* node(std::string_view key) const { return table_.get(key); }
  /// Calls `note(key, line)` for every key that is there.
  template <typename Note>
  void each_key(Note&& note) const {
    for (const auto& [key, value] : table_)
      note(std::string(key.str()), ProblemList::line_of(value));
  }
  /// Reports every key that was not asked for.
  void finish();

 private:
  const toml::node* find(std::string_view key, Need need, std::string_view expected);
  /// Bounded and without control characters; else a problem.
  bool plain(const toml::value<std::string>& string, std::string_view key);
  void fill_numbers(std::string_view key, Need need, std::span<double> values);
  void wrong_type(const toml::node& node, std::string_view key, std::string_view expected);

  const toml::table& table_;
  std::string what_;
  ProblemList& problems_;
  std::set<std::string, std::less<>> asked_;
};

/// "a, b or c".
std::string join_choices(std::span<const std::string_view> words);

}  // namespace auslan
