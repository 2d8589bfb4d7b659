// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The blocks that StructureRepair has open.

#include "frontend/parse/repair/structure.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <utility>

namespace glider::frontend {

void StructureRepair::structural(const Lexeme& t) {
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
  if (std::exchange(transition_left_out_, false) && !isTransition(t.type)) {
    insert(GliderLexer::STAY);
  }
  const bool promise = previous() == GliderLexer::REQUIRE;
  if (promise || (blocks_.empty() ? topLevel(t) : inBlock(t))) {
    out_.push_back(t);
  }
}

bool StructureRepair::topLevel(const Lexeme& t) {
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
    case GliderLexer::SAMPLE:
    case GliderLexer::ENTRY:
      return outside(t);
    case GliderLexer::DO:
      open(BlockKind::Do, t, "this `do`");
      return true;
    case GliderLexer::BEGIN:
      return openMembers(t);
    default:
      return !isBehaviourWord(t.type) || previous() == GliderLexer::EXTERN || definesBehaviour() ||
             outside(t);
  }
}

bool StructureRepair::definesBehaviour() const {
  return peek(afterFormals(2)).type == GliderLexer::BEGIN;
}

bool StructureRepair::outside(const Lexeme& t) {
  reporter_.at(t, support::diagnostics::outsideState, source_.text(t));
  skipping_ = true;
  return false;
}

bool StructureRepair::openMembers(const Lexeme& t) {
  if (header_.empty()) {
    reporter_.at(t, support::diagnostics::secondBegin)
        .hint("write `state` and a name before it, or delete it");
    return false;
  }
  open(BlockKind::Members, header_at_, header_);
  header_.clear();
  return true;
}

void StructureRepair::secondBegin(const Lexeme& t) {
  Block& block = blocks_.back();
  if (!block.begun) {
    block.begun = true;
    return;
  }
  reporter_.at(t, support::diagnostics::secondBegin).fix(source_.range(t), "");
}

void StructureRepair::open(BlockKind kind, const Lexeme& opener, std::string what) {
  blocks_.push_back({kind, opener, std::move(what)});
  blocks_.back().at = at_;
  if (blocks_.size() > kDeepestNesting) {
    reporter_.at(opener, support::diagnostics::nestedTooDeep, kDeepestNesting, "blocks");
    ok_ = false;
  }
}

bool StructureRepair::inBlock(const Lexeme& t) {
  if (startsItem(t.type) || t.type == kEof) {
    if (stillInside(t)) {
      reporter_.at(t, support::diagnostics::insideState, source_.text(t), blocks_.front().what);
      skipping_in_block_ = true;
      return false;
    }
    closeUntil(0, t);
    return topLevel(t);
  }
  if (isTransition(t.type) && leavesFromInside()) {
    reportLeaving(t);
    return false;
  }
  if (startsMember(t.type) || isTransition(t.type) || t.type == GliderLexer::CASE) {
    closeActions(t);
    if (blocks_.empty()) {
      return topLevel(t);
    }
  }
  return insideMembers(t);
}

