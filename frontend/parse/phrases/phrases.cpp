// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/phrases.h"

#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"

namespace glider::frontend {
namespace {

/// A kind of error, with the tokens that it may begin with. The repair looks at its first token
/// itself: this saves the call for all others.
struct Row {
  PhraseRepair repair;
  bool (*begins)(uint32_t type);
};

bool anyToken(uint32_t) {
  return true;
}

bool plainName(uint32_t type) {
  return type == GliderLexer::NAME;
}

/// `is above`, `not between`.
bool nameOrNot(uint32_t type) {
  return isAnyName(type) || type == GliderLexer::NOT_WORD;
}

/// `harbour`, `(39.2, 72.1)`, `39.2 N 72.1 W`.
bool beginsPlace(uint32_t type) {
  return isName(type) || oneOf(type, {GliderLexer::LPAREN, GliderLexer::NUMBER});
}

template <uint32_t... Types>
bool among(uint32_t type) {
  return ((type == Types) || ...);
}

/// In this order: what is prose is not read as anything else, and a keyword is a keyword before it
/// is anything else.
constexpr Row kRows[] = {
    {phrases::textWithoutOpeningQuote, anyToken},
    {phrases::choice, among<GliderLexer::CHOOSE, GliderLexer::NAME>},
    {phrases::preference, among<GliderLexer::PREFER, GliderLexer::NAME>},
    {phrases::pack, among<GliderLexer::PACK, GliderLexer::NAME>},
    {phrases::nap, among<GliderLexer::NAP, GliderLexer::NAME>},
    {phrases::sample,
     [](uint32_t type) {
       return isAnyName(type) || (type >= GliderLexer::AND && type <= GliderLexer::SEMICOLON) ||
              oneOf(type,
                    {GliderLexer::EVERY, GliderLexer::IF, GliderLexer::ALWAYS, GliderLexer::NUMBER,
                     GliderLexer::AND_WORD, GliderLexer::NOT_WORD, GliderLexer::FOREIGN});
     }},
    {phrases::declinationWithLetter, among<GliderLexer::NUMBER>},
    {phrases::writtenPosition, among<GliderLexer::NUMBER, GliderLexer::COMPASS, GliderLexer::NAME>},
    {phrases::promiseWithoutRequire, isName},
    {phrases::comment, among<GliderLexer::MINUS, GliderLexer::UNIT, GliderLexer::SEMICOLON,
                             GliderLexer::NOT, GliderLexer::NAME>},
    {phrases::lineOfMi, among<GliderLexer::NAME, GliderLexer::SENSOR>},
    {phrases::caseWord, anyToken},
    {phrases::ifInCase, anyToken},
    {phrases::stateAsCondition, among<GliderLexer::STATE>},
    {phrases::promise, anyToken},
    {phrases::promiseInside, isName},
    {phrases::timesLeftOut, among<GliderLexer::MOST, GliderLexer::LEAST>},
    {phrases::alwaysAfterScope, among<GliderLexer::ALWAYS>},
    {phrases::orExitOfSurfaces, among<GliderLexer::OR_WORD>},
    {phrases::reaction,
     [](uint32_t type) {
       return isName(type) ||
              oneOf(type, {GliderLexer::GOTO, GliderLexer::CALL, GliderLexer::NUMBER,
                           GliderLexer::COMMA, GliderLexer::STAY, GliderLexer::EXIT});
     }},
    {phrases::stateWordInPromise, among<GliderLexer::STATE>},
    {phrases::placesWithoutComma,
     among<GliderLexer::NAME, GliderLexer::UNIT, GliderLexer::COMPASS, GliderLexer::MIN>},
    {phrases::promiseAfterAnd,
     among<GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND>},
    {phrases::andOfPlaces,
     among<GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND>},
    {phrases::assumption, isName},
    {phrases::wordBeforeEntry, isName},
    {phrases::blockOfLeaving, among<GliderLexer::EXIT>},
    {phrases::routeToPlace,
     [](uint32_t type) { return isName(type) || type == GliderLexer::GOTO; }},
    {phrases::rateOfSensor, among<GliderLexer::AT, GliderLexer::EVERY>},
    {phrases::wordForSensors, plainName},
    {phrases::unitAfterName, among<GliderLexer::UNIT>},
    {phrases::valueForCondition,
     among<GliderLexer::OR, GliderLexer::OR_WORD, GliderLexer::AND, GliderLexer::AND_WORD>},
    {phrases::absoluteBars, among<GliderLexer::ONE_BAR>},
    {phrases::andOfSensors,
     among<GliderLexer::AND_WORD, GliderLexer::AND, GliderLexer::ONE_AMPERSAND, GliderLexer::PLUS>},
    {phrases::entryWithoutDo, anyToken},
    {phrases::beginOfAlways, among<GliderLexer::BEGIN>},
    {phrases::conditionalValue, among<GliderLexer::IF, GliderLexer::NAME>},
    {phrases::ifInCondition, among<GliderLexer::IF>},
    {phrases::forATime, among<GliderLexer::FOR>},
    {phrases::loop, among<GliderLexer::FOR, GliderLexer::SET, GliderLexer::NAME>},
    {phrases::blockAfterTransition, among<GliderLexer::DO>},
    {phrases::endForTransition, among<GliderLexer::END>},
    {phrases::afterTransition, anyToken},
    {phrases::place, among<GliderLexer::PLACE>},
    {phrases::signOfItem, among<GliderLexer::DECLINATION, GliderLexer::RESUME>},
    {phrases::importWithoutQuotes, anyToken},
    {phrases::everyMinute, plainName},
    {phrases::target, among<GliderLexer::STATE, GliderLexer::NAME, GliderLexer::GOTO,
                            GliderLexer::CALL, GliderLexer::LPAREN>},
    {phrases::textInParentheses, among<GliderLexer::LPAREN>},
    {phrases::power, among<GliderLexer::FOREIGN>},
    {phrases::capitals, plainName},
    {phrases::arrow, among<GliderLexer::MINUS, GliderLexer::WRONG_COMPARISON, GliderLexer::FOREIGN,
                           GliderLexer::NOT>},
    {phrases::conditionWord, among<GliderLexer::ALWAYS, GliderLexer::AFTER, GliderLexer::EVERY>},
    {phrases::knownWords, [](uint32_t type) { return isName(type) || type == GliderLexer::HEARD; }},
    {phrases::equalToTruth, among<GliderLexer::ASSIGN, GliderLexer::WRONG_COMPARISON,
                                  GliderLexer::NAME, GliderLexer::EQ, GliderLexer::NE>},
    {phrases::eachForEvery, among<GliderLexer::NAME>},
    {phrases::tilde, among<GliderLexer::FOREIGN>},
    {phrases::signOfFeet, among<GliderLexer::FOREIGN>},
    {phrases::wordOfWindow, [](uint32_t type) { return isName(type) || type == GliderLexer::FOR; }},
    {phrases::everyBeforeSensor, among<GliderLexer::EVERY>},
    {phrases::unitAfterSensor, among<GliderLexer::LPAREN>},
    {phrases::atTheSurface, among<GliderLexer::AT>},
    {phrases::percentOf, among<GliderLexer::OF>},
    {phrases::questionMark, among<GliderLexer::FOREIGN>},
    {phrases::arithmeticWords, isAnyName},
    {phrases::numberWord, plainName},
    {phrases::comparison, nameOrNot},
    {phrases::between, nameOrNot},
    {phrases::sameLeft, among<GliderLexer::LT, GliderLexer::GT, GliderLexer::LE, GliderLexer::GE>},
    {phrases::notWord, among<GliderLexer::NAME, GliderLexer::NOT_WORD>},
    {phrases::foreignSign,
     among<GliderLexer::COLON, GliderLexer::GT, GliderLexer::LT, GliderLexer::TO>},
    {phrases::colonOfArgument, among<GliderLexer::COLON>},
    {phrases::degreesCelsius, among<GliderLexer::FOREIGN, GliderLexer::UNIT, GliderLexer::NAME>},
    {phrases::instant, among<GliderLexer::NUMBER>},
    {phrases::clockTime, among<GliderLexer::NUMBER>},
    {phrases::timeInParts, among<GliderLexer::NUMBER>},
    {phrases::remainderSign, among<GliderLexer::UNIT>},
    {phrases::latitudeWithLongitude, plainName},
    {phrases::leg, plainName},
    {phrases::part, isAnyName},
    {phrases::magneticHeading, among<GliderLexer::UNIT, GliderLexer::NAME>},
    {phrases::perUnit, plainName},
    {phrases::millilitresPerLitre, plainName},
    {phrases::softUnit, plainName},
    {phrases::rangeWordAsUnit, among<GliderLexer::IN>},
    {phrases::foreignUnit, among<GliderLexer::NAME, GliderLexer::FOREIGN, GliderLexer::UNIT>},
    {phrases::rangeInBrackets, among<GliderLexer::LBRACKET, GliderLexer::LPAREN>},
    {phrases::sizeOfConstant, among<GliderLexer::LBRACKET>},
    {phrases::pairOfNumbers,
     among<GliderLexer::LPAREN, GliderLexer::LBRACKET, GliderLexer::NUMBER, GliderLexer::MINUS>},
    {phrases::pathWithoutBrackets, beginsPlace},
    {phrases::compassPoint, among<GliderLexer::COMPASS, GliderLexer::NAME>},
    {phrases::statement, [](uint32_t type) { return isName(type) || type == GliderLexer::SET; }},
    {phrases::valueAfterText, among<GliderLexer::NAME, GliderLexer::NUMBER, GliderLexer::HEARD>},
    {phrases::heldWithoutParentheses, plainName},
    {phrases::actionWithoutDo, among<GliderLexer::SET, GliderLexer::LOG>},
    {phrases::untyped,
     [](uint32_t
            type) { return isName(type) || oneOf(type, {GliderLexer::VAR, GliderLexer::PARAM}); }},
    {phrases::range, among<GliderLexer::NUMBER>},
    {phrases::withoutParentheses,
     among<GliderLexer::LBRACKET, GliderLexer::NUMBER, GliderLexer::MINUS, GliderLexer::NAME>},
    {phrases::commaInPosition, among<GliderLexer::COMMA>},
    {phrases::secondText, among<GliderLexer::COMMA>},
    {phrases::commaAsAnd, among<GliderLexer::COMMA>},
    {phrases::plusOfTexts, among<GliderLexer::PLUS>}};

/// The repairs of each type of token.
using Repairs = std::vector<std::vector<PhraseRepair>>;

const Repairs& repairsByType() {
  static const Repairs all = [] {
    Repairs repairs(GliderLexer::FOREIGN + 1);
    for (uint32_t type = 0; type < repairs.size(); ++type) {
      for (const Row& row : kRows) {
        if (row.begins(type)) {
          repairs[type].push_back(row.repair);
        }
      }
    }
    return repairs;
  }();
  return all;
}

/// The number of tokens that a phrase at the current one took, or 0.
size_t repairOne(Phrase& phrase, const Repairs& repairs) {
  for (const PhraseRepair repair : repairs.at(phrase.type())) {
    if (const size_t taken = repair(phrase)) {
      return taken;
    }
  }
  return 0;
}

}  // namespace

Rephrased repairPhrases(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter) {
  const Repairs& repairs = repairsByType();
  Phrase phrase(lexemes, reporter);
  bool reading = true;  // after a comment without an end, nothing is text
  while (!phrase.atEnd()) {
    reading = reading && phrase.type() != GliderLexer::OPEN_COMMENT && !reporter.full();
    if (phrase.skip()) {
      continue;
    }
    const size_t taken = reading && phrase.type() != kEof ? repairOne(phrase, repairs) : 0;
    if (taken == 0) {
      phrase.put(phrase.token());
    }
    phrase.advance(taken == 0 ? 1 : taken);
  }
  const bool as_meant = phrase.asMeant();
  return {phrase.take(), as_meant};
}

}  // namespace glider::frontend
