// SPDX-License-Identifier: Apache-2.0
#include "words.h"

#include "characters.h"
#include "closed_class.h"
#include "contraction.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

/// Reads one text; the methods advance `at_`.
class Reader {
 public:
  Reader(std::string_view text, std::vector<Character> characters)
      : text_(text), characters_(std::move(characters)), count_(characters_.size() - 1) {}

  std::vector<Word> read() {
    while (at_ < count_)
      read_next();
    settle_possessives();
    return std::move(words_);
  }

 private:
  CharClass kind(size_t i) const { return i < count_ ? characters_[i].kind : CharClass::kNewline; }
  int32_t code(size_t i) const { return i < count_ ? characters_[i].code : 0; }
  size_t byte(size_t i) const { return characters_[i].begin; }
  std::string_view slice(size_t from, size_t to) const { return text_.substr(byte(from), byte(to) - byte(from)); }
  bool in_word(size_t i) const { return kind(i) == CharClass::kLetter || kind(i) == CharClass::kDigit; }

  void read_next() {
    switch (kind(at_)) {
      case CharClass::kLetter:
        return read_letters();
      case CharClass::kDigit:
        return read_number();
      case CharClass::kFraction:
        return read_fraction();
      case CharClass::kSymbolWord:
        return read_symbol();
      case CharClass::kOther:
        return read_other();
      case CharClass::kHyphen:
        return read_hyphen();
      case CharClass::kDash:
        return read_dash();
      case CharClass::kPoint:
        return read_point();
      case CharClass::kStop:
        return add_break(2, false, 1);
      case CharClass::kQuestion:
        return add_break(2, true, 1);
      case CharClass::kComma:
        return add_break(1, false, 1);
      case CharClass::kSlash:
        if (at_ > 0 && in_word(at_ - 1) && in_word(at_ + 1)) {
          ++at_;
          return;
        }
        return add_break(1, false, 1);
      case CharClass::kNewline:
        return read_newlines();
      default:
        ++at_;
    }
  }

  void add_break(int strength, bool question, size_t length) {
    const size_t begin = byte(at_);
    at_ += length;
    if (words_.empty()) return;
    Break& after = words_.back().after;
    if (after.begin == after.end) after.begin = begin;
    after.end = byte(at_);
    after.strength = std::max(after.strength, strength);
    after.question = after.question || question;
  }

  /// A blank line ends a sentence; a single line break is white space, because text is often wrapped by hand.
  void read_newlines() {
    int newlines = 0;
    while (at_ < count_ && (kind(at_) == CharClass::kNewline || kind(at_) == CharClass::kSpace)) {
      if (kind(at_) == CharClass::kNewline) ++newlines;
      ++at_;
    }
    if (newlines < 2 || words_.empty() || words_.back().after.strength == 2) return;
    Break& after = words_.back().after;
    if (after.begin == after.end) after.begin = after.end = words_.back().end;
    after.strength = 2;
  }

  Word& add_word(WordKind word_kind, size_t from, size_t to, std::string norm) {
    Word word;
    word.kind = word_kind;
    word.begin = byte(from);
    word.end = byte(to);
    word.norm = std::move(norm);
    word.capital = is_upper(code(from));
    word.glued = std::exchange(glue_, false);
    words_.push_back(std::move(word));
    return words_.back();
  }

  bool all_upper(size_t from, size_t to) const {
    int letters = 0;
    for (size_t i = from; i < to; ++i) {
      if (kind(i) != CharClass::kLetter) continue;
      if (!is_upper(code(i))) return false;
      ++letters;
    }
    return letters > 1;
  }

  /// "a.m.", "U.S.A": single letters with points between. Returns the end, or `from` where it is none.
  size_t abbreviation_end(size_t from) const {
    size_t i = from;
    int letters = 0;
    while (kind(i) == CharClass::kLetter && kind(i + 1) == CharClass::kPoint) {
      i += 2;
      ++letters;
    }
    if (kind(i) == CharClass::kLetter && !in_word(i + 1) && letters > 0) {
      ++i;
      ++letters;
    }
    return letters > 1 && !in_word(i) ? i : from;
  }

  void read_letters() {
    const size_t from = at_;
    const size_t abbreviation = abbreviation_end(from);
    if (abbreviation > from) {
      std::string letters;
      for (size_t i = from; i < abbreviation; ++i)
        if (kind(i) == CharClass::kLetter) letters += slice(i, i + 1);
      at_ = abbreviation;
      Word& word = add_word(WordKind::kLetters, from, abbreviation, fold_case(letters));
      word.rule = "abbreviation";
      return end_sentence_after_abbreviation();
    }
    while (at_ < count_) {
      const bool inner_apostrophe =
          kind(at_) == CharClass::kApostrophe && in_word(at_ - 1) && kind(at_ + 1) == CharClass::kLetter;
      if (!in_word(at_) && kind(at_) != CharClass::kIgnored && !inner_apostrophe) break;
      ++at_;
    }
    add_letters(from, at_);
  }

