// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/unit_names.h"

#include "frontend/parse/token_kinds.h"

#include <set>
#include <string_view>

namespace glider::frontend {
namespace {

bool isUnitWord(uint32_t type) {
  return oneOf(type, {GliderLexer::UNIT, GliderLexer::COMPASS, GliderLexer::MIN});
}

/// Whether token `at` is a name that is declared there, of anything but a mission.
bool isDeclared(const std::vector<Lexeme>& lexemes, size_t at) {
  const uint32_t before = lexemes[at - 1].type;
  const uint32_t after = lexemes[at + 1].type;
  const bool value = oneOf(before, {GliderLexer::CONST, GliderLexer::PARAM, GliderLexer::VAR,
                                    GliderLexer::PLACE, GliderLexer::SHARE, GliderLexer::CHOOSE}) &&
                     oneOf(after, {GliderLexer::COLON, GliderLexer::ASSIGN, GliderLexer::LBRACKET,
                                   GliderLexer::EVERY});
  const bool formal =
      oneOf(before, {GliderLexer::LPAREN, GliderLexer::COMMA}) && after == GliderLexer::COLON;
  const bool behaviour = isBehaviourWord(before);
  const bool external = oneOf(before, {GliderLexer::FUNCTION, GliderLexer::SENSOR}) &&
                        oneOf(after, {GliderLexer::COLON, GliderLexer::LPAREN}) && at > 1 &&
                        lexemes[at - 2].type == GliderLexer::EXTERN;
  return value || formal || behaviour || external || before == GliderLexer::STATE ||
         (before == GliderLexer::FOR && after == GliderLexer::IN);
}

/// Whether token `at` is the unit of a number: `5 m`, the `s` of `5 m/s`.
bool isOfNumber(const std::vector<Lexeme>& lexemes, size_t at) {
  while (at > 1 && oneOf(lexemes[at - 1].type, {GliderLexer::TIMES, GliderLexer::DIVIDE}) &&
         isUnitWord(lexemes[at - 2].type)) {
    at -= 2;
  }
  return at > 0 && lexemes[at - 1].type == GliderLexer::NUMBER;
}

}  // namespace

std::vector<Lexeme> nameDeclaredUnits(std::vector<Lexeme> lexemes, const Source& source) {
  std::set<std::string_view> declared;
  for (size_t at = 1; at + 1 < lexemes.size(); ++at) {
    if (isUnitWord(lexemes[at].type) && isDeclared(lexemes, at)) {
      declared.insert(source.text(lexemes[at]));
    }
  }
  if (declared.empty()) {
    return lexemes;
  }
  for (size_t at = 1; at + 1 < lexemes.size(); ++at) {
    const bool function =
        lexemes[at].type == GliderLexer::MIN && lexemes[at + 1].type == GliderLexer::LPAREN;
    if (isUnitWord(lexemes[at].type) && declared.contains(source.text(lexemes[at])) &&
        !isOfNumber(lexemes, at) && !function) {
      lexemes[at].type = GliderLexer::NAME;
    }
  }
  return lexemes;
}

}  // namespace glider::frontend
