// SPDX-License-Identifier: Apache-2.0
// The lexicon in the field's notations: every entry is written in both kinds of SiGML and in symbols, and what a reader
// understands of it is compared with the entry, parameter by parameter.
#include "lexicon/lexicon.h"
#include "notation/writer.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace auslan {
namespace {

const Lexicon& lexicon() {
  static const Lexicon* opened =
      new Lexicon(Lexicon::open(std::string(AUSLANJAM_BINARY_DIR) + "/share/auslanjam/lexicon.sqlite").value());
  return *opened;
}

const std::vector<Handshape>& handshapes() {
  static const std::vector<Handshape> all = lexicon().handshapes().value();
  return all;
}

double degrees_between(const Direction& a, const Direction& b) {
  const Vec3 x = to_vector(a), y = to_vector(b);
  return std::acos(std::clamp(glm::dot(x, y), -1.0, 1.0)) * 57.29577951308232;
}

/// Of the palm only what lies across the fingers is stated.
double palm_between(const Posture& wanted, const Posture& read) {
  const Vec3 along = to_vector(wanted.fingers);
  const auto across = [&along](const Direction& palm) {
    const Vec3 v = to_vector(palm);
    return glm::normalize(v - along * glm::dot(v, along));
  };
  return std::acos(std::clamp(glm::dot(across(wanted.palm), across(read.palm)), -1.0, 1.0)) * 57.29577951308232;
}

bool is_two_handed(const Sign& sign) {
  return sign.handedness != Handedness::kOne &&
         !(sign.handedness == Handedness::kDominantBase && sign.non_dominant.empty());
}

/// Degrees of a joint on average.
double joints_between(const Handshape& a, const Handshape& b) {
  double sum = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    const FingerAngles &x = a.fingers[i], &y = b.fingers[i];
    for (const double d : {x.mcp - y.mcp, x.pip - y.pip, x.dip - y.dip, x.abduction - y.abduction})
      sum += d * d;
  }
  return std::sqrt(sum / 16.0);
}

const Handshape& shape_of(const std::vector<Handshape>& all, const std::string& id) {
  const auto found = std::ranges::find(all, id, &Handshape::id);
  if (found == all.end()) throw std::runtime_error("no handshape " + id);
  return *found;
}

struct Tally {
  int entries = 0, hands = 0;
  double fingers = 0.0, palm = 0.0, joints = 0.0, mean_joints = 0.0;  ///< the worst, degrees
};

bool touches(const Posture& posture) {
  return posture.contact && posture.contact->kind != ContactKind::kNear;
}

/// The other hand and its arm, signing space (also before a trunk that is not touched), the head with the neck, the
/// trunk.
int region_of(const Posture& posture, Location location) {
  if (!touches(posture) && location >= Location::kShoulder && location <= Location::kThigh) return 1;
  if (is_on_other_hand(location) || location == Location::kUpperArm || location == Location::kElbow) return 0;
  if (location >= Location::kHighNeutral && location <= Location::kContraSpace) return 1;
  return location <= Location::kNeck ? 2 : 3;
}

Location place_of(const Posture& posture) {
  return posture.contact && posture.contact->target ? *posture.contact->target : posture.location;
}

bool moves(const Sign& sign) {
  return std::ranges::any_of(sign.movements, [](const Movement& movement) { return movement.kind != MoveKind::kHold; });
}

// Twelve base forms with their bends are coarser than measured joints, degrees.
constexpr double kMeanJoints = 2.5, kWorstJoints = 21.0;

class NotationLexicon : public testing::TestWithParam<NotationForm> {};

