// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/lexeme.h"
#include "frontend/parse/reporter.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Errors that are recognised by several tokens: `is above`, `1h30`, `if … then call up`.
namespace glider::frontend {

/// An open parenthesis or bracket.
struct OpenList {
  uint32_t type = 0;
  bool arguments = false;  ///< of a name
};

/// A token with everything around it. The text is read forward from token 0, which is the current
/// one; `before` is what was read, as repaired.
class Phrase {
 public:
  Phrase(const std::vector<Lexeme>& in, SyntaxReporter& reporter);

  [[nodiscard]] const Source& source() const { return reporter_.source(); }
  [[nodiscard]] SyntaxReporter& reporter() { return reporter_; }

  // The text from the current token on; after its end, the end of the file.
  [[nodiscard]] const Lexeme& token(size_t k = 0) const {
    return in_[std::min(at_ + k, in_.size() - 1)];
  }
  [[nodiscard]] uint32_t type(size_t k = 0) const { return token(k).type; }
  [[nodiscard]] std::string_view text(size_t k = 0) const { return source().text(token(k)); }
  /// In lower case.
  [[nodiscard]] std::string lower(size_t k = 0) const;
  /// Whether token `k` is `word`, which is in lower case, in any case. Of each name it is asked
  /// dozens of times: the length, which needs no text, refuses most.
  [[nodiscard]] bool says(size_t k, std::string_view word) const {
    const Lexeme& lexeme = token(k);
    return lexeme.end - lexeme.begin == word.size() && spells(lexeme, word);
  }
  [[nodiscard]] bool atEnd() const;
  /// Whether token `k` stands immediately after the token before it.
  [[nodiscard]] bool touches(size_t k) const;
  /// Whether only white space, or a comment, is on its line before token `k`.
  [[nodiscard]] bool startsLine(size_t k = 0) const;
  /// The number of tokens from the current one to the end of its line, or of a few hundred.
  [[nodiscard]] size_t tokensOfLine() const;
  /// The tokens from `first` on, `count` of them, as one of type `type`.
  [[nodiscard]] Lexeme whole(size_t first, size_t count, uint32_t type = 0) const;
  /// Their text.
  [[nodiscard]] std::string_view wholeText(size_t first, size_t count) const {
    return source().text(whole(first, count));
  }

  /// Whether a name is declared in the file, or has a type or a value in it.
  [[nodiscard]] bool isDeclared(std::string_view name);

  /// Whether a name is declared as a path, which encloses an area.
  [[nodiscard]] bool isArea(std::string_view name) const;

  // What was read, as repaired; 0 counts the last token.
  [[nodiscard]] uint32_t before(size_t k = 0) const {
    return k < out_.size() ? out_[out_.size() - 1 - k].type : 0;
  }
  [[nodiscard]] const Lexeme* lexemeBefore(size_t k = 0) const;
  /// Whether one of these types was read in the item at hand: since the word that began it, and not
  /// too far back.
  [[nodiscard]] bool hasRead(std::initializer_list<uint32_t> types) const;
  /// The last keyword that is neither an operator nor a value.
  [[nodiscard]] uint32_t keyword() const { return keyword_; }
  /// Whether values stand after that keyword.
  [[nodiscard]] bool readsValues() const;
  [[nodiscard]] const std::vector<OpenList>& open() const { return open_; }
  /// Whether `in` was read since the last keyword.
  [[nodiscard]] bool inRange() const { return in_range_; }
  /// Whether a case may begin here: right after `events` or `always`, or after a whole transition.
  [[nodiscard]] bool mayBeginCase() const { return case_may_begin_; }

  // What is read instead.
  void put(const Lexeme& lexeme);
  /// A token that is missing in the text.
  void insert(uint32_t type);
  /// Token `k` of the text is left out later, without a report.
  void leaveOut(size_t k) { left_out_.insert(at_ + k); }
  /// A token that is missing is inserted later, before token `k` of the text.
  void supplyBefore(size_t k, uint32_t type) { supplied_.emplace(at_ + k, type); }
  /// What was put is not what the text means: its names and types are not checked.
  void notAsMeant() { as_meant_ = false; }

  // For the walk over the text.
  bool skip();
  void advance(size_t tokens) { at_ += tokens; }
  [[nodiscard]] bool asMeant() const { return as_meant_; }
  std::vector<Lexeme> take() { return std::move(out_); }

 private:
  void follow(const Lexeme& lexeme);
  [[nodiscard]] bool spells(const Lexeme& lexeme, std::string_view word) const;
  [[nodiscard]] bool afterTransition() const;

  const std::vector<Lexeme>& in_;
  SyntaxReporter& reporter_;
  size_t at_ = 0;
  std::vector<Lexeme> out_;
  std::vector<OpenList> open_;
  std::set<size_t> left_out_;
  std::map<size_t, uint32_t> supplied_;
  std::optional<std::set<std::string_view>> declared_;  ///< once it was needed
  std::array<size_t, detail::kMostTypes>
      read_{};       ///< how many tokens were, with the last of a type
  size_t item_ = 0;  ///< how many tokens were read, with the word that began the item at hand
  uint32_t keyword_ = 0;
  bool in_range_ = false;
  bool case_may_begin_ = false;
  bool as_meant_ = true;
};

/// Recognises one kind of error at the current token, reports it and puts what was meant: the
/// number of tokens that it took, or 0 for none.
using PhraseRepair = size_t (*)(Phrase&);

/// What the first of `repairs` took that recognises its error, or 0.
size_t firstOf(Phrase& phrase, std::initializer_list<PhraseRepair> repairs);

/// Whether `count` tokens from `first` on can be one value, or one condition: no two values stand
/// next to each other, and every parenthesis is closed.
bool readsAsValue(const Phrase& phrase, size_t first, size_t count);

/// The tokens of the value that begins with token `first`: up to a comma or parenthesis that is not
/// its own, a keyword or a sign that no value contains; 0 if it is longer than any phrase.
/// `conditions` also ends it at `&&` and `||`.
size_t tokensOfValue(const Phrase& phrase, size_t first, bool conditions);

/// `20 m`, `-5 deg`, `1`: the tokens of a number with its unit from token `first` on; 0: there is
/// none.
size_t tokensOfNumber(const Phrase& phrase, size_t first);

/// The same, with a unit of several, `0.2 m/s`, or in several parts, `4 h 30 min`.
size_t tokensOfQuantity(const Phrase& phrase, size_t first);

/// The number of tokens of `words`, in lower case, from token `k` on; 0: there are others.
size_t tokensOfWords(const Phrase& phrase, size_t k, std::string_view words);

/// Those of the first of `words` that begins with token `k`.
size_t tokensOfOne(const Phrase& phrase, size_t k, std::span<const std::string_view> words);
inline size_t tokensOfOne(const Phrase& phrase, size_t k,
                          std::initializer_list<std::string_view> words) {
  return tokensOfOne(phrase, k, std::span(words.begin(), words.size()));
}

/// The tokens of `->`, `-->`, `=>`, `→` from token `k` on; 0: there is no arrow.
size_t tokensOfArrow(const Phrase& phrase, size_t k);

}  // namespace glider::frontend
