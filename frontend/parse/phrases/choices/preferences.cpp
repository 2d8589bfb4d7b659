// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/phrases/choices/clauses.h"
#include "frontend/parse/phrases/repairs.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace glider::frontend::phrases {
namespace {

/// A part of the line: `greatest bottom`, `endurance`.
struct Goal {
  size_t then = 0;   ///< the first token of what is between it and the one before
  size_t first = 0;  ///< its own first token
  size_t value = 0;  ///< past the word that says what is preferred of the value
  size_t end = 0;
  uint32_t aim = 0;  ///< `least`, `greatest` or `endurance`; 0: it does not say
};

template <size_t N>
bool saysOneOf(const Phrase& phrase, size_t k, const std::array<std::string_view, N>& words) {
  return std::ranges::any_of(words, [&](auto word) { return phrase.says(k, word); });
}

/// `greatst`; 0: it is a name, or another word.
uint32_t misspelledAim(Phrase& phrase, size_t k) {
  if (phrase.type(k) != GliderLexer::NAME || phrase.isDeclared(phrase.text(k))) {
    return 0;
  }
  const std::string_view near = closest(phrase.text(k), {"greatest", "least"});
  return near.empty() ? 0 : near == "least" ? GliderLexer::LEAST : GliderLexer::GREATEST;
}

/// What pilots write for `greatest` and `least` before a value; 0: it is none of these.
uint32_t aimAt(Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 29> kGreatest = {
      "greatest", "maximum",  "max",      "maximal",    "most",       "highest",
      "longest",  "deepest",  "biggest",  "largest",    "farthest",   "furthest",
      "greater",  "more",     "higher",   "longer",     "deeper",     "bigger",
      "larger",   "maximise", "maximize", "maximising", "maximizing", "high",
      "long",     "deep",     "large",    "latest",     "fastest"};
  constexpr std::array<std::string_view, 24> kLeast = {
      "least",    "minimum",    "min",      "minimal",  "fewest",     "lowest",
      "shortest", "smallest",   "less",     "lower",    "shorter",    "smaller",
      "fewer",    "shallowest", "minimise", "minimize", "minimising", "minimizing",
      "low",      "short",      "small",    "earliest", "slowest",    "shallower"};
  if (oneOf(phrase.type(k), {GliderLexer::LEAST, GliderLexer::GREATEST})) {
    return phrase.type(k);
  }
  return saysOneOf(phrase, k, kGreatest) ? uint32_t{GliderLexer::GREATEST}
         : saysOneOf(phrase, k, kLeast)  ? uint32_t{GliderLexer::LEAST}
                                         : misspelledAim(phrase, k);
}

/// `endurance`, also misspelled.
bool isEndurance(Phrase& phrase, size_t k) {
  return phrase.type(k) == GliderLexer::ENDURANCE ||
         (phrase.type(k) == GliderLexer::NAME && !phrase.isDeclared(phrase.text(k)) &&
          !closest(phrase.text(k), {"endurance"}).empty());
}

/// Whether what is used of the batteries is named, of which `endurance` prefers the least.
bool isEnergy(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 8> kWords = {
      "energyused", "energy", "power", "battery", "charge", "consumption", "batteries", "current"};
  return saysOneOf(phrase, k, kWords);
}

/// `maximise`: 1; `minimise`: 2; `optimise`: 3, of which either may be meant; 0: something else.
/// The word stands for `prefer` and for the aim.
uint32_t verbAt(const Phrase& phrase) {
  constexpr std::array<std::string_view, 4> kMost = {"maximise", "maximize", "maximising",
                                                     "maximizing"};
  constexpr std::array<std::string_view, 4> kLeast = {"minimise", "minimize", "minimising",
                                                      "minimizing"};
  constexpr std::array<std::string_view, 4> kBest = {"optimise", "optimize", "optimising",
                                                     "optimizing"};
  return saysOneOf(phrase, 0, kMost)    ? 1
         : saysOneOf(phrase, 0, kLeast) ? 2
         : saysOneOf(phrase, 0, kBest)  ? 3
                                        : 0;
}

/// `prefers`, `objective`: what pilots write for `prefer`.
bool isOtherPrefer(const Phrase& phrase) {
  constexpr std::array<std::string_view, 11> kWords = {
      "prefers", "preferring", "preferred", "preference", "preferences", "preferably",
      "prefere", "prefer",     "objective", "objectives", "goal"};
  return phrase.type() == GliderLexer::NAME && saysOneOf(phrase, 0, kWords);
}

/// The tokens of what separates two goals: `then`, `,`, `and then`, `over`; 0: nothing does.
size_t tokensOfThen(const Phrase& phrase, size_t k) {
  constexpr std::array<std::string_view, 9> kWords = {"and then",    "and if equal", "followed by",
                                                      "rather than", "and",          "then",
                                                      "over",        "before",       "or"};
  if (oneOf(phrase.type(k), {GliderLexer::COMMA, GliderLexer::SEMICOLON})) {
    const size_t more = oneOf(phrase.type(k + 1), {GliderLexer::THEN, GliderLexer::AND_WORD});
    return phrase.startsLine(k) ? 0 : 1 + more;
  }
  for (const std::string_view word : kWords) {
    const size_t tokens = tokensOfWords(phrase, k, word);
    if (tokens > 0 && (phrase.type(k) == GliderLexer::THEN || !phrase.startsLine(k))) {
      return tokens;
    }
  }
  if (const size_t arrow = tokensOfArrow(phrase, k)) {
    return arrow;
  }
  const bool above = phrase.type(k) == GliderLexer::GT && isName(phrase.type(k + 1));
  return above || oneOf(phrase.type(k), {GliderLexer::AND, GliderLexer::ONE_AMPERSAND}) ? 1 : 0;
}

/// Past the value of a goal: up to what separates it from the next.
size_t endOfGoal(const Phrase& phrase, size_t first) {
  const size_t end = endOfValue(phrase, first, false);
  size_t deep = 0;
  for (size_t k = first; k < end; ++k) {
    const uint32_t type = phrase.type(k);
    deep += type == GliderLexer::LPAREN ? 1U : 0U;
    deep -= type == GliderLexer::RPAREN ? 1U : 0U;
    const bool joins = isOperator(type) || !isAnyName(type);
    if (deep == 0 && k > first && joins && tokensOfThen(phrase, k) != 0) {
      return k;
    }
  }
  return end;
}

/// A line `prefer`, or one with another word for it.
class PreferenceLine {
 public:
  explicit PreferenceLine(Phrase& phrase) : phrase_(phrase) {}

