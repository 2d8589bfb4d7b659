// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `unsampled`: cases, profiles and routes that wait for a reading of an instrument which
// their state has switched off, or which it lets read more seldom than its readings stay known
// (GL3146). In: the codes of `sample`, the interval of a time between readings. Certain: while the
// state is current and its commands are obeyed, the reading is unknown (off), or most of the time.
// Nothing is reported of what a state samples at some time, nor of cases of `always` that may fire
// in some state.

#include "hooks/protocol/sampling.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/sensors_awaited.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kNeverRead = std::numeric_limits<double>::infinity();

/// Calls `visit` with each sensor whose reading an expression, or what its temporals watch, waits
/// for. Whether there is one, and how old it is, may be asked of an instrument that is off.
template <typename Visit>
void forEachReading(const Mission& mission, ExprId expression, Visit visit) {
  std::vector<ExprId> open{expression};
  std::set<ExprId> seen;
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid() || !seen.insert(id).second) {
      continue;
    }
    const Expr& e = mission[id];
    if (e.op == Op::Sensor) {
      visit(e.sensor);
    } else if (e.op == Op::Temporal) {
      const Temporal& watched = mission[e.temporal];
      open.insert(open.end(), {watched.along, watched.duration, watched.operand});
    } else if (e.op != Op::Known && e.op != Op::Age && !hasDefault(mission, e)) {
      open.insert(open.end(), e.operands.begin(), e.operands.begin() + operandCount(e));
    }
  }
}

class UnsampledSearch {
 public:
  explicit UnsampledSearch(Proof& proof)
      : proof_(proof), context_(proof.proof_context), m_(context_.mission) {}

  void run() {
    for (const State& state : m_.states) {
      if (!state.sampling.empty()) {
        inState(state);
      }
    }
    for (const Case& c : m_.always) {
      inAlways(c);
    }
  }

 private:
  void inState(const State& state) {
    std::set<uint32_t> told;
    const auto waits = [&](SensorId sensor, const support::SourceRange& range,
                           std::string_view who) {
      if (isLate(state, sensor) && told.insert(sensor.index).second) {
        tell(sensor, state, range, who);
      }
    };
    for (const Case& c : state.cases) {
      forEachReading(m_, c.guard, [&](SensorId sensor) { waits(sensor, c.range, "this case"); });
    }
    for (const auto& [activity, who] :
         {std::pair(&state.profile, "the profile"), std::pair(&state.route, "the route")}) {
      for (const Case& c : activity->cases) {
        forEachSensorAwaited(m_, c.guard,
                             [&](SensorId sensor) { waits(sensor, activity->range, who); });
      }
      for (const SensorId sensor : m_[activity->behaviour].reads) {
        waits(sensor, activity->range, who);
      }
    }
  }

  void inAlways(const Case& c) {
    std::set<uint32_t> told;
    forEachReading(m_, c.guard, [&](SensorId sensor) {
      const bool late =
          std::ranges::all_of(m_.states, [&](const State& state) { return isLate(state, sensor); });
      if (late && told.insert(sensor.index).second) {
        tell(sensor, m_.states.front(), c.range, "this case");
      }
    });
  }

  /// The instrument that measures a sensor, by its place; none if missions do not switch it.
  [[nodiscard]] const platforms::Instrument* instrumentOf(SensorId sensor) const {
    const auto& all = context_.platform.instruments;
    const auto found = std::ranges::find_if(all, [&](const platforms::Instrument& one) {
      return std::ranges::find(one.sensors, m_[sensor].vehicle_name) != one.sensors.end();
    });
    return found == all.end() ? nullptr : &*found;
  }

  /// The shortest time between readings that a state may command, s; 0 if it does not.
  [[nodiscard]] double shortest(const State& state, SensorId sensor) const {
    const platforms::Instrument* instrument = instrumentOf(sensor);
    if (instrument == nullptr) {
      return 0;
    }
    const auto place = static_cast<uint32_t>(instrument - context_.platform.instruments.data());
    const auto found = std::ranges::find(state.sampling, place, &Sampling::place);
    return found == state.sampling.end() ? 0 : shortestOf(*found, found->code);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the choices of one word
  [[nodiscard]] double shortestOf(const Sampling& sampling, ExprId code) const {
    const Expr& e = m_[code];
    if (e.op == Op::Select) {
      const bool certain = m_[e.operands[0]].op == Op::Known && sampling.period.valid();
      return certain ? shortestOf(sampling, e.operands[1])
                     : std::min(shortestOf(sampling, e.operands[1]),
                                shortestOf(sampling, e.operands[2]));
    }
    if (e.op == Op::Constant) {
      const double seconds = hookSamplingSecs(static_cast<uint32_t>(e.number));
      return seconds < 0 ? kNeverRead : seconds >= 0 ? seconds : 0;
    }
    const bool known = sampling.period.valid() && !context_.intervals[sampling.period.index].empty;
    return known ? context_.intervals[sampling.period.index].lowest : 0;
  }

  [[nodiscard]] bool isLate(const State& state, SensorId sensor) const {
    return shortest(state, sensor) > m_[sensor].stale_after_s;
  }

  void tell(SensorId id, const State& state, const support::SourceRange& range,
            std::string_view who) {
    const Sensor& sensor = m_[id];
    const std::string& instrument = instrumentOf(id)->name;
    const double seconds = shortest(state, id);
    const std::string often =
        seconds == kNeverRead
            ? fmt::format("`{}` is off in state `{}`", instrument, state.name)
            : fmt::format("`{}` reads every {} in state `{}`, and a reading is known for {}",
                          instrument, durationOf(seconds), state.name,
                          durationOf(sensor.stale_after_s));
    proof_.diagnostics.report(
        support::diagnostics::unsampled, range, who, sensor.name, often,
        fmt::format("`sample {} every {:g} s`", instrument, std::min(10.0, sensor.stale_after_s)));
  }

  Proof& proof_;
  const ProofContext& context_;
  const Mission& m_;
};

}  // namespace

void passes::unsampled(Proof& proof) {
  UnsampledSearch(proof).run();
}

}  // namespace glider::ir::prove
