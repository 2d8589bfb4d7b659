// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme_stream.h"
#include "grammar/GliderParser.h"

#include <antlr4-runtime.h>

#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace glider::frontend {

/// ANTLR's choice between the alternatives of a rule, with the automata that it has found in a
/// table: ANTLR looks each of their states up in a hash map behind a lock. What ANTLR has not found
/// yet is not in the table either, so the grammar alone says what is chosen.
class PredictionTable final : public antlr4::atn::ParserATNSimulator {
 public:
  /// For `reader`, a parser of `tokens` that has its own simulator still.
  PredictionTable(grammar::GliderParser& reader, LexemeStream& tokens);

  size_t adaptivePredict(antlr4::TokenStream* input, size_t decision,
                         antlr4::ParserRuleContext* context) override;

 private:
  using Number = uint16_t;
  static constexpr Number kUnknown = std::numeric_limits<Number>::max();

  struct State {
    antlr4::dfa::DFAState* state = nullptr;
    size_t chosen = 0;         ///< the number of an alternative; 0: more tokens decide
    bool usable = true;        ///< nothing but the tokens decides
    std::vector<Number> next;  ///< by the type of the token, the end of the file first
  };

  /// The alternative, if ANTLR has been on the whole way to it before; otherwise 0.
  size_t known(size_t decision);
  Number start(size_t decision);
  Number follow(Number from, size_t type);
  Number numberOf(antlr4::dfa::DFAState* state);

  LexemeStream& tokens_;
  size_t types_;
  std::vector<State> states_;
  std::unordered_map<const antlr4::dfa::DFAState*, Number> numbers_;
  std::vector<std::vector<Number>> starts_;  ///< of a decision, by how tightly operators must bind
};

}  // namespace glider::frontend
