// SPDX-License-Identifier: Apache-2.0
// What notations mean in the model: facts of HamNoSys 4 and SiGML, not what the reader happened to say.
#include "notation/notation.h"
#include "phonology/vocabulary.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace auslan {
namespace {

NotatedSign ham(const std::string& names) {
  auto sign = parse_hamnosys(names);
  EXPECT_TRUE(sign) << names;
  if (!sign) return {};
  EXPECT_TRUE(sign->signable) << names;
  return std::move(*sign);
}

NotatedSign gestural(const std::string& manual, const std::string& attributes = "", const std::string& before = "") {
  auto signs = parse_sigml("<sigml><hamgestural_sign gloss=\"X\">" + before + "<sign_manual " + attributes + ">" +
                               manual + "</sign_manual></hamgestural_sign></sigml>",
                           "test");
  EXPECT_TRUE(signs) << manual;
  if (!signs || signs->size() != 1) return {};
  EXPECT_TRUE(signs->front().signable) << manual;
  return std::move(signs->front());
}

Posture first(const NotatedSign& sign) {
  return sign.sign.dominant.empty() ? Posture{} : sign.sign.dominant.front();
}

Handshape shape(const std::string& symbols) {
  const NotatedSign sign = ham(symbols + ",hamextfingeru,hampalml");
  return sign.handshapes.empty() ? Handshape{} : sign.handshapes.front();
}

bool warned(const NotatedSign& sign) {
  return std::any_of(sign.diagnostics.begin(), sign.diagnostics.end(),
                     [](const Diagnostic& d) { return d.grade == Diagnostic::Grade::kWarning; });
}

const std::string kFlat = "hamflathand,hamextfingeru,hampalml,";

struct Orientation {
  const char* fingers;
  const char* palm;
  Direction fingers_are, palm_is;
};

TEST(NotationMeaning, PalmLettersBecomeAbsoluteByTheDirectionOfTheFingers) {
  const Orientation facts[] = {
      {"u", "d", {0, 1, 0}, {0, 0, 1}},    // fingers up, palm d: away from the signer
      {"u", "u", {0, 1, 0}, {0, 0, -1}},   // … palm u: towards the signer
      {"l", "l", {1, 0, 0}, {0, 0, -1}},   // fingers left, palm l: towards the signer
      {"r", "r", {-1, 0, 0}, {0, 0, -1}},  // its mirror image
      {"l", "d", {1, 0, 0}, {0, -1, 0}},   // level fingers: u and d are literal
      {"o", "u", {0, 0, 1}, {0, 1, 0}},   {"o", "d", {0, 0, 1}, {0, -1, 0}},  {"i", "d", {0, 0, -1}, {0, -1, 0}},
      {"o", "l", {0, 0, 1}, {1, 0, 0}},   {"i", "l", {0, 0, -1}, {1, 0, 0}},  // l and r literal in the middle plane
      {"u", "l", {0, 1, 0}, {1, 0, 0}},   {"d", "l", {0, -1, 0}, {1, 0, 0}},  {"u", "r", {0, 1, 0}, {-1, 0, 0}},
      {"i", "r", {0, 0, -1}, {-1, 0, 0}}, {"d", "d", {0, -1, 0}, {0, 0, -1}},
  };
  for (const Orientation& fact : facts) {
    const NotatedSign sign =
        ham("hamflathand,hamextfinger" + std::string(fact.fingers) + ",hampalm" + std::string(fact.palm));
    EXPECT_EQ(first(sign).fingers, fact.fingers_are) << fact.fingers << " " << fact.palm;
    EXPECT_EQ(first(sign).palm, fact.palm_is) << fact.fingers << " " << fact.palm;
  }
}

TEST(NotationMeaning, AllTwentySixDirectionsAndEightPalmsGiveAFrame) {
  const char* const fingers[] = {"u",  "ur", "r",  "dr", "d",  "dl",  "l",   "ul",  "ol",  "o",   "or",  "il",  "i",
                                 "ir", "ui", "di", "do", "uo", "uol", "uor", "dol", "dor", "uil", "uir", "dil", "dir"};
  const char* const palms[] = {"u", "ur", "r", "dr", "d", "dl", "l", "ul"};
  std::set<std::string> seen;
  for (const char* direction : fingers) {
    std::set<std::string> palm_names;
    for (const char* palm : palms) {
      const NotatedSign sign = gestural("<handconfig handshape=\"flat\" extfidir=\"" + std::string(direction) +
                                        "\" palmor=\"" + std::string(palm) + "\"/>");
      const Posture posture = first(sign);
      seen.insert(to_name(posture.fingers));
      palm_names.insert(to_name(posture.palm));
      EXPECT_LT(std::abs(glm::dot(to_vector(posture.fingers), to_vector(posture.palm))), 0.6)
          << direction << " " << palm;
    }
    EXPECT_EQ(palm_names.size(), 8u) << direction << ": eight palms stay eight";
  }
  EXPECT_EQ(seen.size(), 26u);
}

TEST(NotationMeaning, TwelveBaseHandshapesDiffer) {
  const char* const bases[] = {"hamfist",           "hamflathand",   "hamfinger2", "hamfinger23",
                               "hamfinger23spread", "hamfinger2345", "hampinch12", "hampinchall",
                               "hampinch12open",    "hamcee12",      "hamceeall",  "hamceeopen"};
  std::vector<Handshape> shapes;
  for (const char* base : bases)
    shapes.push_back(shape(base));
  for (size_t a = 0; a < shapes.size(); ++a)
    for (size_t b = 0; b < a; ++b) {
      double most = 0;
      for (size_t i = 0; i < 4; ++i) {
        const FingerAngles &x = shapes[a].fingers[i], &y = shapes[b].fingers[i];
        most = std::max({most, std::abs(x.mcp - y.mcp), std::abs(x.pip - y.pip), std::abs(x.abduction - y.abduction)});
      }
      EXPECT_GT(most, 10.0) << bases[a] << " and " << bases[b];
      EXPECT_NE(shapes[a].id, shapes[b].id);
    }
}

TEST(NotationMeaning, SelectedFingersAreOutAndTheOthersClosed) {
  const Handshape point = shape("hamfinger2");
  EXPECT_EQ(point.fingers[0].mcp + point.fingers[0].pip + point.fingers[0].dip, 0);
  for (size_t i = 1; i < 4; ++i)
    EXPECT_GT(point.fingers[i].pip, 80) << i;
  EXPECT_EQ(point.selected, "index");
  // finger2 with the little finger's digit is the little finger.
  const Handshape little = shape("hamfinger2,hampinky");
  EXPECT_EQ(little.fingers[3].pip, 0);
  EXPECT_GT(little.fingers[0].pip, 80);
  EXPECT_EQ(little.selected, "little");
  // Index, middle, ring.
  const Handshape three = shape("hamfinger23,hamindexfinger,hammiddlefinger,hamringfinger");
  EXPECT_EQ(three.fingers[2].pip, 0);
  EXPECT_GT(three.fingers[3].pip, 80);
  EXPECT_GT(shape("hamfinger23spread").fingers[0].abduction, shape("hamfinger23").fingers[0].abduction + 5);
}

TEST(NotationMeaning, BendsAreTheirJoints) {
  const auto joints = [](const std::string& bend) { return shape("hamflathand," + bend).fingers[0]; };
  const FingerAngles bent = joints("hamfingerstraightmod"), round = joints("hamfingerbendmod"),
                     hooked = joints("hamfingerhookmod"), doubled = joints("hamdoublebent"),
                     full = joints("hamdoublehooked");
  // Knuckle only; all equally; the two outer ones; the two inner ones; all fully.
  EXPECT_TRUE(bent.mcp > 70 && bent.pip == 0 && bent.dip == 0);
  EXPECT_TRUE(round.mcp > 30 && round.pip > 30 && round.dip > 20 && round.mcp < bent.mcp);
  EXPECT_TRUE(hooked.mcp == 0 && hooked.pip > 80 && hooked.dip > 50);
  EXPECT_TRUE(doubled.mcp == bent.mcp && doubled.pip > 80 && doubled.dip == 0);
  EXPECT_TRUE(full.mcp == bent.mcp && full.pip == hooked.pip && full.dip == hooked.dip);
  // A bend after a digit is that digit's alone.
  const Handshape one = shape("hamfinger2345,hammiddlefinger,hamfingerstraightmod");
  EXPECT_GT(one.fingers[1].mcp, 70);
  EXPECT_EQ(one.fingers[0].mcp, 0);
  EXPECT_EQ(one.fingers[2].mcp, 0);
  // A digit after a bend is spared.
  const Handshape spared = shape("hamfinger2345,hamfingerhookmod,hamindexfinger");
  EXPECT_EQ(spared.fingers[0].pip, 0);
  EXPECT_GT(spared.fingers[1].pip, 80);
}

TEST(NotationMeaning, TheThumbIsOutAcrossOrOpposed) {
  const ThumbAngles out = shape("hamfist,hamthumboutmod").thumb, across = shape("hamfist,hamthumbacrossmod").thumb,
                    opposed = shape("hamfist,hamthumbopenmod").thumb;
  EXPECT_GT(out.radial_abduction, across.radial_abduction + 20);
  EXPECT_GT(opposed.palmar_abduction, out.palmar_abduction + 20);
  EXPECT_GT(across.ip, out.ip + 20);
  EXPECT_EQ(shape("hamfist,hamthumboutmod").id, "ham:fist+thumbout");
}

TEST(NotationMeaning, BetweenIsTheMean) {
  const Handshape a = shape("hamfinger2345"), b = shape("hamfinger2345,hamfingerhookmod"),
                  c = shape("hamfinger2345,hambetween,hamfinger2345,hamfingerhookmod");
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(c.fingers[i].pip, 0.5 * (a.fingers[i].pip + b.fingers[i].pip));
    EXPECT_DOUBLE_EQ(c.fingers[i].mcp, 0.5 * (a.fingers[i].mcp + b.fingers[i].mcp));
  }
  // Midway of left and up is up-left.
  EXPECT_EQ(first(ham("hamflathand,hamextfingeru,hambetween,hamextfingerl,hampalmd")).fingers, (Direction{1, 1, 0}));
}

