// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::random_proofs {
namespace {

using ir::Assumption;
using ir::AssumptionKind;
using ir::ExprId;
using ir::Op;

/// Written as frontend/sema/declarations/lower_assumption.cpp does.
class Assumptions {
 public:
  Assumptions(ir::Mission& mission, Conditions& conditions, random_missions::Random& random)
      : m_(mission), conditions_(conditions), random_(random) {}

  void add() {
    for (uint32_t k = random_.between(1, 2); k > 0; --k) {
      Assumption a;
      if (fill(a)) {
        m_.assumptions.push_back(std::move(a));
      }
    }
  }

 private:
  bool fill(Assumption& a) {
    switch (random_.below(6)) {
      case 0:
        return startDepth(a);
      case 1:
        return outage(a);
      case 2:
        return range(a);
      case 3:
        return known(a);
      case 4:
        return current(a);
      default:
        a.words = "a condition";
        a.watch.condition = conditions_.ofReadings();
        return true;
    }
  }

  [[nodiscard]] bool hasOne(AssumptionKind kind) const {
    return std::ranges::find(m_.assumptions, kind, &Assumption::kind) != m_.assumptions.end();
  }

  bool startDepth(Assumption& a) {
    constexpr double kDepths[] = {0, 1, 2.5, 6};
    a.kind = AssumptionKind::StartDepth;
    a.limit = random_.pick(kDepths);
    a.words = fmt::format("start depth <= {} m", a.limit);
    return !hasOne(a.kind);
  }

  bool current(Assumption& a) {
    constexpr double kCurrents[] = {0.1, 0.4, 0.8};
    a.kind = AssumptionKind::Current;
    a.limit = random_.pick(kCurrents);
    a.words = fmt::format("current <= {} m/s", a.limit);
    return !hasOne(a.kind);
  }

  bool outage(Assumption& a) {
    constexpr double kOutages[] = {0, 20, 60, 600};
    constexpr double kGap = 20;
    a.kind = AssumptionKind::Outage;
    a.limit = random_.pick(kOutages);
    a.words = fmt::format("outage <= {} s", a.limit);
    if (hasOne(a.kind)) {
      return false;
    }
    ir::MonitorWriter monitor = builder(a);
    monitor.everyTick();
    const ir::VariableId last = monitor.clock("last");
    monitor.violation(monitor.passed(last, std::max(a.limit, kGap)), "no tick");
    monitor.set(last, monitor.now());
    monitor.finish(a.watch);
    return true;
  }

  bool range(Assumption& a) {
    const auto sensor = conditions_.measured(depth());
    if (!sensor) {
      return false;
    }
    const ir::Sensor row = m_[*sensor];
    const double lowest = std::clamp(row.lowest * row.to_si, -1e6, 1e6);
    const double highest = std::clamp(row.highest * row.to_si, -1e6, 1e6);
    const double one = random_.chance(0.4) ? lowest : random_.uniform(lowest, highest);
    const double other = random_.chance(0.4) ? highest : random_.uniform(lowest, highest);
    a.kind = AssumptionKind::Range;
    a.sensor = *sensor;
    a.lowest = std::min(one, other);
    a.highest = std::max(one, other);
    a.words = fmt::format("{} in {} .. {}", row.name, a.lowest, a.highest);
    ir::MonitorWriter write = builder(a);
    const ExprId reading = conditions_.reading(*sensor);
    const auto is = [&](Op op, double limit) {
      return write.operation(op, ir::boolean(), {reading, write.number(limit, row.type)});
    };
    const ExprId below = is(Op::Less, a.lowest);
    a.watch.condition = write.negation(write.either(below, is(Op::Greater, a.highest)));
    return true;
  }

  bool known(Assumption& a) {
    const auto sensor = conditions_.measured(depth());
    if (!sensor) {
      return false;
    }
    const double every = conditions_.time();
    a.words = fmt::format("known {} every {} s", m_[*sensor].name, every);
    ir::MonitorWriter monitor = builder(a);
    const ExprId reading = conditions_.reading(*sensor);
    monitor.everyTick();
    monitor.longest(every);
    const ir::VariableId last = monitor.clock("last");
    const ExprId known = monitor.operation(Op::Known, ir::boolean(), {reading});
    monitor.when(known, [&] { monitor.set(last, monitor.now()); });
    monitor.violation(monitor.passed(last, every), "it was unknown");
    monitor.finish(a.watch);
    return true;
  }

  /// Assumptions and requirements are about the true depth.
  [[nodiscard]] std::optional<ir::SensorId> depth() const {
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      if (m_.sensors[i].vehicle_name == "m_depth") {
        return ir::SensorId{i};
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] ir::MonitorWriter builder(const Assumption& a) const {
    return {m_, fmt::format("assumption {}", m_.assumptions.size() + 1), a.range};
  }

  ir::Mission& m_;
  Conditions& conditions_;
  random_missions::Random& random_;
};

}  // namespace

void addAssumptions(ir::Mission& mission, Conditions& conditions, random_missions::Random& random) {
  Assumptions(mission, conditions, random).add();
}

}  // namespace glider::random_proofs