TEST_P(NotationLexicon, EveryEntryIsWrittenAndReadAsNearlyTheSame) {
  Tally tally;
  const std::vector<SignSummary> entries = lexicon().list().value();
  for (const SignSummary& entry : entries) {
    const Sign sign = lexicon().sign(entry.gloss).value().value();
    const auto made = notate(sign, handshapes(), GetParam());
    ASSERT_TRUE(made) << entry.gloss << ": " << to_string(made.error());
    ++tally.entries;
    const Sign& read = made->sign.sign;
    ASSERT_TRUE(made->sign.signable && !read.dominant.empty()) << entry.gloss;
    for (const Diagnostic& diagnostic : made->sign.diagnostics)
      EXPECT_NE(diagnostic.grade, Diagnostic::Grade::kError) << entry.gloss << " " << to_string(diagnostic);
    EXPECT_EQ(read.gloss, sign.gloss);
    // Who touches the other arm has two hands, as a notation sees it.
    if (is_two_handed(read) != is_two_handed(sign)) {
      ++tally.hands;
      EXPECT_EQ(place_of(sign.dominant.front()), Location::kUpperArm) << entry.gloss;
    }
    if (is_mirrored(sign.handedness)) {
      EXPECT_TRUE(is_mirrored(read.handedness)) << entry.gloss;
    }
    for (const bool last : {false, true}) {
      const Posture& first = last ? sign.dominant.back() : sign.dominant.front();
      const Posture& again = last ? read.dominant.back() : read.dominant.front();
      const double joints =
          joints_between(shape_of(handshapes(), first.handshape), shape_of(made->sign.handshapes, again.handshape));
      tally.fingers = std::max(tally.fingers, degrees_between(first.fingers, again.fingers));
      tally.palm = std::max(tally.palm, palm_between(first, again));
      tally.joints = std::max(tally.joints, joints);
      tally.mean_joints += 0.5 * joints;
      if (last) continue;
      EXPECT_EQ(region_of(first, place_of(first)), region_of(again, place_of(again))) << entry.gloss;
      EXPECT_EQ(touches(first), touches(again)) << entry.gloss;
    }
    if (moves(sign)) {
      EXPECT_TRUE(moves(read)) << entry.gloss << " does not move any more";
    }
    if (GetParam() == NotationForm::kSymbols) {
      const auto symbols = write_hamnosys(made->sign);
      ASSERT_TRUE(symbols) << entry.gloss;
      EXPECT_TRUE(parse_hamnosys(*symbols)) << entry.gloss;
    }
  }
  tally.mean_joints /= std::max(1, tally.entries);
  std::printf(
      "%d entries, %d of them of one hand at the other arm; off at most by %.1f degrees (fingers), %.1f (palm), %.1f "
      "of a "
      "joint on average (in the mean %.1f)\n",
      tally.entries, tally.hands, tally.fingers, tally.palm, tally.joints, tally.mean_joints);
  EXPECT_GE(tally.entries, 460);
  EXPECT_LE(tally.fingers, GetParam() == NotationForm::kGestural ? 0.1 : 11.0);
  EXPECT_LE(tally.palm, 25.0);
  EXPECT_LE(tally.mean_joints, kMeanJoints);
  EXPECT_LE(tally.joints, kWorstJoints);
}

// What a handshape says of itself in HamNoSys is read as that handshape. Twelve base forms are coarse: a knuckle that
// is bent by half has no symbol.
TEST(NotationLexiconTest, TheHamNoSysOfEachHandshapeIsReadAsIt) {
  constexpr double kMean = 6.0, kWorst = 17.0;
  double sum = 0.0, worst = 0.0;
  std::string of;
  for (const Handshape& shape : handshapes()) {
    const auto read = parse_hamnosys(shape.hamnosys + ",hamextfingero,hampalmd");
    ASSERT_TRUE(read && read->signable) << shape.id << ": " << shape.hamnosys;
    for (const Diagnostic& told : read->diagnostics)
      EXPECT_FALSE(told.left_out) << shape.id << ": " << to_string(told);
    const double off = joints_between(shape, shape_of(read->handshapes, read->sign.dominant.front().handshape));
    sum += off;
    if (off <= worst) continue;
    worst = off;
    of = shape.id;
  }
  const double mean = sum / static_cast<double>(handshapes().size());
  std::printf("%zu handshapes; joints are off by %.1f degrees in the mean, at most by %.1f (%s)\n", handshapes().size(),
              mean, worst, of.c_str());
  EXPECT_LE(mean, kMean);
  EXPECT_LE(worst, kWorst);
}

// By hand from the symbol table: an index with its thumb across, pointing away, palm down, before the chest, moves
// away.
TEST(NotationLexiconTest, APointingHandIsWrittenAsTheFieldDoes) {
  const auto made = notate(lexicon().sign("YOU").value().value(), handshapes(), NotationForm::kSymbols);
  ASSERT_TRUE(made);
  std::string names;
  for (const WrittenElement& part : made->sign.written.children)
    for (const WrittenElement& symbol : part.children)
      if (part.name == "hamnosys_manual") names += symbol.name + " ";
  EXPECT_TRUE(names.starts_with("hamfinger2 hamthumbacrossmod hamextfingero hampalmd hamchest ")) << names;
  EXPECT_NE(names.find(" hammoveo hamsmallmod "), std::string::npos) << names;
}

TEST(NotationLexiconTest, WhatCannotBeSaidIsTold) {
  Sign sign = lexicon().sign("YOU").value().value();
  sign.dominant.front().handshape = "no_such_shape";
  const auto made = notate(sign, handshapes(), NotationForm::kGestural);
  ASSERT_TRUE(made);
  EXPECT_TRUE(std::ranges::any_of(made->findings, [](const Diagnostic& found) {
    return found.left_out && found.message.find("no_such_shape") != std::string::npos;
  }));
  sign.dominant.clear();
  EXPECT_EQ(notate(sign, handshapes(), NotationForm::kGestural).error().code, ErrorCode::kMalformed);
}

INSTANTIATE_TEST_SUITE_P(Forms, NotationLexicon, testing::Values(NotationForm::kGestural, NotationForm::kSymbols),
                         [](const auto& form) {
                           return form.param == NotationForm::kGestural ? "gestural" : "symbols";
                         });

}  // namespace
}  // namespace auslan
