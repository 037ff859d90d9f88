// SPDX-License-Identifier: Apache-2.0
// Signs back into the field's notations. What was read is written as it was read, also what nobody understood: reading
// it again gives an equal sign. Between the kinds of notation a sign is converted where the other kind can say the
// same. Signs of the lexicon are written as nearly as a notation can say them.
#pragma once

#include "notation/notation.h"

#include <span>

namespace auslan {

enum class NotationForm {
  kSymbols,   ///< hns_sign: HamNoSys symbols as elements
  kGestural,  ///< hamgestural_sign
};

/// Which of the two a sign is written in; none where it is neither.
std::optional<NotationForm> form_of(const WrittenElement& written);

/// A file of SiGML with these signs, as they are written.
std::string write_sigml(std::span<const NotatedSign> signs);

/// The manual symbols of an hns_sign as code points of HamNoSys 4. kUnsupported for other kinds (convert it first).
Result<std::string> write_hamnosys(const NotatedSign& sign);

/// The same sign in another kind of notation, read again. kUnsupported for what is no sign at all.
struct ConvertedSign {
  NotatedSign sign;
  bool same_sign = false;            ///< what is signed is equal
  std::vector<Diagnostic> findings;  ///< what that kind cannot say; places count within the sign as it is written
};
Result<ConvertedSign> convert(const NotatedSign& sign, NotationForm form);

/// A sign of the lexicon in a notation, and what a reader understands of it. `handshapes`: at least those that it uses.
/// What the notation cannot say, or says only nearly, is told in the findings; their places mean nothing.
Result<ConvertedSign> notate(const Sign& sign, std::span<const Handshape> handshapes, NotationForm form);

}  // namespace auslan
