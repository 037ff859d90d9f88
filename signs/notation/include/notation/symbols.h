// SPDX-License-Identifier: Apache-2.0
// The symbols of HamNoSys 4: code point in the private use area, SiGML element name, and what the symbol says.
#pragma once

#include <span>
#include <string_view>

namespace auslan {

enum class SymbolKind {
  kHandshape,
  kThumb,
  kBend,
  kDigit,
  kFingerPart,
  kFingers,
  kPalm,
  kBody,
  kHandSite,
  kSide,
  kContact,
  kBrushing,
  kBehind,
  kMove,
  kCircle,
  kClock,
  kClockFull,
  kArc,
  kWaviness,
  kEllipse,
  kGrowth,
  kSize,
  kWrist,
  kFingerplay,
  kReplace,
  kNoMotion,
  kManner,
  kRepeat,
  kAlternating,
  kSequenceBegin,
  kSequenceEnd,
  kParallelBegin,
  kParallelEnd,
  kFusionBegin,
  kFusionEnd,
  kBetween,
  kPlus,
  kSymmetry,
  kNonDominant,
  kNonIpsi,
  kOther,
};

struct HamSymbol {
  char32_t code = 0;
  std::string_view name;  ///< of the SiGML element, "hamflathand"
  SymbolKind kind = SymbolKind::kOther;
  std::string_view value;  ///< the SiGML attribute value that says the same: "flat", "ul", "out"
};

/// In order of code points, each name and each code once.
std::span<const HamSymbol> ham_symbols();
/// Spellings met in real files, such as "hampinchopen", are found too; nullptr for what is not a symbol.
const HamSymbol* find_ham_symbol(std::string_view name);
const HamSymbol* find_ham_symbol(char32_t code);

}  // namespace auslan
