// SPDX-License-Identifier: Apache-2.0
#include "notation/symbols.h"

#include <algorithm>
#include <array>
#include <utility>

namespace auslan {
namespace {

using enum SymbolKind;

// clang-format off
constexpr HamSymbol kSymbols[] = {
    {0x0020, "hamspace", kOther, ""}, {0x0021, "hamexclaim", kOther, ""}, {0x002C, "hamcomma", kOther, ""},
    {0x002E, "hamfullstop", kOther, ""}, {0x003F, "hamquery", kOther, ""},
    {0x007B, "hamaltbegin", kOther, "alternatives"}, {0x007C, "hammetaalt", kOther, "alternatives"},
    {0x007D, "hamaltend", kOther, "alternatives"}, {0xE000, "hamfist", kHandshape, "fist"},
    {0xE001, "hamflathand", kHandshape, "flat"}, {0xE002, "hamfinger2", kHandshape, "finger2"},
    {0xE003, "hamfinger23", kHandshape, "finger23"}, {0xE004, "hamfinger23spread", kHandshape, "finger23spread"},
    {0xE005, "hamfinger2345", kHandshape, "finger2345"}, {0xE006, "hampinch12", kHandshape, "pinch12"},
    {0xE007, "hampinchall", kHandshape, "pinchall"}, {0xE008, "hampinch12open", kHandshape, "pinch12open"},
    {0xE009, "hamcee12", kHandshape, "cee12"}, {0xE00A, "hamceeall", kHandshape, "ceeall"},
    {0xE00B, "hamceeopen", kHandshape, "cee12open"}, {0xE00C, "hamthumboutmod", kThumb, "out"},
    {0xE00D, "hamthumbacrossmod", kThumb, "across"}, {0xE00E, "hamthumbopenmod", kThumb, "opposed"},
    {0xE010, "hamfingerstraightmod", kBend, "bent"}, {0xE011, "hamfingerbendmod", kBend, "round"},
    {0xE012, "hamfingerhookmod", kBend, "hooked"}, {0xE013, "hamdoublebent", kBend, "dblbent"},
    {0xE014, "hamdoublehooked", kBend, "dblhooked"}, {0xE020, "hamextfingeru", kFingers, "u"},
    {0xE021, "hamextfingerur", kFingers, "ur"}, {0xE022, "hamextfingerr", kFingers, "r"},
    {0xE023, "hamextfingerdr", kFingers, "dr"}, {0xE024, "hamextfingerd", kFingers, "d"},
    {0xE025, "hamextfingerdl", kFingers, "dl"}, {0xE026, "hamextfingerl", kFingers, "l"},
    {0xE027, "hamextfingerul", kFingers, "ul"}, {0xE028, "hamextfingerol", kFingers, "ol"},
    {0xE029, "hamextfingero", kFingers, "o"}, {0xE02A, "hamextfingeror", kFingers, "or"},
    {0xE02B, "hamextfingeril", kFingers, "il"}, {0xE02C, "hamextfingeri", kFingers, "i"},
    {0xE02D, "hamextfingerir", kFingers, "ir"}, {0xE02E, "hamextfingerui", kFingers, "ui"},
    {0xE02F, "hamextfingerdi", kFingers, "di"}, {0xE030, "hamextfingerdo", kFingers, "do"},
    {0xE031, "hamextfingeruo", kFingers, "uo"}, {0xE038, "hampalmu", kPalm, "u"}, {0xE039, "hampalmur", kPalm, "ur"},
    {0xE03A, "hampalmr", kPalm, "r"}, {0xE03B, "hampalmdr", kPalm, "dr"}, {0xE03C, "hampalmd", kPalm, "d"},
    {0xE03D, "hampalmdl", kPalm, "dl"}, {0xE03E, "hampalml", kPalm, "l"}, {0xE03F, "hampalmul", kPalm, "ul"},
    {0xE040, "hamhead", kBody, "head"}, {0xE041, "hamheadtop", kBody, "headtop"},
    {0xE042, "hamforehead", kBody, "forehead"}, {0xE043, "hameyebrows", kBody, "eyebrows"},
    {0xE044, "hameyes", kBody, "eyes"}, {0xE045, "hamnose", kBody, "nose"},
    {0xE046, "hamnostrils", kBody, "nostrils"}, {0xE047, "hamear", kBody, "ear"},
    {0xE048, "hamearlobe", kBody, "earlobe"}, {0xE049, "hamcheek", kBody, "cheek"},
    {0xE04A, "hamlips", kBody, "lips"}, {0xE04B, "hamtongue", kBody, "tongue"}, {0xE04C, "hamteeth", kBody, "teeth"},
    {0xE04D, "hamchin", kBody, "chin"}, {0xE04E, "hamunderchin", kBody, "underchin"},
    {0xE04F, "hamneck", kBody, "neck"}, {0xE050, "hamshouldertop", kBody, "shouldertop"},
    {0xE051, "hamshoulders", kBody, "shoulders"}, {0xE052, "hamchest", kBody, "chest"},
    {0xE053, "hamstomach", kBody, "stomach"}, {0xE054, "hambelowstomach", kBody, "belowstomach"},
    {0xE058, "hamlrbeside", kSide, "beside"}, {0xE059, "hamlrat", kSide, "at"},
    {0xE05A, "hamcoreftag", kOther, "a name for a place"}, {0xE05B, "hamcorefref", kOther, "a named place"},
    {0xE05F, "hamneutralspace", kBody, "neutralspace"}, {0xE060, "hamupperarm", kHandSite, "upperarm"},
    {0xE061, "hamelbow", kHandSite, "elbow"}, {0xE062, "hamelbowinside", kHandSite, "elbowinside"},
    {0xE063, "hamlowerarm", kHandSite, "lowerarm"}, {0xE064, "hamwristback", kHandSite, "wristback"},
    {0xE065, "hamwristpulse", kHandSite, "wristpulse"}, {0xE066, "hamthumbball", kHandSite, "thumbball"},
    {0xE067, "hampalm", kHandSite, "palm"}, {0xE068, "hamhandback", kHandSite, "handback"},
    {0xE069, "hamthumbside", kHandSite, "thumbside"}, {0xE06A, "hampinkyside", kHandSite, "pinkyside"},
    {0xE070, "hamthumb", kDigit, "1"}, {0xE071, "hamindexfinger", kDigit, "2"},
    {0xE072, "hammiddlefinger", kDigit, "3"}, {0xE073, "hamringfinger", kDigit, "4"},
    {0xE074, "hampinky", kDigit, "5"}, {0xE075, "hamfingertip", kFingerPart, "tip"},
    {0xE076, "hamfingernail", kFingerPart, "nail"}, {0xE077, "hamfingerpad", kFingerPart, "pad"},
    {0xE078, "hamfingermidjoint", kFingerPart, "midjoint"}, {0xE079, "hamfingerbase", kFingerPart, "base"},
    {0xE07A, "hamfingerside", kFingerPart, "side"}, {0xE07C, "hamwristtopulse", kOther, "an obsolete wrist posture"},
    {0xE07D, "hamwristtoback", kOther, "an obsolete wrist posture"},
    {0xE07E, "hamwristtothumb", kOther, "an obsolete wrist posture"},
    {0xE07F, "hamwristtopinky", kOther, "an obsolete wrist posture"}, {0xE080, "hammoveu", kMove, "u"},
    {0xE081, "hammoveur", kMove, "ur"}, {0xE082, "hammover", kMove, "r"}, {0xE083, "hammovedr", kMove, "dr"},
    {0xE084, "hammoved", kMove, "d"}, {0xE085, "hammovedl", kMove, "dl"}, {0xE086, "hammovel", kMove, "l"},
    {0xE087, "hammoveul", kMove, "ul"}, {0xE088, "hammoveol", kMove, "ol"}, {0xE089, "hammoveo", kMove, "o"},
    {0xE08A, "hammoveor", kMove, "or"}, {0xE08B, "hammoveil", kMove, "il"}, {0xE08C, "hammovei", kMove, "i"},
    {0xE08D, "hammoveir", kMove, "ir"}, {0xE08E, "hammoveui", kMove, "ui"}, {0xE08F, "hammovedi", kMove, "di"},
    {0xE090, "hammovedo", kMove, "do"}, {0xE091, "hammoveuo", kMove, "uo"}, {0xE092, "hamcircleo", kCircle, "o"},
    {0xE093, "hamcirclei", kCircle, "i"}, {0xE094, "hamcircled", kCircle, "d"}, {0xE095, "hamcircleu", kCircle, "u"},
    {0xE096, "hamcirclel", kCircle, "l"}, {0xE097, "hamcircler", kCircle, "r"},
    {0xE098, "hamcircleul", kCircle, "ul"}, {0xE099, "hamcircledr", kCircle, "dr"},
    {0xE09A, "hamcircleur", kCircle, "ur"}, {0xE09B, "hamcircledl", kCircle, "dl"},
    {0xE09C, "hamcircleol", kCircle, "ol"}, {0xE09D, "hamcircleir", kCircle, "ir"},
    {0xE09E, "hamcircleor", kCircle, "or"}, {0xE09F, "hamcircleil", kCircle, "il"},
    {0xE0A0, "hamcircleui", kCircle, "ui"}, {0xE0A1, "hamcircledo", kCircle, "do"},
    {0xE0A2, "hamcircleuo", kCircle, "uo"}, {0xE0A3, "hamcircledi", kCircle, "di"},
    {0xE0A4, "hamfingerplay", kFingerplay, ""}, {0xE0A5, "hamnodding", kWrist, "nodding"},
    {0xE0A6, "hamswinging", kWrist, "swinging"}, {0xE0A7, "hamtwisting", kWrist, "twisting"},
    {0xE0A8, "hamstircw", kWrist, "stircw"}, {0xE0A9, "hamstirccw", kWrist, "stirccw"},
    {0xE0AA, "hamreplace", kReplace, ""}, {0xE0AD, "hammovecross", kOther, "an obsolete crossing movement"},
    {0xE0AE, "hammovex", kOther, "an obsolete crossing movement"}, {0xE0AF, "hamnomotion", kNoMotion, ""},
    {0xE0B0, "hamclocku", kClock, "u"}, {0xE0B1, "hamclockul", kClock, "ul"}, {0xE0B2, "hamclockl", kClock, "l"},
    {0xE0B3, "hamclockdl", kClock, "dl"}, {0xE0B4, "hamclockd", kClock, "d"}, {0xE0B5, "hamclockdr", kClock, "dr"},
    {0xE0B6, "hamclockr", kClock, "r"}, {0xE0B7, "hamclockur", kClock, "ur"},
    {0xE0B8, "hamclockfull", kClockFull, ""}, {0xE0B9, "hamarcl", kArc, "l"}, {0xE0BA, "hamarcu", kArc, "u"},
    {0xE0BB, "hamarcr", kArc, "r"}, {0xE0BC, "hamarcd", kArc, "d"}, {0xE0BD, "hamwavy", kWaviness, "wavy"},
    {0xE0BE, "hamzigzag", kWaviness, "zigzag"}, {0xE0C0, "hamellipseh", kEllipse, "h"},
    {0xE0C1, "hamellipseur", kEllipse, "ur"}, {0xE0C2, "hamellipsev", kEllipse, "v"},
    {0xE0C3, "hamellipseul", kEllipse, "ul"}, {0xE0C4, "hamincreasing", kGrowth, "increasing"},
    {0xE0C5, "hamdecreasing", kGrowth, "decreasing"}, {0xE0C6, "hamsmallmod", kSize, "small"},
    {0xE0C7, "hamlargemod", kSize, "big"}, {0xE0C8, "hamfast", kManner, "fast"}, {0xE0C9, "hamslow", kManner, "slow"},
    {0xE0CA, "hamtense", kManner, "tense"}, {0xE0CB, "hamrest", kManner, "rest"},
    {0xE0CC, "hamhalt", kManner, "halt"}, {0xE0D0, "hamclose", kContact, "close"},
    {0xE0D1, "hamtouch", kContact, "touch"}, {0xE0D2, "haminterlock", kContact, "interlock"},
    {0xE0D3, "hamcross", kContact, "cross"}, {0xE0D4, "hamarmextended", kContact, "armextended"},
    {0xE0D5, "hambehind", kBehind, ""}, {0xE0D6, "hambrushing", kBrushing, ""},
    {0xE0D8, "hamrepeatfromstart", kRepeat, "fromstart"},
    {0xE0D9, "hamrepeatfromstartseveral", kRepeat, "fromstart_several"},
    {0xE0DA, "hamrepeatcontinue", kRepeat, "continue"},
    {0xE0DB, "hamrepeatcontinueseveral", kRepeat, "continue_several"},
    {0xE0DC, "hamrepeatreverse", kRepeat, "reverse"}, {0xE0DD, "hamalternatingmotion", kAlternating, ""},
    {0xE0E0, "hamseqbegin", kSequenceBegin, ""}, {0xE0E1, "hamseqend", kSequenceEnd, ""},
    {0xE0E2, "hamparbegin", kParallelBegin, ""}, {0xE0E3, "hamparend", kParallelEnd, ""},
    {0xE0E4, "hamfusionbegin", kFusionBegin, ""}, {0xE0E5, "hamfusionend", kFusionEnd, ""},
    {0xE0E6, "hambetween", kBetween, ""}, {0xE0E7, "hamplus", kPlus, ""}, {0xE0E8, "hamsymmpar", kSymmetry, "par"},
    {0xE0E9, "hamsymmlr", kSymmetry, "lr"}, {0xE0EA, "hamnondominant", kNonDominant, ""},
    {0xE0EB, "hamnonipsi", kNonIpsi, ""}, {0xE0EC, "hametc", kOther, "\"and so on\""},
    {0xE0ED, "hamorirelative", kOther, "orientation that follows the path"}, {0xE0F0, "hammime", kOther, "mime"},
    {0xE0F1, "hamversion40", kOther, ""},
};
// clang-format on

/// Spellings of older tools and of real files.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kAliases = {{
    {"hampinchopen", "hampinch12open"},
    {"hamcee12open", "hamceeopen"},
    {"hamfingerhookedmod", "hamfingerhookmod"},
    {"hamclockplus", "hamclockfull"},
    {"hamsympar", "hamsymmpar"},
    {"hamsymlr", "hamsymmlr"},
}};

}  // namespace

std::span<const HamSymbol> ham_symbols() {
  return kSymbols;
}

const HamSymbol* find_ham_symbol(std::string_view name) {
  for (const auto& [alias, meant] : kAliases)
    if (name == alias) name = meant;
  auto found = std::ranges::find(kSymbols, name, &HamSymbol::name);
  if (found == std::end(kSymbols)) {
    // Some files have capitals in the middle of a name.
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    found = std::ranges::find_if(
        kSymbols, [&](const HamSymbol& symbol) { return std::ranges::equal(symbol.name, name, {}, {}, small); });
  }
  return found == std::end(kSymbols) ? nullptr : &*found;
}

const HamSymbol* find_ham_symbol(char32_t code) {
  const auto found = std::ranges::lower_bound(kSymbols, code, {}, &HamSymbol::code);
  return found == std::end(kSymbols) || found->code != code ? nullptr : &*found;
}

}  // namespace auslan
