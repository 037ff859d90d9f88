// SPDX-License-Identifier: Apache-2.0
#include "synthesis/choreography.h"

#include "performance_of_sign.h"
#include "phonology/vocabulary.h"
#include "stroke.h"
#include "synthesis/mouthing.h"
#include "synthesis/non_manual.h"
#include "synthesis/performance.h"
#include "turning.h"
#include "way.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace auslan {
namespace {

constexpr size_t kLeft = static_cast<size_t>(Side::kLeft), kRight = static_cast<size_t>(Side::kRight);

bool any_weight(const FaceWeights& weights) {
  return std::any_of(weights.begin(), weights.end(), [](float w) { return w > 0; });
}

bool any(const BodyFeature& feature) {
  return feature.head != Vec3(0.0) || feature.trunk != Vec3(0.0) || feature.swing != Vec3(0.0);
}

/// A word of the tier of that name.
void add_word(std::string_view tier, std::string_view word, BodyFeature& body, FaceWeights& face) {
  if (tier == "brows") add_brows(word, face);
  if (tier == "eyes") add_eyes(word, face);
  if (tier == "mouth") add_mouth(word, face);
  if (tier == "cheeks") add_cheeks(word, face);
  if (tier == "face") add_face(word, face);
  if (tier == "head") add_head(word, body);
  if (tier == "shoulders") add_shoulders(word, body);
  if (tier == "gaze") add_gaze(word, body, face);
}

/// Builds the score unit by unit.
class Choreographer {
 public:
  Choreographer(const Signer& signer, const Utterance& utterance, const ChoreographyOptions& options)
      : signer_(signer), utterance_(utterance), options_(options) {
    hand_ = {signer.rest(Side::kLeft), signer.rest(Side::kRight)};
  }

  Result<Score> run();

 private:
  struct Span {
    Tick begin = 0, end = 0;
  };

  Tick scaled(double duration) const { return std::max<Tick>(1, ticks(duration / options_.speed)); }
  /// The same for a movement that takes a body at least so many seconds, at any speed of signing.
  Tick paced(double duration, double least) const { return std::max(scaled(duration), ticks(least)); }
  bool uses_left(size_t unit) const;
  bool meets_left(size_t unit) const;
  /// Until when the track of a hand is laid out.
  Tick laid_out(size_t side) const { return score_.hands[side].empty() ? 0 : score_.hands[side].back().end; }
  void stay(size_t side, Tick until);
  /// Fills the track of a hand with a segment that ends then; nothing when it reaches so far already.
  void append(size_t side, Tick until, HandSegment segment);
  /// On from where the hand is; `wanted` says where to and how the path is bent in any case, `approach` is the outward
  /// normal of what is touched there, else zero.
  Way way_to(size_t side, HandSegment wanted, const Touch& approach, const Meanwhile& meanwhile) const;
  /// Whether a hand makes again what it made last.
  bool is_made_anew(size_t unit, size_t side) const;
  Way way_to_rest(size_t side, double forwards, const Meanwhile& meanwhile) const;
  /// Brings the base hand down while the other one goes on.
  void lower_left();
  /// What becomes of the base hand when a sign does not use it: it waits, or goes down.
  void release_left(size_t unit);
  /// Whether the right hand of a sign would go through the left one where that waits.
  bool left_is_in_way(const SignPerformance& performance) const;
  void transition(const SignPerformance& performance, size_t unit);
  void add_beats(const SignPerformance& performance, const Unit& unit);
  /// The hand shows its target from `begin` to `end`; one that it has shown until now goes on.
  void show(size_t side, const std::optional<HandTarget>& target, Tick begin, Tick end);
  /// Over the units from the one that has the mouthing.
  void add_mouthing(size_t first, size_t last);
  /// The lips' shapes of a word, spread over a span.
  void lay_mouthing(const std::string& mouthing, Span span);
  void add_own_features(size_t unit);
  void add_rise_and_fall(const FaceWeights& face, const BodyFeature& body, Span span, Tick onset, Tick release);
  /// A feature that takes a part of a sign: it rises and falls within it.
  void add_part(const FaceWeights& face, const BodyFeature& body, Span part);
  void add_spans();
  /// Over units, rising on the way into the first of them and falling on the way out of the last: no feature reaches
  /// into the sign before or after.
  void add_features(const FaceWeights& face, const BodyFeature& body, size_t from, size_t to);
  /// By how much the last hold of a unit is lengthened, seconds at speed 1; the unit took `duration` without it.
  double hold_after(size_t unit, double duration) const;

