// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/phrases/phrase.h"

/// The errors of several tokens, by what they are about.
namespace glider::frontend::phrases {

/// `% warm water`, `-- warm water`, and prose at the beginning of a line.
size_t comment(Phrase& phrase);
/// `b_arg: d_target_depth(m) 40`.
size_t lineOfMi(Phrase& phrase);
/// `CASE`, `Call`: a keyword with capitals.
size_t capitals(Phrase& phrase);
/// `if … then call up`, `when … call up`, `else stay`, a condition without `case`.
size_t caseWord(Phrase& phrase);
/// `entry log "warm" end`.
size_t entryWithoutDo(Phrase& phrase);
/// `always begin … end`.
size_t beginOfAlways(Phrase& phrase);
/// `call state up`, `go to up`.
size_t target(Phrase& phrase);
/// `exit mission`, `return look`, `call up exit`.
size_t afterTransition(Phrase& phrase);
/// `exit do log "over" end`.
size_t blockAfterTransition(Phrase& phrase);
/// `case statetime > 10 h end`.
size_t endForTransition(Phrase& phrase);
/// `declination = -12 deg`, `resume = 20 min`, `resume 20 min`.
size_t signOfItem(Phrase& phrase);
/// `place low battery = …`, `place low: …`.
size_t place(Phrase& phrase);
/// `import goto_l10.ma as list`.
size_t importWithoutQuotes(Phrase& phrase);
/// `every minute`.
size_t everyMinute(Phrase& phrase);
/// `-> call up`, `=> call up`.
size_t arrow(Phrase& phrase);
/// `case after 1 h`, `case always`.
size_t conditionWord(Phrase& phrase);
/// `temp is known`.
size_t knownWords(Phrase& phrase);
/// `case state == up`.
size_t stateAsCondition(Phrase& phrase);
/// `case if temp > 20 degC then exit end`.
size_t ifInCase(Phrase& phrase);
/// `ensure always depth <= 60 m`, `depth must be <= 60 m`.
size_t promiseWithoutRequire(Phrase& phrase);
/// `require exits within 5 h`, `require depth <= 55 m`, `require max depth 60 m`.
size_t promise(Phrase& phrase);
/// `require depth never > 40 m`.
size_t promiseInside(Phrase& phrase);
/// `require always depth <= 60 m and exit within 2 h`: two requirements.
size_t promiseAfterAnd(Phrase& phrase);
/// `require visit look home within 5 h`.
size_t placesWithoutComma(Phrase& phrase);
/// `require visit look in 5 h`, `require whenever low goto homeward`, `require whenever low then
/// homeward 1 min`.
size_t reaction(Phrase& phrase);
/// `require visit state look within 5 h`.
size_t stateWordInPromise(Phrase& phrase);
/// `pack 168 Ah, 14.4 V`, `pack 14.4 V 168 Ah`, `reserve = 20 %`.
size_t pack(Phrase& phrase);
/// `nap 4 min`, `sleep at most 4 min`, `nap up to 4 min`.
size_t nap(Phrase& phrase);
/// `choose bottom : length from 60 m to 180 m step 5 m`.
size_t choice(Phrase& phrase);
/// `prefer maximum bottom, endurance`, `maximise bottom`.
size_t preference(Phrase& phrase);
/// `sample ctd at 0.25 Hz and optode off`.
size_t sample(Phrase& phrase);
/// `require visit look and home within 5 h`.
size_t andOfPlaces(Phrase& phrase);
/// `assume no outages`, `assume current < 0.2 m/s`.
size_t assumption(Phrase& phrase);
/// `case a || if b`.
size_t ifInCondition(Phrase& phrase);
/// `routedone = true`.
size_t equalToTruth(Phrase& phrase);
/// `held depth < 1 m for 10 min`.
size_t heldWithoutParentheses(Phrase& phrase);
/// `case depth < 1 m for 10 min`, `held(depth < 1 m for 10 min)`.
size_t forATime(Phrase& phrase);
/// `depth > 30 m or 40 m`.
size_t valueForCondition(Phrase& phrase);
/// `temp at 1 Hz`, `temp every 2 Hz`.
size_t rateOfSensor(Phrase& phrase);
/// `sample depth, temp` for `sensors`.
size_t wordForSensors(Phrase& phrase);
/// `on entry do`.
size_t wordBeforeEntry(Phrase& phrase);
/// `exit do log "over" end` before the events of a state.
size_t blockOfLeaving(Phrase& phrase);
/// `flightroute goto(home)`, `flightroute to home`.
size_t routeToPlace(Phrase& phrase);
/// `deepest m`: a name with a unit.
size_t unitAfterName(Phrase& phrase);
/// `sensors lat and lon`.
size_t andOfSensors(Phrase& phrase);
/// `|a - b|` for `abs(a - b)`.
size_t absoluteBars(Phrase& phrase);
/// `log begin at", depth`.
size_t textWithoutOpeningQuote(Phrase& phrase);
/// `sensors temp each 20 s`.
size_t eachForEvery(Phrase& phrase);
/// `~warm`, `n ~= 3`.
size_t tilde(Phrase& phrase);
/// `100'`: feet.
size_t signOfFeet(Phrase& phrase);
/// `log "deep" depth`.
size_t valueAfterText(Phrase& phrase);
/// `yo(top: 5 m)`.
size_t colonOfArgument(Phrase& phrase);
/// `visit a at most twice`, `at least 3`.
size_t timesLeftOut(Phrase& phrase);
/// `in look: always depth < 60 m`.
size_t alwaysAfterScope(Phrase& phrase);
/// `surfaces every 4 h or exit`: what ends is not asked any more.
size_t orExitOfSurfaces(Phrase& phrase);
/// `const home = 39 10.5 N, 73 46.8 W`.
size_t commaInPosition(Phrase& phrase);
/// `log("deep", depth)`.
size_t textInParentheses(Phrase& phrase);
/// `depth^2`.
size_t power(Phrase& phrase);
/// `mean(temp over 5 min)`.
size_t wordOfWindow(Phrase& phrase);
/// `sensors every 60 s battery`.
size_t everyBeforeSensor(Phrase& phrase);
/// `10 % of peak`.
size_t percentOf(Phrase& phrase);
/// `peak minus 10 m`, `temp at 20 m`.
size_t arithmeticWords(Phrase& phrase);
/// `IF(depth > 10 m; 3; 4)`, `temp > if … then … else …`.
size_t conditionalValue(Phrase& phrase);
/// `depth > 10 m ? 3 : 4`.
size_t questionMark(Phrase& phrase);
/// `two days`.
size_t numberWord(Phrase& phrase);
/// `sensors depth (m)`.
size_t unitAfterSensor(Phrase& phrase);
/// `case at the surface`.
size_t atTheSurface(Phrase& phrase);
/// `is above`, `drops below`, `exceeds`, `at least`.
size_t comparison(Phrase& phrase);
/// `depth between 5 m and 10 m`, `depth in 5 m .. 10 m`.
size_t between(Phrase& phrase);
/// `depth > 5 m && < 10 m`.
size_t sameLeft(Phrase& phrase);
/// `not (…)`, `NOT known(…)`.
size_t notWord(Phrase& phrase);
/// `:=`, `set n to 1`, `>>`.
size_t foreignSign(Phrase& phrase);
/// `case depth > 5 m, temp > 3 degC call up`.
size_t commaAsAnd(Phrase& phrase);
/// `log "a", depth, "b"`.
size_t secondText(Phrase& phrase);
/// `log "d " + depth`.
size_t plusOfTexts(Phrase& phrase);
/// `20 deg C`, `20 °C`.
size_t degreesCelsius(Phrase& phrase);
/// `highest(temp, last leg)`: the leg of a window.
size_t leg(Phrase& phrase);
/// `here.lat`: no value has parts.
size_t part(Phrase& phrase);
/// `90 deg magnetic`.
size_t magneticHeading(Phrase& phrase);
/// `20 cm per s`.
size_t perUnit(Phrase& phrase);
/// `2 ml/l` of oxygen: the millilitre is a unit of the language.
size_t millilitresPerLitre(Phrase& phrase);
/// `3 days`, `2 ug/L`: units that are names elsewhere.
size_t softUnit(Phrase& phrase);
/// `0.5 in)`: `in` is not a unit.
size_t rangeWordAsUnit(Phrase& phrase);
/// `200 ml/L`, `5 hPa`: units of other systems.
size_t foreignUnit(Phrase& phrase);
/// `2027-01-01 00:00`.
size_t instant(Phrase& phrase);
/// `18:00`, `6 pm`, `18:00 EST`.
size_t clockTime(Phrase& phrase);
/// `yo_number % 3`.
size_t remainderSign(Phrase& phrase);
/// `1h30`, `3 h 30 min`.
size_t timeInParts(Phrase& phrase);
/// `(39.175, -73.83)`, `39.175 N, 73.83 W`.
size_t pairOfNumbers(Phrase& phrase);
/// `= 39.175 N 73.83 W, 39.2 N 73.8 W`, `(39.175 N 73.83 W, 39.2 N 73.8 W)`: a path without
/// brackets.
size_t pathWithoutBrackets(Phrase& phrase);
/// `set p = lat lon`.
size_t latitudeWithLongitude(Phrase& phrase);
/// `39°10.5'N 73°49.8'W`, `N 39 10.5`, `39.175 North`: positions of charts and other tools.
size_t writtenPosition(Phrase& phrase);
/// `heading(E)`, `heading(south-east)`.
size_t compassPoint(Phrase& phrase);
/// `set n += 1`, `n++`, `print "warm"`, `wait 10 min`.
size_t statement(Phrase& phrase);
/// `for i = 1 to 8`, `while depth < 5 m do`.
size_t loop(Phrase& phrase);
/// `case … set n = 1 call up`.
size_t actionWithoutDo(Phrase& phrase);
/// `var n = 0`, `length d = 5 m`.
size_t untyped(Phrase& phrase);
/// `in 3 m to 8 m`.
size_t range(Phrase& phrase);
/// `in [3 m, 8 m]`.
size_t rangeInBrackets(Phrase& phrase);
/// `const depths[3] = [20 m, 30 m, 40 m]`.
size_t sizeOfConstant(Phrase& phrase);
/// `declination 12 deg W`.
size_t declinationWithLetter(Phrase& phrase);
/// `yo 5 m, 20 m`, `yo[5 m, 20 m]`.
size_t withoutParentheses(Phrase& phrase);

}  // namespace glider::frontend::phrases
