// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/format/layout.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

namespace glider::frontend::formatting {
namespace {

bool tokenIsOneOf(const Token& token, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, token.text) != words.end();
}

/// Goes through the tokens with the stack of open blocks. Hard keywords are never names, so each
/// determines what begins.
class Layout {
 public:
  explicit Layout(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::vector<Line> run() {
    for (at_ = 0; at_ + 1 < tokens_.size(); ++at_) {
      if (frames_.empty()) {
        topLevel();
      } else if (frames_.back().kind == Kind::Body) {
        body();
      } else {
        block();
      }
    }
    startLine(0);
    lines_.back().end = tokens_.size();
    return std::move(lines_);
  }

 private:
  enum class Kind : uint8_t { Body, Block };
  struct Frame {
    Kind kind;
    size_t indent;
    bool flat;  ///< is on one line with the token that opens it
  };

  [[nodiscard]] const Token& token() const { return tokens_[at_]; }
  [[nodiscard]] bool after(std::initializer_list<std::string_view> words) const {
    return at_ > 0 && tokenIsOneOf(tokens_[at_ - 1], words);
  }

  void startLine(size_t indent) {
    if (!lines_.empty()) {
      lines_.back().end = at_;
    }
    lines_.push_back({at_, at_, indent, indent, false});
  }

  /// `nap at most …`; `nap` alone is a name in many missions.
  [[nodiscard]] bool startsNap() const {
    return token().is("nap") && at_ + 2 < tokens_.size() && tokens_[at_ + 1].is("at") &&
           tokens_[at_ + 2].is("most");
  }

  /// True at a line such as `declination -12 deg`, `assume no outage` or `pack 168 Ah at 14.4 V`:
  /// where a value or a name is expected, the word is a name.
  [[nodiscard]] bool softItem() const {
    return (startsNap() || tokenIsOneOf(token(), {"declination", "assume", "share", "vehicles",
                                                  "pack", "choose", "prefer"})) &&
           !after({"mission", "platform", "const",    "param", "var",    "function", "sensor",
                   "=",       "+",        "-",        "*",     "/",      "(",        ",",
                   "[",       "in",       "..",       "where", "<",      "<=",       ">",
                   ">=",      "==",       "!=",       "&&",    "||",     "!",        "and",
                   "or",      "not",      "of",       ":",     "always", "within",   "every",
                   "after",   "reach",    "never",    "reads", "place",  "visit",    "then",
                   "patrol",  "when",     "whenever", "hold",  "until",  "before",   "outside",
                   "from",    "to",       "known",    "share", "assume", "precision"});
  }

  void topLevel() {
    const bool named = after({"require", "extern"});
    const bool large =
        !named && tokenIsOneOf(token(), {"always", "state", "flightprofile", "flightroute"});
    const bool resume = token().is("resume") && tokens_[at_ + 1].is("within");
    const bool place =
        !named && token().is("place") && at_ + 2 < tokens_.size() && tokens_[at_ + 2].is("=");
    const bool small = resume || place || softItem() ||
                       tokenIsOneOf(token(), {"mission", "platform", "import", "const", "param",
                                              "var", "extern", "require"});
    if (large || small) {
      startLine(0);
      lines_.back().apart = large || after_large_;
      after_large_ = large;
    } else if (token().is("begin")) {
      startLine(0);
      frames_.push_back({Kind::Body, 0, false});
    } else if (token().is("case")) {
      startLine(kIndent);
    } else if (token().is("do")) {
      openDo();
    }
  }

  void body() {
    if (tokenIsOneOf(token(),
                     {"flightroute", "flightprofile", "sensors", "var", "entry", "events"}) ||
        token().isSample()) {
      startLine(kIndent);
    } else if (token().is("case")) {
      startLine(2 * kIndent);
    } else if (token().is("do")) {
      openDo();
    } else if (token().is("end")) {
      close();
    }
  }

  void block() {
    if (token().is("end")) {
      close();
    } else if (token().is("else")) {
      closeArm();
    } else if (startsStatement(at_)) {
      const Frame frame = frames_.back();
      if (!frame.flat) {
        startLine(frame.indent + kIndent);
      }
      if (token().is("if")) {
        frames_.push_back({Kind::Block, lines_.back().indent, frame.flat || fits(at_)});
      }
    } else if (token().is("do")) {  // of a loop
      frames_.push_back({Kind::Block, lines_.back().indent, frames_.back().flat || fits(at_)});
    }
  }

  void openDo() { frames_.push_back({Kind::Block, lines_.back().indent, fits(at_)}); }

  void close() {
    closeArm();
    frames_.pop_back();
  }
  void closeArm() {
    const Frame& frame = frames_.back();
    if (frame.flat) {
      return;
    }
    const Line& last = lines_.back();
    const bool opened = after({"begin", "do", "then", "else", "events"});
    const size_t inner = opened ? last.indent + kIndent : last.indent;
    startLine(frame.indent);
    lines_.back().comment_indent = std::max(inner, frame.indent + kIndent);
  }

  /// Only inside a block.
  [[nodiscard]] bool startsStatement(size_t i) const {
    const Token& last = tokens_[i - 1];
    const bool command = tokens_[i].depth == 0 && tokens_[i].name && tokens_[i + 1].is("(") &&
                         (last.ends_value || tokenIsOneOf(last, {"do", "then", "else", "end"}));
    return command || startsLoop(i) || tokenIsOneOf(tokens_[i], {"set", "if", "log"});
  }
  /// At `for i in`: where it is a name, no other name follows it.
  [[nodiscard]] bool startsLoop(size_t i) const {
    return i + 2 < tokens_.size() && tokens_[i].is("for") && tokens_[i + 2].is("in") &&
           !tokens_[i + 1].is("in");
  }

  /// Whether the `do` or `if` at `open` was written on one line up to its `end`, has at most one
  /// statement in each branch, and fits on one line with what comes before and after it.
  [[nodiscard]] bool fits(size_t open) const {
    std::vector<size_t> statements;  // in the open branches
    size_t i = open;
    do {
      const Token& next = tokens_[i];
      if (i > open && next.broken()) {
        return false;
      }
      if (i > open && startsStatement(i) && ++statements.back() > 1) {
        return false;
      }
      if (tokenIsOneOf(next, {"do", "if"})) {
        statements.push_back(0);
      } else if (next.is("else")) {
        statements.back() = 0;
      } else if (next.is("end")) {
        statements.pop_back();
      }
      ++i;
    } while (!statements.empty());
    const bool of_case = tokens_[open].is("do") && !after({"entry"}) &&
                         (frames_.empty() || frames_.back().kind == Kind::Body);
    return fitsWhole(of_case ? pastTransition(i) : i);
  }

  /// The token after the transition that begins at `i`.
  [[nodiscard]] size_t pastTransition(size_t i) const {
    if (!tokenIsOneOf(tokens_[i], {"goto", "call"})) {
      return i + 1;
    }
    i += 2;
    if (tokens_[i].is("(")) {
      while (!(tokens_[i].is(")") && tokens_[i].depth == 0)) {
        ++i;
      }
      ++i;
    }
    return i;
  }

  /// Whether the line begun last fits on one line up to token `end`.
  [[nodiscard]] bool fitsWhole(size_t end) const {
    size_t columns = lines_.back().indent;
    const size_t first = lines_.back().first;
    for (size_t i = first; i < end; ++i) {
      const Token& next = tokens_[i];
      const bool must_break = i > first && tokens_[i - 1].opens() && next.broken();
      if (must_break || (i > first && !next.rows.empty())) {
        return false;
      }
      columns += width(next.text) + (i > first && !next.tight ? 1U : 0U);
    }
    return columns <= kColumns;
  }

  const std::vector<Token>& tokens_;
  std::vector<Line> lines_;
  std::vector<Frame> frames_;
  size_t at_ = 0;
  bool after_large_ = false;
};

}  // namespace

size_t width(std::string_view text) {
  return static_cast<size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<Line> layOut(const std::vector<Token>& tokens) {
  return Layout(tokens).run();
}

}  // namespace glider::frontend::formatting
