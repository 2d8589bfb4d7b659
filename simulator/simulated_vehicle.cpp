// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/simulated_vehicle.h"

#include "simulator/family/family.h"
#include "simulator/sensors/noise.h"
#include "simulator/surroundings.h"
#include "support/diagnostics/ids/vehicle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace glider::simulator {
namespace {

/// Those of `sensors` that the vehicle of a scenario carries.
std::vector<std::string> carried(std::vector<std::string> sensors, const Scenario& scenario) {
  for (const NotCarried& missing : sensorsNotCarried(scenario)) {
    std::erase(sensors, missing.name);
  }
  return sensors;
}

constexpr int kStepsPerSecond = 4;
constexpr int64_t kProgressCycles = 25;
constexpr double kAfloat = 1;  // m
static_assert(kStepsPerSecond * Vehicle::kStep == 1, "the vehicle's step divides a second");

/// Sets the numbers of the sensors that faults name.
support::Result<void> numberSensors(const platforms::Platform& platform, Faults& faults) {
  for (SensorFault& fault : faults.sensors) {
    const platforms::PlatformSensor* sensor = platform.find(fault.name);
    if (sensor == nullptr) {
      return support::fail(support::diagnostics::platformLacksSensor, platform.name, fault.name);
    }
    fault.id = sensor->id;
  }
  return {};
}

/// --kill-sbc-at is a power cut without an end.
SimulationSetup withKill(SimulationSetup setup) {
  if (setup.kill_sbc_at_s) {
    setup.scenario.faults.power.push_back({*setup.kill_sbc_at_s, kForever});
  }
  return setup;
}

/// Puts the vehicle where its scenario starts.
SimulationSetup placed(SimulationSetup setup, const World& world) {
  const GeoPosition start{setup.scenario.latitude_deg, setup.scenario.longitude_deg};
  VehicleSettings& vehicle = setup.scenario.vehicle;
  if (start != world.origin()) {  // the origin itself is exactly at 0
    world.frame().locate(start, vehicle.start_x_m, vehicle.start_y_m);
  }
  return setup;
}

support::Trace headOf(const SimulationSetup& setup) {
  support::Trace trace;
  trace.mission = setup.mission_name;
  trace.scenario = setup.scenario.name;
  trace.way = setup.sbc ? setup.sbc->way() : "none";
  trace.seed = setup.seed.value_or(setup.scenario.seed);
  trace.state_names = setup.state_names;
  if (const Family* family = familyOf(setup.platform)) {
    trace.own_control = family->own_control;
  }
  return trace;
}

/// Makes positions relative to where the vehicle started, as those of its own sensors are: in a
/// world of several vehicles they are relative to the origin of all.
void relateToStart(const VehicleSettings& start, support::Trace& trace) {
  const int east = trace.column("true_x"), north = trace.column("true_y");
  for (size_t row = 0; row < trace.rowCount(); ++row) {
    double* const values = &trace.rows[row * trace.columns.size()];
    values[east] -= start.start_x_m;
    values[north] -= start.start_y_m;
  }
  for (double& x : trace.bottom.x_m) {
    x -= start.start_x_m;
  }
  for (double& y : trace.bottom.y_m) {
    y -= start.start_y_m;
  }
}

/// Adds the mission time to events while the SBC was in control, from the rows around them.
void stampMissionTimes(support::Trace& trace) {
  const int time = trace.column("time"), mission_time = trace.column("missiontime");
  size_t row = 0;
  for (support::TraceEvent& event : trace.events) {
    while (row + 1 < trace.rowCount() && trace.at(row + 1, time) <= event.time_s) {
      ++row;
    }
    if (std::isnan(event.mission_time_s) && row < trace.rowCount()) {
      event.mission_time_s = trace.at(row, mission_time) + event.time_s - trace.at(row, time);
    }
  }
}

}  // namespace

