// SPDX-License-Identifier: Apache-2.0
// The recursive reader over HamNoSys symbols.
#pragma once

#include "token_reader.h"

#include <utility>

namespace auslan::notation {

inline bool starts_shape(SymbolKind kind) {
  using enum SymbolKind;
  return kind == kHandshape || kind == kThumb || kind == kBend;
}
inline bool starts_place(SymbolKind kind) {
  using enum SymbolKind;
  return kind == kBody || kind == kHandSite || kind == kDigit || kind == kFingerPart || kind == kSide ||
         kind == kContact || kind == kBehind;
}
inline bool starts_posture(SymbolKind kind) {
  using enum SymbolKind;
  return starts_shape(kind) || kind == kFingers || kind == kPalm || starts_place(kind);
}
inline bool starts_action(SymbolKind kind) {
  using enum SymbolKind;
  return kind == kMove || kind == kCircle || kind == kWrist || kind == kFingerplay || kind == kReplace ||
         kind == kNoMotion || kind == kBrushing;
}

/// Reads a whole sign; postures are in token_postures.cpp, symmetry and movements in token_reader.cpp.
class TokenReader {
 public:
  TokenReader(std::span<const Token> tokens, const Mark& mark, WrittenSign& sign, Findings& findings)
      : tokens_(tokens), mark_(mark), sign_(sign), findings_(findings) {}

  void read() {
    while (at_ < tokens_.size())
      read_part();
  }

 private:
  using enum SymbolKind;

  bool more() const { return at_ < tokens_.size(); }
  SymbolKind kind(size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() ? tokens_[at_ + ahead].symbol->kind : kOther;
  }
  std::string value() const { return std::string(tokens_[at_].symbol->value); }
  const Mark& mark() const { return at_ < tokens_.size() ? tokens_[at_].mark : mark_; }
  bool take(SymbolKind wanted) {
    if (!more() || kind() != wanted) return false;
    ++at_;
    return true;
  }
  void skip(std::string_view why) {
    const std::string_view value = tokens_[at_].symbol->value;
    if (kind() != kOther || !value.empty())
      findings_.left_out(mark(), "the symbol " + in_quotes(tokens_[at_].symbol->name) +
                                     (kind() == kOther ? " (" + std::string(value) + ")" : "") + " " +
                                     std::string(why));
    ++at_;
  }
  /// What a bracket is about: the first symbol inside it.
  SymbolKind first_inside(size_t ahead) const {
    size_t i = at_ + ahead;
    while (i < tokens_.size() &&
           (tokens_[i].symbol->kind == kParallelBegin || tokens_[i].symbol->kind == kSequenceBegin ||
            tokens_[i].symbol->kind == kFusionBegin || tokens_[i].symbol->kind == kPlus))
      ++i;
    return i < tokens_.size() ? tokens_[i].symbol->kind : kOther;
  }
  bool action_here() const {
    if (!more()) return false;
    if (starts_action(kind())) return true;
    const bool bracket = kind() == kParallelBegin || kind() == kSequenceBegin || kind() == kFusionBegin;
    return bracket && starts_action(first_inside(0));
  }

  void read_part();
  void read_symmetry(WrittenPart& part);
  void read_posture(WrittenPosture& posture, bool top);
  void read_posture_piece(WrittenPosture& posture, size_t hand, bool split);
  void read_posture_group(WrittenPosture& posture);
  void read_place(WrittenPosture& posture, size_t hand, bool split);
  WrittenShape read_shape(std::optional<WrittenShape>& second);
  void read_one_shape(WrittenShape& shape);
  WrittenHandSite read_hand_site();
  std::string side_word(const std::string& step, bool before) const { return (before ? "left_" : "right_") + step; }
  std::optional<WrittenMotion> read_action(int depth);
  WrittenMotion read_group(int depth);
  void read_modifiers(WrittenMotion& motion);
  void read_repeats(WrittenMotion& motion);
  void read_target(WrittenMotion& motion);

  std::span<const Token> tokens_;
  size_t at_ = 0;
  Mark mark_;
  WrittenSign& sign_;
  Findings& findings_;
};

}  // namespace auslan::notation
