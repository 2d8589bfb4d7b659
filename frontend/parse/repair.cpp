// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair.h"

#include "frontend/parse/blocks/indentation.h"
#include "frontend/parse/foreign_characters.h"
#include "frontend/parse/phrases/phrases.h"
#include "frontend/parse/phrases/unit_names.h"
#include "frontend/parse/repair_names.h"
#include "frontend/parse/repair_superfluous.h"
#include "frontend/parse/repair_values.h"
#include "frontend/parse/repair_words.h"
#include "frontend/parse/token_kinds.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::frontend {

namespace {

std::string nameOwner(uint32_t keyword) {
  switch (keyword) {
    case GliderLexer::MISSION:
      return "the mission";
    case GliderLexer::PLATFORM:
      return "the platform";
    case GliderLexer::FLIGHTPROFILE:
      return "a flightprofile";
    case GliderLexer::FLIGHTROUTE:
      return "a flightroute";
    case GliderLexer::CONST:
      return "a constant";
    case GliderLexer::PARAM:
      return "a parameter";
    case GliderLexer::VAR:
    case GliderLexer::SET:
      return "a variable";
    default:
      return "a state";
  }
}

/// Was keyword `t`, after `before` and before `next`, meant as a name? If not, the name is missing.
bool meantAsName(uint32_t before, uint32_t t, uint32_t next) {
  switch (before) {
    case GliderLexer::STATE:
      return next == GliderLexer::BEGIN || next == GliderLexer::LPAREN;
    case GliderLexer::GOTO:
    case GliderLexer::CALL:
      return oneOf(next, {GliderLexer::CASE, GliderLexer::END, GliderLexer::LPAREN});
    case GliderLexer::MISSION:
    case GliderLexer::PLATFORM:
      return !startsItem(t) || startsItem(next);
    case GliderLexer::FLIGHTPROFILE:
    case GliderLexer::FLIGHTROUTE:
      return next == GliderLexer::LPAREN;
    default:
      return oneOf(next, {GliderLexer::ASSIGN, GliderLexer::EQ, GliderLexer::COLON});
  }
}

/// The second pass of repair: walks the tokens once, with the open blocks on a stack.
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

  Repaired run() {
    for (at_ = 0; at_ < in_.size() && ok_; ++at_) {
      if (at_ != left_out_ || at_ == 0) {
        step(in_[at_]);
      }
      ok_ = ok_ && !reporter_.full();
    }
    return {std::move(out_), ok_};
  }

 private:
  enum class BlockKind : uint8_t { Members, Do, If };
  struct Block {
    BlockKind kind;
    Lexeme opener;
    std::string what;     ///< "state `s1`"
    bool events = false;  ///< `events` was seen
    bool silent = false;  ///< already reported: a missing `end` is not reported again
    bool then = false;    ///< `then` was seen
    bool begun = true;    ///< its `begin` was read, not only supplied
    size_t at = 0;        ///< the number of its opener in `in_`
    std::optional<UnendedBlock> unended = std::nullopt;  ///< in it, by the indentation
    bool doubtful = false;                               ///< an `end` in it may be its own
  };

  [[nodiscard]] uint32_t previous() const { return out_.empty() ? 0 : out_.back().type; }
  [[nodiscard]] const Lexeme& peek(size_t k) const {
    return in_[std::min(at_ + k, in_.size() - 1)];
  }
  void insert(uint32_t type) {
    const uint32_t place = out_.empty() ? 0 : out_.back().end;
    out_.push_back({type, place, place});
  }

  void step(Lexeme t) {
    const bool skipping = skipping_ || skipping_in_block_;
    if (!skipping && (t.type == GliderLexer::NAME || t.type == GliderLexer::SENSOR) &&
        at_ != begin_at_ && !values_.inParentheses()) {
      correct(t);
    }
    const bool keyword =
        t.type == kEof ||
        (isHardKeyword(t.type) &&
         !oneOf(t.type, {GliderLexer::TRUE, GliderLexer::FALSE, GliderLexer::NOT_WORD}));
    if (!skipping && isSuperfluous(t, keyword)) {
      return;
    }
    if (keyword && wantsName(previous()) && !skipping && becomesName(t)) {
      return;
    }
    if (at_ == begin_at_ && supplyBegin(t)) {
      return;
    }
    if (keyword) {
      structural(t);
    } else if (!skipping && (declaresPlace(t) || startsAssumption(t))) {
      values_.keyword(t);
      out_.push_back(t);
    } else if (!skipping) {
      if (t.type == GliderLexer::ASSIGN) {
        supplyKeyword();
      }
      ok_ = values_.take(t, peek(1)) && ok_;
      noteHeader(1);
    }
  }