SimulatedVehicle::SimulatedVehicle(SimulationSetup setup, const World& world, uint32_t number,
                                   std::shared_ptr<Channel> channel)
    : setup_(placed(withKill(std::move(setup)), world)),
      world_(world),
      real_time_(setup_.sbc != nullptr && setup_.sbc->keepsTime()),
      seed_(seedOfVehicle(setup_.seed.value_or(setup_.scenario.seed), number)),
      duration_s_(setup_.duration_s.value_or(setup_.scenario.duration_s)),
      cycles_(setup_.scenario.cycles, setup_.platform.envelope.cycle_s, Vehicle::kStep, seed_),
      most_steps_(static_cast<int64_t>(duration_s_ / Vehicle::kStep)),
      trace_(headOf(setup_)),
      vehicle_(setup_.platform, setup_.scenario.vehicle),
      seat_(familyOf(setup_.platform)
                ->make_seat(SeatSetup{setup_.platform, setup_.scenario, world, seed_, real_time_,
                                      journal_})),
      sbc_line_(seat_->sbcBaud(), damageOf(LineWay::FromSbc, seat_->sbcBaud()),
                damageOf(LineWay::ToSbc, seat_->sbcBaud())),
      link_(std::move(setup_.sbc), std::move(setup_.restart_sbc), faults(), seed_, sbc_line_,
            journal_),
      number_(number),
      channel_(std::move(channel)),
      story_(setup_.platform, setup_.state_names, setup_.explain),
      recorder_(trace_, world, *seat_, setup_.platform, setup_.scenario, setup_.record) {
  seat_->startAt(vehicle_);
  vehicle_.readSensors(carried(setup_.read, setup_.scenario));
  link_.showTo(setup_.observer);
  if (setup_.talks && setup_.platform.modem && channel_ != nullptr) {
    channel_->jam(number_, faults().modem);
    modem_ =
        std::make_unique<SimulatedModem>(modemSettings(*setup_.platform.modem), channel_, number_);
  }
  start_J_ = vehicle_.battery().usedJ();
  trace_.battery = {(start_J_ + vehicle_.battery().leftJ()) / kJoulesPerWattHour,
                    start_J_ / kJoulesPerWattHour,
                    {},
                    vehicle_.sleepSaves()};
  trace_.start_utc_s = seat_->clockAtStart();
}

support::Result<std::unique_ptr<SimulatedVehicle>> SimulatedVehicle::make(
    SimulationSetup setup, const World& world, uint32_t number, std::shared_ptr<Channel> channel) {
  if (auto checked = checkPlatform(setup.platform); !checked) {
    return std::unexpected(checked.error());
  }
  if (auto numbered = numberSensors(setup.platform, setup.scenario.faults); !numbered) {
    return std::unexpected(numbered.error());
  }
  // Too large for a stack: the queues of hooks are arrays.
  return std::unique_ptr<SimulatedVehicle>(
      new SimulatedVehicle(std::move(setup), world, number, std::move(channel)));
}

void SimulatedVehicle::placeModem() {
  if (modem_ != nullptr && flying()) {
    channel_->place(number_, place());
  } else if (modem_ != nullptr) {
    channel_->leave(number_);
  }
}

void SimulatedVehicle::advance(double time_s) {
  for (double now = 0; flying() && (now = static_cast<double>(step_) * Vehicle::kStep) < time_s;
       ++step_) {
    step(now);
  }
}

void SimulatedVehicle::step(double now) {
  sbc_line_.setNow(now);
  seat_->begin(now, sbc_line_);
  if (step_ == next_cycle_) {
    if (controlCycle(now)) {
      over_ = true;
      return;
    }
    next_cycle_ += cycles_.steps();
  }
  if (step_ % kStepsPerSecond == 0) {
    serveSbc(now);
  }
  link_.pump(now);
  serveModem(now);
  vehicle_.feedSbc(link_.hasPower(), seat_->sbcMaySleep());
  seat_->steer(now, vehicle_);
  vehicle_.step(world_.ocean(), now);
  bottom_.look(now + Vehicle::kStep, vehicle_.depth(),
               world_.ocean().waterDepth(vehicle_.x(), vehicle_.y()), journal_);
}

