// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_assumption.h"

#include "frontend/sema/declarations/disc_of_distance.h"
#include "frontend/sema/expressions/literals.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/promises/lower_promise.h"
#include "ir/core/inside.h"
#include "ir/core/monitor_writer.h"
#include "ir/core/walk.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace glider::frontend {

using ir::AssumptionKind;
using ir::ExprId;
using ir::Op;

namespace {

/// Where a fix of the GPS is read.
constexpr const char* kFix = "m_gps_lat";

/// Lowers one assumption; empty, and reported, if it is wrong.
class AssumptionLowering {
 public:
  AssumptionLowering(const ast::Assumption& node, Scope& scope) : node_(node), scope_(scope) {}

  std::optional<ir::Assumption> run() {
    constexpr size_t kWord = std::string_view("assume ").size();
    result_.words = scope_.wholeText(node_.where).substr(kWord);
    result_.range = node_.where;
    result_.watch.range = node_.where;
    const bool right = std::visit([&](const auto& premise) { return lower(premise); }, node_.node);
    return right ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  /// `start inside(area)`, `start depth <= 3 m`, `start distance(place) <= 300 m`
  bool lower(const ast::StartPremise& premise) {
    if (const auto* limit = std::get_if<ast::Binary>(&premise.condition.node)) {
      return isDistance(*limit->left) || isDistance(*limit->right)
                 ? startDistance(premise.condition)
                 : startDepth(*limit, premise.condition);
    }
    const auto condition = ExprLowering(scope_).lowerCondition(premise.condition);
    if (!condition) {
      return false;
    }
    const auto known = scope_.areas.find(condition->index);
    if (known == scope_.areas.end()) {
      return refuse(premise.condition, " of the start",
                    "assume start inside(39.1 N 74 W, 39.1 N 73.8 W, 39.3 N 73.9 W)");
    }
    result_.kind = AssumptionKind::StartInside;
    result_.area = known->second.area;
    return true;
  }

  static bool isDistance(const ast::Expr& expr) {
    const auto* call = std::get_if<ast::Invocation>(&expr.node);
    return call != nullptr && call->function.text == "distance";
  }

  /// Proofs are about polygons, so it becomes one that holds the disc: to assume less is safe.
  bool startDistance(const ast::Expr& whole) {
    const auto condition = ExprLowering(scope_).lowerCondition(whole);
    if (!condition) {
      return false;
    }
    const auto disc = discOf(*condition, true, scope_);
    const auto polygon = disc && disc->keep_in ? ir::polygonAround(*disc) : std::nullopt;
    if (!polygon) {
      return refuse(whole, " of the start", "assume start distance(39.2 N 73.9 W) <= 500 m");
    }
    result_.kind = AssumptionKind::StartInside;
    result_.area = *polygon;
    return true;
  }

  bool startDepth(const ast::Binary& limit, const ast::Expr& whole) {
    constexpr const char* kExample = "assume start depth <= 3 m";
    const auto* name = std::get_if<ast::NameUse>(&limit.left->node);
    const auto depth = limit.op == ast::BinaryOp::LessEqual && name != nullptr
                           ? readingOf({name->name, limit.left->where})
                           : std::nullopt;
    if (!depth || !isDepth(*depth)) {
      return refuse(whole, " of the start", kExample);
    }
    result_.kind = AssumptionKind::StartDepth;
    return limitOf(*limit.right, quantity(support::dimension::length), "start depth", kExample);
  }

  bool lower(const ast::OutagePremise& premise) {
    result_.kind = AssumptionKind::Outage;
    if (premise.limit && !limitOf(*premise.limit, quantity(support::dimension::time), "outage",
                                  "assume outage <= 5 min")) {
      return false;
    }
    ir::MonitorWriter monitor = builder();
    monitor.everyTick();
    const ir::VariableId last = monitor.clock("last");
    const double gap = std::max(result_.limit, scope_.platform().world.tick_gap_s);
    monitor.violation(monitor.passed(last, gap),
                      fmt::format("there was no tick for more than {:g} s", gap));
    monitor.set(last, monitor.now());
    monitor.finish(result_.watch);
    return true;
  }

  bool lower(const ast::CurrentPremise& premise) {
    result_.kind = AssumptionKind::Current;
    return limitOf(premise.limit, quantity(support::dimension::speed), "current",
                   "assume current <= 0.4 m/s");
  }

  /// After a time without ticks the reading may take as long as after the start of the mission.
  bool lower(const ast::KnownPremise& premise) {
    const ast::Name fix{kFix, node_.where};
    const ast::Name& name = premise.sensor ? *premise.sensor : fix;
    const auto reading = readingOf(name);
    if (reading && isDepth(*reading)) {
      return refuse(name.where,
                    " to be known: assumptions and requirements are about the true depth",
                    "assume known altitude every 1 min");
    }
    const auto every = promisedTime(premise.every, "every", scope_);
    if (!reading || !every) {
      return false;
    }
    ir::MonitorWriter monitor = builder();
    monitor.everyTick();
    monitor.longest(every->seconds);
    const ir::VariableId last = monitor.clock("last");
    const ir::VariableId before = monitor.clock("before");
    const double gap = std::max(every->seconds, scope_.platform().world.tick_gap_s);
    const ExprId known = monitor.operation(Op::Known, boolean(), {*reading});
    monitor.when(monitor.either(known, monitor.passed(before, gap)),
                 [&] { monitor.set(last, monitor.now()); });
    monitor.violation(monitor.passed(last, every->seconds),
                      fmt::format("`{}` was unknown for more than {}", name.text, every->words));
    monitor.set(before, monitor.now());
    monitor.finish(result_.watch);
    return true;
  }

  /// Between two ticks on which the reading is known.
  bool lower(const ast::ChangesPremise& premise) {
    const auto reading = readingOf(premise.sensor);
    if (!reading) {
      return false;
    }
    const ir::Type type = scope_.mission[*reading].type;
    const bool wraps =  // north is both 0 and 360 degrees
        scope_.mission[scope_.mission[*reading].sensor].encoding == ir::Encoding::Magnetic;
    if (type.kind != ir::TypeKind::Quantity || wraps) {
      return refuse(premise.sensor.where, " to change slowly", "assume temp changes <= 0.2 degC/s");
    }
    const ir::Type rate = quantity(*support::quotient(type.dimension, support::dimension::time));
    if (!limitOf(premise.limit, rate, premise.sensor.text + " changes",
                 "assume temp changes <= 0.2 degC/s")) {
      return false;
    }
    ir::MonitorWriter monitor = builder();
    monitor.everyTick();
    const ir::VariableId seen = monitor.flag("seen");
    const ir::VariableId before = monitor.value("before", type);
    bound(before, scope_.mission[scope_.mission[*reading].sensor]);
    const ir::VariableId since = monitor.clock("since");
    // Bounded, so that proofs know that the product does not overflow: three years are enough.
    constexpr double kLongest = 1e8;
    const ir::Type time = quantity(support::dimension::time);
    const ExprId passed =
        monitor.operation(Op::Subtract, time, {monitor.now(), monitor.read(since)});
    const ExprId gone = monitor.operation(
        Op::Clamp, time, {passed, monitor.number(0, time), monitor.number(kLongest, time)});
    const ExprId most =
        monitor.operation(Op::Multiply, type, {monitor.number(result_.limit, rate), gone});
    const auto exceeds = [&](ExprId to, ExprId from) {
      const ExprId change = monitor.operation(Op::Subtract, type, {to, from});
      return monitor.operation(Op::Greater, boolean(), {change, most});
    };
    const ExprId rises = exceeds(*reading, monitor.read(before));
    const ExprId faster = monitor.either(rises, exceeds(monitor.read(before), *reading));
    monitor.violation(monitor.both(monitor.read(seen), faster),
                      fmt::format("`{}` changed faster", premise.sensor.text));
    monitor.when(monitor.operation(Op::Known, boolean(), {*reading}), [&] {
      monitor.set(seen, true);
      monitor.set(before, *reading);
      monitor.set(since, monitor.now());
    });
    monitor.finish(result_.watch);
    return true;
  }

  bool lower(const ast::RangePremise& premise) {
    const auto reading = readingOf(premise.sensor);
    if (!reading) {
      return false;
    }
    const ir::Expr sensor = scope_.mission[*reading];
    const auto lowest =
        promisedNumber(premise.range.lowest, sensor.type, "the lowest reading", scope_);
    const auto highest =
        promisedNumber(premise.range.highest, sensor.type, "the highest reading", scope_);
    if (!lowest || !highest) {
      return false;
    }
    const bool heading = scope_.mission[sensor.sensor].encoding == ir::Encoding::Magnetic;
    if (*lowest > *highest) {
      return refuse(premise.range.lowest, ": the range would end before it begins",
                    heading ? kAcrossNorth : "assume temp in 2 degC .. 28 degC");
    }
    constexpr double kTurn = kFullTurn * (1 + 1e-12);
    if (heading && (*lowest < 0 || *highest > kTurn)) {
      return refuse(*lowest < 0 ? premise.range.lowest : premise.range.highest,
                    ": readings of a heading are from 0 deg to 360 deg", kAcrossNorth);
    }
    // The prover narrows the range of readings that the vehicle sends in their own unit; but not of
    // the depth, as its reading differs from the true depth, which the assumption is about.
    if (scope_.mission[sensor.sensor].encoding == ir::Encoding::Linear && !isDepth(*reading)) {
      result_.kind = AssumptionKind::Range;
      result_.sensor = sensor.sensor;
      result_.lowest = *lowest;
      result_.highest = *highest;
    }
    ir::MonitorWriter bounds = builder();
    const ExprId below =
        bounds.operation(Op::Less, boolean(), {*reading, bounds.number(*lowest, sensor.type)});
    const ExprId above =
        bounds.operation(Op::Greater, boolean(), {*reading, bounds.number(*highest, sensor.type)});
    result_.watch.condition = bounds.negation(bounds.either(below, above));
    return true;
  }

  bool lower(const ast::ConditionPremise& premise) {
    auto condition = conditionOf(premise.condition);
    if (!condition) {
      return false;
    }
    if (premise.inside) {
      const auto inside = conditionOf(*premise.inside);
      if (!inside) {
        return false;
      }
      ir::MonitorWriter build = builder();
      condition = build.either(build.negation(*inside), *condition);
    }
    result_.watch.condition = *condition;
    return true;
  }

  // --- parts ---

  [[nodiscard]] ir::MonitorWriter builder() const {
    return {scope_.mission, fmt::format("assumption {}", scope_.mission.assumptions.size() + 1),
            node_.where};
  }

  /// A condition of readings, clocks of the mission and parameters.
  std::optional<ExprId> conditionOf(const ast::Expr& expr) {
    const auto condition = ExprLowering(scope_).lowerCondition(expr);
    if (!condition) {
      return std::nullopt;
    }
    const ir::Expr* wrong = nullptr;
    ir::forEachIn(scope_.mission, *condition, [&](const ir::Expr& e) {
      const bool of_mission =
          e.op == Op::StateTime || e.op == Op::ResumeTime || e.op == Op::Temporal ||
          e.op == Op::Call || e.op == Op::Age ||
          // No message may ever arrive.
          (e.op == Op::Sensor && scope_.mission[e.sensor].id >= ir::kFirstHeardSensor &&
           scope_.mission[e.sensor].id < ir::kFirstOwnSensor) ||
          (e.op == Op::Variable && scope_.mission[e.variable].kind != ir::VariableKind::Parameter);
      wrong = of_mission && wrong == nullptr ? &e : wrong;
    });
    if (wrong != nullptr) {
      scope_.report(support::diagnostics::assumptionReads, wrong->range,
                    fmt::format("`{}`", scope_.text(wrong->range)));
      return std::nullopt;
    }
    return condition;
  }

  /// The expression that reads a sensor.
  std::optional<ExprId> readingOf(const ast::Name& name) {
    const auto value =
        ExprLowering(scope_).lower({ast::NameUse{name.text}, name.where}, std::nullopt);
    if (value && scope_.mission[value->id].op != Op::Sensor) {
      scope_.report(support::diagnostics::assumptionReads, name.where,
                    fmt::format("`{}` here, which is not a sensor", name.text));
      return std::nullopt;
    }
    return value ? std::optional(value->id) : std::nullopt;
  }

  /// A variable that keeps readings, 0 before the first: so that proofs know that differences do
  /// not overflow.
  void bound(ir::VariableId variable, const ir::Sensor& sensor) {
    constexpr double kWider = 1 + 1e-9;  // the conversion of a reading rounds
    ir::Variable& kept = scope_.mission.variables[variable.index];
    kept.lowest = std::min(0.0, kWider * sensor.lowest * sensor.to_si);
    kept.highest = std::max(0.0, kWider * sensor.highest * sensor.to_si);
  }

  [[nodiscard]] bool isDepth(ExprId reading) const {
    const ir::Sensor& sensor = scope_.mission[scope_.mission[reading].sensor];
    const platforms::PlatformSensor* row = scope_.platform().find(sensor.vehicle_name);
    return row != nullptr && row->alias == "depth";
  }

  bool limitOf(const ast::Expr& expr, const ir::Type& type, const std::string& what,
               const char* example) {
    const auto value = promisedNumber(expr, type, fmt::format("the limit of `{}`", what), scope_);
    if (value && !(*value >= 0)) {
      scope_.report(support::diagnostics::assumptionLimit, expr.where, what, "a value of 0 or more",
                    scope_.text(expr.where), example);
      return false;
    }
    result_.limit = value.value_or(0);
    return value.has_value();
  }

  static constexpr const char* kAcrossNorth = "assume heading >= 350 deg || heading <= 10 deg";

  bool refuse(const support::SourceRange& where, std::string_view why, const char* example) {
    scope_.report(support::diagnostics::assumptionForm, where, scope_.text(where), why, example);
    return false;
  }
  bool refuse(const ast::Expr& expr, std::string_view why, const char* example) {
    return refuse(expr.where, why, example);
  }

  const ast::Assumption& node_;
  Scope& scope_;
  ir::Assumption result_;
};

/// What a mission assumes at most once; empty: as often as it likes.
std::string onlyOnce(AssumptionKind kind) {
  switch (kind) {
    case AssumptionKind::StartDepth:
      return "the depth at the start";
    case AssumptionKind::StartInside:
      return "the place of the start";
    case AssumptionKind::Outage:
      return "outages";
    case AssumptionKind::Current:
      return "the current";
    case AssumptionKind::Range:
    case AssumptionKind::Always:
      break;
  }
  return "";
}

}  // namespace

void lowerAssumptions(const ast::File& file, Scope& scope) {
  for (const ast::Item& item : file.items) {
    const auto* node = std::get_if<ast::Assumption>(&item);
    auto assumption = node != nullptr ? AssumptionLowering(*node, scope).run() : std::nullopt;
    if (!assumption) {
      continue;
    }
    const std::string once = onlyOnce(assumption->kind);
    const auto first =
        std::ranges::find(scope.mission.assumptions, assumption->kind, &ir::Assumption::kind);
    if (!once.empty() && first != scope.mission.assumptions.end()) {
      scope.report(support::diagnostics::assumptionTwice, node->where, once)
          .note(first->range, "the first is here");
    }
    scope.mission.assumptions.push_back(*std::move(assumption));
  }
}

}  // namespace glider::frontend
