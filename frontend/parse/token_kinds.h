// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "grammar/GliderLexer.h"

#include <cstdint>
#include <utility>

/// Groups of tokens that repair and recovery use.
namespace glider::frontend {

using grammar::GliderLexer;

inline constexpr auto kEof = static_cast<uint32_t>(antlr4::Token::EOF);

/// The number of types is known to the compiler, which makes comparisons of it and no loop.
template <size_t N>
constexpr bool oneOf(uint32_t type, const uint32_t (&types)[N]) {
  return [&]<size_t... I>(std::index_sequence<I...>) {
    return ((type == types[I]) || ...);
  }(std::make_index_sequence<N>());
}

/// Whether it begins an item that is only allowed at the top level.
inline bool startsItem(uint32_t type) {
  return oneOf(type, {GliderLexer::MISSION, GliderLexer::PLATFORM, GliderLexer::IMPORT,
                      GliderLexer::CONST, GliderLexer::PARAM, GliderLexer::STATE,
                      GliderLexer::ALWAYS, GliderLexer::EXTERN, GliderLexer::REQUIRE});
}

inline bool isBehaviourWord(uint32_t type) {
  return type == GliderLexer::FLIGHTPROFILE || type == GliderLexer::FLIGHTROUTE;
}

/// Whether it begins a member that is directly inside a state.
inline bool startsMember(uint32_t type) {
  return isBehaviourWord(type) || oneOf(type, {GliderLexer::SENSORS, GliderLexer::SAMPLE,
                                               GliderLexer::ENTRY, GliderLexer::EVENTS});
}

inline bool isTransition(uint32_t type) {
  return oneOf(type, {GliderLexer::GOTO, GliderLexer::CALL, GliderLexer::RETURN, GliderLexer::EXIT,
                      GliderLexer::STAY});
}

inline bool endsValue(uint32_t type) {
  return isAnyName(type) ||
         oneOf(type, {GliderLexer::NUMBER, GliderLexer::INSTANT, GliderLexer::STRING,
                      GliderLexer::TRUE, GliderLexer::FALSE, GliderLexer::HEARD,
                      GliderLexer::RPAREN, GliderLexer::RBRACKET});
}

inline bool startsValue(uint32_t type) {
  return isName(type) || oneOf(type, {GliderLexer::NUMBER, GliderLexer::INSTANT, GliderLexer::HEARD,
                                      GliderLexer::STRING, GliderLexer::TRUE, GliderLexer::FALSE});
}

/// The same also for one with a sign or in parentheses.
inline bool startsAnyValue(uint32_t type) {
  return startsValue(type) ||
         oneOf(type, {GliderLexer::MINUS, GliderLexer::LPAREN, GliderLexer::MIN});
}

inline bool isOperator(uint32_t type) {
  return (type >= GliderLexer::OR && type <= GliderLexer::DIVIDE) || type == GliderLexer::NOT_WORD;
}

/// Whether a name must follow it.
inline bool wantsName(uint32_t type) {
  return isBehaviourWord(type) ||
         oneOf(type, {GliderLexer::MISSION, GliderLexer::PLATFORM, GliderLexer::CONST,
                      GliderLexer::PARAM, GliderLexer::VAR, GliderLexer::STATE, GliderLexer::GOTO,
                      GliderLexer::CALL, GliderLexer::SET});
}

}  // namespace glider::frontend
