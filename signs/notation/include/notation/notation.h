// SPDX-License-Identifier: Apache-2.0
// Signs from the field's notations: SiGML files (hns_sign and hamgestural_sign) and HamNoSys 4 strings, read into the
// phonological model. The handshapes come with the sign, so that no lexicon is needed to perform it.
//
// Nothing is dropped silently: what is read and cannot be carried by the model, and what is not known at all, is told
// in a diagnostic with its place.
#pragma once

#include "kinematics/result.h"
#include "notation/written_element.h"
#include "phonology/sign.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace auslan {

struct Diagnostic {
  enum class Grade {
    kError,    ///< the sign cannot be signed
    kWarning,  ///< it is signed with the stated assumption
    kNote,     ///< it is signed as written, up to rounding
  };
  Grade grade = Grade::kNote;
  int line = 1;    ///< 1-based; in a HamNoSys string always 1
  int column = 1;  ///< 1-based, in bytes; in a HamNoSys string the byte at which the symbol starts
  bool left_out =
      false;  ///< something that is written has no part in what is signed; else it is signed, if differently
  std::string message;
};

/// "line:column: warning: message"
std::string to_string(const Diagnostic& diagnostic);

/// True when nothing of what is written was left out.
bool nothing_left_out(const std::vector<Diagnostic>& diagnostics);

struct NotatedSign {
  Sign sign;                            ///< gloss as written, else "HAMNOSYS"
  std::vector<Handshape> handshapes;    ///< all that the sign uses, each once; ids such as "ham:finger2+thumbout"
  std::vector<Diagnostic> diagnostics;  ///< in reading order
  WrittenElement written;               ///< all that was read (writer.h writes it again)
  bool signable = false;                ///< false: `sign` is empty of postures and an error says why
};

/// Limits of what is read; beyond them a file is refused with kLimit.
inline constexpr size_t kMaxSigmlBytes = size_t{16} << 20;
inline constexpr int kMaxSigmlDepth = 64;
inline constexpr size_t kMaxSigmlAttributeBytes = 4096;
inline constexpr size_t kMaxHamnosysBytes = size_t{64} << 10;

/// Every sign of a file, in order. kNotFound or kUnreadable for the file itself; else as parse_sigml.
Result<std::vector<NotatedSign>> read_sigml(const std::filesystem::path& path);

/// `name` is what errors call the text. kMalformed (place "name:line:column") for text that is not well-formed XML in
/// UTF-8, declares or uses entities, or holds no sign; kLimit beyond the limits above.
Result<std::vector<NotatedSign>> parse_sigml(std::string_view text, const std::string& name);

/// HamNoSys 4 as its private-use code points, or as symbol names separated by commas or spaces
/// ("hamflathand,hamextfingeru,hampalml"). kMalformed for invalid UTF-8 and for text without any symbol.
Result<NotatedSign> parse_hamnosys(std::string_view utf8);

}  // namespace auslan
