// SPDX-License-Identifier: Apache-2.0
#include "token_reader.h"

#include "token_parser.h"

namespace auslan::notation {
namespace {

using enum SymbolKind;
using Kind = WrittenMotion::Kind;

constexpr int kMaxNesting = 24;

}  // namespace

void TokenReader::read_symmetry(WrittenPart& part) {
  bool seen = false;
  while (more()) {
    if (kind() == kSymmetry) {
      part.both_hands = true;
      part.mirror_lr = value() == "lr";
      seen = true;
      ++at_;
    } else if (seen && kind() == kSize) {
      if (value() == "big") part.mirror_ud = true;
      if (value() != "big") findings_.left_out(mark(), "a small symmetry is not known; left out");
      ++at_;
    } else if (seen && kind() == kBend) {
      part.mirror_oi = true;
      ++at_;
    } else if (seen && kind() == kAlternating) {
      part.out_of_phase = true;
      ++at_;
    } else if (kind() == kNonIpsi) {
      part.literal_space = true;
      ++at_;
    } else if (kind() == kNonDominant) {
      part.non_dominant = true;
      ++at_;
    } else {
      return;
    }
  }
}

void TokenReader::read_modifiers(WrittenMotion& motion) {
  // A size belongs to what stands before it.
  std::string* size = &motion.size;
  while (more()) {
    switch (kind()) {
      case kSize:
        *size = value();
        break;
      case kArc:
        motion.curve = value();
        size = &motion.curve_size;
        break;
      case kWaviness:
        motion.waviness = value();
        size = &motion.waviness_size;
        break;
      case kClock:
        (motion.clock_start.empty() ? motion.clock_start : motion.clock_end) = value();
        break;
      case kClockFull:
        ++motion.extra_turns;
        break;
      case kEllipse:
        motion.ellipse = value();
        size = &motion.ellipse_size;
        break;
      case kGrowth:
        motion.growth = value();
        size = &motion.growth_size;
        break;
      case kManner: {
        const std::string manner = value();
        motion.fast = motion.fast || manner == "fast";
        motion.slow = motion.slow || manner == "slow";
        motion.tense = motion.tense || manner == "tense";
        motion.rest = motion.rest || manner == "rest";
        motion.halt = motion.halt || manner == "halt";
        break;
      }
      case kAlternating:
        motion.alternating = true;
        break;
      case kBrushing:
        motion.brushing = true;
        findings_.note(mark(), "brushing is carried where the hand is");
        break;
      case kBetween:
        if ((kind(1) == kMove && motion.kind == Kind::kDirected) ||
            (kind(1) == kCircle && motion.kind == Kind::kCircular)) {
          ++at_;
          motion.second_direction = value();
        } else if (kind(1) == kSize) {
          ++at_;
          motion.second_size = value();
        } else {
          return;
        }
        break;
      default:
        return;
    }
    ++at_;
  }
}

void TokenReader::read_repeats(WrittenMotion& motion) {
  while (more() && (kind() == kRepeat || kind() == kAlternating)) {
    if (kind() == kAlternating) {
      motion.alternating = true;
      ++at_;
      continue;
    }
    WrittenMotion repeat;
    repeat.mark = mark();
    repeat.kind = Kind::kRepeat;
    repeat.repetition = value();
    repeat.alternating = motion.alternating;
    ++at_;
    // "once more and once more" nests without end; a few are what people write.
    int levels = 0;
    for (const WrittenMotion* inner = &motion; inner->kind == Kind::kRepeat && !inner->parts.empty();
         inner = &inner->parts[0])
      ++levels;
    if (levels >= 3) {
      findings_.left_out(repeat.mark, "a repetition of a repetition of a repetition is left out");
      continue;
    }
    repeat.parts.push_back(std::move(motion));
    motion = std::move(repeat);
  }
}

/// A place or posture after a movement is where it ends.
void TokenReader::read_target(WrittenMotion& motion) {
  if (!more()) return;
  const bool group = kind() == kParallelBegin && starts_posture(first_inside(0));
  const bool touch = kind() == kSequenceBegin && kind(1) == kContact;
  if (!starts_place(kind()) && !(group && !starts_shape(first_inside(0))) && !touch) return;
  WrittenMotion target;
  target.mark = motion.mark;
  target.kind = Kind::kTarget;
  read_posture(target.target, false);
  if (target.target.empty()) return;
  target.parts.push_back(std::move(motion));
  motion = std::move(target);
}

WrittenMotion TokenReader::read_group(int depth) {
  WrittenMotion group;
  group.mark = mark();
  const SymbolKind begin = kind();
  const SymbolKind end = begin == kParallelBegin ? kParallelEnd : begin == kSequenceBegin ? kSequenceEnd : kFusionEnd;
  group.fused = begin == kFusionBegin;
  ++at_;
  std::vector<std::vector<WrittenMotion>> sides(1);
  while (more() && kind() != end) {
    if (kind() == kPlus) {
      ++at_;
      if (sides.size() >= 2) findings_.warning(mark(), "a third part of a two-handed bracket; read with the second");
      if (sides.size() < 2) sides.emplace_back();
    } else if (action_here() && depth < kMaxNesting) {
      if (auto action = read_action(depth + 1)) sides.back().push_back(std::move(*action));
    } else if ((starts_posture(kind()) || kind() == kParallelBegin) && depth < kMaxNesting) {
      // A posture within a movement: a change to it at the same time.
      WrittenMotion change;
      change.mark = mark();
      change.kind = Kind::kTarget;
      const size_t before = at_;
      read_posture(change.target, false);
      if (at_ == before) {
        skip("is out of order and left out");
      } else {
        sides.back().push_back(std::move(change));
      }
    } else {
      skip("is out of order and left out");
    }
  }
  if (more()) {
    ++at_;
  } else {
    findings_.warning(group.mark, "a bracket is not closed; it ends with the sign");
  }
  const Kind inside = begin == kParallelBegin ? Kind::kParallel : Kind::kSequence;
  if (sides.size() == 1) {
    group.kind = inside;
    group.parts = std::move(sides[0]);
  } else {
    group.kind = Kind::kSplit;
    for (auto& side : sides) {
      WrittenMotion half;
      half.mark = side.empty() ? group.mark : side.front().mark;
      half.kind = inside;
      half.parts = std::move(side);
      group.parts.push_back(std::move(half));
    }
  }
  return group;
}

std::optional<WrittenMotion> TokenReader::read_action(int depth) {
  WrittenMotion motion;
  motion.mark = mark();
  switch (kind()) {
    case kMove:
    case kCircle:
      motion.kind = kind() == kMove ? Kind::kDirected : Kind::kCircular;
      motion.direction = value();
      ++at_;
      read_modifiers(motion);
      break;
    case kWrist:
      motion.kind = Kind::kWrist;
      motion.wrist = value();
      ++at_;
      read_modifiers(motion);
      break;
    case kFingerplay: {
      motion.kind = Kind::kFingerplay;
      ++at_;
      while (more() && kind() == kDigit) {
        if (motion.digits.find(value()) == std::string::npos) motion.digits += value();
        ++at_;
      }
      read_modifiers(motion);
      break;
    }
    case kNoMotion:
      ++at_;
      read_modifiers(motion);
      break;
    case kReplace:
      motion.kind = Kind::kTarget;
      ++at_;
      read_modifiers(motion);
      read_posture(motion.target, false);
      if (more() && (kind() == kManner || kind() == kGrowth)) read_modifiers(motion);
      // A change that grows or shrinks goes from finger to finger.
      if (!motion.growth.empty() && motion.target.shared.shape)
        motion.target.shared.shape->successive = motion.growth == "increasing" ? "towards_pinky" : "towards_thumb";
      break;
    case kBrushing:
      findings_.left_out(mark(), "brushing without a movement is left out");
      ++at_;
      return std::nullopt;
    default:
      motion = read_group(depth);
      read_modifiers(motion);
      break;
  }
  if (motion.kind != Kind::kTarget) read_target(motion);
  read_repeats(motion);
  return motion;
}

void TokenReader::read_part() {
  const size_t begin = at_;
  WrittenPart part;
  part.mark = mark();
  read_symmetry(part);
  while (more() && !starts_posture(kind()) && !action_here() && kind() != kParallelBegin && kind() != kSymmetry &&
         kind() != kPlus)
    skip("is out of order and left out");
  if (more() && kind() == kSymmetry) read_symmetry(part);
  read_posture(part.start, true);
  bool ended = false;
  while (more() && !ended) {
    if (action_here()) {
      if (auto action = read_action(0)) part.motions.push_back(std::move(*action));
    } else if (kind() == kPlus) {
      // A new manual part: the sign is a compound.
      ++at_;
      ended = true;
    } else if (kind() == kSymmetry || (!part.motions.empty() && kind() == kHandshape)) {
      ended = true;
    } else if (kind() == kRepeat && !part.motions.empty()) {
      read_repeats(part.motions.back());
    } else if (kind() == kRepeat || kind() == kAlternating) {
      if (kind() == kAlternating) part.out_of_phase = true;
      if (kind() == kRepeat) findings_.left_out(mark(), "a repetition without a movement before it is left out");
      ++at_;
    } else if (!part.motions.empty() &&
               (starts_posture(kind()) || (kind() == kParallelBegin && starts_posture(first_inside(0))))) {
      WrittenMotion target;
      target.mark = mark();
      target.kind = Kind::kTarget;
      const size_t before = at_;
      read_posture(target.target, false);
      if (at_ == before) {
        skip("is out of order and left out");
      } else {
        part.motions.push_back(std::move(target));
      }
    } else {
      skip("is out of order and left out");
    }
  }
  if (at_ == begin) skip("is out of order and left out");
  if (!part.start.empty() || !part.motions.empty()) sign_.parts.push_back(std::move(part));
}

void read_tokens(std::span<const Token> tokens, const Mark& mark, WrittenSign& sign, Findings& findings) {
  TokenReader(tokens, mark, sign, findings).read();
}

}  // namespace auslan::notation
