// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/format/tokens.h"

#include "frontend/parse/lexeme.h"
#include "frontend/parse/token_kinds.h"
#include "support/one_of.h"
#include "support/units/units.h"

#include <algorithm>

namespace glider::frontend::formatting {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// A comment with `\n` line ends and no spaces before them.
std::string cleaned(std::string_view comment) {
  std::string out;
  auto endLine = [&out] { out.erase(out.find_last_not_of(" \t\f\v") + 1); };
  for (size_t i = 0; i < comment.size(); ++i) {
    const bool pair = comment[i] == '\r' && i + 1 < comment.size() && comment[i + 1] == '\n';
    if (comment[i] != '\n' && comment[i] != '\r') {
      out += comment[i];
    } else if (!pair) {
      endLine();
      out += '\n';
    }
  }
  endLine();
  return out;
}

/// Reads what is between two tokens: spaces, line ends and comments.
class GapReader {
 public:
  explicit GapReader(std::string_view gap) : gap_(gap) {}

  void read(Token& next) {
    while (at_ < gap_.size()) {
      const char c = gap_[at_];
      if (c == '#' || c == '/') {
        comment(next);
        continue;
      }
      const bool pair = c == '\r' && at_ + 1 < gap_.size() && gap_[at_ + 1] == '\n';
      newlines_ += (c == '\n' || c == '\r') && !pair ? 1U : 0U;
      ++at_;
    }
    next.newlines_before = newlines_;
  }

 private:
  void comment(Token& next) {
    const bool block = gap_.substr(at_, 2) == "/*";
    const size_t close = block ? gap_.find("*/", at_ + 2) + 2 : gap_.find_first_of("\r\n", at_);
    const size_t end = std::min(close, gap_.size());
    if (next.rows.empty() || newlines_ > 0) {
      next.rows.push_back({{}, newlines_, false});
    }
    next.rows.back().comments.push_back(cleaned(gap_.substr(at_, end - at_)));
    next.rows.back().open_ended = !block;
    newlines_ = 0;
    at_ = end;
  }

  std::string_view gap_;
  size_t at_ = 0;
  size_t newlines_ = 0;
};

/// Determines the role of each token from the tokens before and after it.
class Classifier {
 public:
  Classifier(std::vector<Token>& tokens, const std::vector<Lexeme>& lexemes)
      : tokens_(tokens), lexemes_(lexemes) {}

  void run() {
    for (size_t i = 0; i + 1 < tokens_.size(); ++i) {
      const Token none;
      const Token& last = i > 0 ? tokens_[i - 1] : none;
      brackets(tokens_[i]);
      chain(i, last);
      kind(i, last);
      tokens_[i].tight = tight(tokens_[i], last);
    }
  }

 private:
  /// The meaning of a sequence of names joined by `*` and `/`.
  enum class Chain : uint8_t { None, Type, Unit };

  void brackets(Token& token) {
    depth_ -= token.closes() && depth_ > 0 ? 1U : 0U;
    token.depth = depth_;
    depth_ += token.opens() ? 1U : 0U;
  }

  /// Finds the parts of `degC/m` and `temperature/length`.
  void chain(size_t i, const Token& last) {
    Token& token = tokens_[i];
    if (token.is(":")) {
      chain_ = Chain::Type;
    } else if (isNumber(last.text) && (isUnit(i) || isSoftUnit(i))) {
      chain_ = Chain::Unit;
    } else if (support::isOneOf(token.text, {"*", "/"})) {
      token.unit_part =
          chain_ == Chain::Type || (chain_ == Chain::Unit && (unitFollows(i) || isFraction(i - 1)));
      chain_ = token.unit_part ? chain_ : Chain::None;
    } else if (last.unit_part && support::isOneOf(last.text, {"*", "/"})) {
      token.unit_part = true;
    } else if (!last.is(":")) {
      chain_ = Chain::None;
    }
  }
  [[nodiscard]] bool isUnit(size_t i) const {
    return isAnyName(lexemes_[i].type) && !isName(lexemes_[i].type);
  }
  /// `kt`, or the beginning of `ug/L`, right after a number.
  [[nodiscard]] bool isSoftUnit(size_t i) const {
    const auto unit = support::findUnit(tokens_[i].text);
    return (unit && unit->soft) || isFraction(i);
  }
  /// Whether tokens i to i + 2 are a unit of one word: `ug/L`.
  [[nodiscard]] bool isFraction(size_t i) const {
    if (i + 2 >= tokens_.size() || !tokens_[i + 1].is("/")) {
      return false;
    }
    const auto unit =
        support::findUnit(std::string(tokens_[i].text) + "/" + std::string(tokens_[i + 2].text));
    return unit && unit->soft;
  }
  /// Not before `min(`, which is the function.
  [[nodiscard]] bool unitFollows(size_t i) const {
    return isUnit(i + 1) && !(i + 2 < tokens_.size() && tokens_[i + 2].is("("));
  }

  void kind(size_t i, const Token& last) {
    Token& token = tokens_[i];
    if (isAnyName(lexemes_[i].type)) {
      token.name = !isSoftKeyword(lexemes_[i].type) || token.unit_part || !noNameAfter(last);
      token.ends_value = token.name;
    } else {
      token.ends_value = isNumber(token.text) || token.text.starts_with('"') || token.closes() ||
                         lexemes_[i].type == GliderLexer::HEARD ||
                         support::isOneOf(token.text, {"true", "false"});
    }
    token.operation = !token.unit_part && last.ends_value &&
                      support::isOneOf(token.text, {"+", "-", "*", "/", "<", "<=", ">",
                                                    ">=", "==", "!=", "&&", "||"});
  }
  static bool isNumber(std::string_view text) {
    const std::string_view digits = text.starts_with('.') ? text.substr(1) : text;
    return !digits.empty() && digits[0] >= '0' && digits[0] <= '9';
  }
  /// After `last`, words such as `in`, `of`, `where` and `done` are words of the language.
  static bool noNameAfter(const Token& last) {
    return last.ends_value ||
           support::isOneOf(last.text, {"end", "extern", "require", "exit", "stale"});
  }

  static bool tight(const Token& token, const Token& last) {
    const bool sign = support::isOneOf(last.text, {"-", "!"}) && !last.operation;
    return token.unit_part || sign || last.opens() || token.closes() ||
           support::isOneOf(token.text, {",", ":"}) || (token.opens() && last.name);
  }

  std::vector<Token>& tokens_;
  const std::vector<Lexeme>& lexemes_;
  size_t depth_ = 0;
  Chain chain_ = Chain::None;
};

}  // namespace

std::string CommentRow::text() const {
  std::string out;
  for (const std::string& comment : comments) {
    out += (out.empty() ? "" : " ") + comment;
  }
  return out;
}

bool Token::broken() const {
  return newlines_before > 0 ||
         std::ranges::any_of(rows, [](const CommentRow& row) { return row.newlines_before > 0; });
}

std::vector<Token> readTokens(std::string_view text) {
  size_t end = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::vector<Lexeme> lexemes = lex(text, end);
  std::vector<Token> tokens(lexemes.size());
  for (size_t i = 0; i < lexemes.size(); ++i) {
    tokens[i].text = text.substr(lexemes[i].begin, lexemes[i].end - lexemes[i].begin);
    GapReader(text.substr(end, lexemes[i].begin - end)).read(tokens[i]);
    end = lexemes[i].end;
  }
  Classifier(tokens, lexemes).run();
  return tokens;
}

}  // namespace glider::frontend::formatting
