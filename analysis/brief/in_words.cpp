// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/in_words.h"

#include "analysis/brief/written.h"
#include "support/listed.h"
#include "support/one_line.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace glider::analysis {
namespace {

constexpr std::string_view kLatitude = ".latitude";

}  // namespace

std::string InWords::written(support::SourceRange range) const {
  return range.valid() ? inCode(support::onOneLine(sources_.text(range))) : "";
}

std::optional<std::string> InWords::position(ir::ExprId first, ir::ExprId second) const {
  const ir::Expr& latitude = m_[first];
  const ir::Expr& longitude = m_[second];
  if (latitude.type.kind != ir::TypeKind::Latitude ||
      longitude.type.kind != ir::TypeKind::Longitude) {
    return std::nullopt;
  }
  if (latitude.range == longitude.range) {
    return written(latitude.range);
  }
  const bool numbers = latitude.op == ir::Op::Constant && longitude.op == ir::Op::Constant;
  return numbers ? std::optional(inCode(support::positionText(latitude.number, longitude.number)))
                 : std::nullopt;
}

std::string InWords::values(const std::vector<ir::ExprId>& values) const {
  std::vector<std::string> all;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i + 1 < values.size()) {
      if (auto both = position(values[i], values[i + 1])) {
        all.push_back(*std::move(both));
        ++i;
        continue;
      }
    }
    all.push_back(written(m_[values[i]].range));
  }
  return support::listed(all);
}

const WrittenLoop* InWords::loopOf(const ir::Statement& statement,
                                   const WrittenLoop* around) const {
  for (const WrittenLoop& loop : loops_) {
    const bool inside = around == nullptr || (&loop != around && isIn(loop.whole, around->whole));
    if (inside && isIn(statement.range, loop.whole)) {
      return &loop;
    }
  }
  return nullptr;
}

/// The `set` of a position is the one of its latitude and then the one of its longitude.
std::optional<std::string> InWords::positionSet(std::span<const ir::Statement> statements) const {
  const auto isSet = [](const ir::Statement& one) { return one.kind == ir::StatementKind::Set; };
  if (statements.size() < 2 || !isSet(statements[0]) || !isSet(statements[1]) ||
      statements[0].range != statements[1].range) {
    return std::nullopt;
  }
  return position(statements[0].value, statements[1].value);
}

std::string InWords::statement(std::span<const ir::Statement> statements,
                               const WrittenLoop* around) const {
  const ir::Statement& statement = statements.front();
  const std::string_view text =
      statement.range.valid() ? sources_.text(statement.range) : std::string_view();
  if (isPush(text)) {
    return "does " + written(statement.range);
  }
  if (const auto set = asSet(text)) {
    return fmt::format("sets {} to {}", inCode(set->target),
                       positionSet(statements).value_or(inCode(set->value)));
  }
  return oneAsIs(statement, around);
}

std::string InWords::oneAsIs(const ir::Statement& statement, const WrittenLoop* around) const {
  switch (statement.kind) {
    case ir::StatementKind::Set:
      return fmt::format("sets {} to {}", inCode(m_[statement.variable].name),
                         written(m_[statement.value].range));
    case ir::StatementKind::Log: {
      std::string text = statement.text;
      std::ranges::replace(text, '`', '\'');
      return fmt::format("logs “{}”{}{}", text, statement.values.empty() ? "" : " with ",
                         values(statement.values));
    }
    case ir::StatementKind::If: {
      const std::string otherwise = block(statement.otherwise, around);
      return fmt::format("(if {}: {}{}{})", written(m_[statement.value].range),
                         block(statement.then, around),
                         otherwise.empty() ? "" : "; otherwise: ", otherwise);
    }
    case ir::StatementKind::Command:
      break;
  }
  return "commands " + written(statement.range);
}