TEST(NotationMeaning, PlacesOnTheBody) {
  const std::pair<const char*, Location> places[] = {
      {"hamchin", Location::kChin},   {"hamforehead", Location::kForehead},   {"hamnose", Location::kNose},
      {"hamlips", Location::kMouth},  {"hamcheek", Location::kCheek},         {"hamear", Location::kEar},
      {"hamchest", Location::kChest}, {"hamstomach", Location::kStomach},     {"hamheadtop", Location::kTopHead},
      {"hamneck", Location::kNeck},   {"hamshouldertop", Location::kShoulder}};
  for (const auto& [symbol, location] : places) {
    const Posture posture = first(ham(kFlat + symbol + ",hamtouch"));
    EXPECT_EQ(posture.location, location) << symbol;
    ASSERT_TRUE(posture.contact) << symbol;
    EXPECT_EQ(posture.contact->kind, ContactKind::kTouch) << symbol;
  }
  EXPECT_EQ(first(ham(kFlat + "hamlrat,hamchest,hamtouch")).location, Location::kContraChest);
  EXPECT_EQ(first(ham(kFlat + "hamlrat,hamshouldertop,hamtouch")).location, Location::kContraShoulder);
  EXPECT_EQ(first(ham("hamfinger2,hamextfingeru,hampalmu,hamchin,hamtouch")).contact->part, HandPart::kIndexTip);
  // The thumb's side of a hand with the fingers up and the palm left faces the signer.
  EXPECT_EQ(first(ham(kFlat + "hamchin,hamtouch")).contact->part, HandPart::kRadial);
  EXPECT_EQ(first(ham("hamflathand,hamextfingeru,hampalmu,hamchin,hamtouch")).contact->part, HandPart::kPalm);
}

