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
  // An arc that the model would turn over is told.
  EXPECT_FALSE(warned(ham(kFlat + "hammovel,hamarcu")));
  EXPECT_TRUE(warned(ham(kFlat + "hammovel,hamarcd")));
}

TEST(NotationMeaning, CirclesKeepTheirAxis) {
  const auto circle = [](const std::string& axis) { return ham(kFlat + "hamchest,hamcircle" + axis); };
  const NotatedSign out = circle("o"), in = circle("i"), up = circle("u"), left = circle("l");
  ASSERT_EQ(out.sign.movements.size(), 1u);
  EXPECT_EQ(out.sign.dominant.size(), 1u) << "a circle comes back to where it began";
  EXPECT_EQ(out.sign.movements[0].kind, MoveKind::kCircle);
  EXPECT_EQ(out.sign.movements[0].plane, Plane::kFrontal);
  EXPECT_EQ(*out.sign.movements[0].direction, (Direction{0, 0, 1}));
  EXPECT_EQ(*in.sign.movements[0].direction, (Direction{0, 0, -1}));
  EXPECT_EQ(up.sign.movements[0].plane, Plane::kHorizontal);
  EXPECT_EQ(left.sign.movements[0].plane, Plane::kSagittal);
  EXPECT_TRUE(warned(in)) << "the opposite sense is not silent";
  EXPECT_FALSE(warned(out));
}

TEST(NotationMeaning, LocalMovements) {
  const std::pair<const char*, MoveKind> moves[] = {
      {"hamfingerplay", MoveKind::kWiggle}, {"hamnodding", MoveKind::kNod}, {"hamtwisting", MoveKind::kTwist}};
  for (const auto& [symbol, kind] : moves) {
    const NotatedSign sign = ham(kFlat + "hamchest," + symbol);
    ASSERT_EQ(sign.sign.movements.size(), 1u) << symbol;
    EXPECT_EQ(sign.sign.movements[0].kind, kind) << symbol;
    EXPECT_EQ(sign.sign.movements[0].from, sign.sign.movements[0].to) << symbol;
    EXPECT_FALSE(warned(sign)) << symbol;
  }
  for (const char* symbol : {"hamswinging", "hamstircw", "hamstirccw"}) {
    const NotatedSign sign = ham(kFlat + "hamchest," + symbol);
    EXPECT_EQ(sign.sign.movements.size(), 1u) << symbol;
    EXPECT_TRUE(warned(sign)) << symbol << " is carried by something else";
  }
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
