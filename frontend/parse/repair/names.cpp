// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/names.h"

#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/word_byte.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

namespace {

/// The most tokens and bytes of a name that is not one word: what is longer was not meant as a
/// name.
constexpr size_t kMostTokens = 7;
constexpr uint32_t kMostBytes = 200;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether it may be part of what was written as a name.
bool maybePart(uint32_t type) {
  return isAnyName(type) ||
         oneOf(type, {GliderLexer::HEARD, GliderLexer::NUMBER, GliderLexer::STRING,
                      GliderLexer::MINUS, GliderLexer::PLUS, GliderLexer::COLON, GliderLexer::COMMA,
                      GliderLexer::DIVIDE, GliderLexer::ASSIGN, GliderLexer::EQ, GliderLexer::NOT,
                      GliderLexer::TIMES, GliderLexer::RPAREN});
}

/// A keyword that the name of a state may be meant to contain: `state return home`.
bool isAction(uint32_t type) {
  return isTransition(type) || oneOf(type, {GliderLexer::ENTRY, GliderLexer::LOG,
                                            GliderLexer::EVERY, GliderLexer::SENSORS});
}

bool isTarget(uint32_t type) {
  return oneOf(type, {GliderLexer::GOTO, GliderLexer::CALL});
}

/// Whether it begins a declaration, though it may also be a name.
bool isSoftItem(uint32_t type) {
  return oneOf(
      type, {GliderLexer::PLACE, GliderLexer::RESUME, GliderLexer::DECLINATION, GliderLexer::ASSUME,
             GliderLexer::SHARE, GliderLexer::VEHICLES, GliderLexer::PACK, GliderLexer::CHOOSE,
             GliderLexer::PREFER, GliderLexer::NAP});
}

}  // namespace

std::vector<Lexeme> NameRepair::run(const std::vector<Lexeme>& lexemes) {
  in_ = lexemes;
  gatherNames();
  std::vector<Lexeme> out;
  out.reserve(in_.size());
  for (size_t i = 0; i < in_.size(); ++i) {
    out.push_back(in_[i]);
    const WrittenName slip = reporter_.full() ? WrittenName{} : slipAfter(i);
    if (slip.found()) {
      out.push_back(report(i, slip));
      i = slip.end - 1;
    }
  }
  return out;
}

/// First what is defined, then what is used: whether several words after `goto` are a name depends
/// on that.
void NameRepair::gatherNames() {
  for (size_t i = 0; i + 2 < in_.size(); ++i) {
    const uint32_t type = in_[i].type;
    if (type != GliderLexer::STATE && !isBehaviourWord(type)) {
      continue;
    }
    if (const WrittenName slip = slipAfter(i); slip.found()) {
      joined_.insert(joined(slip.words));
    } else if (isAnyName(in_[i + 1].type) &&
               (type == GliderLexer::STATE || in_[i + 2].type == GliderLexer::BEGIN)) {
      defined_.emplace(source_.text(in_[i + 1]));
    }
  }
  for (size_t i = 0; i + 2 < in_.size(); ++i) {
    if (!isTarget(in_[i].type) && !isBehaviourWord(in_[i].type)) {
      continue;
    }
    const WrittenName slip = isTarget(in_[i].type) ? targetAfter(i) : WrittenName{};
    if (slip.found()) {
      used_.insert(joined(slip.words));
    } else if (isAnyName(in_[i + 1].type) && !isAnyName(in_[i + 2].type) &&
               in_[i + 2].type != GliderLexer::BEGIN) {
      used_.emplace(source_.text(in_[i + 1]));
    }
  }
}

NameRepair::WrittenName NameRepair::slipAfter(size_t keyword) const {
  const uint32_t type = in_[keyword].type;
  if (keyword + 1 >= in_.size()) {
    return {};
  }
  if (type == GliderLexer::MISSION) {
    return missionAfter(keyword);
  }
  if (isTarget(type)) {
    return targetAfter(keyword);
  }
  const bool external = keyword > 0 && in_[keyword - 1].type == GliderLexer::EXTERN;
  return type == GliderLexer::STATE || (isBehaviourWord(type) && !external) ? headerAfter(keyword)
                                                                            : WrittenName{};
}