  const Signer& signer_;
  const Utterance& utterance_;
  const ChoreographyOptions& options_;
  Score score_;
  Tick now_ = 0;
  std::array<HandState, 2> hand_;
  std::array<Touch, 2> leave_;
  std::array<bool, 2> raised_{};
  std::map<std::string, SignPerformance> letters_;                    ///< those that have been spelled, by gloss
  std::map<std::tuple<std::string, std::string, size_t>, Way> ways_;  ///< from letter to letter, of a hand
  std::string last_letter_;   ///< the gloss of the last sign, where it was a letter of both hands
  bool left_is_met_ = false;  ///< the sign that has just been laid out touches the base hand or its arm
  std::vector<Span> spans_;   ///< of each unit
};

bool Choreographer::uses_left(size_t unit) const {
  const auto& sign = utterance_.units[unit].sign;
  return sign && sign->handedness != Handedness::kOne &&
         (sign->handedness != Handedness::kDominantBase || !sign->non_dominant.empty());
}

bool Choreographer::meets_left(size_t unit) const {
  const auto& sign = utterance_.units[unit].sign;
  if (!sign) return false;
  const auto on_left = [](Location location) {
    return is_on_other_hand(location) || location == Location::kUpperArm || location == Location::kElbow;
  };
  return std::any_of(sign->dominant.begin(), sign->dominant.end(), [&](const Posture& posture) {
    return on_left(posture.location) ||
           (posture.contact && posture.contact->target && on_left(*posture.contact->target));
  });
}

void Choreographer::stay(size_t side, Tick until) {
  HandSegment segment;
  segment.from = segment.to = hand_[side];
  append(side, until, segment);
}

void Choreographer::append(size_t side, Tick until, HandSegment segment) {
  auto& track = score_.hands[side];
  segment.begin = laid_out(side);
  segment.end = until;
  if (segment.end <= segment.begin) return;
  track.push_back(segment);
  hand_[side] = segment.to;
}

Way Choreographer::way_to(size_t side, HandSegment wanted, const Touch& approach, const Meanwhile& meanwhile) const {
  const auto hand = static_cast<Side>(side);
  wanted.from = hand_[side];
  // Away from what is left and towards what is met along their normals.
  const Vec3 apart = wanted.to.wrist.position - wanted.from.wrist.position;
  const double lift = lift_of(std::sqrt(glm::dot(apart, apart)));
  const TouchedSurfaces touched{leave_[side], approach};
  wanted.leave = lift * touched.from.normal;
  wanted.approach = lift * touched.to.normal;
  const Vec3 bulge = wanted.bulge;
  const auto with = [&](const std::optional<Quat>& turn_middle, const Vec3& detour = Vec3(0.0)) {
    wanted.turn_middle = turn_middle;
    wanted.bulge = bulge + detour;
    Way way = find_way(signer_, hand, wanted, touched, meanwhile);
    way.seconds = shortest_seconds(signer_, hand, way.segment);
    return way;
  };
  Way way = with(turn_through_joints(signer_, hand, wanted));
  // Where the bent way asks too much of the arm, or still leads into the trunk: turned as the bent way wants it, or as
  // the hand turns least.
  constexpr double kTooLong = 0.6, kSecondsPerMetre = 25.0;
  const auto cost = [](const Way& candidate) { return candidate.seconds + kSecondsPerMetre * candidate.depth; };
  if (cost(way) > kTooLong) {
    for (const auto& turn : {turn_through_joints(signer_, hand, way.segment), std::optional<Quat>()}) {
      const Way candidate = with(turn);
      if (cost(candidate) < cost(way)) way = candidate;
    }
  }
  // Where it leads through something all the same: forwards, up, aside or down first.
  constexpr double kPressed = 0.002, kDetour = 0.08;
  const double outwards = hand == Side::kLeft ? 1.0 : -1.0;
  const std::optional<Quat> turn = way.segment.turn_middle;
  for (const Vec3& detour : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(outwards, 0, 0), Vec3(0, -1, 0)}) {
    if (way.depth <= kPressed) break;
    const Way candidate = with(turn, kDetour * detour);
    if (cost(candidate) < cost(way)) way = candidate;
  }
  return way;
}

