// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "grammar/GliderLexer.h"

#include <antlr4-runtime.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace glider::frontend {

/// The lexer's automaton as a table. ANTLR finds each of its states once, keeps them in hash maps
/// behind locks, and looks one up for each byte; here a byte costs one index. What ANTLR has not
/// found yet is not in the table either, so the grammar alone says what a token is.
class LexerTable final : private antlr4::atn::LexerATNSimulator {
 public:
  /// `lexer` must outlive the table and find every token that the table does not know.
  explicit LexerTable(grammar::GliderLexer& lexer);

  /// A token and where it ends; white space and comments have type 0.
  struct Found {
    uint32_t type = 0;
    size_t end = 0;
  };
  /// The token that begins at byte `at`, if ANTLR has been on its whole way before.
  std::optional<Found> tokenAt(std::string_view text, size_t at);

 private:
  using Number = uint16_t;
  static constexpr Number kUnknown = std::numeric_limits<Number>::max();
  static constexpr Number kNone = kUnknown - 1;  ///< no token goes on with this byte
  static constexpr size_t kBytes = MAX_DFA_EDGE + 1;

  struct State {
    antlr4::dfa::DFAState* state = nullptr;
    bool ends = false;     ///< a token may end here
    bool skipped = false;  ///< and is left out
    bool usable = true;    ///< ANTLR does nothing at its end that the table does not know
    std::array<Number, kBytes> next{};
  };

  Number start();
  Number follow(Number from, uint8_t byte);
  Number numberOf(antlr4::dfa::DFAState* state);

  std::vector<State> states_;
  std::unordered_map<const antlr4::dfa::DFAState*, Number> numbers_;
  Number start_ = kUnknown;
};

}  // namespace glider::frontend
