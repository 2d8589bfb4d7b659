// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `silentSensors`: missions that no clock can end, so that they fly on until the vehicle
// aborts if their sensors report nothing (GL3118). In: the mission with sensors that never have a
// known reading. Out: a warning with the sensors on which the end depends. Certain that no `exit`
// fires without readings. Nothing is reported if the mission may command the surface, where a pilot
// can end it, or if `ir/verify` reports that it has no exit at all.

#include "ir/core/ops.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/context/sensors_awaited.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

using MayFire = std::function<bool(ExprId guard)>;

/// The states that a trace may enter if only these cases may fire. Each case of `always` may fire
/// in every state, and a return leads only to states that have been entered.
struct Reached {
  Reached(const Mission& mission, const MayFire& may_fire)
      : mission_(mission), may_fire_(may_fire), states(mission.states.size()) {
    enter({0});
    follow(mission.always);
    while (!open_.empty()) {
      const StateId next = open_.back();
      open_.pop_back();
      follow(mission[next].cases);
    }
  }

 private:
  void follow(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      const bool ends = c.transition == Transition::Exit;
      if ((!ends && !c.target.valid()) || !may_fire_(c.guard)) {
        continue;
      }
      exits = exits || ends;
      if (c.target.valid()) {
        enter(c.target);
      }
    }
  }

  void enter(StateId state) {
    if (!states[state.index]) {
      states[state.index] = true;
      open_.push_back(state);
    }
  }

  const Mission& mission_;
  const MayFire& may_fire_;
  std::vector<StateId> open_;

 public:
  std::vector<bool> states;
  bool exits = false;  ///< an `exit` may fire
};

/// Looks for a mission that no clock can end: if its sensors report nothing, it flies on until the
/// vehicle aborts.
class SilenceCheck {
 public:
  explicit SilenceCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    // Most missions have an exit by a clock; this finds it without looking at values.
    if (Reached(m_, [&](ExprId guard) { return !awaitsSensor(guard); }).exits ||
        !Reached(m_, [](ExprId) { return true; }).exits) {
      return;
    }
    Mission silent = m_;
    for (Sensor& sensor : silent.sensors) {
      sensor.lowest = 1;  // no value is in range
      sensor.highest = 0;
    }
    const ProofContext nothing(silent, proof_.proof_context.platform);
    const Valuation values = anyValues(silent);
    constexpr Interval kEver{0, std::numeric_limits<double>::max(), false};
    const AbstractEvaluator possible(nothing, values, {kEver, kEver, kEver});
    const Reached reached(m_, [&](ExprId guard) { return possible.truth(guard).is_true; });
    if (!reached.exits && !surfaces(reached)) {
      tell(reached);
    }
  }

 private:
  /// Whether the vehicle may come to the surface, where its pilot can end the mission.
  [[nodiscard]] bool surfaces(const Reached& reached) const {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      if (reached.states[i] && commandsSurface(m_, m_.states[i])) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool awaitsSensor(ExprId guard) const {
    bool awaits = false;
    forEachSensorAwaited(m_, guard, [&](SensorId) { awaits = true; });
    return awaits;
  }

  /// Names the sensors on which the cases hang that lead away from where the mission stays.
  void tell(const Reached& reached) {
    std::vector<bool> awaited(m_.sensors.size());
    const auto add = [&](const std::vector<Case>& cases) {
      for (const Case& c : cases) {
        if (c.transition != Transition::Stay) {
          forEachSensorAwaited(m_, c.guard, [&](SensorId id) { awaited[id.index] = true; });
        }
      }
    };
    add(m_.always);
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      add(reached.states[i] ? m_.states[i].cases : std::vector<Case>());
    }
    std::vector<std::string> names;
    std::vector<std::string> of_science;
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      if (!awaited[i]) {
        continue;
      }
      const platforms::PlatformSensor* row = proof_.proof_context.platformSensor({i});
      // Missions call the vehicle's clock by that word.
      const bool clock = row != nullptr && row->unit == "timestamp";
      names.push_back(clock ? "`utc`" : fmt::format("`{}`", m_.sensors[i].name));
      if (row != nullptr && row->computer == platforms::Computer::Science) {
        of_science.push_back(names.back());
      }
    }
    if (names.empty()) {
      return;
    }
    auto warning =
        proof_.diagnostics.report(support::diagnostics::endNeedsReadings, m_.states.front().range,
                                  fmt::to_string(fmt::join(names, ", ")));
    if (!of_science.empty()) {
      warning.note(m_.states.front().range,
                   fmt::format("{} {} measured by the science bay, and not every vehicle carries "
                               "every instrument",
                               fmt::join(of_science, ", "), of_science.size() == 1 ? "is" : "are"));
    }
  }

  Proof& proof_;
  const Mission& m_;
};

}  // namespace

void passes::silentSensors(Proof& proof) {
  SilenceCheck(proof).run();
}

}  // namespace glider::ir::prove
