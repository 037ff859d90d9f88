// SPDX-License-Identifier: Apache-2.0
#include "synthesis/choreography.h"

#include "performance_of_sign.h"
#include "stroke.h"
#include "synthesis/mouthing.h"
#include "synthesis/non_manual.h"
#include "way.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  bool uses_left(size_t unit) const;
  void stay(size_t side, Tick until);
  /// Fills the track of a hand with a segment that ends then; nothing when it reaches so far already.
  void append(size_t side, Tick until, HandSegment segment);
  Way way_to(size_t side, const HandState& to, const Vec3& bulge) const {
    return find_way(signer_, static_cast<Side>(side), hand_[side], to, bulge);
  }
  /// Brings the base hand down from where it is, beginning with what was not yet laid out since `since`.
  void lower_left(Tick since, const HandState& low);
  void transition(const SignPerformance& performance, const Unit& unit);
  void add_beats(const SignPerformance& performance, const Unit& unit);
  /// The hand shows its target from `begin` to `end`; one that it has shown until now goes on.
  void show(size_t side, const std::optional<HandTarget>& target, Tick begin, Tick end);
  void add_mouthing(const std::string& mouthing, Span span);
  void add_own_features(const Unit& unit, Span span);
  void add_spans();
  void add_features(const FaceWeights& face, const BodyFeature& body, Span span);
  double hold_after(size_t unit) const;

  const Signer& signer_;
  const Utterance& utterance_;
  const ChoreographyOptions& options_;
  Score score_;
  Tick now_ = 0;
  std::array<HandState, 2> hand_;
  std::array<Vec3, 2> leave_{};
  std::array<bool, 2> raised_{};
  std::vector<Span> spans_;  ///< of each unit
};

bool Choreographer::uses_left(size_t unit) const {
  const auto& sign = utterance_.units[unit].sign;
  return sign && sign->handedness != Handedness::kOne &&
         (sign->handedness != Handedness::kDominantBase || !sign->non_dominant.empty());
}

void Choreographer::stay(size_t side, Tick until) {
  HandSegment segment;
  segment.from = segment.to = hand_[side];
  append(side, until, segment);
}

void Choreographer::append(size_t side, Tick until, HandSegment segment) {
  auto& track = score_.hands[side];
  segment.begin = track.empty() ? 0 : track.back().end;
  segment.end = until;
  if (segment.end <= segment.begin) return;
  track.push_back(segment);
  hand_[side] = segment.to;
}

void Choreographer::lower_left(Tick since, const HandState& low) {
  const Way way = way_to(kLeft, low, Vec3(0, 0, 0.04));
  const Tick end = std::max(now_, since + scaled(std::max(stroke::kLongestTransition, way.seconds)));
  append(kLeft, end, way.segment);
  now_ = std::max(now_, score_.hands[kLeft].back().end);
  raised_[kLeft] = false;
}

void Choreographer::transition(const SignPerformance& performance, const Unit& unit) {
  double time = stroke::kShortestTransition;
  bool from_rest = false;
  for (const size_t side : {kLeft, kRight}) {
    if (!performance.active[side]) continue;
    time = std::max(time, stroke::travel_seconds(hand_[side], performance.start[side]));
    from_rest = from_rest || !raised_[side];
  }
  if (unit.spelled && !unit.first_of_word) {
    // The rate of spelling: transition and hold together make one letter.
    const double letter = 1.0 / options_.letters_per_second;
    time = std::max(0.10, std::min(time, letter - stroke::kLetterHold));
  } else {
    time = std::clamp(time, stroke::kShortestTransition, stroke::kLongestTransition);
    if (from_rest) time = std::max(time, stroke::kFromRest);
  }
  std::array<Way, 2> ways;
  for (const size_t side : {kLeft, kRight}) {
    if (!performance.active[side]) continue;
    const HandState& to = performance.start[side];
    const Vec3 way = to.wrist.position - hand_[side].wrist.position;
    const double distance = std::sqrt(glm::dot(way, way));
    // Away from what is left and towards what is met along their normals, and clear of the body on long ways.
    const double lift = std::min(0.06, 0.3 * distance);
    Vec3 bulge = 0.5 * lift * (performance.approach[side] + leave_[side]);
    bulge.z += std::max(0.0, 0.22 * (distance - 0.08));
    ways[side] = way_to(side, to, bulge);
    ways[side].segment.digits_lead = unit.spelled ? 0.85 : 0.75;
    time = std::max(time, ways[side].seconds);
    raised_[side] = true;
  }
  const Tick until = now_ + scaled(time);
  for (const size_t side : {kLeft, kRight}) {
    if (!performance.active[side]) continue;
    append(side, until, ways[side].segment);
    show(side, performance.start_target[side], until, until);
  }
  now_ = until;
}

