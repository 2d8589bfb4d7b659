// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `unsampled`: cases, profiles and routes that wait for a reading of an instrument which
// their state has switched off, or which it lets read more seldom than its readings stay known
// (GL3146). In: the codes of `sample`, the interval of a time between readings. Certain: while the
// state is current and its commands are obeyed, the reading is unknown (off), or most of the time.
// Nothing is reported of what a state samples at some time, nor of cases of `always` that may fire
// in some state.

#include "hooks/protocol/sampling.h"
#include "ir/core/sampling.h"
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
      forEachReadingAwaited(m_, c.guard,
                            [&](SensorId sensor) { waits(sensor, c.range, "this case"); });
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
    forEachReadingAwaited(m_, c.guard, [&](SensorId sensor) {
      const bool late =
          std::ranges::all_of(m_.states, [&](const State& state) { return isLate(state, sensor); });
      if (late && told.insert(sensor.index).second) {
        tell(sensor, m_.states.front(), c.range, "this case");
      }
    });
  }

  /// The shortest time between readings that a state may command, s; 0 if it does not.
  [[nodiscard]] double shortest(const State& state, SensorId sensor) const {
    const auto& instruments = context_.platform.instruments;
    const auto* instrument = measuring(instruments, m_[sensor].vehicle_name);
    const Sampling* sampling =
        instrument == nullptr
            ? nullptr
            : samplingOf(state, static_cast<uint32_t>(instrument - instruments.data()));
    if (sampling == nullptr) {
      return 0;
    }
    double shortest = kNeverRead;
    const auto isKnown = [&](ExprId) { return sampling->period.valid(); };
    forEachCode(m_, *sampling, isKnown, [&](const Expr& code) {
      shortest = std::min(shortest, secondsOf(code, sampling->period));
    });
    return shortest;
  }

  [[nodiscard]] double secondsOf(const Expr& code, ExprId period) const {
    if (code.op == Op::Constant) {
      const double seconds = hookSamplingSecs(static_cast<uint32_t>(code.number));
      return seconds < 0 ? kNeverRead : seconds >= 0 ? seconds : 0;
    }
    const bool known = period.valid() && !context_.intervals[period.index].empty;
    return known ? context_.intervals[period.index].lowest : 0;
  }

  [[nodiscard]] bool isLate(const State& state, SensorId sensor) const {
    return shortest(state, sensor) > m_[sensor].stale_after_s;
  }

  void tell(SensorId id, const State& state, const support::SourceRange& range,
            std::string_view who) {
    const Sensor& sensor = m_[id];
    const std::string& instrument =
        measuring(context_.platform.instruments, sensor.vehicle_name)->name;
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
