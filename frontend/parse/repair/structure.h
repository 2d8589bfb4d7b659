// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/blocks/indentation.h"
#include "frontend/parse/repair/repair.h"
#include "frontend/parse/repair/values.h"
#include "frontend/parse/reporter.h"
#include "frontend/parse/token_kinds.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// The last pass of repair: walks the tokens once, with the open blocks on a stack. Its definitions
/// are in structure.cpp (keywords, names and `begin`) and blocks.cpp.
class StructureRepair {
 public:
  StructureRepair(const std::vector<Lexeme>& in, bool cut, SyntaxReporter& reporter)
      : in_(in),
        cut_(cut),
        reporter_(reporter),
        source_(reporter.source()),
        values_(reporter, out_) {
    out_.reserve(in.size());
  }

  Repaired run();
  /// Whether something was read as what it may not mean: its names and types are not checked.
  [[nodiscard]] bool guessed() const { return values_.guessed() || undeclared_; }

 private:
  enum class BlockKind : uint8_t { Members, Do, If };
  struct Block {
    BlockKind kind;
    Lexeme opener;
    std::string what;        ///< "state `s1`"
    bool events = false;     ///< `events` was seen
    bool silent = false;     ///< already reported: a missing `end` is not reported again
    bool then = false;       ///< `then` was seen
    bool otherwise = false;  ///< `else` was seen
    bool leaves = false;     ///< a transition in one of its blocks was reported and left out
    bool begun = true;       ///< its `begin` was read, not only supplied
    size_t at = 0;           ///< the number of its opener in `in_`
    std::optional<UnendedBlock> unended = std::nullopt;  ///< in it, by the indentation
    bool doubtful = false;                               ///< an `end` in it may be its own
  };

  [[nodiscard]] uint32_t previous() const { return out_.empty() ? 0 : out_.back().type; }
  [[nodiscard]] const Lexeme& peek(size_t k) const;
  [[nodiscard]] bool comparesNext() const;
  void insert(uint32_t type);
  void step(Lexeme t);

  // --- what is written although nothing is said by it ---
  /// Whether `t` was left out.
  bool isSuperfluous(const Lexeme& t, bool keyword);
  /// Whether cases are read here.
  [[nodiscard]] bool inCases() const;
  /// The comma just written has nothing after it but keyword `t`.
  void dropComma(const Lexeme& t);
  /// `assume`, `share` and `vehicles` may also be names.
  [[nodiscard]] bool startsAssumption(const Lexeme& t) const;
  /// `choose NAME : …`, `prefer least …`: in a block these are nothing else.
  [[nodiscard]] bool startsChoice(const Lexeme& t) const;
  /// `place NAME = …`
  [[nodiscard]] bool declaresPlace(const Lexeme& t) const;

  // --- misspelled keywords ---
  /// If the name `t` is where only a keyword is possible and is spelled similarly, makes it that
  /// keyword.
  void correct(Lexeme& t);
  [[nodiscard]] std::string_view meantAtTop(const Lexeme& t) const;
  [[nodiscard]] std::string_view meantInBlock(const Lexeme& t) const;
  /// Where the name before this `=` is, which may have an index: `x[2] = 5`.
  [[nodiscard]] size_t assignedName() const;
  /// `x = 5` without `set` or `const`: the name before `t`, this `=`, begins a line.
  void supplyKeyword(const Lexeme& t);
  /// `:=`, which is reported only if nothing else is wrong there, as a keyword missing before it.
  [[nodiscard]] bool isColonEqual(const Lexeme& t) const;

  // --- names ---
  /// Reports a keyword, or nothing, where a name is expected. True if `t` was used as that name.
  bool becomesName(const Lexeme& t);
  /// If the token just written names a state or a behaviour, finds out whether `begin` follows,
  /// from `ahead` tokens on.
  void noteHeader(size_t ahead);
  /// How many tokens ahead the first token after a list of formals is, if one begins `k` tokens
  /// ahead.
  [[nodiscard]] size_t afterFormals(size_t k) const;
  /// `t` is where `begin` is expected. True if it was used as that.
  bool supplyBegin(const Lexeme& t);
  /// Whether a `begin` comes before the next state.
  [[nodiscard]] bool isBegunLater() const;
  /// Whether `t` is on another line than what was read before it.
  [[nodiscard]] bool onLaterLine(const Lexeme& t) const;

