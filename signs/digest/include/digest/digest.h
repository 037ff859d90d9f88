// SPDX-License-Identifier: Apache-2.0
// A fingerprint of bytes: to tell whether two things are the same, not to keep secrets or to withstand forgers.
#pragma once

#include <string>
#include <string_view>

namespace auslan {

/// XXH3 of 128 bits in its canonical order, as 32 small hexadecimal digits.
std::string digest_of(std::string_view bytes);

}  // namespace auslan
