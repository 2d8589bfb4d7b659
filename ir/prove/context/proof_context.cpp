// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/proof_context.h"

#include "ir/core/ops.h"
#include "ir/prove/context/never_unknown.h"
#include "ir/prove/context/setting.h"
#include "ir/verify/intervals.h"
#include "ir/verify/value_text.h"
#include "ir/verify/whole_numbers.h"
#include "ir/worlds/depth_sensor.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

/// Every clock runs from 0 and no faster than mission time.
std::vector<Interval> intervalsUntil(const Mission& mission, double latest) {
  return intervalsOf(mission, [&](const Expr& e) {
    const bool clock = groupOf(e.op) == OpGroup::Clock || groupOf(e.op) == OpGroup::Age;
    return clock ? std::optional(Interval{0, latest, false}) : std::nullopt;
  });
}

/// Variables that keep when something happened, such as `set leak_at = missiontime`.
std::vector<bool> missionTimesOf(const Mission& mission) {
  const auto expression = [&](size_t index, const GreatestFixpoint& judged) {
    const Expr& e = mission.exprs[index];
    return e.op == Op::MissionTime || (e.op == Op::Constant && e.number == 0) ||
           (e.op == Op::Variable && judged.variables[e.variable.index]);
  };
  const auto begins = [](const Variable& variable, bool initial) {
    return variable.kind != VariableKind::Parameter &&  // which may be set to another time
           (variable.kind == VariableKind::Argument || (variable.initial.valid() && initial));
  };
  return greatestFixpoint(mission, {expression, begins, /*lost_by_set=*/true}).expressions;
}

}  // namespace

ProofContext::ProofContext(const Mission& asked, const platforms::Platform& vehicle)
    : ProofContext(asked, vehicle, kGreatestNumber) {}

ProofContext::ProofContext(const Mission& asked, const platforms::Platform& vehicle, double latest)
    : mission(asked),
      platform(vehicle),
      intervals(intervalsUntil(asked, latest)),
      known(neverUnknown(asked, intervals)),
      whole(wholeExpressions(asked, intervals)),
      mission_times(missionTimesOf(asked)),
      set_since(setSinceWatched(asked)),
      depth(depthSensor(asked, vehicle)),
      tick_gap_s(std::max(vehicle.world.tick_gap_s, asked.resume_within_s)),
      latest_s(latest) {
  sensors.assign(mission.sensors.size(), {-kGreatestNumber, kGreatestNumber, false});
  windows.assign(mission.temporals.size(), {-kGreatestNumber, kGreatestNumber, false});
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    const Expr& e = mission.exprs[i];
    if (e.op == Op::Sensor) {
      sensors[e.sensor.index] = intervals[i];
    } else if (e.op == Op::Temporal) {
      windows[e.temporal.index] = intervals[i];
    }
  }
}

ProofContext ProofContext::withDepthKnown() const {
  ProofContext seen = *this;
  for (size_t i = 0; i < mission.exprs.size(); ++i) {
    const Expr& e = mission.exprs[i];
    if (e.op == Op::Sensor && e.sensor == depth) {
      seen.known.expressions[i] = true;
    }
  }
  return seen;
}

ProofContext ProofContext::ofVersion(const Mission& changed) const {
  ProofContext same(changed, platform);
  same.tick_gap_s = tick_gap_s;
  return same;
}

ProofContext ProofContext::withoutPowerCuts() const {
  ProofContext same = *this;
  same.tick_gap_s = platform.world.tick_gap_s;
  return same;
}

ProofContext ProofContext::endingBy(double latest) const {
  ProofContext same(mission, platform, latest);
  same.tick_gap_s = tick_gap_s;
  return same;
}

std::string ProofContext::readingText(SensorId id, double value) const {
  const platforms::PlatformSensor* row = platformSensor(id);
  return withCountedUnit(value, mission[id].type, row == nullptr ? std::string_view() : row->unit);
}

}  // namespace glider::ir::prove