TEST(NotationMeaning, SidesStandBeforeForLeftAndAfterForRight) {
  const Vec3 left = first(ham(kFlat + "hamlrat,hamshoulders")).offset,
             middle = first(ham(kFlat + "hamshoulders")).offset,
             right = first(ham(kFlat + "hamshoulders,hamlrat")).offset,
             beside = first(ham(kFlat + "hamshoulders,hamlrbeside")).offset;
  EXPECT_GT(left.x, middle.x + 0.05);
  EXPECT_LT(right.x, middle.x - 0.05);
  EXPECT_LT(beside.x, right.x - 0.05);
  EXPECT_DOUBLE_EQ(left.x - middle.x, middle.x - right.x);
  // close, unmarked, at arm's length: further and further from the chest.
  const double close = first(ham(kFlat + "hamchest,hamclose")).offset.z,
               usual = first(ham(kFlat + "hamchest")).offset.z,
               far = first(ham(kFlat + "hamchest,hamarmextended")).offset.z;
  EXPECT_LT(close, usual);
  EXPECT_LT(usual, far);
}

TEST(NotationMeaning, StraightMovementsGoWhereTheyPoint) {
  const std::pair<const char*, Vec3> ways[] = {{"u", {0, 1, 0}}, {"r", {-1, 0, 0}}, {"d", {0, -1, 0}},
                                               {"l", {1, 0, 0}}, {"o", {0, 0, 1}},  {"i", {0, 0, -1}}};
  for (const auto& [letter, way] : ways) {
    const NotatedSign sign = ham(kFlat + "hamchest,hammove" + letter);
    ASSERT_EQ(sign.sign.dominant.size(), 2u) << letter;
    const Vec3 by = sign.sign.dominant[1].offset - sign.sign.dominant[0].offset;
    EXPECT_GT(glm::dot(by, way), 0.05) << letter;
    EXPECT_NEAR(glm::dot(by, by), glm::dot(by, way) * glm::dot(by, way), 1e-12) << letter;
    ASSERT_EQ(sign.sign.movements.size(), 1u);
    EXPECT_EQ(sign.sign.movements[0].kind, MoveKind::kStraight);
    EXPECT_EQ(sign.sign.movements[0].from, 0);
    EXPECT_EQ(sign.sign.movements[0].to, 1);
  }
  const auto reach = [](const std::string& size) {
    const NotatedSign sign = ham(kFlat + "hamchest,hammovel" + size);
    return sign.sign.dominant[1].offset.x - sign.sign.dominant[0].offset.x;
  };
  EXPECT_LT(reach(",hamsmallmod"), reach(""));
  EXPECT_LT(reach(""), reach(",hamlargemod"));
  EXPECT_EQ(ham(kFlat + "hammovel,hamarcu").sign.movements[0].kind, MoveKind::kArc);
  EXPECT_EQ(ham(kFlat + "hammovel,hamwavy").sign.movements[0].kind, MoveKind::kWavy);
  EXPECT_EQ(ham(kFlat + "hammovel,hamzigzag").sign.movements[0].kind, MoveKind::kZigzag);
  EXPECT_EQ(ham(kFlat + "hammovel,hamfast").sign.movements[0].manner, Manner::kFast);
  EXPECT_EQ(ham(kFlat + "hammovel,hamslow").sign.movements[0].manner, Manner::kSlow);
  EXPECT_EQ(ham(kFlat + "hammovel,hamhalt").sign.movements[0].manner, Manner::kSharp);
}

