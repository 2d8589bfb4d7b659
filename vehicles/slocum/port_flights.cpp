// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/port_flights.h"

#include "vehicles/slocum/oracles/port_judge.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/port/port_file.h"
#include "vehicles/slocum/rules/port/port_whole.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace glider::vehicles {
namespace {

using slocum::rules::PortFile;

/// The mission file by which the vehicle flies; null: not by one of its port.
const slocum::MissionFile* portFileOf(const simulator::Scenario& scenario) {
  const slocum::MissionFile* const own = slocum::oracles::portFileIn(scenario);
  return own != nullptr && slocum::rules::isPortFile(*own) ? own : nullptr;
}

/// Whether a line changes or loses bytes, so that a wrong sentence can pass its sum, which is
/// short. A line that is cut, late or repeats itself says nothing wrong.
bool damagesSentences(const simulator::Faults& faults) {
  return std::ranges::any_of(faults.lines, [](const simulator::LineFault& line) {
    return line.loss > 0 || line.flips > 0 || line.bursts > 0 || line.heard_at_baud > 0;
  });
}

/// How deep the vehicle may be, m.
struct Depths {
  double commanded_m;  ///< the deepest target of the SBC
  double aborted_m;    ///< the true depth in which an abort turns it round, for any target
};

/// What the mission file bounds. One without overdepth, which `check` refuses, bounds nothing: then
/// the hull's depth counts.
Depths depthsOf(const slocum::MissionFile& own, const PortFile& port,
                const platforms::Platform& platform) {
  const double most_m =
      std::isfinite(port.deepest_m) ? port.deepest_m : platform.envelope.greatest_depth_m;
  const auto file = slocum::rules::portVehicleFile(own, "", platform);
  return {file.commands.greatest_depth_m.value_or(most_m), most_m};
}

/// The same with the depth that was promised when the program was built: a mission file that was
/// edited since may allow more, and the program still commands no more.
Depths promisedDepths(Depths file, const std::optional<double>& program_m) {
  const double excess_m =
      std::max(0.0, file.commanded_m - program_m.value_or(std::numeric_limits<double>::infinity()));
  return {file.commanded_m - excess_m, file.aborted_m - excess_m};
}

/// From one surfacing to the next, s. A file that does not bring the vehicle up, which `check`
/// refuses, is to be seen in flights too: it is compared with the usual one.
double underAtMost(const slocum::MissionFile& own, const PortFile& port, double deepest_m,
                   const platforms::Platform& platform) {
  const slocum::rules::Ending silence =
      slocum::rules::portWhole(own, port, platform).endings.front();
  const bool stated =
      silence.proved() && silence.parts.front().seconds <= slocum::kMostSurfaceAfter;
  return stated ? silence.seconds()
                : slocum::PortChoice{}.surface_after_s + platform.world.turn_s +
                      deepest_m / platform.world.slowest_climb_m_s;
}

/// Only d_target_altitude of the file keeps the vehicle off the bottom, which needs an echo before
/// it is too late.
bool seesBottom(const simulator::Scenario& scenario) {
  constexpr double kMostLost = 0.2, kLeastRange = 15;
  const auto& altimeter = scenario.sensors.altimeter;
  return altimeter.dropout <= kMostLost && altimeter.range_m >= kLeastRange;
}

}  // namespace

bool isFlownByPort(const simulator::Scenario& scenario) {
  return portFileOf(scenario) != nullptr;
}

/// The faults of the SBC, its line and the science computer, and a bottom that is not where it was.
/// Nothing on the vehicle notices a wrong sensor, and there is no handshake.
bool portPromises(simulator::FaultKind kind) {
  using enum simulator::FaultKind;
  constexpr simulator::FaultKind kKinds[] = {
      None,    ByteLoss,     BitFlips,      Bursts,      Delay,       DoubledFrames, HalfOpen,
      LineCut, BaudMismatch, FlightScience, LateLine,    Port,        Power,         Checkpoints,
      Stuck,   Science,      Console,       FlightAbort, ShallowWater};
  return std::ranges::find(kKinds, kind) != std::end(kKinds);
}

/// What bounds its depth is what the SBC may command, unless the line damages it: then it is its
/// own abend.
std::unique_ptr<simulator::Judge> makePortJudge(const FlightToJudge& flight) {
  const slocum::MissionFile* const own = portFileOf(flight.scenario);
  if (own == nullptr) {
    return nullptr;
  }
  slocum::oracles::PortPromise promise;
  const simulator::Faults& faults = flight.scenario.faults;
  if (!faults.sensors.empty() || !faults.clock.empty() || !faults.flight.empty()) {
    return std::make_unique<slocum::oracles::PortJudge>(promise);  // nothing on it notices those
  }
  const platforms::Platform& platform = flight.platform;
  const PortFile port = slocum::rules::portFileOf(*own, platform);
  const Depths file = depthsOf(*own, port, platform);
  const Depths depths = promisedDepths(file, slocum::oracles::programDepthIn(flight.scenario));
  const bool damaged = damagesSentences(faults);
  promise.deepest_m =
      damaged ? depths.aborted_m : depths.commanded_m + platform.envelope.inflection_overshoot_m;
  promise.under_s = underAtMost(*own, port, file.aborted_m, platform);
  promise.cycle_s = platform.envelope.cycle_s;
  promise.may_abort = damaged || !faults.aborts.empty();
  promise.sees_bottom = seesBottom(flight.scenario);
  return std::make_unique<slocum::oracles::PortJudge>(promise);
}

}  // namespace glider::vehicles
