// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate.h"

#include "ir/core/defects.h"
#include "ir/core/ops.h"
#include "ir/core/validate_code.h"
#include "ir/core/validate_shares.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace glider::ir {
namespace {

/// Whether only a quantity has a dimension, and that is one that `support::product` can give.
bool sound(Type type) {
  if (type.kind != TypeKind::Quantity) {
    return type.dimension.dimensionless();
  }
  return support::product(type.dimension, {}).has_value();
}

/// Whether `unit` of a variable is that of a plain number, and the variable a parameter.
bool counts(const Variable& v) {
  const auto unit = support::findUnit(v.unit);
  return v.kind == VariableKind::Parameter && v.type == Type{TypeKind::Quantity, {}} &&
         unit.has_value() && unit->dimension.dimensionless();
}

/// Checks what does not depend on the code of the mission: sensors, behaviours, expressions.
class Validator {
 public:
  explicit Validator(const Mission& mission) : m_(mission) {}

  std::vector<Defect> run() {
    sensors();
    compass();
    pack();
    require(!m_.nap_s || (std::isfinite(*m_.nap_s) && *m_.nap_s > 0), {}, "the longest nap is {} s",
            m_.nap_s.value_or(0));
    behaviours();
    variables();
    validateShares(m_, defects_);
    tables();
    functions();
    if (defects_.empty() && expressions()) {
      validateCode(m_, defects_);
    }
    return defects_.take();
  }

 private:
  template <typename... Args>
  void require(bool holds, support::SourceRange range, std::string_view message,
               const Args&... args) {
    defects_.require(holds, range, message, args...);
  }

  void sensors() {
    std::set<std::string_view> names;
    std::set<uint16_t> ids;
    for (const Sensor& s : m_.sensors) {
      require(names.insert(s.name).second, {}, "two sensors are named `{}`", s.name);
      require(ids.insert(s.id).second, {}, "sensor `{}` has number {}, which is already used",
              s.name, s.id);
      require(s.symbol.empty() == (s.id < kFirstOwnSensor), {},
              "sensor `{}` has a number outside the range for its owner", s.name);
      require(s.type.kind != TypeKind::Bool && sound(s.type), {}, "sensor `{}` is not a number",
              s.name);
      const bool position = s.type.kind == TypeKind::Latitude || s.type.kind == TypeKind::Longitude;
      require(s.encoding != Encoding::DegreesMinutes || position, {},
              "sensor `{}` has degrees and minutes but is not a latitude or longitude", s.name);
      require(s.encoding != Encoding::Magnetic || isAngle(s), {},
              "sensor `{}` is magnetic, but is not an angle of the vehicle in rad", s.name);
      require(std::isfinite(s.to_si) && s.to_si != 0, {}, "sensor `{}` has the factor {}", s.name,
              s.to_si);
      require(s.lowest <= s.highest, {}, "sensor `{}` has the range {} to {}", s.name, s.lowest,
              s.highest);
      require(s.stale_after_s >= 0, {}, "sensor `{}` is stale after {} s", s.name, s.stale_after_s);
    }
  }

  static bool isAngle(const Sensor& s) {
    return s.isOfVehicle() && s.to_si == 1 &&
           s.type == Type{TypeKind::Quantity, support::dimension::angle};
  }

  /// A mission whose headings are true needs the difference from those of the vehicle.
  void compass() {
    const bool magnetic = std::ranges::any_of(
        m_.sensors, [](const Sensor& s) { return s.encoding == Encoding::Magnetic; });
    require(m_.compass.has_value() || !magnetic, {}, "there is a magnetic sensor, but no compass");
    if (!m_.compass) {
      return;
    }
    const SensorId variation = m_.compass->variation;
    require(!variation.valid() ||
                (variation.index < m_.sensors.size() && isAngle(m_.sensors[variation.index])),
            {}, "the variation of the compass is not an angle of the vehicle");
    require(std::fabs(m_.compass->declination.value_or(0)) <= std::numbers::pi, {},
            "the declination is more than half a turn");
  }

  void pack() {
    const Pack pack = m_.pack.value_or(Pack{1, 1, 0});
    require(pack.capacity_C > 0 && pack.voltage_V > 0 && pack.reserve >= 0 && pack.reserve < 1, {},
            "the pack has no capacity, no voltage, or a reserve that is all of it");
  }

  void behaviours() {
    std::set<std::pair<BehaviourKind, std::string_view>> names;
    for (const Behaviour& b : m_.behaviours) {
      require(names.insert({b.kind, b.name}).second, {},
              "two behaviours of one kind are named `{}`", b.name);
      require(!b.symbol.empty() || (b.parameters.empty() && b.reads.empty()), {},
              "`{}` has parameters or sensors but no C function", b.name);
      for (const Parameter& p : b.parameters) {
        require(sound(p.type), {}, "parameter `{}` of `{}` has no type", p.name, b.name);
      }
      for (SensorId id : b.reads) {
        require(id.index < m_.sensors.size(), {}, "`{}` reads an unknown sensor", b.name);
      }
    }
  }