TEST(NotationMeaning, ArcsBowWhereTheyAreWritten) {
  // Letters of a bow are read on a movement away from the signer; every other movement carries them with it by the
  // shortest turn.
  const auto bow = [](const std::string& symbols) { return ham(kFlat + "hamchest," + symbols).sign.movements[0].bow; };
  EXPECT_EQ(bow("hammoveo,hamarcu"), (Direction{0, 1, 0}));
  EXPECT_EQ(bow("hammoveo,hamarcd"), (Direction{0, -1, 0}));
  EXPECT_EQ(bow("hammoveo,hamarcl"), (Direction{1, 0, 0}));
  EXPECT_EQ(bow("hammoveo,hamarcr"), (Direction{-1, 0, 0}));
  EXPECT_EQ(bow("hammovei,hamarcl"), (Direction{1, 0, 0})) << "towards the signer the bow stays literal";
  EXPECT_EQ(bow("hammovel,hamarcd"), (Direction{0, -1, 0})) << "a level turn leaves up and down";
  EXPECT_EQ(bow("hammoveu,hamarcu"), (Direction{0, 0, -1})) << "turned up, the top of the way is towards the signer";
  for (const char* symbols : {"hammovel,hamarcd", "hammoveu,hamarcr", "hammoveui,hamarcl"})
    EXPECT_FALSE(warned(ham(kFlat + symbols))) << symbols;
  const NotatedSign waved = ham(kFlat + "hamchest,hammover,hamarcd,hamwavy,hamsmallmod");
  ASSERT_EQ(waved.sign.movements.size(), 2u) << "an arc, and the waves on it";
  EXPECT_EQ(waved.sign.movements[0].bow, (Direction{0, -1, 0}));
  EXPECT_EQ(waved.sign.movements[1].size, Size::kSmall);
}

TEST(NotationMeaning, CirclesKeepTheirAxis) {
  const auto circle = [](const std::string& axis) { return ham(kFlat + "hamchest,hamcircle" + axis); };
  const NotatedSign out = circle("o"), in = circle("i"), up = circle("u"), left = circle("l");
  ASSERT_EQ(out.sign.movements.size(), 1u);
  EXPECT_EQ(out.sign.dominant.size(), 1u) << "a circle comes back to where it began";
  EXPECT_EQ(out.sign.movements[0].kind, MoveKind::kCircle);
  EXPECT_EQ(*out.sign.movements[0].direction, (Direction{0, 0, 1}));
  EXPECT_EQ(*in.sign.movements[0].direction, (Direction{0, 0, -1}));
  EXPECT_EQ(*up.sign.movements[0].direction, (Direction{0, 1, 0}));
  EXPECT_EQ(*left.sign.movements[0].direction, (Direction{1, 0, 0}));
  EXPECT_EQ(*circle("ul").sign.movements[0].direction, (Direction{1, 1, 0}));
  for (const char* axis :
       {"o", "i", "u", "d", "l", "r", "ul", "dr", "ur", "dl", "ol", "ir", "or", "il", "ui", "do", "uo", "di"})
    EXPECT_FALSE(warned(circle(axis))) << axis;
}

TEST(NotationMeaning, CirclesStartAndEndByTheClock) {
  const auto sign = [](const std::string& symbols) { return ham(kFlat + "hamchest," + symbols).sign; };
  // About the direction away from the signer a circle goes clockwise as the signer sees it: from the top to the right.
  const Sign quarter = sign("hamcircleo,hamclocku,hamclockr");
  ASSERT_EQ(quarter.dominant.size(), 2u) << "a part of a circle ends elsewhere";
  EXPECT_EQ(quarter.movements[0].start, (Direction{0, 1, 0}));
  EXPECT_EQ(quarter.movements[0].eighths, 2);
  const Vec3 by = quarter.dominant[1].offset - quarter.dominant[0].offset;
  EXPECT_LT(by.x, -0.01) << "to the right";
  EXPECT_NEAR(by.x, by.y, 1e-12) << "and as far down";
  EXPECT_EQ(sign("hamcirclei,hamclocku,hamclockl").movements[0].eighths, 2) << "the other way round";
  EXPECT_EQ(sign("hamcirclei,hamclocku,hamclockr").movements[0].eighths, 6);
  EXPECT_EQ(sign("hamcircleo,hamclockd").movements[0].start, (Direction{0, -1, 0}));
  EXPECT_EQ(sign("hamcircleo,hamclockd").movements[0].eighths, 8) << "a start alone: once round";
  EXPECT_EQ(sign("hamcircleo,hamclocku,hamclockr,hamclockfull").movements[0].eighths, 10) << "once more round";
  const Sign ellipse = sign("hamcircleo,hamellipsev,hamlargemod");
  EXPECT_EQ(ellipse.movements[0].ellipse, (Direction{0, 1, 0}));
  EXPECT_EQ(ellipse.movements[0].flattening, Size::kLarge);
  EXPECT_EQ(sign("hamcircleo,hamincreasing").movements[0].growth, Growth::kIncreasing);
}

