// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate.h"

#include "ir/core/ops.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <utility>

namespace glider::ir {
namespace {

/// Whether only a quantity has a dimension, and one that `support::product` could give.
bool sound(Type type) {
  if (type.kind != TypeKind::Quantity) {
    return type.dimension.dimensionless();
  }
  return support::product(type.dimension, {}).has_value();
}

class Validator {
 public:
  explicit Validator(const Mission& mission) : m_(mission) {}

  std::vector<Defect> run() {
    sensors();
    behaviours();
    if (expressions()) {
      states();
    }
    return std::move(defects_);
  }

 private:
  void require(bool holds, support::SourceRange range, std::string message) {
    if (!holds) {
      defects_.push_back({range, std::move(message)});
    }
  }

  void sensors() {
    std::set<std::string_view> names;
    std::set<uint16_t> ids;
    for (const Sensor& s : m_.sensors) {
      require(names.insert(s.name).second, {}, fmt::format("two sensors are named `{}`", s.name));
      require(ids.insert(s.id).second, {},
              fmt::format("sensor `{}` has number {}, which another has", s.name, s.id));
      require(s.type.kind != TypeKind::Bool && sound(s.type), {},
              fmt::format("sensor `{}` is no number", s.name));
      const bool position = s.type.kind == TypeKind::Latitude || s.type.kind == TypeKind::Longitude;
      require(s.encoding == Encoding::Linear || position, {},
              fmt::format("sensor `{}` has degrees and minutes but is no latitude or longitude",
                          s.name));
      require(std::isfinite(s.to_si) && s.to_si != 0, {},
              fmt::format("sensor `{}` has the factor {}", s.name, s.to_si));
      require(s.lowest <= s.highest, {},
              fmt::format("sensor `{}` has the range {} to {}", s.name, s.lowest, s.highest));
      require(s.stale_after_s >= 0, {},
              fmt::format("sensor `{}` is stale after {} s", s.name, s.stale_after_s));
    }
  }

  void behaviours() {
    std::set<std::pair<BehaviourKind, std::string_view>> names;
    for (const Behaviour& b : m_.behaviours) {
      require(names.insert({b.kind, b.name}).second, {},
              fmt::format("two behaviours of one kind are named `{}`", b.name));
      for (const Parameter& p : b.parameters) {
        require(p.type.kind != TypeKind::Bool && sound(p.type), {},
                fmt::format("parameter `{}` of `{}` is no number", p.name, b.name));
      }
      for (SensorId id : b.reads) {
        require(id.index < m_.sensors.size(), {},
                fmt::format("`{}` reads a sensor that is not there", b.name));
      }
    }
  }

  /// Whether operands and sensor of expression `i` are there, and no more than there should be.
  bool complete(uint32_t i, const Expr& e) const {
    const uint32_t count = opInfo(e.op).operands;
    for (uint32_t k = 0; k < e.operands.size(); ++k) {
      const ExprId operand = e.operands.at(k);
      if (k < count ? operand.index >= i : operand.valid()) {
        return false;
      }
    }
    const bool reads = e.op == Op::Sensor || e.op == Op::Age;
    return reads ? e.sensor.index < m_.sensors.size() : !e.sensor.valid();
  }

  bool expressions() {
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const Expr& e = m_.exprs[i];
      const bool known = static_cast<size_t>(e.op) < opCount();
      if (!known || !complete(i, e)) {
        require(false, e.range,
                fmt::format("expression {} lacks an operand or has one too many", i));
        return false;
      }
      const std::optional<Type> type = resultType(m_, e);
      require(type == e.type && sound(e.type), e.range,
              fmt::format("the operands or the type of `{}` do not fit", opInfo(e.op).text));
      require(std::isfinite(e.number) && (e.op == Op::Constant || e.number == 0), e.range,
              fmt::format("expression {} holds the number {}", i, e.number));
    }
    return true;
  }

  /// Whether `id` is an expression of numbers (or of truth).
  bool expression(ExprId id, bool truth) const {
    return id.index < m_.exprs.size() && (m_[id].type.kind == TypeKind::Bool) == truth;
  }

  void states() {
    require(!m_.states.empty(), {}, "a mission needs at least one state");
    std::set<std::string_view> names;
    for (const State& s : m_.states) {
      require(names.insert(s.name).second, s.range,
              fmt::format("two states are named `{}`", s.name));
      activity(s, s.route, BehaviourKind::Route, "route");
      activity(s, s.profile, BehaviourKind::Profile, "profile");
      for (const LogItem& item : s.log) {
        require(expression(item.value, false), s.range,
                fmt::format("state `{}` logs `{}`, which is no number", s.name, item.name));
        require(item.period_s >= 0 && std::isfinite(item.period_s), s.range,
                fmt::format("state `{}` logs `{}` every {} s", s.name, item.name, item.period_s));
      }
      for (const Case& c : s.cases) {
        require(expression(c.guard, true), c.range,
                fmt::format("a guard of state `{}` is not true or false", s.name));
        const bool targeted = c.transition == Transition::Goto || c.transition == Transition::Call;
        require(targeted ? c.target.index < m_.states.size() : !c.target.valid(), c.range,
                fmt::format("a case of state `{}` has no target, or one too many", s.name));
      }
    }
  }

  void activity(const State& s, const Activity& a, BehaviourKind kind, std::string_view what) {
    if (a.behaviour.index >= m_.behaviours.size() || m_[a.behaviour].kind != kind) {
      require(false, s.range, fmt::format("state `{}` has no {}", s.name, what));
      return;
    }
    const Behaviour& b = m_[a.behaviour];
    bool fits = a.arguments.size() == b.parameters.size();
    for (size_t i = 0; fits && i < a.arguments.size(); ++i) {
      fits = expression(a.arguments[i], false) && m_[a.arguments[i]].type == b.parameters[i].type;
    }
    require(fits, a.range,
            fmt::format("the arguments of `{}` in state `{}` do not fit its parameters", b.name,
                        s.name));
  }

  const Mission& m_;
  std::vector<Defect> defects_;
};

}  // namespace

std::vector<Defect> validate(const Mission& mission) {
  return Validator(mission).run();
}

}  // namespace glider::ir