  /// The point of "10 a.m." also ends a sentence where a new one begins.
  void end_sentence_after_abbreviation() {
    size_t next = at_;
    while (next < count_ && kind(next) == CharClass::kSpace)
      ++next;
    const std::string& norm = words_.back().norm;
    if (next > at_ && is_upper(code(next)) && (norm == "am" || norm == "pm") && kind(at_ - 1) == CharClass::kPoint) {
      words_.back().after = {2, false, byte(at_ - 1), byte(at_)};
      words_.back().end = byte(at_ - 1);
    }
  }

  void add_letters(size_t from, size_t to) {
    std::string norm = fold_case(slice(from, to));
    // As many bytes as characters: plain letters, typographic apostrophes already made plain.
    const bool plain = norm.size() == to - from;
    const Contraction contraction = plain ? expand_contraction(norm) : accented_word(norm, to - from);
    if (contraction.parts.size() > 1) {
      size_t at = from;
      for (const ContractionPart& part : contraction.parts) {
        Word& word = add_word(WordKind::kLetters, at, at + part.length, part.norm);
        word.rule = at == from ? std::string_view{} : "contraction";
        word.upper = all_upper(at, at + part.length);
        at += part.length;
      }
      return;
    }
    Word& word = add_word(WordKind::kLetters, from, to, std::move(norm));
    word.upper = all_upper(from, to);
    word.possessive = contraction.apostrophe_s == ApostropheS::kUnclear;
  }

  /// Words with letters beyond ASCII ("café's") have no other contraction than 's.
  static Contraction accented_word(const std::string& norm, size_t length) {
    Contraction none;
    none.parts.push_back({length, norm});
    if (norm.size() > 2 && norm.compare(norm.size() - 2, 2, "'s") == 0) none.apostrophe_s = ApostropheS::kUnclear;
    return none;
  }

  size_t digits_end(size_t from) const {
    while (kind(from) == CharClass::kDigit)
      ++from;
    return from;
  }

  void append_digits(size_t from, size_t to, std::string* norm) const {
    for (size_t i = from; i < to; ++i)
      *norm += static_cast<char>('0' + digit_value(code(i)));
  }

  /// Digits with separators that belong to the number; appends the reading to `norm` and returns the end.
  size_t scan_number(size_t from, std::string* norm) const {
    size_t end = digits_end(from);
    append_digits(from, end, norm);
    bool thousands = end - from <= 3;
    while (kind(end + 1) == CharClass::kDigit) {
      const size_t next_end = digits_end(end + 1);
      const int32_t separator = code(end);
      if (separator == ',' && thousands && next_end - end - 1 == 3) {
        // a thousands comma is not read
      } else if (separator == '.' || separator == ':' || separator == '/') {
        *norm += static_cast<char>(separator);
        thousands = false;
      } else if (separator == '-' && is_date(from, end, next_end)) {
        *norm += '/';
        thousands = false;
      } else {
        break;
      }
      append_digits(end + 1, next_end, norm);
      end = next_end;
    }
    return end;
  }

  /// 2026-11-22, seen from its first or its second hyphen.
  bool is_date(size_t from, size_t hyphen, size_t next_end) const {
    if (next_end - hyphen != 3) return false;
    const bool first = hyphen - from == 4 && code(next_end) == '-' && digits_end(next_end + 1) == next_end + 3;
    const bool second = hyphen - from == 7 && code(hyphen - 3) == '-';
    return first || second;
  }

  void read_number() {
    const size_t from = at_;
    std::string norm;
    const size_t end = scan_number(from, &norm);
    size_t letters_end = end;
    while (kind(letters_end) == CharClass::kLetter)
      ++letters_end;
    const std::string suffix = fold_case(slice(end, letters_end));
    const bool whole = !in_word(letters_end);
    if (!suffix.empty() && !(whole && is_unit(suffix))) {
      at_ = end;  // an ordinal ("2nd"), or letters and digits mixed ("4WD", "2b3")
      while (in_word(at_) || (kind(at_) == CharClass::kIgnored && at_ < count_))
        ++at_;
      Word& word = add_word(WordKind::kLetters, from, at_, fold_case(slice(from, at_)));
      word.capital = false;
      return;
    }
    at_ = end;
    add_word(WordKind::kNumber, from, end, std::move(norm));
    if (suffix.empty()) return;
    at_ = letters_end;
    glue_ = true;
    add_word(WordKind::kLetters, end, letters_end, suffix).rule = "unit";
  }

  void read_fraction() {
    const size_t from = at_++;
    std::string norm = fraction_reading(slice(from, at_));
    const WordKind word_kind = norm.empty() ? WordKind::kOther : WordKind::kNumber;
    add_word(word_kind, from, at_, std::move(norm));
  }