void StructureRepair::wantThen(const Lexeme& t) {
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

bool StructureRepair::insideMembers(const Lexeme& t) {
  wantThen(t);
  switch (t.type) {
    case GliderLexer::END:
      noteEnd();
      transition_left_out_ = blocks_.back().leaves && !isEntry(blocks_.back());
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
    case GliderLexer::ELSE:
      blocks_.back().otherwise = true;
      return true;
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

void StructureRepair::noteEnd() {
  const size_t keep = membersOpen();
  if (keep + 1 >= blocks_.size() || blocks_[keep].unended) {
    return;
  }
  Block& outer = blocks_[keep];
  EndOfBlock found = endByIndentation(source_, in_, outer.at, blocks_.back().at, at_);
  outer.doubtful = outer.doubtful || !found.sure;
  outer.unended = std::move(found.unended);
}

bool StructureRepair::stillInside(const Lexeme& t) const {
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

void StructureRepair::wantEvents(const Lexeme& t) {
  if (!blocks_.back().events) {
    auto report = reporter_.at(t, support::diagnostics::caseOutsideEvents);
    if (const auto begin = beginOfLine(t)) {
      report.fix({source_.file, *begin, *begin}, fmt::format("{}events\n", indentOfMembers(t)));
    } else {
      report.fix({source_.file, t.begin, t.begin}, "events ");
    }
    insert(GliderLexer::EVENTS);
    blocks_.back().events = true;
  }
}

std::string_view StructureRepair::indentOfMembers(const Lexeme& t) const {
  const Lexeme* neighbour = &t;
  for (size_t n = out_.size(); n > 0 && out_[n - 1].type != GliderLexer::BEGIN; --n) {
    if (startsMember(out_[n - 1].type) && beginOfLine(out_[n - 1])) {
      neighbour = &out_[n - 1];
      break;
    }
  }
  return source_.text({0, *beginOfLine(*neighbour), neighbour->begin});
}

std::optional<uint32_t> StructureRepair::beginOfLine(const Lexeme& t) const {
  const std::string_view before = source_.text().substr(0, t.begin);
  const size_t last = before.find_last_not_of(" \t");
  const bool first = last == std::string_view::npos || before[last] == '\n';
  return first ? std::optional(static_cast<uint32_t>(last + 1)) : std::nullopt;  // npos + 1 is 0
}

size_t StructureRepair::membersOpen() const {
  size_t keep = blocks_.size();
  while (keep > 0 && blocks_[keep - 1].kind != BlockKind::Members) {
    --keep;
  }
  return keep;
}

void StructureRepair::supplyEnd(support::DiagnosticBuilder& report, const Block& block,
                                const Lexeme& found) {
  const uint32_t place = found.begin;
  if (block.kind == BlockKind::Members && block.begun && blocks_.size() == 1 &&
      found.type == kEof && endsWithTransition() &&
      beginOfLine(block.opener) == block.opener.begin) {
    if (const auto line = lineAfter(out_.back())) {
      report.fix({source_.file, *line, *line}, "end\n");
    }
  }
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

std::optional<uint32_t> StructureRepair::lineAfter(const Lexeme& t) const {
  const std::string_view text = source_.text();
  const size_t line = text.find('\n', t.end);
  if (line == std::string_view::npos) {
    return std::nullopt;  // the file may be cut off there
  }
  const std::string_view rest = text.substr(t.end, line - t.end);
  const size_t word = rest.find_first_not_of(" \t\r");
  const bool comment = word != std::string_view::npos && rest[word] == '#';
  return word == std::string_view::npos || comment ? std::optional(static_cast<uint32_t>(line + 1))
                                                   : std::nullopt;
}

bool StructureRepair::endsWithTransition() const {
  const size_t n = out_.size();
  const auto at = [&](size_t k) { return k < n ? out_[n - 1 - k].type : 0; };
  return oneOf(at(0), {GliderLexer::RETURN, GliderLexer::EXIT, GliderLexer::STAY}) ||
         (isAnyName(at(0)) && oneOf(at(1), {GliderLexer::GOTO, GliderLexer::CALL}));
}

size_t StructureRepair::endAfterTransition() const {
  const bool leads = oneOf(peek(0).type, {GliderLexer::GOTO, GliderLexer::CALL});
  const size_t k = leads ? afterFormals(2) : 1;
  const bool extra = peek(k).type == GliderLexer::END &&
                     oneOf(peek(k + 1).type, {GliderLexer::CASE, GliderLexer::END});
  return extra ? at_ + k : 0;
}

void StructureRepair::closeUntil(size_t keep, const Lexeme& found) {
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

void StructureRepair::reportUnended(const UnendedBlock& block) {
  auto report = reporter_.at(block.before, support::diagnostics::missingEnd, block.what,
                             describe(source_, block.before));
  report.note(source_.range(block.opener), block.what + " begins here");
  report.fix({source_.file, block.place, block.place}, block.text);
}

}  // namespace glider::frontend