Way Choreographer::way_to_rest(size_t side, double forwards, const Meanwhile& meanwhile) const {
  HandSegment wanted;
  wanted.to = signer_.rest(static_cast<Side>(side));
  wanted.bulge = Vec3(0, 0, forwards);
  return way_to(side, wanted, {}, meanwhile);
}

void Choreographer::lower_left() {
  const Way way = way_to_rest(kLeft, 0.04, {});
  stay(kLeft, now_);
  append(kLeft, laid_out(kLeft) + paced(stroke::kLongestTransition, way.seconds), way.segment);
  raised_[kLeft] = false;
}

void Choreographer::release_left(size_t unit) {
  if (!raised_[kLeft]) return;
  // A hand that is met hangs, wherever it was before: a sign is the same after any other.
  const bool soon = utterance_.units[unit].spelled || (unit + 1 < utterance_.units.size() && uses_left(unit + 1));
  if (!soon || meets_left(unit)) lower_left();
}

bool Choreographer::left_is_in_way(const SignPerformance& performance) const {
  constexpr int kSamples = 8;
  constexpr double kPressed = 0.002;  // metres
  return std::ranges::any_of(performance.beats, [&](const Beat& beat) {
    for (int i = 0; i <= (beat.hold ? 0 : kSamples); ++i) {
      const HandState right = state_after(beat.hands[kRight], static_cast<double>(i) / kSamples);
      if (signer_.depth_in_arm(Side::kRight, right, hand_[kLeft], kPressed).metres > kPressed) return true;
    }
    return false;
  });
}

bool Choreographer::is_made_anew(size_t unit, size_t side) const {
  if (unit == 0 || !raised_[side]) return false;
  const auto& sign = utterance_.units[unit].sign;
  const auto& before = utterance_.units[unit - 1].sign;
  if (!sign || !before || sign->gloss != before->gloss) return false;
  return side == kRight || is_mirrored(sign->handedness);
}

