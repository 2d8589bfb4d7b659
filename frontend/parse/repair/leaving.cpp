// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The part of StructureRepair that reads transitions inside `if` and `for`.

#include "frontend/parse/repair/structure.h"
#include "support/diagnostics/ids/syntax.h"

#include <fmt/format.h>

#include <utility>

namespace glider::frontend {

size_t StructureRepair::tokensOfTransition() const {
  const bool leads = oneOf(peek(0).type, {GliderLexer::GOTO, GliderLexer::CALL});
  return leads && isAnyName(peek(1).type) ? afterFormals(2) : 1;
}

bool StructureRepair::leavesFromInside() const {
  constexpr size_t kFarthest = 1000;
  size_t deep = blocks_.size() - membersOpen();
  if (deep < 2) {
    return false;
  }
  const bool first = at_ > 0 && oneOf(in_[at_ - 1].type, {GliderLexer::THEN, GliderLexer::ELSE});
  if (first || isDeeper(in_[at_], blocks_.back().opener)) {
    return true;
  }
  for (size_t k = tokensOfTransition(); k < kFarthest; ++k) {
    const uint32_t type = peek(k).type;
    if (startsMember(type) || startsItem(type) || oneOf(type, {GliderLexer::CASE, kEof})) {
      return false;
    }
    deep += oneOf(type, {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= type == GliderLexer::END ? 1U : 0U;
    if (deep == 0) {
      const uint32_t next = peek(k + 1).type;
      return isTransition(next) || startsMember(next) ||
             oneOf(next, {GliderLexer::CASE, GliderLexer::END});
    }
  }
  return false;
}

bool StructureRepair::isDeeper(const Lexeme& t, const Lexeme& opener) const {
  const auto line = beginOfLine(t);
  const auto outer = beginOfLine(opener);
  if (!line || !outer) {
    return false;
  }
  const std::string_view indent = source_.text({0, *line, t.begin});
  const std::string_view other = source_.text({0, *outer, opener.begin});
  return other.size() < indent.size() && indent.starts_with(other);  // tabs are not compared
}

std::string_view StructureRepair::textUpTo(size_t first, uint32_t type) const {
  size_t end = first;
  while (end < in_.size() && in_[end].type != type && in_[end].type != kEof) {
    ++end;
  }
  return end == first ? std::string_view() : source_.text({0, in_[first].begin, in_[end - 1].end});
}

std::string StructureRepair::guardHere() const {
  constexpr size_t kLongest = 100;
  const auto inParentheses = [](std::string_view text) {
    return text.contains("||") ? fmt::format("({})", text) : std::string(text);
  };
  const size_t outer = membersOpen();
  size_t word = blocks_[outer].at;  // `case`
  while (word > 0 && (in_[word].type == GliderLexer::DO) == (word == blocks_[outer].at) &&
         in_[word].type != GliderLexer::CASE) {
    --word;
  }
  if (in_[word].type != GliderLexer::CASE) {
    return "";
  }
  std::string guard = inParentheses(textUpTo(word + 1, GliderLexer::DO));
  for (size_t k = outer + 1; k < blocks_.size(); ++k) {
    const Block& block = blocks_[k];
    if (block.kind != BlockKind::If) {
      return "";
    }
    const std::string_view condition = textUpTo(block.at + 1, GliderLexer::THEN);
    guard += " && ";
    const bool name = block.then && isAnyName(in_[block.at + 1].type) &&
                      in_[block.at + 2].type == GliderLexer::THEN;
    guard += !block.otherwise ? inParentheses(condition)
             : name           ? fmt::format("!{}", condition)
                              : fmt::format("!({})", condition);
  }
  return guard.size() > kLongest || guard.contains('\n') ? "" : guard;
}

size_t StructureRepair::branchOf(const Block& block) const {
  size_t deep = 0;
  for (size_t k = block.at + 1; block.otherwise && k < at_; ++k) {
    const uint32_t type = in_[k].type;
    if (type == GliderLexer::ELSE && deep == 0) {
      return k;
    }
    deep += oneOf(type, {GliderLexer::DO, GliderLexer::IF}) ? 1U : 0U;
    deep -= type == GliderLexer::END && deep > 0 ? 1U : 0U;
  }
  return block.at;
}

bool StructureRepair::asksFor(std::string_view name) const {
  for (size_t i = membersOpen() + 1; i < blocks_.size(); ++i) {
    for (size_t n = blocks_[i].at; n < at_ && in_[n].type != GliderLexer::THEN; ++n) {
      if (source_.text(in_[n]) == name) {
        return true;
      }
    }
  }
  return false;
}

std::string_view StructureRepair::setBefore() const {
  for (size_t i = membersOpen(); i < blocks_.size(); ++i) {
    const size_t end = i + 1 < blocks_.size() ? blocks_[i + 1].at : at_;
    for (size_t k = branchOf(blocks_[i]) + 1; k < end; ++k) {
      if (in_[k - 1].type == GliderLexer::SET && asksFor(source_.text(in_[k]))) {
        return source_.text(in_[k]);
      }
    }
  }
  return "";
}

void StructureRepair::reportLeaving(const Lexeme& t) {
  Block& outer = blocks_[membersOpen()];
  const size_t tokens = tokensOfTransition();
  read_from_ = at_ + tokens;
  undeclared_ = true;  // the state that it leads to would be reported
  if (std::exchange(outer.leaves, true)) {
    return;  // once for each case
  }
  const Lexeme whole{t.type, t.begin, peek(tokens - 1).end};
  const bool entry = isEntry(outer);
  const bool loop = blocks_.back().kind != BlockKind::If;
  auto report = reporter_.at(whole, support::diagnostics::superfluousWord, source_.text(whole),
                             loop ? "inside `for`" : "inside `if`");
  const std::string guard = entry ? "" : guardHere();
  if (entry) {
    report.hint("`entry` has no transition: write a case with that condition under `events`");
  } else if (guard.empty()) {
    report.hint("a block has no transition: write a case of its own before this one");
  } else {
    const std::string_view variable = setBefore();
    report.hint(fmt::format(
        "write a case of its own before this one: `case {} {}`{}", guard, source_.text(whole),
        variable.empty() ? "" : fmt::format("; `{}` is not yet set there", variable)));
  }
}

}  // namespace glider::frontend