  void variables() {
    std::set<std::string_view> names;
    for (const Variable& v : m_.variables) {
      require(names.insert(v.name).second, v.range, "two variables are named `{}`", v.name);
      require(sound(v.type), v.range, "variable `{}` has no type", v.name);
      const bool endless = v.lowest == -Variable::kEndless && v.highest == Variable::kEndless;
      require(v.type.kind == TypeKind::Bool ? endless : v.lowest <= v.highest, v.range,
              "variable `{}` has the range {} to {}", v.name, v.lowest, v.highest);
      require(v.unit.empty() || counts(v), v.range, "variable `{}` cannot have the unit `{}`",
              v.name, v.unit);
    }
  }

  void tables() {
    for (size_t i = 0; i < m_.tables.size(); ++i) {
      const Table& t = m_.tables[i];
      const bool finite =
          std::ranges::all_of(t.values, [](double value) { return std::isfinite(value); });
      require(t.type.kind != TypeKind::Bool && sound(t.type) && !t.values.empty() && finite, {},
              "table {} has no values, or one that is not a number", i);
    }
  }

  void functions() {
    std::set<std::string_view> names;
    for (const Function& f : m_.functions) {
      require(names.insert(f.name).second, {}, "two functions are named `{}`", f.name);
      require(!f.symbol.empty() && sound(f.result) && f.lowest <= f.highest &&
                  f.parameters.size() <= kMostOperands,
              {}, "function `{}` has no symbol, no result or too many parameters", f.name);
      for (const Parameter& p : f.parameters) {
        require(sound(p.type), {}, "parameter `{}` of `{}` has no type", p.name, f.name);
      }
    }
    for (const FunctionUse& use : m_.uses) {
      require(use.function.index < m_.functions.size(), use.range, "a use of an unknown function");
    }
  }

  /// Whether expression `i` has exactly the operands that it should have.
  bool hasOperands(uint32_t i, const Expr& e) const {
    const uint32_t count = operandCount(e);
    for (uint32_t k = 0; k < e.operands.size(); ++k) {
      const ExprId operand = e.operands.at(k);
      if (k < count ? operand.index >= i : operand.valid()) {
        return false;
      }
    }
    return true;
  }

  /// The same of what a leaf names.
  bool hasLeaf(const Expr& e) const {
    auto fits = [](bool wanted, auto id, size_t count) {
      return wanted ? id.index < count : !id.valid();
    };
    return fits(e.op == Op::Sensor || e.op == Op::Age, e.sensor, m_.sensors.size()) &&
           fits(e.op == Op::Variable, e.variable, m_.variables.size()) &&
           fits(e.op == Op::Temporal, e.temporal, m_.temporals.size()) &&
           fits(e.op == Op::Element, e.table, m_.tables.size()) &&
           fits(e.op == Op::Call, e.use, m_.uses.size());
  }

  /// Whether what `e` watches, or an earlier temporal watches, precedes expression `i`.
  bool watchedBefore(uint32_t i, const Expr& e) const {
    return e.op != Op::Temporal || watched_end_[e.temporal.index] <= i;
  }

  /// For each temporal, one more than the greatest number in it and those before it.
  void watchedEnds() {
    uint32_t end = 0;
    for (const Temporal& t : m_.temporals) {
      for (ExprId id : {t.operand, t.duration, t.along}) {
        end = id.valid() ? std::max(end, id.index + 1) : end;
      }
      watched_end_.push_back(t.operand.valid() ? end : UINT32_MAX);
    }
  }

  bool expressions() {
    watchedEnds();
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const Expr& e = m_.exprs[i];
      const bool known = static_cast<size_t>(e.op) < opCount();
      if (!known || !hasOperands(i, e) || !hasLeaf(e) || !watchedBefore(i, e)) {
        require(false, e.range, "expression {} lacks an operand or has one too many", i);
        return false;
      }
      const std::optional<Type> type = resultType(m_, e);
      require(type == e.type && sound(e.type), e.range,
              "the operands or the type of `{}` do not match", opInfo(e.op).text);
      require(std::isfinite(e.number) && (e.op == Op::Constant || e.number == 0), e.range,
              "expression {} holds the number {}", i, e.number);
    }
    return true;
  }

  const Mission& m_;
  Defects defects_;
  std::vector<uint32_t> watched_end_;
};

}  // namespace

std::vector<Defect> validate(const Mission& mission) {
  return Validator(mission).run();
}

}  // namespace glider::ir