void Choreographer::transition(const SignPerformance& performance, size_t index) {
  const Unit& unit = utterance_.units[index];
  std::array<double, 2> times{};
  std::array<Way, 2> ways;
  // When the left hand sets out, and when both have arrived, for how long each takes. The base hand gets ready while
  // the sign before is still being made, unless that one touches it.
  const auto spans = [this](Tick right, Tick left) {
    const Tick free = left_is_met_ ? std::max(now_, laid_out(kLeft)) : laid_out(kLeft);
    const Tick until = now_ + right;
    if (left == 0) return std::pair(free, until);
    const Tick ready = std::max(free, std::min(now_, until - left) - scaled(stroke::kAnticipation));
    return std::pair(ready, std::max(until, ready + left));
  };
  for (const size_t side : {kLeft, kRight}) {
    if (!performance.active[side]) continue;
    const HandState& to = performance.start[side];
    double time = stroke::travel_seconds(hand_[side], to);
    if (unit.spelled && !unit.first_of_word) {
      // The rate of spelling: transition and hold together make one letter.
      time = std::clamp(time, 0.10, std::max(0.10, 1.0 / options_.letters_per_second - stroke::kLetterHold));
    } else {
      time = std::clamp(time, stroke::kShortestTransition, stroke::kLongestTransition);
      if (!raised_[side] && index == 0) time = stroke::kFromRest;
    }
    const Vec3 way = to.wrist.position - hand_[side].wrist.position;
    const double distance = std::sqrt(glm::dot(way, way));
    const bool anew = is_made_anew(index, side) && distance < 0.5 * stroke::kAnewWidth;
    if (anew) time = std::max(time, stroke::kAnew);
    times[side] = time;
    HandSegment wanted;
    wanted.to = to;
    // Clear of the body on long ways.
    wanted.bulge.z = std::max(0.0, 0.22 * (distance - 0.08));
    if (anew) {
      const Touch& touch = performance.approach[side];
      const Vec3 outwards(side == kRight ? -1.0 : 1.0, 0.0, 0.0);
      wanted.bulge = stroke::kAnewWidth * (touch.touches() ? touch.normal : outwards);
    }
    wanted.digits_lead = unit.spelled ? 0.85 : 0.75;
    // The base hand goes its way, and the other one keeps clear of it.
    HandSegment left = ways[kLeft].segment;
    Meanwhile meanwhile;
    if (side == kRight && performance.active[kLeft]) {
      const auto [ready, until] = spans(scaled(time), paced(times[kLeft], ways[kLeft].seconds));
      meanwhile = {&left, static_cast<double>(now_ - ready) / static_cast<double>(until - ready), 1.0};
    } else if (side == kRight && laid_out(kLeft) > now_) {
      // It is being lowered.
      left = score_.hands[kLeft].back();
      const auto share = [&left](Tick at) {
        return static_cast<double>(at - left.begin) / static_cast<double>(left.end - left.begin);
      };
      meanwhile = {&left, share(now_), share(now_ + scaled(time))};
    } else if (side == kRight && raised_[kLeft]) {
      left.from = left.to = hand_[kLeft];
      meanwhile.other = &left;
    }
    // From letter to letter the way is the same each time.
    const bool between_letters = unit.spelled && !last_letter_.empty() && raised_[kLeft] && performance.active[kLeft];
    if (!between_letters) {
      ways[side] = way_to(side, wanted, performance.approach[side], meanwhile);
      continue;
    }
    const auto key = std::tuple(last_letter_, unit.sign->gloss, side);
    auto known = ways_.find(key);
    if (known == ways_.end())
      known = ways_.emplace(key, way_to(side, wanted, performance.approach[side], meanwhile)).first;
    ways[side] = known->second;
  }
  const Tick right = paced(times[kRight], ways[kRight].seconds);
  auto [ready, until] = spans(right, performance.active[kLeft] ? paced(times[kLeft], ways[kLeft].seconds) : 0);
  if (!performance.active[kLeft] && meets_left(index)) until = std::max(until, laid_out(kLeft));
  for (const size_t side : {kLeft, kRight}) {
    if (!performance.active[side]) continue;
    stay(side, side == kLeft ? ready : now_);
    append(side, until, ways[side].segment);
    show(side, performance.start_target[side], until, until);
    raised_[side] = true;
  }
  now_ = until;
}

void Choreographer::add_beats(const SignPerformance& performance, const Unit& unit) {
  struct Cleared {
    const Beat* beat;
    std::array<HandSegment, 2> segments;
    double least;
  };
  std::vector<Cleared> cleared;
  for (const Beat& beat : performance.beats) {
    std::array<HandSegment, 2> segments = beat.hands;
    // However fast the signing, a hold is long enough to be read.
    double least = 0;
    if (beat.hold) least = unit.spelled ? stroke::kLeastLetterHold : stroke::kLeastSignHold;
    // What is made again goes the same way again.
    const auto before = std::ranges::find_if(cleared, [&beat](const Cleared& earlier) {
      return earlier.beat->hands == beat.hands && earlier.beat->surfaces == beat.surfaces;
    });
    const bool again = !beat.hold && before != cleared.end();
    if (again) {
      segments = before->segments;
      least = before->least;
    }
    for (const size_t side : {kLeft, kRight}) {
      if (!performance.active[side] || beat.hold || again) continue;
      const auto hand = static_cast<Side>(side);
      clear_stroke(signer_, beat, performance.active, side, segments);
      least = std::max(least, shortest_seconds(signer_, hand, segments[side]));
    }
    if (!beat.hold && !again) cleared.push_back({&beat, segments, least});
    const Tick begin = now_;
    const Tick end = begin + paced(beat.seconds, least);
    for (const size_t side : {kLeft, kRight}) {
      if (!performance.active[side]) continue;
      stay(side, begin);
      HandSegment& segment = segments[side];
      segment.begin = begin;
      segment.end = end;
      score_.hands[side].push_back(segment);
      hand_[side] = segment.to;
      show(side, beat.target[side], beat.hold ? begin : end, end);
    }
    now_ = end;
  }
  leave_ = performance.leave;
}