/// Everything up to `begin`, or up to the parameters before it.
NameRepair::WrittenName NameRepair::headerAfter(size_t keyword) const {
  const bool state = in_[keyword].type == GliderLexer::STATE;
  const size_t line = tokensOfLine(keyword + 1);
  size_t end = keyword + 1;
  while (end < in_.size() && end - keyword <= kMostTokens && in_[end].type != GliderLexer::BEGIN &&
         (maybePart(in_[end].type) || (state && end < line && isAction(in_[end].type)))) {
    ++end;
  }
  if (end >= in_.size()) {
    return {};
  }
  bool begins = in_[end].type == GliderLexer::BEGIN;
  if (in_[end].type == GliderLexer::LPAREN && end > keyword + 1) {
    size_t close = end;
    while (close < in_.size() && in_[close].type != GliderLexer::RPAREN &&
           !isHardKeyword(in_[close].type)) {
      ++close;
    }
    begins = close + 1 < in_.size() && in_[close + 1].type == GliderLexer::BEGIN;
  }
  if (!begins) {
    // `state look:` without its `begin`: only what touches the name.
    const bool touches = state && end > keyword + 2 && isAnyName(in_[keyword + 1].type) &&
                         in_[keyword + 2].type == GliderLexer::COLON &&
                         in_[keyword + 2].begin == in_[keyword + 1].end;
    end = touches ? keyword + 3 : keyword;
  }
  const bool good = end <= keyword + 1 ||
                    (end == keyword + 2 &&
                     (isAnyName(in_[keyword + 1].type) || isHardKeyword(in_[keyword + 1].type)));
  WrittenName slip{keyword + 1, good ? keyword + 1 : end, {}};
  slip.words = wordsIn(slip.begin, slip.end);
  return slip.words.empty() ? WrittenName{} : slip;
}

/// The rest of the line.
NameRepair::WrittenName NameRepair::missionAfter(size_t keyword) const {
  const size_t line = tokensOfLine(keyword + 1);
  size_t end = keyword + 1;
  while (end < line && end - keyword <= kMostTokens && maybePart(in_[end].type) &&
         (end == keyword + 1 || !isSoftItem(in_[end].type))) {
    ++end;
  }
  // `mission my mission`: a keyword that nothing else explains.
  end = end == keyword + 2 && end + 1 == line && in_[end].type == GliderLexer::MISSION ? line : end;
  const bool good = end == keyword + 1 || !sameLine(in_[keyword], in_[keyword + 1]) ||
                    (end == keyword + 2 && isAnyName(in_[keyword + 1].type));
  const bool ends = end < in_.size() && (isHardKeyword(in_[end].type) || in_[end].type == kEof ||
                                         isSoftItem(in_[end].type) || end == line);
  WrittenName slip{keyword + 1, good || !ends ? keyword + 1 : end, {}};
  slip.words = wordsIn(slip.begin, slip.end);
  return slip.words.empty() ? WrittenName{} : slip;
}

/// Words that together, or in quotes, are the name of a state.
NameRepair::WrittenName NameRepair::targetAfter(size_t keyword) const {
  const size_t line = tokensOfLine(keyword + 1);
  size_t end = keyword + 1;
  while (end < line && end - keyword <= kMostTokens &&
         (isAnyName(in_[end].type) ||
          oneOf(in_[end].type, {GliderLexer::NUMBER, GliderLexer::STRING, GliderLexer::MINUS}))) {
    ++end;
  }
  if (end == keyword + 1 || (end == keyword + 2 && isAnyName(in_[keyword + 1].type))) {
    return {};
  }
  WrittenName slip{keyword + 1, end, wordsIn(keyword + 1, end)};
  const std::string name = joined(slip.words);
  // A number belongs to nothing else there.
  const bool number = isAnyName(in_[keyword + 1].type) &&
                      in_[keyword + 2].type == GliderLexer::NUMBER && end == keyword + 3;
  const bool known = defined_.contains(name) || joined_.contains(name);
  return known || number ? slip : WrittenName{};
}

/// The first token after `from` that is on another line than it.
size_t NameRepair::tokensOfLine(size_t from) const {
  size_t end = from;
  while (end < in_.size() && end - from <= kMostTokens && in_[end].type != kEof &&
         sameLine(in_[from], in_[end])) {
    ++end;
  }
  return end;
}