/// Returns true when the flight is over.
bool SimulatedVehicle::controlCycle(double now) {
  completeRow();
  const double before_s = std::exchange(scheduled_s_, now);
  if (seat_->isDown(now)) {
    return false;
  }
  putSensors(before_s, now);
  seat_->cycle(now, link_.goneForGood(now), vehicle_);
  recorder_.row(now, vehicle_);
  if (setup_.spools) {
    spool_.take(trace_);
  }
  cycle_s_ = now;
  if (setup_.progress && cycle_count_++ % kProgressCycles == 0) {
    setup_.progress({now, duration_s_, vehicle_.depth(),
                     story_.flying() ? story_.stateName(story_.state()) : ""});
  }
  // By the true depth, not that of the sensor: a flight is over when the vehicle is at the
  // surface.
  const bool over = seat_->end() && vehicle_.depth() < kAfloat;
  if (over) {
    journal_.add(now, seat_->end()->id, seat_->end()->values, seat_->end()->why);
  }
  const bool seen_enough = setup_.observer != nullptr && !setup_.observer->cycle(view(now, over));
  const bool dead = vehicle_.battery().empty();
  if (dead && !over) {
    journal_.add(now, EventId::PackEmpty, {vehicle_.depth()});
  }
  return over || seen_enough || dead;
}

/// What the operator set after `before_s`, and up to `now`.
void SimulatedVehicle::putSensors(double before_s, double now) {
  for (const Put& put : setup_.scenario.puts) {
    if (now >= put.at_s && before_s < put.at_s) {
      seat_->put(put.sensor, put.value);
      journal_.add(now, EventId::OperatorPuts, {put.sensor, put.value});
    }
  }
}

CycleView SimulatedVehicle::view(double now, bool over) const {
  const Battery& battery = vehicle_.battery();
  CycleView view = seat_->view(now);
  view.true_depth_m = vehicle_.depth();
  view.ended = over;
  view.clearance_m = world_.ocean().waterDepth(vehicle_.x(), vehicle_.y()) - vehicle_.depth();
  view.used_J = battery.usedJ() - start_J_;
  view.volts = battery.voltage();
  view.east_m = vehicle_.x() - setup_.scenario.vehicle.start_x_m;
  view.north_m = vehicle_.y() - setup_.scenario.vehicle.start_y_m;
  view.pumped_cc = vehicle_.pumpedCc();
  view.left_J = battery.leftJ();
  return view;
}

void SimulatedVehicle::serveSbc(double now) {
  if (SbcPort* const sbc = link_.powered()) {
    std::ranges::move(sbc->takeNotes(), std::back_inserter(trace_.notes));
  }
  if (seat_->serve(now, vehicle_, sbc_line_) && story_.follow(now, cycle_s_, *seat_, journal_)) {
    seat_->noteTransition();
  }
}

/// The modem has power while the SBC has.
void SimulatedVehicle::serveModem(double now) {
  if (modem_ == nullptr) {
    return;
  }
  SbcPort* const sbc = link_.powered();
  if (sbc != nullptr) {
    sbc->hearModem(modem_->toHost(now));
    modem_->fromHost(sbc->toModem(), now);
  }
  vehicle_.useByModem(modem_->step(now, sbc != nullptr));
  journal_.add(now, modem_->news());
}

/// The SBC's answer to a control cycle is known only by the next one.
void SimulatedVehicle::completeRow() {
  if (!trace_.rows.empty() && seat_->inControl() && story_.flying()) {
    recorder_.mission(story_.missionTime(cycle_s_), story_.state());
  }
}

std::vector<support::Consumer> SimulatedVehicle::consumers() const {
  std::vector<support::Consumer> found;
  const std::vector<std::string> devices =
      platforms::devicesOf(setup_.scenario.vehicle.battery.power);
  for (size_t i = 0; i < devices.size(); ++i) {
    if (const double used = vehicle_.battery().usedByJ(i); used > 0) {
      found.push_back({devices[i], used / kJoulesPerWattHour});
    }
  }
  return found;
}

support::Trace SimulatedVehicle::finish() {
  completeRow();
  spool_.giveBack(trace_);
  if (!seat_->end() && !vehicle_.battery().empty()) {
    journal_.add(cycle_s_, EventId::TimeIsOver, {duration_s_});
  }
  if (trace_.rowCount() > 0) {
    trace_.field = waterAlong(trace_, world_.ocean());
    trace_.bottom = bottomAround(trace_, world_.ocean());
    relateToStart(setup_.scenario.vehicle, trace_);
  }
  if (modem_ != nullptr) {
    trace_.acoustic = modem_->totals();
  }
  trace_.battery->consumers = consumers();
  trace_.events = std::move(journal_.events());
  std::ranges::stable_sort(trace_.events, {}, &support::TraceEvent::time_s);
  stampMissionTimes(trace_);
  return std::move(trace_);
}

}  // namespace glider::simulator