void Choreographer::show(size_t side, const std::optional<HandTarget>& target, Tick begin, Tick end) {
  if (!target) return;
  auto& shown = score_.targets[side];
  if (!shown.empty() && shown.back().end == begin) shown.pop_back();
  shown.push_back(*target);
  shown.back().begin = begin;
  shown.back().end = end;
}

double Choreographer::hold_after(size_t unit, double duration) const {
  double hold = utterance_.units[unit].extra_hold_seconds;
  const bool ends_phrase = unit + 1 == utterance_.units.size() || !utterance_.units[unit + 1].sign;
  // The hold takes the lengthening: up to it the sign is the same wherever it stands.
  if (ends_phrase) hold = std::max(hold, stroke::kFinalLengthening * duration);
  for (const NonManualSpan& span : utterance_.non_manual)
    if (span.ending == "hold last sign" && span.to == static_cast<int>(unit))
      hold = std::max(hold, stroke::kQuestionHold);
  return hold;
}

void Choreographer::add_features(const FaceWeights& face, const BodyFeature& body, size_t from, size_t to) {
  Tick before = 0, after = spans_[to].end + scaled(stroke::kBrowRelease);
  for (size_t i = from; i-- > 0 && before == 0;)
    if (utterance_.units[i].sign) before = spans_[i].end;
  for (size_t i = to + 1; i < spans_.size(); ++i) {
    if (!utterance_.units[i].sign) continue;
    after = std::min(after, spans_[i].begin);
    break;
  }
  const Tick begin = std::max(before, spans_[from].begin - scaled(stroke::kBrowOnset)), end = after;
  const Tick onset = spans_[from].begin - begin, release = end - spans_[to].end;
  add_rise_and_fall(face, body, {begin, end}, onset, release);
}

void Choreographer::add_part(const FaceWeights& face, const BodyFeature& body, Span part) {
  const Tick third = std::max<Tick>(1, (part.end - part.begin) / 3);
  add_rise_and_fall(face, body, part, std::min(third, scaled(stroke::kBrowOnset)),
                    std::min(third, scaled(stroke::kBrowRelease)));
}

void Choreographer::add_rise_and_fall(const FaceWeights& face, const BodyFeature& body, Span span, Tick onset,
                                      Tick release) {
  if (any_weight(face)) score_.face.push_back({span.begin, span.end, onset, release, face});
  if (any(body)) {
    BodySpan motion;
    motion.begin = span.begin;
    motion.end = span.end;
    motion.onset = onset;
    motion.release = release;
    motion.head = body.head;
    motion.trunk = body.trunk;
    motion.swing = body.swing;
    motion.swing_hz = body.swing_hz * options_.speed;
    score_.body.push_back(motion);
  }
}

