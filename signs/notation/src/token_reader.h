// SPDX-License-Identifier: Apache-2.0
// HamNoSys symbol by symbol: one parser for strings and for the elements of hamnosys_manual.
#pragma once

#include "notation/symbols.h"
#include "written_sign.h"

#include <span>

namespace auslan::notation {

struct Token {
  const HamSymbol* symbol = nullptr;
  Mark mark;
};

/// Appends the manual parts that the symbols write. Total: what is out of order is told and skipped.
void read_tokens(std::span<const Token> tokens, const Mark& mark, WrittenSign& sign, Findings& findings);

}  // namespace auslan::notation