bool NameRepair::sameLine(const Lexeme& a, const Lexeme& b) const {
  return source_.text().substr(a.begin, b.begin - a.begin).find('\n') == std::string_view::npos;
}

std::vector<Lexeme> NameRepair::wordsIn(size_t begin, size_t end) const {
  std::vector<Lexeme> words;
  if (begin >= end || in_[end - 1].end - in_[begin].begin > kMostBytes) {
    return words;
  }
  const std::string_view text = source_.text();
  for (uint32_t at = in_[begin].begin; at < in_[end - 1].end;) {
    const uint32_t from = at;
    while (at < in_[end - 1].end && support::isWordByte(text[at])) {
      ++at;
    }
    if (at > from) {
      words.push_back({GliderLexer::NAME, from, at});
    } else {
      ++at;
    }
  }
  return words;
}

/// "go_home". A digit cannot come first: `1look` becomes "look1".
std::string NameRepair::joined(const std::vector<Lexeme>& words) const {
  std::string name;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = source_.text(words[i]);
    const bool again = i > 0 && word == source_.text(words[i - 1]);
    name += again ? "" : (name.empty() ? "" : "_") + std::string(word);
  }
  const size_t digits = std::min(name.find_first_not_of("0123456789_"), name.size());
  if (!name.empty() && isDigit(name.front())) {
    const std::string number = name.substr(0, digits);
    const std::string rest = name.substr(digits);
    name = (rest.empty() ? "s" : rest) + number.substr(0, number.find('_'));
  }
  return keywordType(name) != 0 ? name + "1" : name;
}

/// A name that is used in the mission and not defined elsewhere is certainly meant; otherwise all
/// words together are, if there is no other sign.
NameRepair::IntendedName NameRepair::meantBy(size_t keyword, const WrittenName& slip) const {
  const std::string name = joined(slip.words);
  const bool as_written = slip.words.size() > 1 || source_.text(slip.words.front()) == name;
  if (in_[keyword].type == GliderLexer::MISSION) {
    return {name, as_written};
  }
  if (isTarget(in_[keyword].type)) {
    std::string glued = name;
    std::erase(glued, '_');
    const bool without = !defined_.contains(name) && defined_.contains(glued);
    return {without ? glued : name, without || defined_.contains(name) || joined_.contains(name)};
  }
  std::vector<std::string> candidates;
  const auto consider = [&](std::string_view candidate) {
    if (used_.contains(candidate) && !defined_.contains(candidate) &&
        std::ranges::find(candidates, candidate) == candidates.end()) {
      candidates.emplace_back(candidate);
    }
  };
  consider(name);
  for (const Lexeme& word : slip.words) {
    consider(source_.text(word));
    const std::string_view text = source_.text(word);
    consider(text.substr(std::min(text.find_first_not_of("0123456789"), text.size())));
  }
  if (candidates.size() == 1) {
    return {candidates.front(), true};
  }
  return {name, candidates.empty() && as_written && !defined_.contains(name)};
}

Lexeme NameRepair::report(size_t keyword, const WrittenName& slip) {
  const Lexeme whole{GliderLexer::NAME, in_[slip.begin].begin, in_[slip.end - 1].end};
  const IntendedName meant = meantBy(keyword, slip);
  auto report = reporter_.at(whole, support::diagnostics::nameNotOneWord, source_.text(whole),
                             fmt::format("write `{} {}`", source_.text(in_[keyword]), meant.name));
  if (meant.certain) {
    // `mission" survey`: it must not become one word with its neighbours.
    const bool before = in_[keyword].end == whole.begin;
    const bool after =
        slip.end < in_.size() && in_[slip.end].begin == whole.end && in_[slip.end].type != kEof;
    report.fix(source_.range(whole), (before ? " " : "") + meant.name + (after ? " " : ""));
  }
  const auto word = std::ranges::find_if(
      slip.words, [&](const Lexeme& one) { return source_.text(one) == meant.name; });
  guessed_ = guessed_ || word == slip.words.end();
  return word == slip.words.end() ? whole : *word;
}

}  // namespace glider::frontend