void Choreographer::add_own_features(size_t unit) {
  const NonManual& own = utterance_.units[unit].sign->non_manual;
  FaceWeights face{};
  BodyFeature body;
  add_brows(own.brows, face);
  add_eyes(own.eyes, face);
  add_mouth(own.mouth, face);
  add_cheeks(own.cheeks, face);
  add_face(own.face, face);
  add_head(own.head, body);
  add_shoulders(own.shoulders, body);
  add_gaze(own.gaze, body, face);
  add_features(face, body, unit, unit);
  for (const NonManualFeature& feature : own.more) {
    const auto at = [this, unit](double share) {
      return spans_[unit].begin + static_cast<Tick>(static_cast<double>(spans_[unit].end - spans_[unit].begin) * share);
    };
    const Span part{at(feature.from), at(feature.to)};
    if (part.end <= part.begin) continue;
    if (feature.tier == "mouthing") {
      if (options_.mouthing) lay_mouthing(feature.word, part);
      continue;
    }
    FaceWeights weights{};
    BodyFeature turn;
    add_word(feature.tier, feature.word, turn, weights);
    for (float& weight : weights)
      weight = std::min(1.0F, weight * static_cast<float>(feature.amount));
    for (Vec3* vector : {&turn.head, &turn.trunk, &turn.swing})
      *vector *= feature.amount;
    add_part(weights, turn, part);
  }
}

void Choreographer::add_mouthing(size_t first, size_t last) {
  // The lips begin on the way into the sign and end on the way out of it.
  const Tick reach = scaled(stroke::kMouthingReach);
  Tick begin = spans_[first].begin - reach, end = spans_[last].end + reach;
  if (first > 0) begin = std::max(begin, (spans_[first - 1].end + spans_[first].begin) / 2);
  if (last + 1 < spans_.size()) end = std::min(end, (spans_[last].end + spans_[last + 1].begin) / 2);
  begin = std::max<Tick>(0, begin);
  lay_mouthing(utterance_.units[first].mouthing, {begin, end});
}

void Choreographer::lay_mouthing(const std::string& mouthing, Span span) {
  const auto [begin, end] = span;
  const auto most = static_cast<size_t>((end - begin) / ticks(stroke::kShortestViseme));
  const std::vector<Viseme> visemes = reduced(visemes_of(mouthing), most);
  if (visemes.empty() || end <= begin) return;
  const std::vector<FaceWeights> faces = coarticulated(visemes);
  // Silence before and after; between two shapes the lips are always on their way.
  double total = 1.0;
  for (const Viseme viseme : visemes)
    total += timing_of(viseme).length;
  const auto at = [begin = begin, end = end, &total](double length) {
    return begin + static_cast<Tick>(static_cast<double>(end - begin) * (length / total));
  };
  std::vector<Span> held;
  double gone = 0.5;
  for (const Viseme viseme : visemes) {
    const auto [length, share] = timing_of(viseme);
    held.push_back({at(gone + 0.5 * length * (1.0 - share)), at(gone + 0.5 * length * (1.0 + share))});
    gone += length;
  }
  for (size_t i = 0; i < visemes.size(); ++i) {
    FaceSpan shape;
    shape.begin = i == 0 ? begin : held[i - 1].end;
    shape.end = i + 1 == visemes.size() ? end : held[i + 1].begin;
    shape.onset = held[i].begin - shape.begin;
    shape.release = shape.end - held[i].end;
    shape.weights = faces[i];
    shape.mouthing = true;
    score_.face.push_back(shape);
  }
}

void Choreographer::add_spans() {
  for (const NonManualSpan& span : utterance_.non_manual) {
    if (span.from < 0 || span.to < span.from || static_cast<size_t>(span.to) >= spans_.size()) continue;
    FaceWeights face{};
    BodyFeature body;
    add_brows(span.brows, face);
    add_eyes(span.eyes, face);
    add_mouth(span.mouth, face);
    add_head(span.head, body);
    add_gaze(span.gaze, body, face);
    add_features(face, body, static_cast<size_t>(span.from), static_cast<size_t>(span.to));
    if (span.ending == "pause/blink") {
      FaceWeights blink{};
      add_eyes("blink", blink);
      const Tick half = ticks(0.09);
      const Tick end = spans_[static_cast<size_t>(span.to)].end;
      score_.face.push_back({end, end + 2 * half, half, half, blink});
    }
  }
}