/// What comes from one place of the text is reported once: the passes of a loop, both halves of a
/// position, the elements of an array.
std::string InWords::list(std::span<const ir::Statement> statements,
                          const WrittenLoop* around) const {
  std::string text;
  std::set<std::pair<uint32_t, uint32_t>> told;
  while (!statements.empty()) {
    const ir::Statement& first = statements.front();
    const WrittenLoop* loop = loopOf(first, around);
    const support::SourceRange& range = loop != nullptr ? loop->whole : first.range;
    size_t count = 1;
    while (loop != nullptr && count < statements.size() &&
           isIn(statements[count].range, loop->whole)) {
      ++count;
    }
    if (!range.valid() || told.emplace(range.begin, range.end).second) {
      text += text.empty() ? "" : ", ";
      text += loop != nullptr ? fmt::format("({}: {})", written(loop->header),
                                            list(statements.first(count), loop))
                              : statement(statements, around);
    }
    statements = statements.subspan(count);
  }
  return text;
}

std::string InWords::block(ir::BlockId block, const WrittenLoop* around) const {
  return block.valid() ? list(m_[block].statements, around) : "";
}

std::string InWords::block(ir::BlockId block) const {
  return this->block(block, nullptr);
}

std::string InWords::nameIn(const ir::State& state, size_t parameter) const {
  const std::string& name = m_[state.parameters[parameter]].name;
  return name.starts_with(state.name + ".") ? name.substr(state.name.size() + 1) : name;
}

std::string InWords::transition(const ir::Case& c) const {
  if (c.transition == ir::Transition::Return) {
    return "returns to the state that called";
  }
  if (c.transition == ir::Transition::Exit) {
    return "ends the mission";
  }
  if (c.transition != ir::Transition::Goto && c.transition != ir::Transition::Call) {
    return "stays";
  }
  const ir::State& target = m_[c.target];
  std::vector<std::string> given;
  const size_t count = std::min(c.arguments.size(), target.parameters.size());
  for (size_t i = 0; i < count; ++i) {
    std::string name = nameIn(target, i);
    std::string value = written(m_[c.arguments[i]].range);
    // A position is two parameters, but one for the pilot.
    if (name.ends_with(kLatitude) && i + 1 < count) {
      name.resize(name.size() - kLatitude.size());
      const ir::ExprId longitude = c.arguments[++i];
      value = position(c.arguments[i - 1], longitude)
                  .value_or(value + " " + written(m_[longitude].range));
    }
    given.push_back(fmt::format("{} = {}", inCode(name), value));
  }
  return fmt::format("{} {}{}{}", c.transition == ir::Transition::Goto ? "goes to" : "calls",
                     inCode(target.name), given.empty() ? "" : " with ", support::listed(given));
}

report::BriefEvent InWords::event(const ir::Case& c, const std::string& never) const {
  const std::string actions = block(c.action);
  return {support::onOneLine(sources_.text(m_[c.guard].range)),
          actions.empty() ? transition(c) : fmt::format("{}; then {}", actions, transition(c)),
          never};
}

std::string InWords::instruments(const ir::State& state) {
  std::vector<std::string> all;
  for (const ir::Sampling& one : state.sampling) {
    all.push_back(inCode(one.instrument + (one.words.empty() ? "" : " " + one.words)));
  }
  return support::listed(all);
}

std::string InWords::samples(const ir::State& state) {
  std::vector<std::pair<double, std::vector<std::string>>> by_period;
  for (const ir::LogItem& item : state.log) {
    auto found = std::ranges::find(by_period, item.period_s,
                                   &std::pair<double, std::vector<std::string>>::first);
    if (found == by_period.end()) {
      found = by_period.insert(by_period.end(), {item.period_s, {}});
    }
    found->second.push_back(inCode(item.name));
  }
  std::string text;
  for (const auto& [period_s, names] : by_period) {
    text += (text.empty() ? "" : "; ") + support::listed(names) +
            (period_s > 0 ? fmt::format(" every {:g} s", period_s) : " on every tick");
  }
  return text;
}

}  // namespace glider::analysis
