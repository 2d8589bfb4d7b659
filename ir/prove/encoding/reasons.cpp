// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/reasons.h"

#include "ir/core/pilot_name.h"
#include "ir/eval/arithmetic.h"
#include "ir/verify/value_text.h"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

std::string rangeOf(const Sensor& sensor) {
  const double low = reading(sensor, sensor.lowest, 0);
  const double high = reading(sensor, sensor.highest, 0);
  return fmt::format("readings of `{}` lie between {} and {}", sensor.name,
                     withUnit(low, sensor.type), withUnit(high, sensor.type));
}

}  // namespace

void noteReasons(support::DiagnosticBuilder& report, const Mission& mission,
                 const std::vector<Fact>& facts, support::SourceRange where) {
  std::set<std::pair<Fact::From, uint32_t>> told;
  for (const Fact& fact : facts) {
    if (!told.emplace(fact.from, fact.index).second) {
      continue;
    }
    switch (fact.from) {
      case Fact::From::Sensor:
        report.note(where, rangeOf(mission.sensors[fact.index]));
        break;
      case Fact::From::Age:
        report.note(where,
                    fmt::format("a reading of `{}` is unknown once it is older than {:.6g} s",
                                mission.sensors[fact.index].name,
                                mission.sensors[fact.index].stale_after_s));
        break;
      case Fact::From::Variable: {
        const Variable& variable = mission.variables[fact.index];
        report.note(
            variable.range.valid() ? variable.range : where,
            fmt::format("`{}` lies in {}", pilotName(mission, {fact.index}), rangeText(variable)));
        break;
      }
      case Fact::From::Temporal:
        report.note(mission.temporals[fact.index].range, "nothing more is known about this");
        break;
      case Fact::From::Nature:
        break;
    }
  }
}

}  // namespace glider::ir::prove
