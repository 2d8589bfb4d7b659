// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The part of WordRepair that reads what encloses: braces and quotation marks.

#include "frontend/parse/foreign_characters.h"
#include "frontend/parse/repair/words.h"
#include "frontend/parse/token_kinds.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {

/// A text in the quotation marks of word processors, on one line: the token is its text, each mark
/// with one byte.
size_t WordRepair::quotedText(const std::vector<Lexeme>& lexemes, size_t at,
                              std::vector<Lexeme>& out) {
  const Source& source = reporter_.source();
  const Lexeme& open = lexemes[at];
  const uint32_t before = out.empty() ? 0 : out.back().type;
  const bool single = source.text(open) == "'" &&
                      (wantsName(before) || oneOf(before, {GliderLexer::LOG, GliderLexer::IMPORT}));
  if (open.type != GliderLexer::FOREIGN || !(single || isQuote(source.text(open)))) {
    return 0;
  }
  const size_t limit = source.text().find_first_of("\n\"\\", open.end);
  for (size_t i = at + 1; i < lexemes.size() && lexemes[i].type != kEof; ++i) {
    const Lexeme& close = lexemes[i];
    if (close.begin > limit) {
      return 0;
    }
    if (close.type == GliderLexer::FOREIGN &&
        (single ? source.text(close) == "'" : isQuote(source.text(close)))) {
      if (wantsName(before)) {  // NameRepair reports names in quotes
        out.push_back({GliderLexer::STRING, open.begin, close.end});
        return i - at + 1;
      }
      reporter_
          .at({GliderLexer::STRING, open.begin, close.end}, support::diagnostics::foreignCharacter,
              characterText(source.text(open)), "write `\"` before and after the text")
          .fix(source.range(open), "\"")
          .fix(source.range(close), "\"");
      out.push_back({GliderLexer::STRING, open.end - 1, close.begin + 1});
      return i - at + 1;
    }
  }
  return 0;
}

bool WordRepair::isBrace(const Lexeme& lexeme) const {
  const std::string_view text = reporter_.source().text(lexeme);
  return lexeme.type == GliderLexer::FOREIGN && (text == "{" || text == "}");
}

/// Where the `}` for the `{` at `at` is; 0: there is none.
size_t WordRepair::closingBrace(const std::vector<Lexeme>& lexemes, size_t at) const {
  size_t deep = 0;
  for (size_t i = at; i < lexemes.size(); ++i) {
    if (isBrace(lexemes[i])) {
      const bool opens = reporter_.source().text(lexemes[i]) == "{";
      deep += opens ? 1U : 0U;
      if (!opens && --deep == 0) {
        return i;
      }
    }
  }
  return 0;
}