void Choreographer::add_beats(const SignPerformance& performance, const Unit& unit) {
  for (const Beat& beat : performance.beats) {
    double time = beat.seconds;
    if (beat.hold && unit.spelled) {
      // Slower speeds lengthen the letters, faster ones never bring the hold under what can be read.
      time = std::max(time, stroke::kLetterHold * 0.8 * options_.speed);
    }
    const Tick begin = now_;
    const Tick end = begin + scaled(time);
    for (const size_t side : {kLeft, kRight}) {
      if (!performance.active[side]) continue;
      stay(side, begin);
      HandSegment segment = beat.hands[side];
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

double Choreographer::hold_after(size_t unit) const {
  double hold = utterance_.units[unit].extra_hold_seconds;
  for (const NonManualSpan& span : utterance_.non_manual)
    if (span.ending == "hold last sign" && span.to == static_cast<int>(unit))
      hold = std::max(hold, stroke::kQuestionHold);
  return hold;
}

void Choreographer::add_features(const FaceWeights& face, const BodyFeature& body, Span span) {
  const Tick onset = scaled(stroke::kBrowOnset), release = scaled(stroke::kBrowRelease);
  const Tick begin = std::max<Tick>(0, span.begin - onset / 2), end = span.end + release / 2;
  if (any_weight(face)) score_.face.push_back({begin, end, onset, release, face});
  if (any(body)) {
    BodySpan motion;
    motion.begin = begin;
    motion.end = end;
    motion.onset = onset;
    motion.release = release;
    motion.head = body.head;
    motion.trunk = body.trunk;
    motion.swing = body.swing;
    motion.swing_hz = body.swing_hz * options_.speed;
    score_.body.push_back(motion);
  }
}

void Choreographer::add_own_features(const Unit& unit, Span span) {
  const NonManual& own = unit.sign->non_manual;
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
  add_features(face, body, span);
  for (const NonManualFeature& feature : own.more) {
    const auto at = [&span](double share) {
      return span.begin + static_cast<Tick>(static_cast<double>(span.end - span.begin) * share);
    };
    const Span part{at(feature.from), at(feature.to)};
    if (part.end <= part.begin) continue;
    if (feature.tier == "mouthing") {
      if (options_.mouthing) add_mouthing(feature.word, part);
      continue;
    }
    FaceWeights weights{};
    BodyFeature turn;
    add_word(feature.tier, feature.word, turn, weights);
    for (float& weight : weights)
      weight = std::min(1.0F, weight * static_cast<float>(feature.amount));
    for (Vec3* vector : {&turn.head, &turn.trunk, &turn.swing})
      *vector *= feature.amount;
    add_features(weights, turn, part);
  }
}

void Choreographer::add_mouthing(const std::string& mouthing, Span span) {
  const std::vector<Viseme> visemes = visemes_of(mouthing);
  if (visemes.empty() || span.end <= span.begin) return;
  const auto count = static_cast<Tick>(visemes.size());
  const Tick length = span.end - span.begin;
  for (Tick i = 0; i < count; ++i) {
    const Tick begin = span.begin + length * i / count, end = span.begin + length * (i + 1) / count;
    const Tick overlap = std::max<Tick>(1, std::min<Tick>((end - begin) / 2, ticks(0.08)));
    score_.face.push_back({std::max<Tick>(0, begin - overlap / 2), end + overlap / 2, overlap, overlap,
                           weights_of(visemes[static_cast<size_t>(i)])});
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
    const Span time{spans_[static_cast<size_t>(span.from)].begin, spans_[static_cast<size_t>(span.to)].end};
    add_features(face, body, time);
    if (span.ending == "pause/blink") {
      FaceWeights blink{};
      add_eyes("blink", blink);
      const Tick half = ticks(0.09);
      score_.face.push_back({time.end, time.end + 2 * half, half, half, blink});
    }
  }
}

Result<Score> Choreographer::run() {
  if (utterance_.units.empty()) return fail(ErrorCode::kUsage, "there is nothing to sign");
  if (!(options_.speed >= 0.25 && options_.speed <= 4.0))
    return fail(ErrorCode::kUsage, "the speed must lie between 0.25 and 4");
  const HandState low_left = signer_.rest(Side::kLeft), low_right = signer_.rest(Side::kRight);
  now_ = scaled(0.15);
  stay(kLeft, now_);
  stay(kRight, now_);
  for (size_t i = 0; i < utterance_.units.size(); ++i) {
    const Unit& unit = utterance_.units[i];
    if (!unit.sign) {
      const Tick begin = now_;
      now_ += scaled(unit.pause_seconds);
      // At the end of a sentence the base hand is lowered, unless the next sign begins with it.
      const bool base_waits = i + 1 < utterance_.units.size() && uses_left(i + 1);
      if (unit.pause_seconds >= stroke::kSentencePause && raised_[kLeft] && !base_waits) lower_left(begin, low_left);
      stay(kLeft, now_);
      stay(kRight, now_);
      spans_.push_back({begin, now_});
      continue;
    }
    auto performance = perform(signer_, utterance_, unit, hand_);
    if (!performance) return tl::unexpected(performance.error());
    const Tick before = now_;
    transition(*performance, unit);
    const Tick begin = now_;
    add_beats(*performance, unit);
    const Tick held = now_;
    now_ += scaled(std::max(1e-6, hold_after(i)));
    for (auto& shown : score_.targets)
      if (!shown.empty() && shown.back().end == held && shown.back().begin < held) shown.back().end = now_;
    stay(kRight, now_);
    if (performance->active[kLeft]) {
      stay(kLeft, now_);
    } else if (raised_[kLeft]) {
      // The base hand waits where it is for the next sign that needs it, and is lowered otherwise.
      const bool soon = unit.spelled || (i + 1 < utterance_.units.size() && uses_left(i + 1));
      if (soon) {
        stay(kLeft, now_);
      } else {
        lower_left(before, low_left);
        stay(kRight, now_);
      }
    } else {
      stay(kLeft, now_);
    }
    const Span span{begin, now_};
    spans_.push_back(span);
    score_.glosses.push_back({unit.label, begin, now_, unit.spelled, static_cast<int>(i)});
    add_own_features(unit, span);
  }
  // Mouthing runs over a sign, or over all letters of a spelled word.
  for (size_t i = 0; i < utterance_.units.size() && options_.mouthing; ++i) {
    const Unit& unit = utterance_.units[i];
    if (unit.mouthing.empty()) continue;
    const size_t last = std::min(i + static_cast<size_t>(std::max(1, unit.word_letters)) - 1, spans_.size() - 1);
    add_mouthing(unit.mouthing, {spans_[i].begin, spans_[last].end});
  }
  add_spans();
  const std::array<Way, 2> ways = {way_to(kLeft, low_left, Vec3(0, 0, 0.05)),
                                   way_to(kRight, low_right, Vec3(0, 0, 0.05))};
  const Tick lowered = now_ + scaled(std::max({stroke::kFromRest + 0.1, ways[kLeft].seconds, ways[kRight].seconds}));
  for (const size_t side : {kLeft, kRight})
    append(side, side == kLeft && !raised_[kLeft] ? now_ : lowered, ways[side].segment);
  score_.end = lowered + scaled(0.25);
  stay(kLeft, score_.end);
  stay(kRight, score_.end);
  return std::move(score_);
}

}  // namespace

Result<Score> choreograph(const Signer& signer, const Utterance& utterance, const ChoreographyOptions& options) {
  return Choreographer(signer, utterance, options).run();
}

}  // namespace auslan
