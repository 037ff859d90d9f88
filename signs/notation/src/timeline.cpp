// SPDX-License-Identifier: Apache-2.0
#include "timeline.h"

#include <algorithm>

namespace auslan::notation {
namespace {

constexpr size_t kMaxStrokes = 64;
constexpr int kMaxRepeats = 12;

using Timeline = std::vector<Stroke>;

class Unroller {
 public:
  explicit Unroller(Findings& findings) : findings_(findings) {}

  Timeline unroll(const WrittenMotion& motion, Hands hands) {
    Timeline strokes = structure(motion, hands);
    for (Stroke& stroke : strokes) {
      stroke.alternating = stroke.alternating || motion.alternating;
      stroke.fast = stroke.fast || motion.fast;
      stroke.slow = stroke.slow || motion.slow;
      stroke.tense = stroke.tense || motion.tense;
      stroke.halt = stroke.halt || motion.halt;
    }
    if (!strokes.empty()) strokes.back().rest = strokes.back().rest || motion.rest;
    if (strokes.size() > kMaxStrokes) cut(motion.mark, strokes);
    return strokes;
  }

  /// Appends, so that numbers of strokes inside `more` keep their meaning.
  void append(Timeline& strokes, Timeline more, const Mark& mark) {
    const int shift = static_cast<int>(strokes.size());
    for (Stroke& stroke : more) {
      if (stroke.restart_from >= 0) stroke.restart_from += shift;
      strokes.push_back(std::move(stroke));
    }
    if (strokes.size() > kMaxStrokes) cut(mark, strokes);
  }

 private:
  void cut(const Mark& mark, Timeline& strokes) {
    strokes.resize(kMaxStrokes);
    if (!told_) findings_.left_out(mark, "more than " + std::to_string(kMaxStrokes) + " strokes; the rest is left out");
    told_ = true;
  }

  /// Stroke by stroke at the same time.
  static void zip(Timeline& strokes, Timeline more) {
    if (more.size() > strokes.size()) strokes.resize(more.size());
    for (size_t i = 0; i < more.size(); ++i) {
      Stroke& stroke = strokes[i];
      Stroke& other = more[i];
      stroke.items.insert(stroke.items.end(), other.items.begin(), other.items.end());
      stroke.repeats = std::max(stroke.repeats, other.repeats);
      if (stroke.restart_from < 0) stroke.restart_from = other.restart_from;
      stroke.alternating = stroke.alternating || other.alternating;
      stroke.fast = stroke.fast || other.fast;
      stroke.slow = stroke.slow || other.slow;
      stroke.tense = stroke.tense || other.tense;
      stroke.rest = stroke.rest || other.rest;
      stroke.halt = stroke.halt || other.halt;
    }
  }

  Timeline structure(const WrittenMotion& motion, Hands hands) {
    Timeline strokes;
    switch (motion.kind) {
      case WrittenMotion::Kind::kSequence:
        if (motion.fused && motion.parts.size() > 1)
          findings_.warning(motion.mark, "a fused sequence is signed as a plain one: with a stop between its parts");
        for (const WrittenMotion& part : motion.parts)
          append(strokes, unroll(part, hands), motion.mark);
        break;
      case WrittenMotion::Kind::kParallel:
        for (const WrittenMotion& part : motion.parts)
          zip(strokes, unroll(part, hands));
        break;
      case WrittenMotion::Kind::kSplit:
        for (size_t i = 0; i < motion.parts.size() && i < 2; ++i)
          zip(strokes, unroll(motion.parts[i], {hands.dominant && i == 0, hands.other && i == 1}));
        break;
      case WrittenMotion::Kind::kTarget:
        for (const WrittenMotion& part : motion.parts)
          append(strokes, unroll(part, hands), motion.mark);
        if (strokes.empty()) strokes.emplace_back();
        strokes.back().items.push_back({nullptr, &motion.target, hands});
        break;
      case WrittenMotion::Kind::kRepeat:
        strokes = repeat(motion, hands);
        break;
      default:
        strokes.emplace_back();
        strokes.back().items.push_back({&motion, nullptr, hands});
        break;
    }
    return strokes;
  }

  Timeline repeat(const WrittenMotion& motion, Hands hands) {
    Timeline once;
    for (const WrittenMotion& part : motion.parts)
      append(once, unroll(part, hands), motion.mark);
    if (once.empty()) return once;
    const std::string& kind = motion.repetition;
    int times = 2;
    if (kind == "fromstart_several" || kind == "continue_several" || kind == "manyrandom") times = 3;
    if (kind == "manyrandom") times = 4;
    if (kind == "swap")
      findings_.left_out(motion.mark, "the repetition \"swap\" is signed as a plain one: the hands keep their parts");
    // Between once more and several times: several are not many.
    if (!motion.second_repetition.empty() && motion.second_repetition.ends_with("_several")) times = 3;
    if (kind == "reverse" || kind == "tofroto") {
      // Back to where it began; to-fro-to then goes there once more.
      Timeline strokes = once;
      strokes.emplace_back();
      strokes.back().restart_from = 0;
      if (kind == "tofroto") append(strokes, once, motion.mark);
      return strokes;
    }
    const bool goes_on = kind == "continue" || kind == "continue_several";
    if (!goes_on && kind != "fromstart" && kind != "fromstart_several" && kind != "manyrandom" && kind != "swap")
      findings_.left_out(motion.mark, "the repetition " + in_quotes(kind) +
                                          " is not known; the movement is made twice (expected fromstart, "
                                          "fromstart_several, continue, continue_several, reverse, tofroto or "
                                          "manyrandom)");
    const bool varies = !motion.shift.empty() || !motion.repetition_growth.empty();
    if (once.size() == 1 && !goes_on && !varies) {
      once.front().repeats = std::min(kMaxRepeats, once.front().repeats * times);
      return once;
    }
    Timeline strokes = once;
    for (int i = 1; i < times && strokes.size() < kMaxStrokes; ++i) {
      const size_t at = strokes.size();
      append(strokes, once, motion.mark);
      if (at >= strokes.size()) break;
      if (!goes_on) strokes[at].restart_from = 0;
      strokes[at].mark = motion.mark;
      strokes[at].shift = motion.shift;
      strokes[at].shift_size = motion.shift_size.empty() ? "small" : motion.shift_size;
      strokes[at].shifts = i;
      const double step = motion.repetition_growth_size == "big" ? 1.6 : 1.3;
      for (size_t k = at; k < strokes.size() && !motion.repetition_growth.empty(); ++k)
        for (int n = 0; n < i; ++n)
          strokes[k].scale *= motion.repetition_growth == "increasing" ? step : 1.0 / step;
    }
    return strokes;
  }

  Findings& findings_;
  bool told_ = false;
};

}  // namespace

std::vector<Stroke> timeline_of(const std::vector<WrittenMotion>& motions, Findings& findings) {
  Unroller unroller(findings);
  Timeline strokes;
  for (const WrittenMotion& motion : motions)
    unroller.append(strokes, unroller.unroll(motion, {}), motion.mark);
  return strokes;
}

}  // namespace auslan::notation