TEST(NotationMeaning, TheOtherHandHasItsOwnAxis) {
  // Two hands in different shapes are no mirror images; a circle of both is mirrored all the same, with its sense.
  const NotatedSign sign =
      ham("hamsymmlr,hamparbegin,hamfist,hamplus,hamflathand,hamparend,hamextfingeru,hampalml,hamchest,hamcircleo");
  ASSERT_EQ(sign.sign.handedness, Handedness::kDominantBase);
  ASSERT_EQ(sign.sign.movements.size(), 2u);
  EXPECT_EQ(sign.sign.movements[0].hands, MovingHands::kDominant);
  EXPECT_EQ(sign.sign.movements[0].direction, (Direction{0, 0, 1}));
  EXPECT_EQ(sign.sign.movements[1].hands, MovingHands::kNonDominant);
  EXPECT_EQ(sign.sign.movements[1].direction, (Direction{0, 0, -1}));
}

TEST(NotationMeaning, DirectionsBetweenTheTwentySixAreExact) {
  const Posture posture = first(ham("hamflathand,hamextfingeru,hambetween,hamextfingerul,hampalmd"));
  const double eighth = 22.5 * 3.14159265358979323846 / 180.0;
  const Vec3 v = to_vector(posture.fingers);
  EXPECT_NEAR(v.x, std::sin(eighth), 1e-3);
  EXPECT_NEAR(v.y, std::cos(eighth), 1e-3);
  EXPECT_NEAR(v.z, 0, 1e-12);
  // The bearing is to the left, so that a palm down stays in the plane of the fingers: left and down, across them.
  const Vec3 palm = to_vector(posture.palm) - v * glm::dot(v, to_vector(posture.palm));
  EXPECT_NEAR(palm.x * std::sin(eighth) + palm.y * std::cos(eighth), 0, 1e-3);
  EXPECT_GT(palm.x, 0);
  EXPECT_NEAR(palm.z, 0, 1e-3);
}

TEST(NotationMeaning, EveryPlaceOnADigitHasItsName) {
  const auto touched = [](const std::string& site) {
    return first(ham("hamflathand,hamextfingeru,hampalmd," + site + ",hamforehead,hamtouch")).contact->part;
  };
  EXPECT_EQ(touched("hamindexfinger,hamfingernail"), hand_part({1, DigitFeature::kNail}));
  EXPECT_EQ(touched("hammiddlefinger,hamfingerpad"), hand_part({2, DigitFeature::kTipPad}));
  EXPECT_EQ(touched("hamthumb,hamfingermidjoint"), hand_part({0, DigitFeature::kMidDorsal}));
  EXPECT_EQ(touched("hampinky,hamfingerbase,hampalm"), hand_part({4, DigitFeature::kBasePalmar}));
  // The thumb of a right hand that is held up with its palm away is on the left.
  const auto on_side = [](const std::string& side, const std::string& palm) {
    const NotatedSign sign = gestural("<handconfig handshape=\"flat\" extfidir=\"u\" palmor=\"" + palm +
                                      "\"/><location_bodyarm location=\"chin\" contact=\"touch\"><location_hand "
                                      "location=\"midjoint\" digits=\"2\" side=\"" +
                                      side + "\"/></location_bodyarm>");
    return first(sign).contact->part;
  };
  EXPECT_EQ(on_side("left_beside", "d"), hand_part({1, DigitFeature::kMidRadial}));
  EXPECT_EQ(on_side("right_beside", "d"), hand_part({1, DigitFeature::kMidUlnar}));
  EXPECT_EQ(on_side("left_beside", "u"), hand_part({1, DigitFeature::kMidUlnar})) << "palm to the signer: turned round";
  EXPECT_EQ(on_side("left_beside", "l"), hand_part({1, DigitFeature::kMidPalmar})) << "the palm itself faces left";
}

TEST(NotationMeaning, SeveralFeaturesOfATierHaveTheirTimes) {
  const NotatedSign sign =
      gestural("<handconfig handshape=\"flat\" extfidir=\"u\" palmor=\"d\"/>", "",
               "<sign_nonmanual><head_tier><head_movement movement=\"NO\"/><head_movement movement=\"SH\"/></head_tier>"
               "<facialexpr_tier><facial_expr_par><eye_brows movement=\"RR\" amount=\"0.5\"/><eye_lids "
               "movement=\"WB\"/></facial_expr_par></facialexpr_tier></sign_nonmanual>");
  const NonManual& face = sign.sign.non_manual;
  ASSERT_EQ(face.more.size(), 3u);
  EXPECT_EQ(face.more[0], (NonManualFeature{"head", "nod", 0, 0.5, 1})) << "one after another";
  EXPECT_EQ(face.more[1], (NonManualFeature{"head", "shake", 0.5, 1, 1}));
  EXPECT_EQ(face.more[2], (NonManualFeature{"brows", "raise-right", 0, 1, 0.5}));
  EXPECT_EQ(face.eyes, "wide") << "at the same time, for the whole sign";
  EXPECT_TRUE(nothing_left_out(sign.diagnostics));
}