  // --- what is written although nothing is said by it ---

  /// Whether `t` was left out.
  bool isSuperfluous(const Lexeme& t, bool keyword) {
    const bool in_condition = inCases() && !values_.inParentheses();
    const std::string where = superfluousWhere({source_, out_, peek(1), in_condition, keyword}, t);
    if (!where.empty()) {
      reporter_.at(t, support::diagnostics::superfluousWord, source_.text(t), where)
          .fix(source_.range(t), "");
      return true;
    }
    if (keyword && previous() == GliderLexer::COMMA && !values_.inParentheses()) {
      dropComma(t);
    }
    return false;
  }

  /// Whether cases are read here.
  [[nodiscard]] bool inCases() const {
    return blocks_.empty() ? in_always_
                           : blocks_.back().kind == BlockKind::Members && blocks_.back().events;
  }

  /// The comma just written has nothing after it but keyword `t`.
  void dropComma(const Lexeme& t) {
    const Lexeme comma = out_.back();
    auto report = reporter_.at(comma, support::diagnostics::trailingComma, describe(source_, t));
    const bool leads = isTransition(t.type) || t.type == GliderLexer::DO;
    if (values_.inSensors() || (inCases() && leads)) {
      report.fix(source_.range(comma), "");
    }
    out_.pop_back();
  }

  /// `assume`, `share` and `vehicles` may also be names.
  [[nodiscard]] bool startsAssumption(const Lexeme& t) const {
    const bool names = t.type == GliderLexer::VEHICLES && isAnyName(peek(1).type);
    return (names || oneOf(t.type, {GliderLexer::ASSUME, GliderLexer::SHARE})) && blocks_.empty() &&
           endsValue(previous());
  }

  /// `place NAME = …`
  [[nodiscard]] bool declaresPlace(const Lexeme& t) const {
    return t.type == GliderLexer::PLACE && blocks_.empty() && isAnyName(peek(1).type) &&
           oneOf(peek(2).type, {GliderLexer::ASSIGN, GliderLexer::EQ});
  }

  // --- misspelled keywords ---

  /// If the name `t` is where only a keyword is possible and is spelled similarly, makes it that
  /// keyword.
  void correct(Lexeme& t) {
    const bool possible =
        out_.empty() || endsValue(previous()) || isTransition(previous()) ||
        oneOf(previous(), {GliderLexer::BEGIN, GliderLexer::END, GliderLexer::EVENTS});
    if (!possible || previous() == GliderLexer::GOTO || previous() == GliderLexer::CALL) {
      return;
    }
    const std::string_view word = blocks_.empty() ? meantAtTop(t) : meantInBlock(t);
    if (!word.empty()) {
      auto report = reporter_.at(t, support::diagnostics::misspelledKeyword, source_.text(t), word);
      if (isSlip(source_.text(t), word)) {
        report.fix(source_.range(t), std::string(word));
      }
      t.type = keywordType(word);
    }
  }

  [[nodiscard]] std::string_view meantAtTop(const Lexeme& t) const {
    if (!isAnyName(peek(1).type) || peek(afterFormals(2)).type != GliderLexer::BEGIN) {
      return {};
    }
    const std::string_view near =
        closest(source_.text(t), {"state", "flightprofile", "flightroute"});
    return near.empty() ? "state" : near;
  }

  [[nodiscard]] std::string_view meantInBlock(const Lexeme& t) const {
    const std::string_view word = source_.text(t);
    const uint32_t next = peek(1).type;
    auto near = [&](std::string_view keyword) { return closest(word, {keyword}) == keyword; };
    const bool leaves = startsItem(next) || startsMember(next) || isTransition(next) ||
                        oneOf(next, {kEof, GliderLexer::END, GliderLexer::CASE});
    if (leaves && near("end")) {
      return "end";
    }
    if (blocks_.back().kind != BlockKind::Members) {
      return {};
    }
    if (next == GliderLexer::CASE && near("events")) {
      return "events";
    }
    if (next == GliderLexer::DO && near("entry")) {
      return "entry";
    }
    if (blocks_.back().events && near("case") && (startsValue(next) || next == GliderLexer::NOT)) {
      return "case";
    }
    return isAnyName(next) ? closest(word, {"flightroute", "flightprofile", "sensors"})
                           : std::string_view{};
  }

