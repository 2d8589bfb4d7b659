// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/vehicle_guards.h"

#include "ir/core/walk.h"
#include "ir/prove/abstract/abstract_evaluator.h"
#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/hovers.h"
#include "ir/prove/context/duration_text.h"
#include "ir/prove/context/proof_context.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/verification.h"
#include "vehicles/slocum/rules/refused_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glider::slocum::rules {
namespace {

/// Every turn of a dive goes at least this far past its target, m: 0.7 m at the flattest pitch.
constexpr double kSurelyPast_m = 0.5;
/// How far the vehicle sinks between the reading of an altitude and the end of the dive that the
/// mission then ends, m: a cycle and the turn, 2.6 m in real logs.
constexpr double kSinksOn_m = 3;
/// hookbeh uses no smaller min_altitude (hooks/hookbeh/hull.c).
constexpr double kLeastAltitude_m = 2;
/// A hover is never longer at one depth than this, s: every 300 to 600 s hookbeh shows by a climb
/// of 4 to 5 m that its depth answers (hooks/hookbeh/README.md), and abend then counts from the
/// start.
constexpr double kHoverShowsDepth_s = 660;

/// Compares the commanded depths and hovers of a mission with the limits in the vehicle's mission
/// file. Certain cases are errors; those that depend on water, trim or time are warnings. The
/// vehicle is taken to be healthy.
class GuardCheck {
 public:
  GuardCheck(const ir::WrittenWorld& world, const VehicleFile& file,
             support::DiagnosticEngine& diagnostics)
      : m_(world.mission),
        platform_(world.platform),
        file_(file),
        diagnostics_(diagnostics),
        deepest_(std::min(file.guards.greatest_depth_m, platform_.envelope.greatest_depth_m)),
        overshoot_(platform_.envelope.inflection_overshoot_m) {}

  void dives() {
    for (const Dive& dive : divesOf(m_)) {
      pastGreatestDepth(dive);
      pastOverdepth(dive);
    }
  }

  void layers(std::span<const Layer> layers) {
    for (const Layer& layer : layers) {
      if (layer.role != Role::Flies || !layer.deepest_m || !(*layer.deepest_m > 0)) {
        continue;
      }
      const std::string dives =
          fmt::format("{} dives to {:.4g} m", layer.label(), *layer.deepest_m);
      const auto overdepth = file_.aborts.overdepth_m;
      if (overdepth && *layer.deepest_m + kSurelyPast_m > *overdepth) {
        diagnostics_.report(support::diagnostics::vehicleAborts, layer.range,
                            fmt::format("{}, and abend allows no more than {:.4g} m (overdepth in "
                                        "{})",
                                        dives, *overdepth, file_.name),
                            "give it a shallower depth, or raise overdepth");
      } else if (*layer.deepest_m + kSurelyPast_m > deepest_) {
        diagnostics_.report(support::diagnostics::mayNotFollow, layer.range,
                            fmt::format("{}, and where the SBC takes control below {:.4g} m ({}) "
                                        "hookbeh first makes the vehicle climb",
                                        dives, deepest_, whose()),
                            isHulls() ? "give it a shallower depth"
                                      : "give it a shallower depth, or raise max_depth");
      }
    }
  }

  void avoidances() {
    const double least = std::max(file_.guards.least_altitude_m, kLeastAltitude_m);
    const auto altitude = sensorCalled("altitude");
    if (file_.guards.least_altitude_m < 0 || !altitude) {
      return;
    }
    const ir::prove::ProofContext proof_context(m_, platform_);
    const ir::prove::Valuation values = ir::prove::anyValues(m_);
    const auto look = [&](const std::vector<ir::Case>& cases, const Use& use) {
      for (const ir::Case& c : cases) {
        const auto below = firesBelow(proof_context, values, *altitude, c.guard);
        if (below && *below + kFine_m < least + kSinksOn_m) {
          tooLate(c, *below, least, use);
        }
      }
    };
    look(m_.always, {});
    for (const ir::State& state : m_.states) {
      look(state.cases, {});
      look(state.profile.cases, {&state, &state.profile});
      look(state.route.cases, {&state, &state.route});
    }
  }

