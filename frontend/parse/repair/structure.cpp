// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/parse/repair/structure.h"

#include "frontend/parse/repair/superfluous.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <utility>

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

}  // namespace

Repaired StructureRepair::run() {
  for (at_ = 0; at_ < in_.size() && ok_; ++at_) {
    if (at_ >= read_from_ && (at_ != left_out_ || at_ == 0)) {
      step(in_[at_]);
    }
    ok_ = ok_ && !reporter_.full();
  }
  return {std::move(out_), ok_};
}

const Lexeme& StructureRepair::peek(size_t k) const {
  return in_[std::min(at_ + k, in_.size() - 1)];
}

void StructureRepair::insert(uint32_t type) {
  const uint32_t place = out_.empty() ? 0 : out_.back().end;
  out_.push_back({type, place, place});
}

void StructureRepair::step(Lexeme t) {
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
  if (!skipping && !blocks_.empty() && startsChoice(t)) {
    reporter_.at(t, support::diagnostics::insideState, source_.text(t), blocks_.front().what);
    skipping_in_block_ = true;
    undeclared_ = true;
    return;
  }
  if (keyword) {
    structural(t);
  } else if (!skipping && (declaresPlace(t) || startsAssumption(t))) {
    values_.keyword(t);
    out_.push_back(t);
  } else if (!skipping) {
    const size_t reported = reporter_.count();
    if (t.type == GliderLexer::ASSIGN) {
      supplyKeyword(t);
    }
    ok_ = values_.take(t, peek(1)) && ok_;
    if (t.type == GliderLexer::ASSIGN && isColonEqual(t) && reporter_.count() == reported) {
      reporter_.at(t, support::diagnostics::wordOperator, source_.text(t), "=")
          .fix(source_.range(t), "=");
    }
    noteHeader(1);
  }
}

