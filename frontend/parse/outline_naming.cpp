// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/outline_naming.h"

#include "frontend/parse/token_kinds.h"

namespace glider::frontend {
namespace {

/// Whether a soft keyword after `before` is a name.
bool mayBeName(uint32_t before) {
  return isOperator(before) ||
         oneOf(before,
               {GliderLexer::LPAREN, GliderLexer::LBRACKET, GliderLexer::COMMA, GliderLexer::ASSIGN,
                GliderLexer::CASE, GliderLexer::IF, GliderLexer::SET, GliderLexer::EVERY,
                GliderLexer::RANGE, GliderLexer::ALWAYS, GliderLexer::SENSORS});
}

}  // namespace

std::optional<Naming> namingAfter(uint32_t keyword, uint32_t before) {
  if (oneOf(keyword, {GliderLexer::GOTO, GliderLexer::CALL})) {
    return Naming::State;
  }
  if (oneOf(keyword, {GliderLexer::REACH, GliderLexer::NEVER})) {
    return before == GliderLexer::REQUIRE ? std::optional(Naming::State) : std::nullopt;
  }
  if (isBehaviourWord(keyword)) {
    return Naming::Behaviour;
  }
  if (keyword == GliderLexer::PLATFORM) {
    return Naming::Platform;
  }
  const bool of_sensors = oneOf(keyword, {GliderLexer::OF, GliderLexer::READS});
  return of_sensors && endsValue(before) ? std::optional(Naming::Value) : std::nullopt;
}

std::optional<Naming> valueNaming(uint32_t before, uint32_t t, uint32_t next) {
  const bool arguments = next == GliderLexer::LPAREN;
  if (t == GliderLexer::MIN) {
    return arguments && before != GliderLexer::NUMBER ? std::optional(Naming::Function)
                                                      : std::nullopt;
  }
  const bool after_value = endsValue(before);
  if (!isName(t) || (isSoftKeyword(t) && (after_value || !mayBeName(before)))) {
    return std::nullopt;
  }
  // Two values are never next to each other, so a name after a value begins a statement.
  const bool begins = after_value || oneOf(before, {GliderLexer::DO, GliderLexer::THEN,
                                                    GliderLexer::ELSE, GliderLexer::END});
  return !arguments ? Naming::Value : begins ? Naming::Command : Naming::Function;
}

}  // namespace glider::frontend