Result<Score> Choreographer::run() {
  if (utterance_.units.empty()) return fail(ErrorCode::kUsage, "there is nothing to sign");
  if (!(options_.speed >= 0.25 && options_.speed <= 4.0))
    return fail(ErrorCode::kUsage, "the speed must lie between 0.25 and 4");
  now_ = scaled(0.15);
  stay(kRight, now_);
  for (size_t i = 0; i < utterance_.units.size(); ++i) {
    const Unit& unit = utterance_.units[i];
    if (!unit.sign) {
      const Tick begin = now_;
      // At the end of a sentence the base hand is lowered, unless the next sign begins with it.
      const bool base_waits = i + 1 < utterance_.units.size() && uses_left(i + 1);
      if (unit.pause_seconds >= stroke::kSentencePause && raised_[kLeft] && !base_waits) lower_left();
      now_ += scaled(unit.pause_seconds);
      stay(kRight, now_);
      spans_.push_back({begin, now_});
      continue;
    }
    if (!uses_left(i)) release_left(i);
    // A letter is the same after any other.
    auto letter = letters_.find(unit.sign->gloss);
    SignPerformance own;
    if (!unit.spelled || letter == letters_.end()) {
      auto made = perform(signer_, utterance_, unit, hand_);
      if (!made) return tl::unexpected(made.error());
      own = std::move(*made);
      if (unit.spelled) letter = letters_.emplace(unit.sign->gloss, own).first;
    }
    const SignPerformance* performance = unit.spelled ? &letter->second : &own;
    if (raised_[kLeft] && !uses_left(i) && left_is_in_way(*performance)) lower_left();
    transition(*performance, i);
    last_letter_ = unit.spelled && performance->active[kLeft] ? unit.sign->gloss : "";
    const Tick begin = now_;
    add_beats(*performance, unit);
    left_is_met_ = meets_left(i);
    const Tick held = now_;
    if (const double hold = hold_after(i, seconds(held - begin) * options_.speed); hold > 0) {
      now_ += scaled(hold);
      for (auto& shown : score_.targets)
        if (!shown.empty() && shown.back().end == held && shown.back().begin < held) shown.back().end = now_;
      stay(kRight, now_);
      if (performance->active[kLeft]) stay(kLeft, now_);
    }
    const Span span{begin, now_};
    spans_.push_back(span);
    score_.glosses.push_back({unit.label, begin, now_, unit.spelled, static_cast<int>(i)});
  }
  for (size_t i = 0; i < utterance_.units.size(); ++i)
    if (utterance_.units[i].sign) add_own_features(i);
  // Mouthing runs over a sign, or over all letters of a spelled word.
  for (size_t i = 0; i < utterance_.units.size() && options_.mouthing; ++i) {
    const Unit& unit = utterance_.units[i];
    if (unit.mouthing.empty()) continue;
    const size_t last = std::min(i + static_cast<size_t>(std::max(1, unit.word_letters)) - 1, spans_.size() - 1);
    add_mouthing(i, last);
  }
  add_spans();
  // The hands drop and relax; one that hangs already stays as it is.
  Tick lowered = now_;
  HandSegment left;
  for (const size_t side : {kLeft, kRight}) {
    if (!raised_[side]) continue;
    const Way way = way_to_rest(side, 0.05, {side == kRight && raised_[kLeft] ? &left : nullptr});
    if (side == kLeft) left = way.segment;
    stay(side, now_);
    append(side, now_ + paced(stroke::kFromRest + 0.1, way.seconds), way.segment);
    lowered = std::max(lowered, laid_out(side));
  }
  score_.end = std::max(lowered, laid_out(kLeft)) + scaled(0.25);
  stay(kLeft, score_.end);
  stay(kRight, score_.end);
  return std::move(score_);
}

}  // namespace

Result<Score> choreograph(const Signer& signer, const Utterance& utterance, const ChoreographyOptions& options) {
  return Choreographer(signer, utterance, options).run();
}

}  // namespace auslan
