// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_pack.h"

#include "frontend/sema/declarations/declared_value.h"
#include "frontend/sema/declarations/only_item.h"
#include "ir/core/mission_writer.h"
#include "ir/core/walk.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/units/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace glider::frontend {
namespace {

/// What a pilot may write for a capacity: a charge, or an energy.
ir::Type capacityType(const ast::Expr& expr, Scope& scope) {
  const ir::Type energy = quantity(support::dimension::energy);
  if (const auto* literal = std::get_if<ast::Literal>(&expr.node)) {
    const auto unit = support::parseUnit(literal->unit);
    return unit && unit->dimension == energy.dimension ? energy
                                                       : quantity(support::dimension::charge);
  }
  const auto* use = std::get_if<ast::NameUse>(&expr.node);
  const Constant* constant = use != nullptr ? scope.findConstant(use->name) : nullptr;
  return constant != nullptr && constant->type == energy ? energy
                                                         : quantity(support::dimension::charge);
}

/// Reads the parts of the line.
class PackReader {
 public:
  PackReader(const ast::Pack& node, Scope& scope) : node_(node), scope_(scope) {}

  /// Empty, and reported, if a part is wrong.
  std::optional<ir::Pack> read() {
    const ir::Type of_capacity = capacityType(node_.capacity, scope_);
    const auto capacity = positive(node_.capacity, of_capacity, "capacity", "168 Ah");
    const auto voltage =
        positive(node_.voltage, quantity(support::dimension::voltage), "voltage", "14.4 V");
    const auto reserve = reserved();
    if (!capacity || !voltage || !reserve) {
      return std::nullopt;
    }
    const bool energy = of_capacity.dimension == support::dimension::energy;
    return ir::Pack{energy ? *capacity / *voltage : *capacity, *voltage, *reserve};
  }

 private:
  std::optional<double> constant(const ast::Expr& expr, const ir::Type& type) {
    const DeclaredType declared{type};
    const ast::Name role{"pack", node_.where};
    const auto known = DeclaredValue(role, declared, scope_).constant(expr, "the line `pack`");
    return known ? std::optional(known->first) : std::nullopt;
  }
  std::optional<double> positive(const ast::Expr& expr, const ir::Type& type, std::string_view part,
                                 std::string_view example) {
    const auto value = constant(expr, type);
    if (value && !(*value > 0)) {
      scope_.report(support::diagnostics::packValue, expr.where, part, scope_.text(expr.where),
                    "write how much there is, for example `" + std::string(example) + "`");
      return std::nullopt;
    }
    return value;
  }
  std::optional<double> reserved() {
    if (!node_.reserve) {
      return 0;
    }
    const auto* literal = std::get_if<ast::Literal>(&node_.reserve->node);
    const auto unit = literal != nullptr ? support::parseUnit(literal->unit) : std::nullopt;
    if (unit && !unit->dimension.dimensionless()) {
      refuseReserve();
      return std::nullopt;
    }
    const auto value = constant(*node_.reserve, plainNumber());
    if (value && !(*value >= 0 && *value < 1)) {
      constexpr double kPercent = 100;
      const support::SourceRange& where = node_.reserve->where;
      auto report = refuseReserve();
      if (literal != nullptr && literal->unit.empty() && *value > 1 && *value < kPercent) {
        report.hint(fmt::format("write `{} %`", literal->digits))
            .fix({where.file, where.end, where.end}, " %");
      }
      return std::nullopt;
    }
    return value;
  }

  support::DiagnosticBuilder refuseReserve() {
    return scope_.report(support::diagnostics::packValue, node_.reserve->where, "reserve",
                         scope_.text(node_.reserve->where),
                         "write the share that is not to be used, for example `20 %`");
  }