TEST(NotationMeaning, RepetitionsMayMoveOn) {
  const NotatedSign sign = gestural(
      "<handconfig handshape=\"flat\" extfidir=\"u\" palmor=\"d\"/><location_bodyarm location=\"chest\"/>"
      "<rpt_motion repetition=\"fromstart_several\" repetition_baseshift=\"r\"><directedmotion direction=\"d\" "
      "size=\"small\"/></rpt_motion>");
  // Down, back up and to the right, down …
  ASSERT_EQ(sign.sign.dominant.size(), 6u);
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 start = sign.sign.dominant[2 * i].offset, end = sign.sign.dominant[2 * i + 1].offset;
    EXPECT_NEAR(start.x, sign.sign.dominant[0].offset.x - 0.06 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(start.y, sign.sign.dominant[0].offset.y, 1e-12);
    EXPECT_NEAR(end.y - start.y, -0.06, 1e-12);
  }
}

TEST(NotationMeaning, LocalMovements) {
  const std::pair<const char*, MoveKind> moves[] = {
      {"hamfingerplay", MoveKind::kWiggle}, {"hamnodding", MoveKind::kNod}, {"hamtwisting", MoveKind::kTwist},
      {"hamswinging", MoveKind::kSwing},    {"hamstircw", MoveKind::kStir}, {"hamstirccw", MoveKind::kStir}};
  for (const auto& [symbol, kind] : moves) {
    const NotatedSign sign = ham(kFlat + "hamchest," + symbol);
    ASSERT_EQ(sign.sign.movements.size(), 1u) << symbol;
    EXPECT_EQ(sign.sign.movements[0].kind, kind) << symbol;
    EXPECT_EQ(sign.sign.movements[0].from, sign.sign.movements[0].to) << symbol;
    EXPECT_FALSE(warned(sign)) << symbol;
  }
  EXPECT_NE(ham(kFlat + "hamstircw").sign.movements[0].plane, ham(kFlat + "hamstirccw").sign.movements[0].plane);
  EXPECT_EQ(ham(kFlat + "hamfingerplay,hamindexfinger,hampinky").sign.movements[0].digits, "25");
  EXPECT_EQ(ham(kFlat + "hammovel,hamtense").sign.movements[0].manner, Manner::kTense);
  EXPECT_EQ(ham(kFlat + "hammovel,hamrest").sign.movements[0].manner, Manner::kRest);
}

TEST(NotationMeaning, ReplaceChangesThePosture) {
  const NotatedSign sign = ham("hamflathand,hamextfingeru,hampalmd,hamchest,hamreplace,hamfist,hamthumbacrossmod");
  ASSERT_EQ(sign.sign.dominant.size(), 2u);
  EXPECT_EQ(sign.sign.dominant[0].handshape, "ham:flat");
  EXPECT_EQ(sign.sign.dominant[1].handshape, "ham:fist+thumbacross");
  EXPECT_EQ(sign.sign.dominant[1].palm, sign.sign.dominant[0].palm);
  EXPECT_EQ(sign.handshapes.size(), 2u);
  // The palm letter stays and is read again by the new direction of the fingers: d is away with fingers up, down with
  // fingers out.
  const NotatedSign turned = ham("hamflathand,hamextfingeru,hampalmd,hamchest,hamreplace,hamextfingero");
  EXPECT_EQ(turned.sign.dominant[0].palm, (Direction{0, 0, 1}));
  EXPECT_EQ(turned.sign.dominant[1].palm, (Direction{0, -1, 0}));
  // With a movement at the same time there is still one stroke.
  const NotatedSign both =
      ham("hamflathand,hamextfingeru,hampalmd,hamchest,hamparbegin,hammoveo,hamreplace,hamfist,hamparend");
  EXPECT_EQ(both.sign.dominant.size(), 2u);
  EXPECT_EQ(both.sign.dominant[1].handshape, "ham:fist");
  EXPECT_GT(both.sign.dominant[1].offset.z, both.sign.dominant[0].offset.z);
}

TEST(NotationMeaning, Repetitions) {
  EXPECT_EQ(ham(kFlat + "hammoveo,hamrepeatfromstart").sign.movements[0].repeats, 2);
  EXPECT_EQ(ham(kFlat + "hammoveo,hamrepeatfromstartseveral").sign.movements[0].repeats, 3);
  // Continued, the hand goes on from where it is.
  const NotatedSign on = ham(kFlat + "hammovel,hamrepeatcontinue");
  ASSERT_EQ(on.sign.dominant.size(), 3u);
  EXPECT_NEAR(on.sign.dominant[2].offset.x - on.sign.dominant[0].offset.x,
              2 * (on.sign.dominant[1].offset.x - on.sign.dominant[0].offset.x), 1e-12);
  // Reversed, it comes back.
  const NotatedSign back = ham(kFlat + "hammovel,hamrepeatreverse");
  ASSERT_EQ(back.sign.dominant.size(), 3u);
  EXPECT_EQ(back.sign.dominant[2].offset, back.sign.dominant[0].offset);
  // A bracket of two strokes from the start: there, there, back, there, there.
  const NotatedSign pair = ham(kFlat + "hamseqbegin,hammovel,hammoveu,hamseqend,hamrepeatfromstart");
  ASSERT_EQ(pair.sign.dominant.size(), 6u);
  EXPECT_EQ(pair.sign.dominant[3].offset, pair.sign.dominant[0].offset);
  EXPECT_EQ(pair.sign.dominant[5].offset, pair.sign.dominant[2].offset);
}

