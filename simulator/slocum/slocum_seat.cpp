// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/slocum_seat.h"

#include "simulator/slocum/own_mission.h"
#include "simulator/slocum/science/extctl_proglet.h"
#include "simulator/slocum/science/science_program.h"

#include <algorithm>
#include <iterator>

namespace glider::simulator {

SlocumSeat::SlocumSeat(const SeatSetup& setup)
    : platform_(setup.platform),
      scenario_(setup.scenario),
      world_(setup.world),
      journal_(setup.journal),
      flight_(setup.platform, missionFileOf(setup.scenario), setup.scenario.sensors, setup.seed,
              setup.world.frame(), setup.world.year(), setup.journal,
              slocumMissionOf(setup.scenario).code_15),
      science_(setup.platform, setup.seed, setup.scenario.sensors, progletFor(setup)),
      damage_(faultsOf(false), setup.seed, NoiseStream::SensorJumps),
      science_damage_(faultsOf(true), setup.seed, NoiseStream::ScienceSensorJumps),
      line_(setup.scenario.faults, setup.seed) {
  flight_.damageBy(&damage_);
  science_.damageBy(&science_damage_);
  for (const Leftover& leftover : faults().leftover) {
    flight_.leaveOver(leftover);
  }
}

double SlocumSeat::sbcBaud() const {
  const std::optional<slocum::ExtctlFile>& extctl = slocumMissionOf(scenario_).extctl;
  return extctl ? extctl->baud : SimulatedSeat::sbcBaud();
}

/// hookprog, here or in a program of its own, or the vendor's proglet on a vehicle without the
/// hooks.
MakeProglet SlocumSeat::progletFor(const SeatSetup& setup) {
  const SlocumMission& mission = slocumMissionOf(setup.scenario);
  if (!mission.extctl && !mission.science_program.empty()) {
    return [this, virtual_time = !setup.real_time](const GliderDictionary& dictionary) {
      return std::make_unique<ScienceProgram>(
          ScienceProgram::Setup{.command = slocumMissionOf(scenario_).science_program,
                                .dictionary = dictionary,
                                .virtual_time = virtual_time,
                                .ended = [this](const std::string& why) {
                                  journal_.add(now_s_, EventId::ScienceProgramEnds, {why});
                                }});
    };
  }
  if (!mission.extctl) {
    return makeHookprog(!setup.real_time);
  }
  return [this, setup](const GliderDictionary&) {
    return std::make_unique<ExtctlProglet>(
        setup.platform, *slocumMissionOf(setup.scenario).extctl,
        ExtctlVehicle{.value = [this](const std::string& sensor) { return valueOf(sensor); },
                      .put =
                          [this](const std::string& sensor, double value) {
                            line_.to_flight.send({.name = sensor, .value = value});
                          }},
        ExtctlProglet::Settings{.seed = setup.seed, .virtual_time = !setup.real_time});
  };
}

/// Of the flight controller, of those that no platform file lists.
double SlocumSeat::valueOf(const std::string& sensor) const {
  return sensor == "x_in_gliderdos" ? (flight_.end() ? 1 : 0) : flight_.setting(sensor);
}

/// The faults of the sensors that the science computer reads, or of the others. What the flight
/// controller receives from the science computer is damaged already: a fault acts once.
std::vector<SensorFault> SlocumSeat::faultsOf(bool science) const {
  std::vector<SensorFault> of;
  std::ranges::copy_if(faults().sensors, std::back_inserter(of), [&](const SensorFault& fault) {
    return science_.reads(fault.id) == science;
  });
  return of;
}

void SlocumSeat::begin(double now_s, SerialLine& sbc) {
  now_s_ = now_s;
  line_.setNow(now_s);
  damage_.setNow(now_s);
  science_damage_.setNow(now_s);
  failDevices(now_s, sbc);
}

/// Makes devices of the flight controller fail, and the science computer restart, at the times of
/// the faults.
void SlocumSeat::failDevices(double now_s, SerialLine& sbc) {
  const auto is_due = [&](double at_s) { return now_s >= at_s && now_s < at_s + Vehicle::kStep; };
  if (std::ranges::any_of(faults().aborts, is_due)) {
    flight_.failDevice(now_s);
  }
  const auto has_now = [&](const Span& span) { return span.has(now_s); };
  const bool down = std::ranges::any_of(faults().science, has_now);
  if (down && !science_down_) {
    journal_.add(now_s, EventId::ScienceRestarts);
    science_.restart();
  }
  if (down) {  // what arrives meanwhile is lost
    line_.to_science.dropArrived();
    line_.to_flight.dropUnsent();
    sbc.dropLeft();
  }
  science_down_ = down;
}

/// True while the flight controller restarts: what arrives meanwhile is lost.
bool SlocumSeat::isDown(double now_s) {
  const FlightRestart* down = nullptr;
  for (const FlightRestart& restart : faults().flight) {
    down = restart.when.has(now_s) ? &restart : down;
  }
  if (down == nullptr && flight_down_ != nullptr) {
    flight_.restart(now_s, flight_down_->keeps_array);
  }
  flight_down_ = down;
  if (down != nullptr) {
    line_.to_flight.dropArrived();
    line_.to_science.dropUnsent();
  }
  return down != nullptr;
}

void SlocumSeat::cycle(double now_s, bool sbc_gone, Vehicle& vehicle) {
  flight_.noteSbcGone(sbc_gone);
  flight_.cycle(now_s, world_.ocean(), vehicle, line_);
  science_.sampleEvery(flight_.samplePeriods());
  vehicle.switchInstruments(flight_.sampling());
}

bool SlocumSeat::serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) {
  if (science_down_) {
    return false;
  }
  science_.run(now_s, world_.ocean(), {vehicle.depth(), vehicle.x(), vehicle.y()}, sbc.left(),
               line_);
  if (slocumMissionOf(scenario_).extctl) {
    const hooks::SbcView view = science_.sbc();
    flight_.noteBackseat(view.known && view.phase == hooks::MissionPhase::Flying);
  }
  return true;
}

double SlocumSeat::reading(uint16_t id) const {
  return platform_.sensors[id].computer == platforms::Computer::Science ? science_.value(id)
                                                                        : flight_.array().get(id);
}

CycleView SlocumSeat::view(double now_s) const {
  return {.time_s = now_s,
          .hook = flight_.hookState(),
          .aborted = flight_.aborted(),
          .array = flight_.array(),
          .mission_s = now_s - flight_.missionStart(),
          .commanded_whole = flight_.commandedWhole(),
          .hookbeh = flight_.hookbeh(),
          .masked = flight_.hookbehMasked()};
}

}  // namespace glider::simulator
