// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/canonical_text.h"

#include "ir/core/ops.h"

#include <fmt/format.h>

#include <functional>
#include <utility>

namespace glider::analysis {
namespace {

/// A longer text of an expression is replaced by its hash: expressions share parts, so that their
/// texts can grow without end.
constexpr size_t kLongest = 400;

std::string shortened(std::string text) {
  return text.size() <= kLongest
             ? std::move(text)
             : fmt::format("#{:x}:{}", std::hash<std::string>()(text), text.size());
}

std::string typeText(const ir::Type& type) {
  std::string text = fmt::format("{}", static_cast<int>(type.kind));
  for (const int exponent : type.dimension.exponents) {
    text += fmt::format(",{}", exponent);
  }
  return text;
}

}  // namespace

CanonicalText::CanonicalText(const ir::Mission& mission, std::vector<std::string> names)
    : m_(mission), names_(std::move(names)) {}

/// What an expression reads comes before it: so does what a temporal in it watches.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::string CanonicalText::expression(ir::ExprId id) {
  if (!id.valid()) {
    return "-";
  }
  if (const auto found = made_.find(id.index); found != made_.end()) {
    return found->second;
  }
  return made_[id.index] = shortened(node(m_[id]));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::string CanonicalText::node(const ir::Expr& e) {
  const ir::OpInfo& info = ir::opInfo(e.op);
  std::string text = "(" + std::string(info.text);
  switch (info.group) {
    case ir::OpGroup::Constant:
      text += fmt::format(" {}:{}", e.number, typeText(e.type));
      break;
    case ir::OpGroup::Sensor:
    case ir::OpGroup::Age:
      text += " " + sensor(e.sensor);
      break;
    case ir::OpGroup::Variable:
      text += " " + nameOf(m_[e.variable]);
      break;
    case ir::OpGroup::Temporal:
      text += " " + temporal(m_[e.temporal]);
      break;
    case ir::OpGroup::Element:
      for (const double value : m_[e.table].values) {
        text += fmt::format(" {}", value);
      }
      break;
    case ir::OpGroup::Call:
      text += fmt::format(" {} {}..{}", m_[e.use].symbol, m_[e.use].lowest, m_[e.use].highest);
      break;
    case ir::OpGroup::Truth:
    case ir::OpGroup::Clock:
    case ir::OpGroup::Unary:
    case ir::OpGroup::Binary:
    case ir::OpGroup::Function:
    case ir::OpGroup::Clamp:
    case ir::OpGroup::Select:
    case ir::OpGroup::Comparison:
    case ir::OpGroup::Known:
    case ir::OpGroup::Logic:
      break;
  }
  for (uint32_t i = 0; i < ir::operandCount(e); ++i) {
    text += " " + expression(e.operands.at(i));
  }
  return text + ")";
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::string CanonicalText::temporal(const ir::Temporal& temporal) {
  return fmt::format("{} {} {} {} {} {} {} {}", static_cast<int>(temporal.kind),
                     expression(temporal.operand), expression(temporal.duration), temporal.length,
                     expression(temporal.along), static_cast<int>(temporal.leg), temporal.dive,
                     temporal.climb);
}

std::string CanonicalText::sensor(ir::SensorId id) const {
  const ir::Sensor& s = m_[id];
  return fmt::format("{}{} {}..{} {}", s.vehicle_name, s.symbol, s.lowest, s.highest,
                     s.stale_after_s);
}

std::string CanonicalText::nameOf(const ir::Variable& variable) const {
  if (!variable.owner.valid()) {
    return variable.name;
  }
  const std::string& owner = m_[variable.owner].name;
  const std::string own =
      variable.name.starts_with(owner + ".") ? variable.name.substr(owner.size()) : variable.name;
  return names_[variable.owner.index] + own;
}

std::string CanonicalText::list(const std::vector<ir::ExprId>& ids) {
  std::string text;
  for (const ir::ExprId id : ids) {
    text += " " + expression(id);
  }
  return text;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::string CanonicalText::statement(const ir::Statement& statement) {
  switch (statement.kind) {
    case ir::StatementKind::Set:
      return fmt::format("set {} {}", nameOf(m_[statement.variable]), expression(statement.value));
    case ir::StatementKind::If:
      return fmt::format("if {} {} {}", expression(statement.value), block(statement.then),
                         block(statement.otherwise));
    case ir::StatementKind::Log:
      return fmt::format("log \"{}\"{}", statement.text, list(statement.values));
    case ir::StatementKind::Command:
      return fmt::format("command {}{}", static_cast<int>(statement.command),
                         list(statement.values));
  }
  return "";
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
std::string CanonicalText::block(ir::BlockId id) {
  std::string text = "{";
  if (id.valid()) {
    for (const ir::Statement& one : m_[id].statements) {
      text += statement(one) + ";";
    }
  }
  return text + "}";
}

std::string CanonicalText::oneCase(const ir::Case& c) {
  return fmt::format("case {} {} {} {}({})", expression(c.guard), block(c.action),
                     static_cast<int>(c.transition), c.target.valid() ? names_[c.target.index] : "",
                     list(c.arguments));
}

std::string CanonicalText::cases(const std::vector<ir::Case>& cases) {
  std::string text;
  for (const ir::Case& c : cases) {
    text += oneCase(c) + "\n";
  }
  return text;
}

std::string CanonicalText::variables(ir::StateId owner, ir::VariableKind kind) {
  std::string text;
  for (const ir::Variable& v : m_.variables) {
    text += v.owner == owner && v.kind == kind ? nameOf(v) + " " + variable(v) + "\n" : "";
  }
  return text;
}

std::string CanonicalText::activity(const ir::Activity& activity, ir::StateId owner,
                                    ir::VariableKind kind) {
  return fmt::format("{}({}) {}\n{}{}", m_[activity.behaviour].symbol, list(activity.arguments),
                     block(activity.entry), cases(activity.cases), variables(owner, kind));
}

std::string CanonicalText::logged(const ir::State& state) {
  std::string text;
  for (const ir::LogItem& item : state.log) {
    text += fmt::format("{} {} every {}\n", item.name, expression(item.value), item.period_s);
  }
  return text;
}

std::string CanonicalText::sampled(const ir::State& state) {
  std::string text;
  for (const ir::Sampling& one : state.sampling) {
    text += fmt::format("sample {} {}\n", one.place, expression(one.code));
  }
  return text;
}

std::string CanonicalText::parameters(const ir::State& state) const {
  std::string text;
  for (const ir::VariableId id : state.parameters) {
    const ir::Variable& v = m_[id];
    text += fmt::format("{} {} {}..{}\n", nameOf(v), typeText(v.type), v.lowest, v.highest);
  }
  return text;
}

std::string CanonicalText::variable(const ir::Variable& v) {
  return fmt::format("{} {} {}..{} {}", static_cast<int>(v.kind), typeText(v.type), v.lowest,
                     v.highest, expression(v.initial));
}

std::string CanonicalText::state(ir::StateId id) {
  const ir::State& s = m_[id];
  return parameters(s) + activity(s.profile, id, ir::VariableKind::Profile) +
         activity(s.route, id, ir::VariableKind::Route) + logged(s) + sampled(s) + block(s.entry) +
         cases(s.cases) + variables(id, ir::VariableKind::State);
}

}  // namespace glider::analysis