TEST(NotationMeaning, MirroredHandsAreASymmetricSign) {
  const NotatedSign sign = ham("hamsymmlr,hamflathand,hamextfingerul,hampalmd,hamchest,hammoveo");
  EXPECT_EQ(sign.sign.handedness, Handedness::kSymmetric);
  EXPECT_TRUE(sign.sign.non_dominant.empty());
  EXPECT_LT(sign.sign.dominant[0].offset.x, -0.05) << "each hand on its own side";
  EXPECT_EQ(ham("hamsymmlr,hamflathand,hamextfingeru,hampalmd,hamchest,hammoveo,hamalternatingmotion").sign.handedness,
            Handedness::kAlternating);
  // Touching, they meet in the middle.
  const Posture touching = first(ham("hamsymmlr,hamflathand,hamextfingeru,hampalml,hamtouch,hamchest"));
  ASSERT_TRUE(touching.contact);
  EXPECT_EQ(touching.contact->target, Location::kHands);
  EXPECT_EQ(touching.contact->part, HandPart::kPalm) << "palms left and right face each other";
}

TEST(NotationMeaning, ParallelHandsKeepTheirDirections) {
  const NotatedSign sign = ham("hamsymmpar,hamflathand,hamextfingeru,hampalml,hamchest,hammovel");
  ASSERT_EQ(sign.sign.handedness, Handedness::kDominantBase);
  ASSERT_EQ(sign.sign.non_dominant.size(), 2u);
  EXPECT_EQ(sign.sign.dominant[0].palm, (Direction{1, 0, 0}));
  EXPECT_EQ(sign.sign.non_dominant[0].palm, (Direction{1, 0, 0}));
  EXPECT_GT(sign.sign.non_dominant[0].offset.x, 0) << "the place is on the hand's own side";
  EXPECT_GT(sign.sign.non_dominant[1].offset.x, sign.sign.non_dominant[0].offset.x) << "and it goes left too";
  // Up and down exchanged as well: the hands move apart vertically.
  const NotatedSign apart = ham("hamsymmlr,hamlargemod,hamflathand,hamextfingero,hampalml,hamchest,hammoveu");
  ASSERT_EQ(apart.sign.non_dominant.size(), 2u);
  EXPECT_GT(apart.sign.dominant[1].offset.y, apart.sign.dominant[0].offset.y);
  EXPECT_LT(apart.sign.non_dominant[1].offset.y, apart.sign.non_dominant[0].offset.y);
}

TEST(NotationMeaning, PlusGivesEachHandItsOwn) {
  const NotatedSign sign =
      ham("hamparbegin,hamfist,hamthumboutmod,hamplus,hamflathand,hamparend,hamparbegin,hamextfingero,hampalml,hamplus,"
          "hamextfingeror,hampalmu,hamparend,hamparbegin,hampinkyside,hamplus,hampalm,hamparend,hamtouch,hamparbegin,"
          "hammoveu,hamplus,hamnomotion,hamparend");
  ASSERT_EQ(sign.sign.handedness, Handedness::kDominantBase);
  ASSERT_EQ(sign.sign.dominant.size(), 2u);
  ASSERT_EQ(sign.sign.non_dominant.size(), 2u);
  EXPECT_EQ(sign.sign.dominant[0].handshape, "ham:fist+thumbout");
  EXPECT_EQ(sign.sign.non_dominant[0].handshape, "ham:flat");
  EXPECT_EQ(sign.sign.non_dominant[0].palm, (Direction{0, 1, 0}));
  EXPECT_EQ(sign.sign.dominant[0].location, Location::kOtherPalm);
  ASSERT_TRUE(sign.sign.dominant[0].contact);
  EXPECT_EQ(sign.sign.dominant[0].contact->part, HandPart::kUlnar);
  EXPECT_EQ(sign.sign.dominant[0].contact->kind, ContactKind::kTouch);
  EXPECT_EQ(sign.sign.non_dominant[1].offset, sign.sign.non_dominant[0].offset) << "the base hand stays";
  EXPECT_GT(sign.sign.dominant[1].offset.y, sign.sign.dominant[0].offset.y + 0.05);
  EXPECT_EQ(sign.sign.dominant[1].contact->kind, ContactKind::kNear) << "the contact is left";
}

