// SPDX-License-Identifier: Apache-2.0
#include "written_sign.h"

#include <algorithm>
#include <utility>

namespace auslan {

std::string to_string(const Diagnostic& diagnostic) {
  static constexpr std::string_view kGrades[] = {"error", "warning", "note"};
  return std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) + ": " +
         std::string(kGrades[static_cast<size_t>(diagnostic.grade)]) + ": " + diagnostic.message;
}

bool nothing_left_out(const std::vector<Diagnostic>& diagnostics) {
  return std::none_of(diagnostics.begin(), diagnostics.end(),
                      [](const Diagnostic& diagnostic) { return diagnostic.left_out; });
}

namespace notation {
namespace {

constexpr size_t kMaxFindings = 400;
constexpr size_t kMaxQuoted = 60;

}  // namespace

void Findings::add(Diagnostic::Grade grade, const Mark& mark, std::string message, bool left_out) {
  // Errors are always kept: they say why there is no sign.
  if (kept_.size() >= kMaxFindings && grade != Diagnostic::Grade::kError) {
    ++left_off_;
    lost_ = lost_ || left_out;
    return;
  }
  kept_.push_back({grade, mark.line, mark.column, left_out, std::move(message)});
}

std::vector<Diagnostic> Findings::take() {
  if (left_off_ > 0) {
    const Diagnostic last = kept_.back();
    kept_.push_back({Diagnostic::Grade::kWarning, last.line, last.column, lost_,
                     std::to_string(left_off_) + " more findings in this sign are not listed"});
    left_off_ = 0;
  }
  return std::exchange(kept_, {});
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  size_t length = text.size();
  if (length > kMaxQuoted) {
    length = kMaxQuoted;
    // Not inside a character of several bytes.
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U)
      --length;
  }
  for (const char c : text.substr(0, length))
    result += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  return result + (length < text.size() ? "…\"" : "\"");
}

bool WrittenShape::empty() const {
  bool digits = false;
  for (const std::string& one : digit_bend)
    digits = digits || !one.empty();
  return !digits && !thumb_enclosed && contact_kind.empty() && opposed.empty() && thumb_contact.empty() &&
         successive.empty() && base.empty() && thumb.empty() && bend.empty() && special.empty() && exempt.empty() &&
         opening.empty() && splay.empty() && crossed.empty() && thumb_between.empty();
}

bool WrittenHand::empty() const {
  return !shape && !second_shape && fingers.empty() && palm.empty();
}

void WrittenHand::merge(const WrittenHand& more) {
  if (empty()) mark = more.mark;
  if (more.shape) {
    shape = more.shape;
    shape_mark = more.mark;
    second_shape = more.second_shape;
  }
  if (!more.fingers.empty()) {
    fingers = more.fingers;
    fingers_mark = more.mark;
    second_fingers = more.second_fingers;
  }
  if (!more.palm.empty()) {
    palm = more.palm;
    palm_absolute = more.palm_absolute;
    palm_mark = more.mark;
    second_palm = more.second_palm;
  }
}

bool WrittenPosture::empty() const {
  return shared.empty() && split[0].empty() && split[1].empty() && !body[0] && !body[1] && !on_other && !meeting &&
         use_name.empty();
}

}  // namespace notation
}  // namespace auslan