 private:
  static constexpr double kFine_m = 1e-6;  ///< of the altitude at which a case fires

  /// Where a state uses the profile or the route of a case; empty: the case is its own.
  struct Use {
    const ir::State* state = nullptr;
    const ir::Activity* activity = nullptr;
  };

  [[nodiscard]] support::SourceRange placeOf(const Dive& dive) const {
    return dive.range.valid() ? dive.range : m_.states.front().range;
  }

  /// Whether no mission file can allow more.
  [[nodiscard]] bool isHulls() const {
    return file_.guards.greatest_depth_m >= platform_.envelope.greatest_depth_m;
  }
  /// Whose limit `deepest_` is.
  [[nodiscard]] std::string whose() const {
    return isHulls() ? "the limit of its hull, which is built into hookbeh"
                     : fmt::format("max_depth in {}", file_.name);
  }

  void pastGreatestDepth(const Dive& dive) {
    if (dive.depth_m > deepest_ || dive.depth_m + overshoot_ <= deepest_) {
      return;  // it is refused (GL3124), or leaves room for the turn
    }
    const bool surely = dive.depth_m + kSurelyPast_m > deepest_;
    diagnostics_.report(
        surely ? support::diagnostics::hookbehOverrides : support::diagnostics::mayNotFollow,
        placeOf(dive),
        fmt::format("{} goes to {:.4g} m, a turn there {} up to {:.4g} m further, and below {:.4g} "
                    "m hookbeh makes the vehicle climb ({})",
                    dive.who, dive.depth_m, surely ? "goes" : "may go", overshoot_, deepest_,
                    whose()),
        fmt::format("command at most {:.4g} m{}", std::max(0.0, deepest_ - overshoot_),
                    dive.depth_m + overshoot_ > platform_.envelope.greatest_depth_m
                        ? ""
                        : fmt::format(", or give max_depth {:.4g}", dive.depth_m + overshoot_)));
  }

  void pastOverdepth(const Dive& dive) {
    const auto overdepth = file_.aborts.overdepth_m;
    if (!overdepth || dive.depth_m > *overdepth || dive.depth_m + overshoot_ <= *overdepth) {
      return;
    }
    const bool surely = dive.depth_m + kSurelyPast_m > *overdepth;
    const std::string what = fmt::format(
        "{} goes to {:.4g} m, a turn there {} up to {:.4g} m further, and abend {} below {:.4g} m "
        "(overdepth in {})",
        dive.who, dive.depth_m, surely ? "goes" : "may go", overshoot_,
        surely ? "allows nothing" : "aborts", *overdepth, file_.name);
    diagnostics_.report(
        surely ? support::diagnostics::vehicleAborts : support::diagnostics::mayNotFollow,
        placeOf(dive), what,
        fmt::format("command at most {:.4g} m, or give overdepth {:.4g}",
                    std::max(0.0, *overdepth - overshoot_), dive.depth_m + overshoot_));
  }

  [[nodiscard]] std::optional<ir::SensorId> sensorCalled(std::string_view alias) const {
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      const auto* row = platform_.find(m_.sensors[i].vehicle_name);
      if (row != nullptr && row->alias == alias) {
        return ir::SensorId{i};
      }
    }
    return std::nullopt;
  }