  // --- blocks ---
  void structural(const Lexeme& t);
  /// True if `t` may be kept outside all blocks.
  bool topLevel(const Lexeme& t);
  /// `flightprofile yo(…) begin`, not a use that is outside its state by mistyping.
  [[nodiscard]] bool definesBehaviour() const;
  bool outside(const Lexeme& t);
  bool openMembers(const Lexeme& t);
  /// The `begin` of a state whose header is wrong may come late: that has been reported.
  void secondBegin(const Lexeme& t);
  void open(BlockKind kind, const Lexeme& opener, std::string what);
  /// True if `t` may be kept inside the block on top.
  bool inBlock(const Lexeme& t);
  /// `if depth > 5 m set …`
  void wantThen(const Lexeme& t);
  bool insideMembers(const Lexeme& t);
  /// The block on top ends here: is that so by the indentation, if it is inside other actions?
  void noteEnd();
  /// Whether an `end` of the open block comes before the next state, so that `t` was written inside
  /// the block.
  [[nodiscard]] bool stillInside(const Lexeme& t) const;
  void wantEvents(const Lexeme& t);
  /// Where the line of `t` begins, if `t` is the first on it.
  [[nodiscard]] std::optional<uint32_t> beginOfLine(const Lexeme& t) const;
  /// The white space before the member above `t`, which begins its line; if there is none, before
  /// `t` itself.
  [[nodiscard]] std::string_view indentOfMembers(const Lexeme& t) const;
  /// Where the line after `t` begins, if `t` is the last on its line.
  [[nodiscard]] std::optional<uint32_t> lineAfter(const Lexeme& t) const;

  // --- transitions inside `if` and `for` ---
  /// Whether the transition at the current token is inside an `if` or `for` of a block: it stands
  /// deeper, or all blocks are closed after it, and the state goes on there.
  [[nodiscard]] bool leavesFromInside() const;
  [[nodiscard]] bool isEntry(const Block& block) const {
    return block.at > 0 && in_[block.at - 1].type == GliderLexer::ENTRY;
  }
  /// Whether `t` and `opener` begin their lines, and `t` stands deeper.
  [[nodiscard]] bool isDeeper(const Lexeme& t, const Lexeme& opener) const;
  /// Reports it, and leaves it out.
  void reportLeaving(const Lexeme& t);
  /// The tokens of the transition at the current token.
  [[nodiscard]] size_t tokensOfTransition() const;
  /// What must be so where the transition is, as the condition of a case: `warm && depth > 5 m`;
  /// empty: it is inside a loop, or it is too long to be shown.
  [[nodiscard]] std::string guardHere() const;
  /// The tokens from number `first` up to the first of type `type`, as text.
  [[nodiscard]] std::string_view textUpTo(size_t first, uint32_t type) const;
  /// A variable of that condition that is set on the way to it; empty: there is none.
  [[nodiscard]] std::string_view setBefore() const;
  /// The token with which the branch of an open block begins that is read now.
  [[nodiscard]] size_t branchOf(const Block& block) const;
  /// Whether the condition of an open `if` names it.
  [[nodiscard]] bool asksFor(std::string_view name) const;
  void closeActions(const Lexeme& found) { closeUntil(membersOpen(), found); }
  /// The number of blocks that are open around all actions.
  [[nodiscard]] size_t membersOpen() const;
  /// Where the missing `end` of `block` goes, if that is certain: before the next state, which
  /// begins its line, after the last line of the file, or before the transition that was written
  /// inside a `do` block.
  void supplyEnd(support::DiagnosticBuilder& report, const Block& block, const Lexeme& found);
  /// Whether what was read ends with a whole case.
  [[nodiscard]] bool endsWithTransition() const;
  /// The number of the `end` after the transition at the current token, if a case or another `end`
  /// follows it: the state is still open there. Otherwise 0.
  [[nodiscard]] size_t endAfterTransition() const;
  /// Closes the blocks above `keep`; each is reported as having no `end` before `found`.
  void closeUntil(size_t keep, const Lexeme& found);
  void reportUnended(const UnendedBlock& block);

  const std::vector<Lexeme>& in_;
  const bool cut_;
  SyntaxReporter& reporter_;
  const Source& source_;
  std::vector<Lexeme> out_;
  ValueRepair values_;
  size_t at_ = 0;
  bool ok_ = true;

  std::vector<Block> blocks_;
  std::string header_;  ///< "state `s1`" until its `begin`
  Lexeme header_at_;
  size_t read_from_ = 0;              ///< a transition before it was reported and left out
  bool transition_left_out_ = false;  ///< one of the case whose block was closed last
  size_t left_out_ = 0;               ///< an `end` that was reported where it was missing
  size_t begin_at_ = SIZE_MAX;        ///< where in `in_` a `begin` is expected but missing
  bool in_always_ = false;
  bool skipping_ = false;           ///< what follows is outside every state: up to the next item
  bool undeclared_ = false;         ///< a choice was left out: its uses would be reported
  bool skipping_in_block_ = false;  ///< or not allowed in a state: up to its next member
};

}  // namespace glider::frontend