  /// Where the name before this `=` is, which may have an index: `x[2] = 5`.
  [[nodiscard]] size_t assignedName() const {
    size_t at = out_.size() - 1;
    if (out_[at].type == GliderLexer::RBRACKET) {
      while (at > 1 && out_[at].type != GliderLexer::LBRACKET) {
        --at;
      }
      --at;
    }
    return at;
  }

  /// `x = 5` without `set` or `const`: the name before this `=` begins a line.
  void supplyKeyword() {
    const size_t at = out_.empty() ? 0 : assignedName();
    if (out_.empty() || !isName(out_[at].type) || values_.inParentheses()) {
      return;
    }
    const uint32_t before = at == 0 ? uint32_t{GliderLexer::END} : out_[at - 1].type;
    const bool action = !blocks_.empty() && blocks_.back().kind != BlockKind::Members;
    const bool begins = endsValue(before) || oneOf(before, {GliderLexer::END, GliderLexer::DO,
                                                            GliderLexer::THEN, GliderLexer::ELSE});
    const bool indexed = at + 1 < out_.size();
    if (!begins || before == GliderLexer::PLACE || (!action && (indexed || !blocks_.empty()))) {
      return;
    }
    const Lexeme name{out_[at].type, out_[at].begin, out_.back().end};
    const std::string_view keyword = action ? "set" : "const";
    reporter_.at(name, support::diagnostics::missingKeyword, source_.text(name), keyword)
        .fix({source_.file, name.begin, name.begin}, std::string(keyword) + " ");
    const Lexeme supplied{keywordType(keyword), name.begin, name.begin};
    values_.keyword(supplied);
    out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(at), supplied);
  }

  // --- names ---

  /// Reports a keyword, or nothing, where a name is expected. True if `t` was used as that name.
  bool becomesName(const Lexeme& t) {
    const uint32_t before = previous();
    const bool name = t.type != kEof && meantAsName(before, t.type, peek(1).type);
    if (name) {
      reporter_.at(t, support::diagnostics::keywordAsName, source_.text(t));
      out_.push_back({GliderLexer::NAME, t.begin, t.end});
    } else {
      reporter_.at(t, support::diagnostics::missingName, nameOwner(before),
                   source_.text(out_.back()), describe(source_, t));
      insert(GliderLexer::NAME);
    }
    noteHeader(name ? 1 : 0);
    return name;
  }

  /// If the token just written names a state or a behaviour, finds out whether `begin` follows,
  /// from `ahead` tokens on.
  void noteHeader(size_t ahead) {
    const size_t n = out_.size();
    if (n < 2 || !isAnyName(out_[n - 1].type)) {
      return;
    }
    const Lexeme& keyword = out_[n - 2];
    const bool defines = isBehaviourWord(keyword.type) && blocks_.empty() &&
                         (n < 3 || out_[n - 3].type != GliderLexer::EXTERN);
    if (keyword.type != GliderLexer::STATE && !defines) {
      return;
    }
    const std::string_view name = source_.text(out_[n - 1]);
    header_ = std::string(source_.text(keyword)) + (name.empty() ? "" : fmt::format(" `{}`", name));
    header_at_ = {keyword.type, keyword.begin, out_[n - 1].end};
    const size_t k = afterFormals(ahead);
    begin_at_ = peek(k).type == GliderLexer::BEGIN ? SIZE_MAX : std::min(at_ + k, in_.size() - 1);
  }

  /// How many tokens ahead the first token after a list of formals is, if one begins `k` tokens
  /// ahead.
  [[nodiscard]] size_t afterFormals(size_t k) const {
    if (peek(k).type != GliderLexer::LPAREN) {
      return k;
    }
    while (!oneOf(peek(k).type, {GliderLexer::RPAREN, kEof}) && !isHardKeyword(peek(k).type)) {
      ++k;
    }
    return peek(k).type == GliderLexer::RPAREN ? k + 1 : k;
  }

  /// `t` is where `begin` is expected. True if it was used as that.
  bool supplyBegin(const Lexeme& t) {
    begin_at_ = SIZE_MAX;
    const bool misspelled =
        t.type == GliderLexer::NAME && closest(source_.text(t), {"begin"}) == "begin";
    if (t.type == kEof && header_at_.end == out_.back().begin) {
      // The file ends before the name.
    } else if (misspelled) {
      auto report =
          reporter_.at(t, support::diagnostics::misspelledKeyword, source_.text(t), "begin");
      if (isSlip(source_.text(t), "begin")) {
        report.fix(source_.range(t), "begin");
      }
    } else {
      auto report =
          reporter_.at(t, support::diagnostics::missingBegin, header_, describe(source_, t));
      report.note(source_.range(header_at_), header_ + " is named here");
      if (startsMember(t.type) && !isBegunLater()) {
        const uint32_t end = out_.back().end;
        report.fix({source_.file, end, end}, onLaterLine(t) ? "\nbegin" : " begin");
      }
    }
    values_.keyword({GliderLexer::BEGIN, t.begin, t.begin});
    open(BlockKind::Members, header_at_, header_);
    blocks_.back().silent = !misspelled && (t.type == kEof || startsItem(t.type));
    header_.clear();
    blocks_.back().begun = misspelled;
    insert(GliderLexer::BEGIN);
    return misspelled;
  }

  /// Whether a `begin` comes before the next state.
  [[nodiscard]] bool isBegunLater() const {
    constexpr size_t kFarthest = 1000;
    size_t k = 0;
    while (k < kFarthest && !startsItem(peek(k).type) &&
           !oneOf(peek(k).type, {GliderLexer::BEGIN, kEof})) {
      ++k;
    }
    return peek(k).type == GliderLexer::BEGIN;
  }

  /// Whether `t` is on another line than what was read before it.
  [[nodiscard]] bool onLaterLine(const Lexeme& t) const {
    const uint32_t from = out_.empty() ? 0 : out_.back().end;
    return source_.text().substr(from, t.begin - from).find('\n') != std::string_view::npos;
  }

  // --- blocks ---

  void structural(const Lexeme& t) {
    values_.keyword(t);
    if (skipping_ && !(startsItem(t.type) || t.type == kEof)) {
      return;
    }
    skipping_ = false;
    if (skipping_in_block_ &&
        !(startsMember(t.type) || oneOf(t.type, {GliderLexer::END, GliderLexer::STATE, kEof}))) {
      return;
    }
    skipping_in_block_ = false;
    const bool promise = previous() == GliderLexer::REQUIRE;
    if (promise || (blocks_.empty() ? topLevel(t) : inBlock(t))) {
      out_.push_back(t);
    }
  }

  /// True if `t` may be kept outside all blocks.
  bool topLevel(const Lexeme& t) {
    const bool partOfCase =
        isTransition(t.type) || oneOf(t.type, {GliderLexer::CASE, GliderLexer::DO});
    in_always_ = t.type == GliderLexer::ALWAYS || (in_always_ && partOfCase);
    switch (t.type) {
      case GliderLexer::END:
        reporter_.at(t, support::diagnostics::strayEnd).fix(source_.range(t), "");
        return false;
      case GliderLexer::CASE:
        return in_always_ || outside(t);
      case GliderLexer::EVENTS:
      case GliderLexer::SENSORS:
      case GliderLexer::ENTRY:
        return outside(t);
      case GliderLexer::DO:
        open(BlockKind::Do, t, "this `do`");
        return true;
      case GliderLexer::BEGIN:
        return openMembers(t);
      default:
        return !isBehaviourWord(t.type) || previous() == GliderLexer::EXTERN ||
               definesBehaviour() || outside(t);
    }
  }

  /// `flightprofile yo(…) begin`, not a use that is outside its state by mistyping.
  [[nodiscard]] bool definesBehaviour() const {
    return peek(afterFormals(2)).type == GliderLexer::BEGIN;
  }

  bool outside(const Lexeme& t) {
    reporter_.at(t, support::diagnostics::outsideState, source_.text(t));
    skipping_ = true;
    return false;
  }

  bool openMembers(const Lexeme& t) {
    if (header_.empty()) {
      reporter_.at(t, support::diagnostics::secondBegin)
          .hint("write `state` and a name before it, or delete it");
      return false;
    }
    open(BlockKind::Members, header_at_, header_);
    header_.clear();
    return true;
  }

  /// The `begin` of a state whose header is wrong may come late: that has been reported.
  void secondBegin(const Lexeme& t) {
    Block& block = blocks_.back();
    if (!block.begun) {
      block.begun = true;
      return;
    }
    reporter_.at(t, support::diagnostics::secondBegin).fix(source_.range(t), "");
  }

  void open(BlockKind kind, const Lexeme& opener, std::string what) {
    blocks_.push_back({kind, opener, std::move(what)});
    blocks_.back().at = at_;
    if (blocks_.size() > kDeepestNesting) {
      reporter_.at(opener, support::diagnostics::nestedTooDeep, kDeepestNesting, "blocks");
      ok_ = false;
    }
  }

  /// True if `t` may be kept inside the block on top.
  bool inBlock(const Lexeme& t) {
    if (startsItem(t.type) || t.type == kEof) {
      if (stillInside(t)) {
        reporter_.at(t, support::diagnostics::insideState, source_.text(t), blocks_.front().what);
        skipping_in_block_ = true;
        return false;
      }
      closeUntil(0, t);
      return topLevel(t);
    }
    if (startsMember(t.type) || isTransition(t.type) || t.type == GliderLexer::CASE) {
      closeActions(t);
      if (blocks_.empty()) {
        return topLevel(t);
      }
    }
    return insideMembers(t);
  }

  /// `if depth > 5 m set …`
  void wantThen(const Lexeme& t) {
    Block& block = blocks_.back();
    if (block.kind != BlockKind::If || block.then) {
      return;
    }
    block.then = true;
    if (t.type != GliderLexer::THEN) {
      auto report =
          reporter_.at(t, support::diagnostics::unexpectedToken, "`then`", describe(source_, t));
      report.hint("write `then` after the condition");
      if (oneOf(t.type, {GliderLexer::SET, GliderLexer::LOG}) && endsValue(previous())) {
        report.fix({source_.file, t.begin, t.begin}, "then ");
      }
      insert(GliderLexer::THEN);
    }
  }

  bool insideMembers(const Lexeme& t) {
    wantThen(t);
    switch (t.type) {
      case GliderLexer::END:
        noteEnd();
        blocks_.pop_back();
        return true;
      case GliderLexer::DO:
        open(BlockKind::Do, t, "this `do`");
        return true;
      case GliderLexer::IF:
        open(BlockKind::If, t, "this `if`");
        return true;
      case GliderLexer::BEGIN:
        secondBegin(t);
        return false;
      case GliderLexer::EVENTS:
        blocks_.back().events = true;
        return true;
      case GliderLexer::CASE:
        wantEvents(t);
        return true;
      default:
        return true;
    }
  }

  /// The block on top ends here: is that so by the indentation, if it is inside other actions?
  void noteEnd() {
    const size_t keep = membersOpen();
    if (keep + 1 >= blocks_.size() || blocks_[keep].unended) {
      return;
    }
    Block& outer = blocks_[keep];
    EndOfBlock found = endByIndentation(source_, in_, outer.at, blocks_.back().at, at_);
    outer.doubtful = outer.doubtful || !found.sure;
    outer.unended = std::move(found.unended);
  }

  /// Whether an `end` of the open block comes before the next state, so that `t` was written inside
  /// the block.
  [[nodiscard]] bool stillInside(const Lexeme& t) const {
    constexpr size_t kFarthest = 1000;
    if (t.type == GliderLexer::STATE || t.type == kEof) {
      return false;
    }
    size_t deep = 0;
    for (size_t k = 1; k < kFarthest; ++k) {
      const uint32_t type = peek(k).type;
      if (type == GliderLexer::END && deep == 0) {
        return true;
      }
      if (type == kEof || type == GliderLexer::STATE) {
        return false;
      }
      deep += oneOf(type, {GliderLexer::BEGIN, GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
      deep -= type == GliderLexer::END ? 1U : 0U;
    }
    return false;
  }

  void wantEvents(const Lexeme& t) {
    if (!blocks_.back().events) {
      reporter_.at(t, support::diagnostics::caseOutsideEvents)
          .fix({source_.file, t.begin, t.begin}, "events ");
      insert(GliderLexer::EVENTS);
      blocks_.back().events = true;
    }
  }

  void closeActions(const Lexeme& found) { closeUntil(membersOpen(), found); }

  /// The number of blocks that are open around all actions.
  [[nodiscard]] size_t membersOpen() const {
    size_t keep = blocks_.size();
    while (keep > 0 && blocks_[keep - 1].kind != BlockKind::Members) {
      --keep;
    }
    return keep;
  }

  /// Where the missing `end` of `block` goes, if that is certain: before the next state, which
  /// begins its line, or before the transition that was written inside a `do` block.
  void supplyEnd(support::DiagnosticBuilder& report, const Block& block, const Lexeme& found) {
    const uint32_t place = found.begin;
    if (block.kind == BlockKind::Members && block.begun && blocks_.size() == 1 &&
        startsItem(found.type) && endsWithTransition()) {
      const bool first = place == 0 || source_.text()[place - 1] == '\n';
      if (first) {
        report.fix({source_.file, place, place}, "end\n\n");
      }
    }
    if (block.kind == BlockKind::Do && startsMember(found.type) && endsValue(previous())) {
      const uint32_t end = out_.back().end;  // of `entry`: a member is in no block
      report.fix({source_.file, end, end}, " end");
    }
    if (block.kind == BlockKind::Do && isTransition(found.type)) {
      report.fix({source_.file, place, place}, "end ");
      if (const size_t extra = endAfterTransition(); extra != 0) {
        report.fix(source_.range(in_[extra]), "");
        left_out_ = extra;
      }
    }
  }

  /// Whether what was read ends with a whole case.
  [[nodiscard]] bool endsWithTransition() const {
    const size_t n = out_.size();
    const auto at = [&](size_t k) { return k < n ? out_[n - 1 - k].type : 0; };
    return oneOf(at(0), {GliderLexer::RETURN, GliderLexer::EXIT, GliderLexer::STAY}) ||
           (isAnyName(at(0)) && oneOf(at(1), {GliderLexer::GOTO, GliderLexer::CALL}));
  }

  /// The number of the `end` after the transition at the current token, if a case or another `end`
  /// follows it: the state is still open there. Otherwise 0.
  [[nodiscard]] size_t endAfterTransition() const {
    const bool leads = oneOf(peek(0).type, {GliderLexer::GOTO, GliderLexer::CALL});
    const size_t k = leads ? afterFormals(2) : 1;
    const bool extra = peek(k).type == GliderLexer::END &&
                       oneOf(peek(k + 1).type, {GliderLexer::CASE, GliderLexer::END});
    return extra ? at_ + k : 0;
  }

  /// Closes the blocks above `keep`; each is reported as having no `end` before `found`.
  void closeUntil(size_t keep, const Lexeme& found) {
    while (blocks_.size() > keep) {
      const Block& block = blocks_.back();
      if (!cut_ && !block.silent && blocks_.size() == keep + 1 && block.unended) {
        reportUnended(*block.unended);
      } else if (!cut_ && !block.silent) {
        auto report = reporter_.at(found, support::diagnostics::missingEnd, block.what,
                                   describe(source_, found));
        report.note(source_.range(block.opener), block.what + " begins here");
        if (blocks_.size() == keep + 1 && !block.doubtful) {
          supplyEnd(report, block, found);
        }
      }
      insert(GliderLexer::END);
      blocks_.pop_back();
    }
  }

  void reportUnended(const UnendedBlock& block) {
    auto report = reporter_.at(block.before, support::diagnostics::missingEnd, block.what,
                               describe(source_, block.before));
    report.note(source_.range(block.opener), block.what + " begins here");
    report.fix({source_.file, block.place, block.place}, block.text);
  }

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
  size_t left_out_ = 0;         ///< an `end` that was reported where it was missing
  size_t begin_at_ = SIZE_MAX;  ///< where in `in_` a `begin` is expected but missing
  bool in_always_ = false;
  bool skipping_ = false;  ///< what follows is outside every state: up to the next item
  bool skipping_in_block_ =
      false;  ///< what follows is not allowed in a state: up to its next member
};

}  // namespace

Repaired repair(const std::vector<Lexeme>& lexemes, SyntaxReporter& reporter) {
  const Source& source = reporter.source();
  const Rephrased phrases =
      repairPhrases(separateForeign(nameDeclaredUnits(lexemes, source), source), reporter);
  WordRepair words(reporter);
  NameRepair names(reporter);
  const std::vector<Lexeme> clean = names.run(words.run(phrases.lexemes));
  Repaired repaired = StructureRepair(clean, words.cut(), reporter).run();
  repaired.named = !names.guessed() && phrases.as_meant;
  repaired.parseable = repaired.parseable && !words.cut();
  return repaired;
}

}  // namespace glider::frontend