  /// The altitude above which the guard is never true; none if it does not only depend on a low
  /// one.
  [[nodiscard]] std::optional<double> firesBelow(const ir::prove::ProofContext& proof_context,
                                                 const ir::prove::Valuation& values,
                                                 ir::SensorId altitude, ir::ExprId guard) const {
    if (!readsSensor(guard, altitude)) {
      return std::nullopt;
    }
    for (const bool ever : {false, true}) {
      const auto may = [&](double reading) {
        constexpr ir::Interval kEver{0, ir::kGreatestNumber, false};
        const ir::prove::AssumedReading sight{altitude, {reading, reading, false}, ever};
        return ir::prove::AbstractEvaluator(proof_context, values, {kEver, kEver, kEver}, sight)
            .truth(guard)
            .is_true;
      };
      const ir::Interval& all = proof_context.sensors[altitude.index];
      double low = all.lowest, high = all.highest;
      if (all.empty || !may(low) || may(high)) {
        continue;
      }
      while (high - low > kFine_m) {
        const double middle = (low + high) / 2;
        (may(middle) ? low : high) = middle;
      }
      return low;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool readsSensor(ir::ExprId guard, ir::SensorId sensor) const {
    return ir::anyIn(m_, guard, [&](const ir::Expr& e) {
      if (e.op == ir::Op::Temporal) {
        const ir::ExprId operand = m_.temporals[e.temporal.index].operand;
        return operand.valid() && readsSensor(operand, sensor);
      }
      return e.op == ir::Op::Sensor && e.sensor == sensor;
    });
  }

  void tooLate(const ir::Case& c, double below, double least, const Use& use) {
    const std::string then =
        below <= least
            ? fmt::format(", but hookbeh already makes the vehicle climb at {:.4g} m", least)
            : fmt::format(
                  "; until the vehicle has turned it may be at {:.4g} m, where hookbeh makes "
                  "it climb",
                  least);
    const support::SourceRange& range = m_[c.guard].range.valid() ? m_[c.guard].range : c.range;
    // A case of the library is not the pilot's: what can be changed is where it is used.
    const bool elsewhere = use.state != nullptr && range.file != use.state->range.file;
    const std::string what =
        elsewhere ? fmt::format("`{}` turns here only", m_[use.activity->behaviour].name)
                  : "this case fires";
    auto report = diagnostics_.report(
        support::diagnostics::mayNotFollow, elsewhere ? use.activity->range : range,
        fmt::format("{} at less than {:.3g} m above the bottom{} (min_altitude in {})", what, below,
                    then, file_.name),
        fmt::format(
            "{} {:.4g} m or more: {:.4g} m for the vehicle's own climb and {:.4g} m in which "
            "it sinks on while it turns; or lower min_altitude",
            elsewhere ? "give it" : "compare with", least + kSinksOn_m, least, kSinksOn_m));
    if (elsewhere) {
      report.note(range, "it is this case of it");
    }
  }

  const ir::Mission& m_;
  const platforms::Platform& platform_;
  const VehicleFile& file_;
  support::DiagnosticEngine& diagnostics_;
  double deepest_;    ///< below it hookbeh climbs, m
  double overshoot_;  ///< m
};

}  // namespace

void checkGuards(const ir::WrittenWorld& world, const VehicleFile& file,
                 std::span<const Layer> layers, support::DiagnosticEngine& diagnostics) {
  GuardCheck check(world, file, diagnostics);
  check.dives();
  check.layers(layers);
  check.avoidances();
}

void checkSameDepth(const ir::WrittenWorld& world, const VehicleFile& file,
                    support::DiagnosticEngine& diagnostics) {
  if (!file.aborts.samedepth_for_s) {
    return;
  }
  const double allowed = *file.aborts.samedepth_for_s;
  const ir::prove::ProofContext proof_context(world);
  const auto end = ir::prove::boundOf(proof_context.withoutPowerCuts(), ir::prove::kLongestMission,
                                      ir::prove::Goal::Exit);
  for (const ir::prove::LongHover& hover : ir::prove::longHovers(proof_context, end)) {
    const double lasts = std::min(hover.lasts_s, kHoverShowsDepth_s);
    if (!(lasts > allowed)) {
      continue;
    }
    const ir::State& state = world.mission[hover.state];
    diagnostics.report(
        support::diagnostics::vehicleAborts, state.range,
        fmt::format("`{}` may stay at {:.4g} m {}, and abend allows {} at one depth (samedepth_for "
                    "in {})",
                    state.name, hover.depth_m,
                    std::isfinite(lasts) ? "for " + ir::prove::durationOf(lasts)
                                         : std::string("without a limit by the clocks"),
                    ir::prove::durationOf(allowed), file.name),
        "end it sooner, fly a yo of some metres in between, or raise samedepth_for");
  }
}

}  // namespace glider::slocum::rules