namespace {

/// Whether `for i in 0 .. 7` was read last.
bool endsLoopHeader(const std::vector<Lexeme>& out) {
  constexpr size_t kLongest = 12;
  const size_t n = out.size();
  for (size_t k = 2; k < std::min(n, kLongest); ++k) {
    if (out[n - k].type == GliderLexer::RANGE) {
      for (size_t i = k + 3; i < std::min(n + 1, k + kLongest); ++i) {
        if (out[n - i].type == GliderLexer::FOR && out[n - i + 2].type == GliderLexer::IN) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

/// What `{` and `}` were meant as after `before` (the tokens so far).
WordRepair::Braces WordRepair::bracesAfter(const std::vector<Lexeme>& out, uint32_t next) const {
  const uint32_t last = out.empty() ? 0 : out.back().type;
  if (oneOf(last, {GliderLexer::EVENTS, GliderLexer::BEGIN, GliderLexer::ALWAYS})) {
    return {"", 0, "", 0};
  }
  if (oneOf(last, {GliderLexer::DO, GliderLexer::THEN, GliderLexer::ELSE})) {
    return {"", 0, "end", GliderLexer::END};
  }
  if (last == GliderLexer::ASSIGN) {
    return {"[", GliderLexer::LBRACKET, "]", GliderLexer::RBRACKET};
  }
  if (last_keyword_ == GliderLexer::IF && endsValue(last)) {
    return {"then", GliderLexer::THEN, "end", GliderLexer::END};
  }
  if (endsLoopHeader(out)) {
    return {"do", GliderLexer::DO, "end", GliderLexer::END};
  }
  if (last_keyword_ == GliderLexer::CASE && isTransition(next)) {
    return {"", 0, "", 0};
  }
  if (last == GliderLexer::ENTRY || last_keyword_ == GliderLexer::CASE) {
    return {"do", GliderLexer::DO, "end", GliderLexer::END};
  }
  const bool header = oneOf(
      last_keyword_, {GliderLexer::STATE, GliderLexer::FLIGHTPROFILE, GliderLexer::FLIGHTROUTE});
  const bool named = header && out.size() > 1 && out.back().type != last_keyword_;
  return named ? Braces{"begin", GliderLexer::BEGIN, "end", GliderLexer::END}
               : Braces{"?", 0, "", 0};
}

namespace {

/// "write `begin` for `{`, and `end` for `}`".
std::string insteadOfBraces(std::string_view open, std::string_view close) {
  if (open.empty() && close.empty()) {
    return "delete `{` and `}`";
  }
  const auto act = [](std::string_view word, const char* brace) {
    return word.empty() ? fmt::format("delete `{}`", brace)
                        : fmt::format("write `{}` for `{}`", word, brace);
  };
  return open.empty() || close.empty()
             ? fmt::format("{}, and {}", act(open, "{"), act(close, "}"))
             : fmt::format("write `{}` for `{{`, and `{}` for `}}`", open, close);
}

}  // namespace

/// `{` and `}` are reported once, and read as the words that were meant.
void WordRepair::brace(const std::vector<Lexeme>& lexemes, size_t at, std::vector<Lexeme>& out) {
  const Source& source = reporter_.source();
  const Lexeme& lexeme = lexemes[at];
  if (const auto known = closing_.find(at); known != closing_.end()) {
    if (known->second != 0) {
      out.push_back({known->second, lexeme.begin, lexeme.end});
      last_keyword_ = known->second;
    }
    return;
  }
  const uint32_t next = lexemes[std::min(at + 1, lexemes.size() - 1)].type;
  Braces meant = source.text(lexeme) == "{" ? bracesAfter(out, next) : Braces{"?", 0, "", 0};
  if (meant.open_type != 0 && next == meant.open_type) {
    meant = {"", 0, "", 0};  // `{ begin`: the word is there too
  }
  if (meant.open == "?") {
    reporter_.at(lexeme, support::diagnostics::braces, source.text(lexeme),
                 "blocks are written `begin … end` and `do … end`");
    return;
  }
  const size_t close = closingBrace(lexemes, at);
  if (close != 0 && lexemes[std::min(close + 1, lexemes.size() - 1)].type == GliderLexer::ELSE) {
    meant.close = "";  // the `if` goes on
    meant.close_type = 0;
  }
  auto report = reporter_.at(lexeme, support::diagnostics::braces, source.text(lexeme),
                             insteadOfBraces(meant.open, meant.close));
  if (close != 0 || meant.close_type != GliderLexer::END || meant.open == "begin") {
    report.fix(source.range(lexeme), std::string(meant.open));
  }
  if (close != 0) {
    report.fix(source.range(lexemes[close]), std::string(meant.close));
    closing_[close] = meant.close_type;
  }
  if (meant.open_type != 0) {
    out.push_back({meant.open_type, lexeme.begin, lexeme.end});
    last_keyword_ = meant.open_type;
  }
}

/// A text without a closing quote was meant to end before a comma, or before the `end` of its
/// block, on its line.
void WordRepair::openString(const Lexeme& lexeme, std::vector<Lexeme>& out) {
  const std::string_view text = reporter_.source().text(lexeme);
  const size_t cut = std::min({text.find(','), text.find(" end"), text.size()});
  // No fix: a comma may be part of the text.
  reporter_.at(lexeme, support::diagnostics::openString)
      .hint(fmt::format("close it with `\"`, as in `{}\"`", text.substr(0, cut)));
  const auto at = static_cast<uint32_t>(lexeme.begin + cut);
  out.push_back({GliderLexer::STRING, lexeme.begin, at});
  for (const Lexeme& rest : lex(reporter_.source().text().substr(0, lexeme.end), at)) {
    if (rest.type != kEof) {
      out.push_back(rest);
    }
  }
}

}  // namespace glider::frontend