// h2s, the translator between the two kinds of SiGML: the same sign in both.
TEST(NotationMeaning, BothKindsOfSigmlReadAlike) {
  const NotatedSign symbols = ham(
      "hamsymmlr,hamfinger2345,hamthumboutmod,hamfingerbendmod,hamextfingerul,hampalmdl,hamshoulders,hamlrat,hamclose,"
      "hamparbegin,hammovedo,hamsmallmod,hamreplace,hamfist,hamparend,hamrepeatfromstartseveral");
  const NotatedSign attributes = gestural(
      "<handconfig handshape='finger2345' thumbpos='out' mainbend='round'/><handconfig extfidir='ul'/>"
      "<handconfig palmor='dl'/><location_bodyarm location='shoulders' side='right_at' contact='close'/>"
      "<rpt_motion repetition='fromstart_several'><par_motion><directedmotion direction='do' size='small'/>"
      "<tgt_motion><changeposture/><handconfig handshape='fist'/></tgt_motion></par_motion></rpt_motion>",
      "both_hands='true' lr_symm='true'");
  ASSERT_EQ(symbols.sign.dominant.size(), 2u);
  ASSERT_EQ(attributes.sign.dominant.size(), 2u);
  EXPECT_EQ(symbols.sign.handedness, attributes.sign.handedness);
  for (size_t i = 0; i < 2; ++i) {
    const Posture &a = symbols.sign.dominant[i], &b = attributes.sign.dominant[i];
    EXPECT_EQ(a.handshape, b.handshape);
    EXPECT_EQ(a.fingers, b.fingers);
    EXPECT_EQ(a.palm, b.palm);
    EXPECT_EQ(a.location, b.location);
    EXPECT_EQ(a.offset, b.offset);
  }
  EXPECT_EQ(symbols.sign.movements[0].repeats, 3);
  EXPECT_EQ(attributes.sign.movements[0].repeats, 3);
}

TEST(NotationMeaning, FaceAndMouth) {
  const NotatedSign sign =
      gestural("<handconfig handshape='flat' extfidir='u' palmor='l'/>", "",
               "<sign_nonmanual><facialexpr_tier><facial_expr_par><eye_brows movement='RB'/><eye_lids movement='WB'/>"
               "</facial_expr_par></facialexpr_tier><head_tier><head_movement movement='SH'/></head_tier>"
               "<mouthing_tier><mouth_picture picture='mO:nIN'/></mouthing_tier></sign_nonmanual>");
  EXPECT_EQ(sign.sign.non_manual.brows, "raise");
  EXPECT_EQ(sign.sign.non_manual.eyes, "wide");
  EXPECT_EQ(sign.sign.non_manual.head, "shake");
  EXPECT_EQ(sign.sign.non_manual.mouthing, "mawning");
}

// What the model has no word for is carried by its code, each of the 78.
TEST(NotationMeaning, MouthGesturesAndGaze) {
  const auto face_of = [](const std::string& gesture, const std::string& gaze) {
    const auto signs = parse_sigml(
        "<sigml><hns_sign gloss=\"X\"><hamnosys_nonmanual><hnm_mouthgesture tag=\"" + gesture +
            "\"/><hnm_eyegaze tag=\"" + gaze +
            "\"/></hamnosys_nonmanual><hamnosys_manual><hamflathand/><hamextfingeru/><hampalml/></hamnosys_manual>"
            "</hns_sign></sigml>",
        "f");
    EXPECT_TRUE(signs);
    return signs->front();
  };
  const NotatedSign tongue = face_of("T14", "UP");
  EXPECT_EQ(tongue.sign.non_manual.mouth, "T14");
  EXPECT_EQ(tongue.sign.non_manual.gaze, "up");
  EXPECT_TRUE(tongue.diagnostics.empty());
  EXPECT_EQ(face_of("L35", "LE").sign.non_manual.mouth, "L35");
  EXPECT_EQ(face_of("L34", "RI").sign.non_manual.mouth, "stretched");
  EXPECT_EQ(face_of("C01", "DN").sign.non_manual.gaze, "down");
  for (const char* wrong : {"D10", "L00", "T18", "Q01", "L3"}) {
    const NotatedSign sign = face_of(wrong, "AD");
    EXPECT_EQ(sign.sign.non_manual.mouth, "");
    EXPECT_EQ(sign.diagnostics.size(), 1U) << wrong;
  }
}

TEST(NotationMeaning, CompoundsFollowEachOther) {
  const NotatedSign sign = gestural(
      "<sign_manual><handconfig handshape='flat' extfidir='u' palmor='u'/><location_bodyarm location='chin' "
      "contact='touch'/></sign_manual><sign_manual both_hands='true' lr_symm='true'><handconfig handshape='fist' "
      "extfidir='o' palmor='d'/></sign_manual>");
  ASSERT_EQ(sign.sign.dominant.size(), 2u);
  EXPECT_EQ(sign.sign.dominant[0].location, Location::kChin);
  EXPECT_EQ(sign.sign.dominant[1].handshape, "ham:fist");
  EXPECT_EQ(sign.sign.non_dominant.size(), 2u);
}

}  // namespace
}  // namespace auslan