bool StructureRepair::isSuperfluous(const Lexeme& t, bool keyword) {
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

bool StructureRepair::inCases() const {
  return blocks_.empty() ? in_always_
                         : blocks_.back().kind == BlockKind::Members && blocks_.back().events;
}

void StructureRepair::dropComma(const Lexeme& t) {
  const Lexeme comma = out_.back();
  auto report = reporter_.at(comma, support::diagnostics::trailingComma, describe(source_, t));
  const bool leads = isTransition(t.type) || t.type == GliderLexer::DO;
  if (values_.inSensors() || (inCases() && leads)) {
    report.fix(source_.range(comma), "");
  }
  out_.pop_back();
}

bool StructureRepair::startsChoice(const Lexeme& t) const {
  const bool choice = t.type == GliderLexer::CHOOSE && isAnyName(peek(1).type) &&
                      peek(2).type == GliderLexer::COLON;
  return choice ||
         (t.type == GliderLexer::PREFER &&
          oneOf(peek(1).type, {GliderLexer::LEAST, GliderLexer::GREATEST, GliderLexer::ENDURANCE}));
}

bool StructureRepair::startsAssumption(const Lexeme& t) const {
  const bool names = t.type == GliderLexer::VEHICLES && isAnyName(peek(1).type);
  const bool prefers =
      t.type == GliderLexer::PREFER &&
      oneOf(peek(1).type, {GliderLexer::LEAST, GliderLexer::GREATEST, GliderLexer::ENDURANCE});
  return (names || prefers || oneOf(t.type, {GliderLexer::ASSUME, GliderLexer::SHARE})) &&
         blocks_.empty() && endsValue(previous());
}

bool StructureRepair::declaresPlace(const Lexeme& t) const {
  const bool place =
      t.type == GliderLexer::PLACE && oneOf(peek(2).type, {GliderLexer::ASSIGN, GliderLexer::EQ});
  const bool choice = t.type == GliderLexer::CHOOSE && peek(2).type == GliderLexer::COLON;
  return (place || choice) && blocks_.empty() && isAnyName(peek(1).type);
}

void StructureRepair::correct(Lexeme& t) {
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

std::string_view StructureRepair::meantAtTop(const Lexeme& t) const {
  if (!isAnyName(peek(1).type) || peek(afterFormals(2)).type != GliderLexer::BEGIN) {
    return {};
  }
  const std::string_view near = closest(source_.text(t), {"state", "flightprofile", "flightroute"});
  return near.empty() ? "state" : near;
}

std::string_view StructureRepair::meantInBlock(const Lexeme& t) const {
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

size_t StructureRepair::assignedName() const {
  size_t at = out_.size() - 1;
  if (out_[at].type == GliderLexer::RBRACKET) {
    while (at > 1 && out_[at].type != GliderLexer::LBRACKET) {
      --at;
    }
    --at;
  }
  return at;
}

/// Whether the line goes on with a condition: the name is then that of a place.
bool StructureRepair::comparesNext() const {
  constexpr size_t kLongest = 40;
  const size_t from = out_.back().begin;
  for (size_t k = 0; k < kLongest && peek(k).type != kEof; ++k) {
    const std::string_view between = source_.text().substr(from, peek(k).begin - from);
    if (between.find('\n') != std::string_view::npos) {
      break;
    }
    if (oneOf(peek(k).type, {GliderLexer::LT, GliderLexer::LE, GliderLexer::GT, GliderLexer::GE,
                             GliderLexer::EQ, GliderLexer::NE})) {
      return true;
    }
  }
  return false;
}

bool StructureRepair::isColonEqual(const Lexeme& t) const {
  return source_.text(t) == ":=";
}

void StructureRepair::supplyKeyword(const Lexeme& t) {
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
  const std::string_view keyword = action ? "set" : comparesNext() ? "place" : "const";
  auto report =
      reporter_.at(name, support::diagnostics::missingKeyword, source_.text(name), keyword);
  report.fix({source_.file, name.begin, name.begin}, std::string(keyword) + " ");
  if (isColonEqual(t)) {
    report.fix(source_.range(t), "=");
  }
  const uint32_t type = keyword == "place" ? uint32_t{GliderLexer::PLACE} : keywordType(keyword);
  const Lexeme supplied{type, name.begin, name.begin};
  values_.keyword(supplied);
  out_.insert(out_.begin() + static_cast<std::ptrdiff_t>(at), supplied);
}

bool StructureRepair::becomesName(const Lexeme& t) {
  const uint32_t before = previous();
  const bool name = t.type != kEof && meantAsName(before, t.type, peek(1).type);
  if (name) {
    reporter_.at(t, support::diagnostics::keywordAsName, source_.text(t));
    out_.push_back({GliderLexer::NAME, t.begin, t.end});
  } else {
    reporter_.at(t, support::diagnostics::missingName, nameOwner(before), source_.text(out_.back()),
                 describe(source_, t));
    insert(GliderLexer::NAME);
  }
  noteHeader(name ? 1 : 0);
  return name;
}

void StructureRepair::noteHeader(size_t ahead) {
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

size_t StructureRepair::afterFormals(size_t k) const {
  if (peek(k).type != GliderLexer::LPAREN) {
    return k;
  }
  while (!oneOf(peek(k).type, {GliderLexer::RPAREN, kEof}) && !isHardKeyword(peek(k).type)) {
    ++k;
  }
  return peek(k).type == GliderLexer::RPAREN ? k + 1 : k;
}

bool StructureRepair::supplyBegin(const Lexeme& t) {
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

bool StructureRepair::isBegunLater() const {
  constexpr size_t kFarthest = 1000;
  size_t k = 0;
  while (k < kFarthest && !startsItem(peek(k).type) &&
         !oneOf(peek(k).type, {GliderLexer::BEGIN, kEof})) {
    ++k;
  }
  return peek(k).type == GliderLexer::BEGIN;
}

bool StructureRepair::onLaterLine(const Lexeme& t) const {
  const uint32_t from = out_.empty() ? 0 : out_.back().end;
  return source_.text().substr(from, t.begin - from).find('\n') != std::string_view::npos;
}

}  // namespace glider::frontend
