// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/superfluous.h"

#include "frontend/parse/token_kinds.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

/// Whether only white space stands between `t` and the word before it. The first of two on two
/// lines begins its line, or follows `events`; otherwise it may be prose, such as a comment
/// without its `#`.
bool isRightAfterPrevious(const TokenContext& around, const Lexeme& t) {
  const auto& before = around.before;
  const std::string_view text = around.source.text();
  if (before.empty() || before.back().end <= before.back().begin) {
    return false;
  }
  const Lexeme& first = before.back();
  const auto blank = [&](uint32_t from, uint32_t to, std::string_view also) {
    return text.substr(from, to - from).find_first_not_of(also) == std::string_view::npos;
  };
  const size_t line = text.substr(0, first.begin).rfind('\n') + 1;  // of npos: 0
  const bool follows = before.size() > 1 && before[before.size() - 2].type == GliderLexer::EVENTS;
  const auto begin = static_cast<uint32_t>(line);
  return blank(first.end, t.begin, " \t\r\n") &&
         (blank(first.end, t.begin, " \t") || follows || blank(begin, first.begin, " \t"));
}

bool takesNoSign(uint32_t before, uint32_t sign) {
  return startsMember(before) ||
         oneOf(before,
               {GliderLexer::MISSION, GliderLexer::STATE, GliderLexer::GOTO, GliderLexer::CALL}) ||
         (sign == GliderLexer::COLON &&
          oneOf(before, {GliderLexer::BEGIN, GliderLexer::END, GliderLexer::DO, GliderLexer::THEN,
                         GliderLexer::ELSE, GliderLexer::ALWAYS, GliderLexer::CASE}));
}

bool isNeverTwice(uint32_t type) {
  return startsMember(type) || isTransition(type) ||
         oneOf(type, {GliderLexer::MISSION, GliderLexer::STATE, GliderLexer::CASE,
                      GliderLexer::CONST, GliderLexer::PARAM, GliderLexer::VAR, GliderLexer::SET,
                      GliderLexer::LOG, GliderLexer::THEN, GliderLexer::ELSE, GliderLexer::REQUIRE,
                      GliderLexer::ALWAYS, GliderLexer::IMPORT, GliderLexer::PLATFORM});
}

/// `end state`, `end look`: a word on the line of `end`, with nothing after it, that cannot begin
/// anything there.
bool isNameOfEnd(const TokenContext& around, const Lexeme& t) {
  const auto apart = [&](uint32_t from, uint32_t to) {
    return around.source.text().substr(from, to - from).find('\n') != std::string_view::npos;
  };
  const auto& before = around.before;
  const Lexeme& next = around.next;
  const bool alone = !before.empty() && before.back().end > before.back().begin &&
                     !apart(before.back().end, t.begin) &&
                     (next.type == kEof || apart(t.end, next.begin));
  const bool follows = startsItem(next.type) || startsMember(next.type) ||
                       isTransition(next.type) ||
                       oneOf(next.type, {kEof, GliderLexer::END, GliderLexer::CASE});
  const bool word = t.type == GliderLexer::NAME ||
                    oneOf(t.type, {GliderLexer::STATE, GliderLexer::IF, GliderLexer::MISSION,
                                   GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE});
  return alone && follows && word;
}

}  // namespace

std::string superfluousWhere(const TokenContext& around, const Lexeme& t) {
  const uint32_t previous = around.before.empty() ? 0 : around.before.back().type;
  if (oneOf(t.type, {GliderLexer::ASSIGN, GliderLexer::COLON}) && takesNoSign(previous, t.type)) {
    return fmt::format("after `{}`", around.source.text(around.before.back()));
  }
  const uint32_t next = around.next.type;
  const bool leads = isTransition(next) || next == GliderLexer::DO;
  if (around.in_condition && endsValue(previous) && leads &&
      oneOf(t.type, {GliderLexer::COLON, GliderLexer::THEN})) {
    return "after the condition of a case";
  }
  if (previous == GliderLexer::END && isNameOfEnd(around, t)) {
    return "after `end`";
  }
  const bool again = around.keyword && t.type == previous && isNeverTwice(t.type) &&
                     isRightAfterPrevious(around, t) && (!wantsName(t.type) || isAnyName(next));
  return again ? "a second time" : "";
}

}  // namespace glider::frontend
