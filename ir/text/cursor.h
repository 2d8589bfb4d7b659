// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/text/lexer.h"
#include "support/diagnostics/engine.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace glider::ir::text {

/// Reads tokens one after another. The first error is reported and ends the reading: from then on
/// every token is End and every result is empty, so that callers check `failed` only at their own
/// end.
class Cursor {
 public:
  Cursor(std::string_view text, uint32_t file, support::DiagnosticEngine& diagnostics);

  [[nodiscard]] const Token& peek() const { return token_; }
  [[nodiscard]] bool failed() const { return failed_; }
  /// From `begin` to the end of the token taken last.
  [[nodiscard]] support::SourceRange since(support::SourceRange begin) const {
    return {begin.file, begin.begin, std::max(begin.end, last_end_)};
  }
  Token take();
  /// Takes the next token if it is this word or mark.
  bool accept(std::string_view word);
  bool accept(char mark);
  /// Takes this word or mark; anything else is an error. `expect(word)` returns the word's place.
  support::SourceRange expect(std::string_view word);
  void expect(char mark);
  /// A word or string; `what` says what it names, "the name of a state".
  std::string name(std::string_view what);
  /// The same together with its place.
  Token nameToken(std::string_view what);
  /// A number, never NaN; an infinity only if `infinite`.
  double number(bool infinite);
  /// A whole number in [lowest, highest].
  int64_t integer(int64_t lowest, int64_t highest);
  /// A type of numbers as `typeText` writes it.
  Type type();
  /// The same, or `bool`.
  Type typeOrBool() { return accept("bool") ? Type{TypeKind::Bool, {}} : type(); }

  /// Reports the first error of the text.
  template <typename... Args>
  void fail(support::DiagnosticId id, support::SourceRange range, Args&&... args) {
    if (!failed_) {
      diagnostics_.report(id, range, std::forward<Args>(args)...);
    }
    failed_ = true;
    token_ = {TokenKind::End, "", range};
  }
  /// Reports that `what` was expected in place of the next token.
  void failExpecting(std::string_view what);

 private:
  Lexer lexer_;
  support::DiagnosticEngine& diagnostics_;
  Token token_;
  uint32_t last_end_ = 0;
  bool failed_ = false;
};

}  // namespace glider::ir::text
