// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/against/guard_reads.h"

#include "ir/core/ops.h"
#include "support/one_line.h"
#include "support/units/units.h"

#include <algorithm>
#include <map>
#include <set>

namespace glider::analysis {
namespace {

using support::Unit;

/// The unit at the end of a number's text, "26 deg"; empty if there is none.
std::optional<Unit> writtenUnit(std::string_view text) {
  const size_t digit = text.find_last_of("0123456789.");
  const size_t begin = text.find_first_not_of(" \t", digit == text.npos ? 0 : digit + 1);
  return begin == text.npos ? std::nullopt : support::parseUnit(text.substr(begin));
}

/// Collects what an expression reads, each thing once, in the order of the text; the unit of a
/// number is that of a constant which the pilot compares it with.
class ReadCollector {
 public:
  ReadCollector(const ir::Mission& mission, const support::SourceManager& sources)
      : m_(mission), sources_(sources) {}

  GuardReads of(ir::ExprId guard) {
    visit(guard, true);
    for (GuardRead& read : reads_.shown) {
      chooseUnit(read);
    }
    return std::move(reads_);
  }

 private:
  /// `show`: not a part of something that is shown already.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void visit(ir::ExprId id, bool show) {
    if (!seen_.insert({id.index, show}).second) {
      return;
    }
    const ir::Expr& e = m_[id];
    switch (ir::groupOf(e.op)) {
      case ir::OpGroup::Sensor:
      case ir::OpGroup::Age:
        add(reads_.sensors, e.sensor);
        add(id, m_[e.sensor].name, show && e.op == ir::Op::Sensor);
        return;
      case ir::OpGroup::Variable:
        add(reads_.variables, e.variable);
        // The values of parameters do not change.
        add(id, textOf(e.range, m_[e.variable].name),
            show && m_[e.variable].kind != ir::VariableKind::Parameter);
        return;
      case ir::OpGroup::Temporal:
        visitTemporal(id, m_[e.temporal], show);
        return;
      case ir::OpGroup::Call:
        add(reads_.functions, m_.uses.at(e.use.index).function);
        add(id, textOf(e.range, m_[e.use].name), show);
        show = false;
        break;
      case ir::OpGroup::Constant:
        constant(e);
        return;
      case ir::OpGroup::Clock:
        add(id, textOf(e.range, "clock"), show);
        return;
      case ir::OpGroup::Function:
        // A distance says more than the positions that it is computed from.
        if (e.op == ir::Op::Distance || e.op == ir::Op::Bearing) {
          add(id, textOf(e.range, "distance"), show);
          show = false;
        }
        break;
      case ir::OpGroup::Truth:
      case ir::OpGroup::Unary:
      case ir::OpGroup::Binary:
      case ir::OpGroup::Clamp:
      case ir::OpGroup::Select:
      case ir::OpGroup::Element:
      case ir::OpGroup::Comparison:
      case ir::OpGroup::Known:
      case ir::OpGroup::Logic:
        break;
    }
    for (uint32_t i = 0; i < ir::operandCount(e); ++i) {
      visit(e.operands.at(i), show);
    }
  }

  // NOLINTNEXTLINE(misc-no-recursion): as above
  void visitTemporal(ir::ExprId id, const ir::Temporal& temporal, bool show) {
    const bool window = ir::isWindow(temporal.kind);
    add(id, textOf(temporal.range, "window"), show && window);
    for (const ir::ExprId part : {temporal.operand, temporal.duration, temporal.along}) {
      if (part.valid()) {
        visit(part, show && !window);
      }
    }
  }

  /// Remembers the unit in which the guard is written.
  void constant(const ir::Expr& e) {
    if (e.type.kind == ir::TypeKind::Quantity && e.range.valid()) {
      const auto unit = writtenUnit(sources_.text(e.range));
      if (unit && unit->dimension == e.type.dimension) {
        units_.push_back(*unit);
      }
    }
  }

  void chooseUnit(GuardRead& read) const {
    const ir::Type type = m_[read.value].type;
    const auto written = std::ranges::find(units_, type.dimension, &Unit::dimension);
    const GuardRead usual = usualUnit(type);
    const bool found = type.kind == ir::TypeKind::Quantity && written != units_.end();
    read.unit = found ? std::string(written->spelling) : usual.unit;
    read.to_si = found ? written->to_si : usual.to_si;
  }

  void add(ir::ExprId id, const std::string& name, bool show) {
    if (show && std::ranges::find(reads_.shown, name, &GuardRead::name) == reads_.shown.end()) {
      reads_.shown.push_back({name, id, "", 1});
    }
  }

  template <typename Id>
  static void add(std::vector<Id>& ids, Id id) {
    if (std::ranges::find(ids, id) == ids.end()) {
      ids.push_back(id);
    }
  }

  /// `otherwise`: in a mission of the IR's text form, which has no source.
  [[nodiscard]] std::string textOf(support::SourceRange range, const std::string& otherwise) const {
    return range.valid() ? support::onOneLine(sources_.text(range)) : otherwise;
  }

  const ir::Mission& m_;
  const support::SourceManager& sources_;
  GuardReads reads_;
  std::vector<Unit> units_;
  std::set<std::pair<uint32_t, bool>> seen_;
};

}  // namespace

GuardReads readsOf(const ir::Mission& mission, const support::SourceManager& sources,
                   ir::ExprId guard) {
  return ReadCollector(mission, sources).of(guard);
}

std::vector<report::LoggedValue> valuesOf(const GuardReads& reads,
                                          const ir::Interpreter& interpreter) {
  std::vector<report::LoggedValue> values;
  for (const GuardRead& read : reads.shown) {
    values.push_back(
        {read.name, ir::asNumber(interpreter.evaluate(read.value)) / read.to_si, read.unit});
  }
  return values;
}

GuardRead usualUnit(ir::Type type) {
  if (type.kind == ir::TypeKind::Latitude || type.kind == ir::TypeKind::Longitude) {
    return {"", {}, "deg", 1};
  }
  if (type.kind == ir::TypeKind::Bool) {
    return {"", {}, report::kTruthUnit, 1};
  }
  if (type.dimension.dimensionless()) {
    return {"", {}, "", 1};
  }
  const auto unit = type.dimension == support::dimension::angle ? support::findUnit("deg")
                                                                : support::bareUnit(type.dimension);
  return {"",
          {},
          unit ? std::string(unit->spelling) : support::unitName(type.dimension),
          unit ? unit->to_si : 1};
}

}  // namespace glider::analysis
