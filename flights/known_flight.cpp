// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/known_flight.h"

#include "ir/prove/context/proof_context.h"
#include "ir/prove/context/requirement_monitor.h"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <set>

namespace glider::flights {
namespace {

/// The true depth (m) at vehicle times that do not fall; NaN beyond the trace.
class TrueDepth {
 public:
  explicit TrueDepth(const support::Trace& trace)
      : trace_(trace), column_(trace.column("true_depth")) {}

  double at(double time) {
    while (row_ < trace_.rowCount() && trace_.at(row_, 0) < time) {
      ++row_;
    }
    const bool there = column_ >= 0 && row_ < trace_.rowCount();
    return there ? trace_.at(row_, column_) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  const support::Trace& trace_;
  int column_;
  size_t row_ = 0;
};

/// What a mission, and who watches it, know at a tick.
struct Knowledge {
  ir::Interpreter interpreter;
  ir::RequirementMonitor monitor;
};

/// The ticks from which the mission has continued without those that followed them.
std::set<size_t> returnedTo(const HeardMission& heard) {
  std::set<size_t> all;
  for (size_t i = 0; i < heard.ticks.size(); ++i) {
    const auto before = heard.ticks[i].before;
    if (before && *before + 1 != i) {
      all.insert(*before);
    }
  }
  return all;
}

}  // namespace

std::optional<FlownViolation> firstViolation(const ir::Requirement& required,
                                             const KnownFlight& flight) {
  const ir::Mission& m = flight.mission.checked->mission();
  const platforms::Platform& platform = flight.mission.platform();
  const Knowledge nothing{ir::Interpreter(m, flight.mission.checked->facts.stack_depth),
                          ir::RequirementMonitor(m, required, platform.world.surface_depth_m,
                                                 ir::prove::depthSensor(m, platform))};
  const std::set<size_t> needed = returnedTo(flight.heard);
  std::map<size_t, Knowledge> kept;
  TrueDepth depth(flight.trace);
  std::optional<Knowledge> known;
  for (size_t i = 0; i < flight.heard.ticks.size(); ++i) {
    const KnownTick& tick = flight.heard.ticks[i];
    if (!tick.before) {
      known.emplace(nothing);
    } else if (*tick.before + 1 != i) {
      known.emplace(kept.at(*tick.before));
    }
    const auto result = tick.before
                            ? known->interpreter.tick(tick.heard.mission_time, tick.heard.frame)
                            : known->interpreter.start(tick.heard.frame, flight.parameters);
    known->monitor.tick(known->interpreter, tick.heard.mission_time, result,
                        depth.at(tick.heard.vehicle_time));
    if (known->monitor.when()) {
      return FlownViolation{0, tick.heard.mission_time, tick.heard.vehicle_time,
                            m[result.state].name, known->monitor.words()};
    }
    if (needed.contains(i)) {
      kept.emplace(i, *known);
    }
  }
  return std::nullopt;
}

std::string outagesBefore(const HeardMission& heard, double vehicle_time) {
  size_t count = 0;
  std::string last;
  for (size_t i = 1; i < heard.ticks.size(); ++i) {
    const HeardTick& tick = heard.ticks[i].heard;
    if (heard.ticks[i].resumed && tick.vehicle_time <= vehicle_time) {
      ++count;
      last = fmt::format("mission time {:.6g} s to {:.6g} s",
                         heard.ticks[*heard.ticks[i].before].heard.mission_time, tick.mission_time);
    }
  }
  return count == 0   ? ""
         : count == 1 ? fmt::format("after an outage of the SBC from {}", last)
                      : fmt::format("after {} outages of the SBC, the last from {}", count, last);
}

}  // namespace glider::flights