  /// The tokens of the line; 0: nothing in it is wrong, or it is none.
  size_t repair();

 private:
  [[nodiscard]] bool isEmpty() const;
  bool readGoals(size_t k);
  [[nodiscard]] Goal goalAt(size_t k) const;
  [[nodiscard]] bool isFunction(size_t k) const;
  void reportVerb();
  void reportSign();
  void reportGoal(const Goal& goal);
  void reportAim(const Goal& goal);
  void reportThen(const Goal& before, const Goal& goal);
  void reportLastThen();
  void reportRest();
  void put();

  [[nodiscard]] std::string text(const Goal& goal) const;
  [[nodiscard]] std::string valueText(const Goal& goal) const;
  /// Whether a goal names the batteries, or says `greatest endurance`.
  [[nodiscard]] bool meansEndurance(const Goal& goal) const;
  [[nodiscard]] bool endsLine(size_t k) const {
    const uint32_t type = phrase_.type(k);
    return phrase_.startsLine(k) || type == kEof || isHardKeyword(type);
  }

  Phrase& phrase_;
  std::vector<Goal> goals_;
  uint32_t verb_ = 0;
  size_t first_ = 1;  ///< past `prefer`, and a sign after it
  size_t end_ = 0;    ///< past what is read of the line
};

/// `max(a, b)` is a function, `max(a)` a pilot's way to say what is preferred.
bool PreferenceLine::isFunction(size_t k) const {
  if (phrase_.type(k + 1) != GliderLexer::LPAREN) {
    return false;
  }
  size_t deep = 0;
  for (size_t i = k + 1; phrase_.type(i) != kEof && !isHardKeyword(phrase_.type(i)); ++i) {
    deep += phrase_.type(i) == GliderLexer::LPAREN ? 1U : 0U;
    deep -= phrase_.type(i) == GliderLexer::RPAREN ? 1U : 0U;
    if (deep == 0) {
      return false;
    }
    if (deep == 1 && phrase_.type(i) == GliderLexer::COMMA) {
      return true;
    }
  }
  return false;
}

Goal PreferenceLine::goalAt(size_t k) const {
  Goal goal{k, k, k, k, 0};
  constexpr std::array<std::string_view, 11> kEmpty = {
      "the", "a", "an", "for", "of", "to", "best", "first", "mainly", "mostly", "always"};
  const auto skipEmpty = [&] {
    while (saysOneOf(phrase_, goal.value, kEmpty) && !endsLine(goal.value + 1) &&
           isAnyName(phrase_.type(goal.value + 1)) &&
           !phrase_.isDeclared(phrase_.text(goal.value))) {
      ++goal.value;
    }
  };
  skipEmpty();
  const bool value = isAnyName(phrase_.type(goal.value + 1)) ||
                     oneOf(phrase_.type(goal.value + 1),
                           {GliderLexer::LPAREN, GliderLexer::NUMBER, GliderLexer::MINUS});
  const bool right = oneOf(phrase_.type(goal.value), {GliderLexer::LEAST, GliderLexer::GREATEST});
  const bool leads = right || (value && !endsLine(goal.value + 1) && !isFunction(goal.value) &&
                               tokensOfThen(phrase_, goal.value + 1) == 0);
  if (const uint32_t aim = leads ? aimAt(phrase_, goal.value) : 0; aim != 0) {
    goal.aim = aim;
    ++goal.value;
    skipEmpty();
  }
  if (goal.aim == 0 && isEndurance(phrase_, goal.value)) {
    goal.aim = GliderLexer::ENDURANCE;
    goal.end = goal.value + 1;
    return goal;
  }
  goal.end = endOfGoal(phrase_, goal.value);
  while (meansEndurance(goal) && phrase_.type(goal.end) == GliderLexer::NAME &&
         !endsLine(goal.end) && tokensOfThen(phrase_, goal.end) == 0) {
    ++goal.end;  // `least power consumption`
  }
  return goal;
}

/// Reads the goals from token `k` on; false: they are none.
bool PreferenceLine::readGoals(size_t k) {
  for (size_t then = k;;) {
    if (endsLine(k) && phrase_.type(k) != GliderLexer::NOT && k == first_) {
      return false;
    }
    Goal goal = goalAt(k);
    goal.then = then;
    if (goal.end == goal.value && goal.aim != GliderLexer::ENDURANCE) {
      end_ = then;
      return !goals_.empty();
    }
    goals_.push_back(goal);
    end_ = goal.end;
    const size_t tokens = tokensOfThen(phrase_, end_);
    const bool next =
        tokens == 0 && !endsLine(end_) && (aimAt(phrase_, end_) != 0 || isEndurance(phrase_, end_));
    if (tokens == 0 && !next) {
      return true;
    }
    then = end_;
    k = end_ + tokens;
  }
}

std::string PreferenceLine::valueText(const Goal& goal) const {
  constexpr size_t kNameInParentheses = 3;
  const size_t tokens = goal.end - goal.value;
  const bool around =
      tokens == kNameInParentheses && phrase_.type(goal.value) == GliderLexer::LPAREN;
  return std::string(phrase_.wholeText(goal.value + (around ? 1 : 0), around ? 1 : tokens));
}

/// A goal as it is written.
std::string PreferenceLine::text(const Goal& goal) const {
  return goal.aim == GliderLexer::ENDURANCE || meansEndurance(goal)
             ? "endurance"
             : fmt::format("{} {}", goal.aim == GliderLexer::LEAST ? "least" : "greatest",
                           valueText(goal));
}

bool PreferenceLine::meansEndurance(const Goal& goal) const {
  const bool energy =
      isEnergy(phrase_, goal.value) && !phrase_.isDeclared(phrase_.text(goal.value));
  return energy || isEndurance(phrase_, goal.value);
}

/// `maximise bottom`, `optimise for endurance`, `prefers greatest bottom`.
void PreferenceLine::reportVerb() {
  const Lexeme word = phrase_.token();
  auto report = phrase_.reporter().at(word, support::diagnostics::misspelledKeyword, phrase_.text(),
                                      "prefer");
  if (verb_ == 0) {
    report.fix(phrase_.source().range(phrase_.whole(0, first_)), "prefer");
    return;
  }
  Goal& goal = goals_.front();
  const bool either = verb_ == 3 && goal.aim == 0 && !meansEndurance(goal);
  goal.aim = goal.aim != 0 ? goal.aim
             : verb_ == 2  ? uint32_t{GliderLexer::LEAST}
                           : uint32_t{GliderLexer::GREATEST};
  if (either) {
    report.hint(fmt::format("write `prefer greatest {0}` or `prefer least {0}`", valueText(goal)));
    return;
  }
  const std::string better = "prefer " + text(goal);
  report.hint(fmt::format("write `{}`", better));
  const bool opposite = verb_ == 1 && isEnergy(phrase_, goal.value);  // `maximise energy`
  if (!opposite && (meansEndurance(goal) || phrase_.isDeclared(phrase_.text(goal.value)))) {
    report.fix({phrase_.source().file, word.begin, phrase_.token(goal.end - 1).end}, better);
  }
  goal.aim = meansEndurance(goal) ? uint32_t{GliderLexer::ENDURANCE} : goal.aim;
}

/// `prefer: greatest bottom`.
void PreferenceLine::reportSign() {
  if (first_ > 1 && phrase_.type() == GliderLexer::PREFER) {
    const Lexeme sign = phrase_.token(1);
    phrase_.reporter()
        .at(sign, support::diagnostics::superfluousWord, phrase_.text(1), "after `prefer`")
        .fix(phrase_.source().range(sign), "");
  }
}

/// `bottom`, `quality`, `bottom = 60 m`: it does not say whether the least or the greatest.
void PreferenceLine::reportAim(const Goal& goal) {
  const Lexeme found = phrase_.token(goal.value);
  const std::string value = valueText(goal);
  constexpr std::array<std::string_view, 8> kNear = {"near",    "around",  "about", "close",
                                                     "nearest", "closest", "at",    "of"};
  size_t near = oneOf(phrase_.type(goal.end), {GliderLexer::ASSIGN, GliderLexer::EQ}) ? 1 : 0;
  if (near == 0 && saysOneOf(phrase_, goal.end, kNear)) {
    near = phrase_.says(goal.end + 1, "to") ? 2 : 1;
  }
  const size_t wished = near > 0 ? tokensOfQuantity(phrase_, goal.end + near) : 0;
  auto report = phrase_.reporter().at(found, support::diagnostics::unexpectedToken,
                                      "`least` or `greatest` and a value, or `endurance`",
                                      describe(phrase_.source(), found));
  if (wished > 0) {
    report.hint(fmt::format("write `least abs({} - {})` for a value near it", value,
                            phrase_.wholeText(goal.end + near, wished)));
    end_ = std::max(end_, goal.end + near + wished);
  } else if (meansEndurance(goal)) {
    report.hint("write `endurance`: it prefers the least energy");
  } else if (phrase_.isDeclared(phrase_.text(goal.value)) || goal.end > goal.value + 1) {
    report.hint(fmt::format("write `greatest {0}` or `least {0}`", value));
  } else {
    report.hint("only what is chosen can be preferred, as in `prefer greatest …`, and `endurance`");
  }
}

/// `maximum bottom`, `the greatest bottom`, `longest endurance`.
void PreferenceLine::reportGoal(const Goal& goal) {
  const bool lone = goal.aim != GliderLexer::ENDURANCE && goal.aim != 0;
  const bool word = oneOf(phrase_.type(goal.first),
                          {GliderLexer::LEAST, GliderLexer::GREATEST, GliderLexer::ENDURANCE});
  if (goal.aim == 0) {
    return reportAim(goal);
  }
  if (word && goal.value - goal.first == (lone ? 1U : 0U)) {
    return;  // whether the value may be preferred is for analysis to say
  }
  const std::string better = text(goal);
  const size_t words = std::max<size_t>(goal.value - goal.first, 1);
  const bool endurance = lone && meansEndurance(goal);
  const Lexeme found = phrase_.whole(goal.first, endurance ? goal.end - goal.first : words);
  auto report = phrase_.reporter().at(found, support::diagnostics::unexpectedToken,
                                      endurance || !lone               ? "`endurance`"
                                      : goal.aim == GliderLexer::LEAST ? "`least`"
                                                                       : "`greatest`",
                                      fmt::format("`{}`", phrase_.source().text(found)));
  report.hint(fmt::format("write `{}`", better));
  const bool energy = isEnergy(phrase_, goal.value);
  if (!endurance || energy == (goal.aim == GliderLexer::LEAST)) {
    report.fix(phrase_.source().range(phrase_.whole(goal.first, goal.end - goal.first)), better);
  }
}

/// `greatest bottom, endurance`, `endurance over bottom`.
void PreferenceLine::reportThen(const Goal& before, const Goal& goal) {
  const size_t tokens = goal.first - goal.then;
  if (tokens == 1 && phrase_.type(goal.then) == GliderLexer::THEN) {
    return goal.aim == 0 ? reportAim(goal) : reportGoal(goal);
  }
  const Lexeme found = phrase_.whole(goal.then, std::max<size_t>(tokens, 1));
  const uint32_t from = phrase_.token(goal.then - 1).end;
  auto report = phrase_.reporter().at(found, support::diagnostics::unexpectedToken, "`then`",
                                      tokens > 0 ? fmt::format("`{}`", phrase_.source().text(found))
                                                 : describe(phrase_.source(), found));
  if (goal.aim == 0) {
    report.hint(
        fmt::format("write the more important first: `{0} then greatest {1}`, or `{0} then "
                    "least {1}`",
                    before.aim == 0 ? valueText(before) : text(before), valueText(goal)));
    return;
  }
  report.hint(fmt::format("write `then {}`", text(goal)))
      .fix({phrase_.source().file, from, phrase_.token(goal.first).begin}, " then ");
  reportGoal(goal);
}

/// `prefer least bottom then`: nothing follows.
void PreferenceLine::reportLastThen() {
  const size_t tokens = tokensOfThen(phrase_, end_);
  if (tokens == 0) {
    return;
  }
  const Lexeme found = phrase_.whole(end_, tokens);
  phrase_.reporter()
      .at(found, support::diagnostics::unexpectedToken,
          fmt::format("what is preferred next, after `{}`", phrase_.source().text(found)),
          describe(phrase_.source(), phrase_.token(end_ + tokens)))
      .hint("write what decides between equally good values, or delete it");
  end_ += tokens;
}

/// `at launch`, `where …`: parts of a line `choose`.
void PreferenceLine::reportRest() {
  if (phrase_.startsLine(end_)) {
    return;
  }
  const size_t alone = phrase_.says(end_, "first") ? 1 : 0;  // `prefer endurance first`
  if (const size_t launch = alone + tokensOfWords(phrase_, end_, "at launch")) {
    const Lexeme found = phrase_.whole(end_, launch);
    phrase_.reporter()
        .at(found, support::diagnostics::superfluousWord, phrase_.source().text(found),
            "after what is preferred")
        .fix(phrase_.source().range(found), "");
    end_ += launch;
  } else if (oneOf(phrase_.type(end_), {GliderLexer::WHERE, GliderLexer::WHEN, GliderLexer::IF})) {
    const Lexeme found = phrase_.token(end_);
    phrase_.reporter()
        .at(found, support::diagnostics::unexpectedToken, "`then` or another line",
            describe(phrase_.source(), found))
        .hint("write the condition where its value is declared: `choose … where …`");
    end_ = std::max(end_, phrase_.tokensOfLine());
  }
}

void PreferenceLine::put() {
  const Lexeme word = phrase_.token();
  phrase_.put({GliderLexer::PREFER, word.begin, word.end});
  for (const Goal& goal : goals_) {
    const Lexeme place = phrase_.token(goal.first);
    const bool first = &goal == &goals_.front();
    if (!first) {
      const Lexeme then = phrase_.token(goal.then);
      phrase_.put({GliderLexer::THEN, then.begin, goal.first > goal.then ? then.end : then.begin});
    }
    if (goal.aim == GliderLexer::ENDURANCE || meansEndurance(goal)) {
      phrase_.put({GliderLexer::ENDURANCE, place.begin, place.end});
      continue;
    }
    const bool written = goal.aim != 0 && goal.value > goal.first;
    phrase_.put({goal.aim == 0 ? uint32_t{GliderLexer::GREATEST} : goal.aim, place.begin,
                 written ? place.end : place.begin});
    for (size_t k = goal.value; k < goal.end; ++k) {
      phrase_.put(phrase_.token(k));
    }
    if (goal.aim == 0) {
      phrase_.notAsMeant();
    }
  }
}

/// `prefer`, and nothing.
bool PreferenceLine::isEmpty() const {
  return phrase_.type() == GliderLexer::PREFER && phrase_.startsLine(1) &&
         (isHardKeyword(phrase_.type(1)) || oneOf(phrase_.type(1), {kEof, GliderLexer::CHOOSE}));
}

size_t PreferenceLine::repair() {
  if (isEmpty()) {
    phrase_.reporter().at(phrase_.token(), support::diagnostics::unexpectedToken,
                          "`least` or `greatest` and a value, or `endurance`, after `prefer`",
                          describe(phrase_.source(), phrase_.token(1)));
    phrase_.put(phrase_.token());
    phrase_.insert(GliderLexer::ENDURANCE);
    return 1;
  }
  verb_ = phrase_.type() == GliderLexer::NAME ? verbAt(phrase_) : 0;
  const bool sign = oneOf(phrase_.type(1), {GliderLexer::COLON, GliderLexer::ASSIGN});
  first_ = sign ? 2 : 1;
  if (phrase_.startsLine(first_) || !readGoals(first_)) {
    return 0;
  }
  const bool other = phrase_.type() == GliderLexer::NAME;
  const bool aims = goals_.front().aim != 0;
  // What is not certainly a line of this kind may be a comment without its `#`.
  if ((sign && !aims) || (other && verb_ == 0 && !aims) || (other && !endsLine(end_)) ||
      (verb_ != 0 && (goals_.size() > 1 && !aims && verb_ == 3))) {
    return 0;
  }
  const size_t before = phrase_.reporter().count();
  if (other) {
    reportVerb();
  }
  reportSign();
  const size_t goals = goals_.size();
  for (size_t i = 0; i < goals; ++i) {
    if (i > 0) {
      reportThen(goals_[i - 1], goals_[i]);
    } else if (!other || verb_ == 0) {
      reportGoal(goals_[i]);
    }
  }
  const bool plain = std::ranges::any_of(goals_, [](const Goal& goal) { return goal.aim == 0; });
  reportLastThen();
  reportRest();
  if (phrase_.reporter().count() == before) {
    return 0;
  }
  put();
  const bool rest = plain && !endsLine(end_);  // `prefer quality of data`
  return rest ? std::max(end_, phrase_.tokensOfLine()) : end_;
}

}  // namespace

size_t preference(Phrase& phrase) {
  // Asked of every name: its first letter tells most.
  const bool perhaps = std::string_view("pomgPOMG").contains(phrase.text().front());
  const bool begins = perhaps && (phrase.type() == GliderLexer::PREFER || isOtherPrefer(phrase) ||
                                  verbAt(phrase) != 0);
  return begins && mayBeginItem(phrase) ? PreferenceLine(phrase).repair() : 0;
}

}  // namespace glider::frontend::phrases
