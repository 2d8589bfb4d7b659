// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/phrases.h"

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"

namespace glider::frontend {
namespace {

/// In this order: what is prose is not read as anything else, and a keyword is a keyword before it
/// is anything else.
constexpr PhraseRepair kRepairs[] = {phrases::comment,
                                     phrases::caseWord,
                                     phrases::loop,
                                     phrases::afterTransition,
                                     phrases::target,
                                     phrases::capitals,
                                     phrases::arrow,
                                     phrases::conditionWord,
                                     phrases::comparison,
                                     phrases::between,
                                     phrases::sameLeft,
                                     phrases::notWord,
                                     phrases::foreignSign,
                                     phrases::degreesCelsius,
                                     phrases::timeInParts,
                                     phrases::leg,
                                     phrases::part,
                                     phrases::magneticHeading,
                                     phrases::softUnit,
                                     phrases::rangeWordAsUnit,
                                     phrases::foreignUnit,
                                     phrases::letterBefore,
                                     phrases::pairOfNumbers,
                                     phrases::compassPoint,
                                     phrases::statement,
                                     phrases::actionWithoutDo,
                                     phrases::untyped,
                                     phrases::range,
                                     phrases::withoutParentheses,
                                     phrases::commaAsAnd,
                                     phrases::plusOfTexts};

/// The number of tokens that a phrase at the current one took, or 0.
size_t repairOne(Phrase& phrase) {
  for (const PhraseRepair repair : kRepairs) {
    if (const size_t taken = repair(phrase)) {
      return taken;
    }
  }
  return 0;
}

}  // namespace

Rephrased repairPhrases(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter) {
  Phrase phrase(lexemes, reporter);
  bool reading = true;  // after a comment without an end, nothing is text
  while (!phrase.atEnd()) {
    reading = reading && phrase.type() != GliderLexer::OPEN_COMMENT && !reporter.full();
    if (phrase.skip()) {
      continue;
    }
    const size_t taken = reading && phrase.type() != kEof ? repairOne(phrase) : 0;
    if (taken == 0) {
      phrase.put(phrase.token());
    }
    phrase.advance(taken == 0 ? 1 : taken);
  }
  const bool as_meant = phrase.asMeant();
  return {phrase.take(), as_meant};
}

}  // namespace glider::frontend