  /// "1/2" for the character one half, "2" for a superscript two, empty where it is neither.
  static std::string fraction_reading(std::string_view character) {
    std::vector<std::string> lost;
    std::string digits = fold_letters(character, &lost);
    if (!lost.empty() && lost != std::vector<std::string>{"\u2044"}) return {};
    if (lost.empty()) {
      const bool plain =
          !digits.empty() && std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
      return plain ? digits : std::string();
    }
    if (digits.size() < 2) return {};
    return digits.substr(0, 1) + "/" + digits.substr(1);  // every vulgar fraction has a numerator of one digit
  }

  void read_symbol() {
    const size_t from = at_++;
    add_word(WordKind::kLetters, from, at_, std::string(symbol_reading(code(from)))).rule = "symbol";
  }

  void read_other() {
    const size_t from = at_;
    while (at_ < count_ && (kind(at_) == CharClass::kOther || kind(at_) == CharClass::kIgnored))
      ++at_;
    add_word(WordKind::kOther, from, at_, {});
  }

  void read_hyphen() {
    const bool before = at_ > 0 && (in_word(at_ - 1) || kind(at_ - 1) == CharClass::kPoint);
    if (!before && kind(at_ + 1) == CharClass::kDigit) {
      add_word(WordKind::kLetters, at_, at_ + 1, "minus").rule = "symbol";
      ++at_;
      return;
    }
    if (before && in_word(at_ + 1)) {
      if (kind(at_ - 1) == CharClass::kDigit && kind(at_ + 1) == CharClass::kDigit) return read_range(true);
      glue_ = true;
      ++at_;
      return;
    }
    read_dash();
  }

  void read_dash() {
    if (at_ > 0 && kind(at_ - 1) == CharClass::kDigit && kind(at_ + 1) == CharClass::kDigit) return read_range(false);
    add_break(1, false, 1);
  }

  /// "9-5" is read "9 to 5"; "555-1234" is a number in groups, not a range.
  void read_range(bool hyphen) {
    size_t before = at_;
    while (before > 0 && kind(before - 1) == CharClass::kDigit)
      --before;
    const size_t after = digits_end(at_ + 1);
    const bool short_numbers = at_ - before <= 2 && after - at_ - 1 <= 2;
    if (!hyphen || short_numbers)
      add_word(WordKind::kLetters, at_, at_ + 1, "to").rule = "number:range";
    else
      glue_ = true;
    ++at_;
  }

  void read_point() {
    size_t points = 1;
    while (kind(at_ + points) == CharClass::kPoint)
      ++points;
    if (points > 1) return add_break(1, false, points);  // an ellipsis
    const bool joined = at_ > 0 && in_word(at_ - 1) && in_word(at_ + 1);
    if (joined && !is_upper(code(at_ + 1))) {  // example.com
      add_word(WordKind::kLetters, at_, at_ + 1, "dot").rule = "symbol";
      ++at_;
      return;
    }
    if (!words_.empty() && words_.back().end == byte(at_) && is_title_abbreviation(words_.back().norm)) {
      ++at_;  // "Dr. Lee": the point belongs to the title
      return;
    }
    add_break(2, false, 1);
  }

  /// noun's: "is" before what cannot follow a possessive, else possessive.
  void settle_possessives() {
    std::vector<Word> settled;
    settled.reserve(words_.size());
    for (size_t i = 0; i < words_.size(); ++i) {
      Word& word = words_[i];
      if (!word.possessive) {
        settled.push_back(std::move(word));
        continue;
      }
      const bool last = i + 1 == words_.size() || word.after.strength > 0;
      const size_t mark = text_.substr(word.begin, word.end - word.begin).find_last_not_of("sS");
      size_t split = word.begin + mark;
      while (split > word.begin && (static_cast<unsigned char>(text_[split]) & 0xC0) == 0x80)
        --split;
      word.norm.resize(word.norm.size() - 2);
      if (!last && follows_copula(words_[i + 1].norm)) {
        Word copula = word;
        word.end = copula.begin = split;
        word.after = {};
        word.possessive = copula.possessive = copula.capital = copula.upper = copula.glued = false;
        copula.norm = "is";
        copula.rule = "contraction";
        settled.push_back(std::move(word));
        settled.push_back(std::move(copula));
      } else {
        settled.push_back(std::move(word));
      }
    }
    words_ = std::move(settled);
  }

  std::string_view text_;
  std::vector<Character> characters_;
  size_t count_ = 0;
  size_t at_ = 0;
  bool glue_ = false;
  std::vector<Word> words_;
};

}  // namespace

Result<std::vector<Word>> read_words(std::string_view text) {
  auto characters = read_characters(text);
  if (!characters) return tl::unexpected<Error>(std::move(characters.error()));
  return Reader(text, std::move(*characters)).read();
}

}  // namespace auslan
