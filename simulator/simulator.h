// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "simulator/flight_observer.h"
#include "simulator/guard_text.h"
#include "simulator/ports/sbc_port.h"
#include "simulator/scenario/scenario.h"
#include "support/trace/trace.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The glider simulator: a vehicle in an ocean, its flight controller with a skeleton mission, its
/// science computer with hookprog, and both serial lines, in virtual time. Needs: platforms, hooks,
/// vehicles/slocum/mission_files.
namespace glider::simulator {

/// The progress of a flight.
struct Progress {
  double time_s = 0;
  double duration_s = 0;  ///< at most
  double depth_m = 0;
  std::string state;  ///< of the SBC's mission; "" while it is not in control
};

/// Everything that a flight depends on. `sbc` and `restart_sbc` come from flights/sbc_choice.h, the
/// names from flights/flight_setup.h.
struct SimulationSetup {
  platforms::Platform platform;
  Scenario scenario;
  std::unique_ptr<SbcPort> sbc;          ///< null: no SBC on board
  StartSbc restart_sbc;                  ///< after a power cut; empty: it stays off
  std::string mission_name;              ///< for the trace
  std::vector<std::string> state_names;  ///< of the SBC's mission, by number
  GuardResolver explain;                 ///< texts for transitions; may be empty
  std::vector<std::string> record;       ///< sensors that the trace must have as columns
  std::vector<std::string> read;         ///< sensors that the mission lists: their devices draw
  std::optional<uint64_t> seed;          ///< replaces the scenario's
  std::optional<double> duration_s;      ///< replaces the scenario's
  std::optional<double> kill_sbc_at_s;   ///< vehicle time at which the SBC loses its power
  bool spools = false;                   ///< rows of the trace wait on disk while it flies
  bool talks = false;                    ///< its modem is in use, if its platform has one
  FlightObserver* observer = nullptr;    ///< may be null
  std::function<void(const Progress&)>
      progress;  ///< called about every 100 s of virtual time; may be empty
};

/// A sensor of the platform that the vehicle of a scenario does not carry.
struct NotCarried {
  std::string name;     ///< as the platform's
  std::string setting;  ///< the setting in the scenario file that adds it
};
std::vector<NotCarried> sensorsNotCarried(const Scenario& scenario);

/// Checks whether the simulator can fly a vehicle. GL5121 when the platform lacks a sensor that the
/// simulated flight controller needs, GL5001 when it lacks one that the hooks need, and when no
/// model moves it.
support::Result<void> checkPlatform(const platforms::Platform& platform);

/// Flies the mission until it has ended, or is aborted and at the surface, or the time is over. The
/// trace has one row per control cycle; the same setup gives the same rows, byte for byte. Fails as
/// checkPlatform does, and with GL5121 when a fault names a sensor that the platform lacks.
support::Result<support::Trace> simulate(SimulationSetup setup);

}  // namespace glider::simulator