  const ast::Pack& node_;
  Scope& scope_;
};

/// Whether one of the texts has the word `energyused`, perhaps in a comment.
bool mentionUsed(std::span<const ast::File* const> files, Scope& scope) {
  return std::ranges::any_of(files, [&](const ast::File* file) {
    return scope.fileText(file->file).contains("energyused");
  });
}

/// The variable for the charge when it was first known: in most flights as the mission begins.
ir::VariableId firstCharge(const platforms::PlatformSensor& charge, const ast::Pack& node,
                           Scope& scope) {
  ir::Variable variable;
  variable.name = scope.freshName("charge.first");
  variable.type = quantity(support::dimension::charge);
  const ir::SensorId counter = scope.subscribe(charge, charge.alias);
  variable.initial = ir::MissionWriter(scope.mission, node.where).read(counter);
  variable.lowest = charge.lowest * charge.to_si;
  variable.highest = charge.highest * charge.to_si;
  variable.range = node.where;
  return ir::MissionWriter(scope.mission).add(std::move(variable));
}

/// Whether a case may lead on by what it finds: it leaves its state, or sets what others read.
bool leadsOn(const ir::Mission& mission, const ir::Case& one) {
  bool sets = false;
  ir::forEachStatement(mission, one.action, [&](const ir::Statement& statement) {
    sets = sets || statement.kind == ir::StatementKind::Set;
  });
  return one.transition != ir::Transition::Stay || (sets && !one.implied);
}

}  // namespace

void lowerPack(const ast::File& file, std::span<const ast::File* const> library, Scope& scope) {
  const auto* line = onlyItem<ast::Pack>(file, [&](const auto& again, const auto& first) {
    scope.report(support::diagnostics::packTwice, again.where)
        .note(first.where, "the first is here");
  });
  if (line == nullptr) {
    return;
  }
  scope.energy.emplace();
  const auto pack = PackReader(*line, scope).read();
  if (!pack) {
    return;
  }
  scope.mission.pack = pack;
  scope.energy->good = true;
  scope.energy->pack = *pack;
  if (line->reserve) {
    scope.energy->reserve = line->reserve->where;
  }
  const platforms::PlatformSensor* charge = findCharge(scope.platform());
  const ast::File* const own[] = {&file};
  if (charge != nullptr && (mentionUsed(own, scope) || mentionUsed(library, scope))) {
    scope.energy->start = firstCharge(*charge, *line, scope);
  }
}

void keepFirstCharge(Scope& scope) {
  if (!scope.energy || !scope.energy->start.valid()) {
    return;
  }
  const platforms::PlatformSensor& charge = *findCharge(scope.platform());
  const support::SourceRange where = scope.mission[scope.energy->start].range;
  ir::MissionWriter write(scope.mission, where);
  const ir::ExprId now = write.read(scope.subscribe(charge, charge.alias));
  const auto known = [&](ir::ExprId value) {
    return write.operation(ir::Op::Known, boolean(), {value});
  };
  const ir::ExprId first = write.read(scope.energy->start);
  ir::Case keep;
  keep.guard = write.both(known(now), write.negation(known(first)));
  keep.action = write.add(ir::Block{{write.assignment(scope.energy->start, now)}});
  keep.range = where;
  keep.implied = true;
  scope.mission.always.push_back(std::move(keep));
}

void warnOfReserve(Scope& scope) {
  const ir::Mission& mission = scope.mission;
  if (!mission.pack || mission.pack->reserve == 0) {
    return;
  }
  const platforms::PlatformSensor* charge = findCharge(scope.platform());
  const ir::SensorId id = charge != nullptr ? scope.subscribed(*charge) : ir::SensorId();
  const auto decides = [&](const ir::Case& one) {
    return leadsOn(mission, one) && id.valid() &&
           ir::anyIn(mission, one.guard,
                     [&](const ir::Expr& e) { return e.op == ir::Op::Sensor && e.sensor == id; });
  };
  const bool kept = std::ranges::any_of(mission.always, decides) ||
                    std::ranges::any_of(mission.states, [&](const ir::State& state) {
                      return std::ranges::any_of(state.cases, decides);
                    });
  if (!kept) {
    const support::SourceRange& reserve = scope.energy->reserve;
    scope.report(support::diagnostics::reserveNotKept, reserve, scope.text(reserve));
  }
}

}  // namespace glider::frontend
