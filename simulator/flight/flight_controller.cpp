// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/flight/flight_controller.h"

#include "hooks/protocol/numbers.h"
#include "platforms/slocum_sensors.h"
#include "simulator/flight/position.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTurn = 2 * std::numbers::pi;
// The pilot's clock at the mission's start: nothing may depend on the wall clock of the machine.
constexpr double kStartOfMission = 1.25e9;  // s since 1970, in 2009
constexpr double kAbortPitch = 0.4538;      // rad, the vehicle's nominal
constexpr double kAbortPump = 1000;         // cc: as far out as it goes
constexpr double kSettledAtSurface = 12;    // s; a mission ends only then
constexpr double kVacuum = 8;               // inHg
constexpr double kDryVoltage = 2.49;        // V, leak detector

/// 0 surface, 1 diving, 2 climbing, 3 hovering: by a quarter of the nominal 0.19 m/s.
double depthState(const Situation& s) {
  if (s.at_surface) {
    return 0;
  }
  return std::fabs(s.depth_rate_mps) < 0.25 * 0.19 ? 3 : s.depth_rate_mps > 0 ? 1 : 2;
}

}  // namespace

FlightController::FlightController(const platforms::Platform& platform,
                                   const slocum::MissionFile& mission,
                                   const SensorSettings& sensors, uint64_t seed,
                                   const LocalFrame& frame, double year, Journal& journal)
    : mission_(mission),
      array_(platform),
      frame_(frame),
      declination_(year),
      navigator_(frame),
      depth_sensor_(seed, sensors.depth_m),
      attitude_(seed, sensors.pitch_rad, sensors.heading_rad),
      altimeter_(seed, sensors.altimeter),
      gps_(seed, sensors.gps_m),
      layers_(std::make_unique<LayeredControl>(mission)),
      journal_(journal),
      cycle_s_(platform.envelope.cycle_s) {}

bool FlightController::hookActive() const {
  return layers_->hookbeh() != nullptr && abort_ == Abort::None &&
         layers_->hookbeh()->hookState() == hooks::HookState::Active;
}

hooks::HookState FlightController::hookState() const {
  if (layers_->hookbeh() == nullptr) {
    return hooks::HookState::Absent;
  }
  return aborted() ? hooks::HookState::Complete : layers_->hookbeh()->hookState();
}

/// By what magnetic headings exceed true ones, rad, as far as the vehicle knows: from its last fix.
double FlightController::variation() const {
  const double told = array_.get(GLIDER_M_GPS_MAG_VAR);
  return std::isnan(told) ? 0 : told;
}

double FlightController::felt(uint16_t id, double truth) const {
  const double held = array_.get(id);
  return held == hooks::asFloat32(truth) ? truth : held;
}

/// Depth comes of the pressure, and its rate of the depth: what is wrong with one is with what is
/// made of it.
void FlightController::readPressure(const Vehicle& vehicle) {
  const double bar = depth_sensor_.pressure(vehicle.depth());
  array_.set(GLIDER_M_PRESSURE, bar);
  const double pressed = felt(GLIDER_M_PRESSURE, bar) * DepthSensor::kMetresPerBar;
  const double truth = pressed < 0 ? 0 : pressed;
  array_.set(GLIDER_M_DEPTH, truth);
  const double depth = felt(GLIDER_M_DEPTH, truth);
  const double rate = cycles_ == 0 ? 0 : (depth - last_depth_) / cycle_s_;
  last_depth_ = depth;
  array_.set(GLIDER_M_DEPTH_RATE, rate);
  depth_rate_ = felt(GLIDER_M_DEPTH_RATE, rate);
}

void FlightController::readSensors(double now_s, const Ocean& ocean, const Vehicle& vehicle) {
  SensorArray& a = array_;
  a.set(GLIDER_M_PRESENT_TIME, kStartOfMission + now_s);
  a.set(GLIDER_M_PRESENT_SECS_INTO_MISSION, now_s - mission_start_s_);
  a.set(GLIDER_M_CYCLE_NUMBER, cycles_);
  readPressure(vehicle);
  a.set(GLIDER_M_PITCH, attitude_.pitch(vehicle.pitch()));
  a.set(GLIDER_M_ROLL, 0);
  const GeoPosition truth = frame_.position(vehicle.x(), vehicle.y());
  const double declination = declination_.at(truth.latitude_deg, truth.longitude_deg);
  a.set(GLIDER_M_HEADING, attitude_.heading(vehicle.heading() - declination));
  const double altitude =
      altimeter_.altitude(vehicle.depth(), ocean.waterDepth(vehicle.x(), vehicle.y()));
  if (!std::isnan(altitude)) {
    a.set(GLIDER_M_ALTITUDE, altitude);
    a.set(GLIDER_M_WATER_DEPTH, last_depth_ + altitude);
  }
  a.set(GLIDER_M_BATTERY, vehicle.battery().voltage());
  a.set(GLIDER_M_COULOMB_AMPHR_TOTAL, vehicle.battery().ampHours());
  a.set(GLIDER_M_VACUUM, kVacuum);
  a.set(GLIDER_M_LEAKDETECT_VOLTAGE, kDryVoltage);
  a.set(GLIDER_M_BALLAST_PUMPED, vehicle.pumpedCc());
  a.set(GLIDER_M_BATTPOS, vehicle.batteryPositionIn());
  a.set(GLIDER_M_FIN, vehicle.fin());
  locate(now_s, declination, vehicle);
}

/// Dead reckoning, and a GPS fix if there is one.
void FlightController::locate(double now_s, double declination, const Vehicle& vehicle) {
  SensorArray& a = array_;
  navigator_.reckon(depth_rate_, a.get(GLIDER_M_PITCH), a.get(GLIDER_M_HEADING) - variation(),
                    last_depth_ < kSurfaceDepth, cycles_ == 0 ? 0 : cycle_s_);
  const auto fix = gps_.fix(vehicle.x(), vehicle.y(), vehicle.depth(), now_s);
  has_fix_ = fix.has_value();
  if (fix) {
    navigator_.fix(*fix);
  }
  const GeoPosition position = navigator_.position();
  a.set(GLIDER_M_X_LMC, navigator_.x());
  a.set(GLIDER_M_Y_LMC, navigator_.y());
  a.set(GLIDER_M_LAT, toDdmm(position.latitude_deg));
  a.set(GLIDER_M_LON, toDdmm(position.longitude_deg));
  a.set(GLIDER_M_SPEED, navigator_.speed());
  if (fix) {
    a.set(GLIDER_M_GPS_LAT, a.get(GLIDER_M_LAT));
    a.set(GLIDER_M_GPS_LON, a.get(GLIDER_M_LON));
    a.set(GLIDER_M_GPS_MAG_VAR, Gps::variation(declination));
  }
}

void FlightController::receive(const GliderByteStream& stream) {
  std::array<hooks::SensorUpdate, hooks::Clothesline::kMostUpdates> updates;
  // The line carries at most a few frames a cycle; the bound holds against a line that never falls
  // silent.
  constexpr int kMostRounds = 16;
  for (int round = 0; round < kMostRounds; ++round) {
    const uint32_t count =
        clothesline_.poll(stream, updates.data(), static_cast<uint32_t>(updates.size()));
    for (uint32_t i = 0; i < count; ++i) {
      const uint16_t id = updates[i].id;
      // Science may write its own sensors only.
      if (id < array_.size() && array_.ofScience(id)) {
        array_.set(id, updates[i].value);
      }
    }
    if (count == 0) {
      return;
    }
  }
}

void FlightController::send(const GliderByteStream& stream) {
  std::array<hooks::SensorUpdate, hooks::Clothesline::kMostUpdates> updates;
  uint32_t count = 0;
  for (uint16_t id = 0; id < array_.size() && count < updates.size(); ++id) {
    if (!array_.ofScience(id) && array_.fresh(id) && !std::isnan(array_.get(id))) {
      updates[count++] = {id, array_.get(id)};
    }
  }
  // A full queue drops this cycle's report whole: the next one says the same, newer.
  clothesline_.send(updates.data(), count);
  clothesline_.poll(stream, updates.data(), 0);
}

Situation FlightController::situation(double now_s) {
  Situation s;
  s.flight_s = now_s;
  s.time_s = now_s - mission_start_s_;
  s.depth_m = array_.get(GLIDER_M_DEPTH);
  s.depth_rate_mps = array_.get(GLIDER_M_DEPTH_RATE);
  s.altitude_m = array_.fresh(GLIDER_M_ALTITUDE) ? array_.get(GLIDER_M_ALTITUDE) : kNaN;
  s.voltage = array_.get(GLIDER_M_BATTERY);
  s.latitude_ddmm = array_.get(GLIDER_M_LAT);
  s.longitude_ddmm = array_.get(GLIDER_M_LON);
  s.waypoint_distance_m = array_.get(GLIDER_M_DIST_TO_WPT);
  s.at_surface = s.depth_m < kSurfaceDepth;
  s.gps_fix = has_fix_;
  s.array = &array_;
  (s.at_surface ? surfaced_s_ : submerged_s_) = s.time_s;
  s.silent_s = s.time_s - surfaced_s_;
  array_.set(GLIDER_M_DEPTH_STATE, depthState(s));
  return s;
}

void FlightController::noteOrder() {
  if (!hookActive()) {
    order_ = {};
    ordered_sequence_ = kNaN;
    return;
  }
  const double sequence = array_.get(GLIDER_X_HOOK_SEQUENCE);
  const bool accepted =
      array_.get(GLIDER_X_HOOK_ANSWER) == static_cast<double>(hooks::HookAnswer::Accepted);
  if (!accepted || sequence == ordered_sequence_) {
    return;
  }
  ordered_sequence_ = sequence;
  if (array_.get(GLIDER_SCI_HOOK_VERTICAL) == static_cast<double>(hooks::HookVertical::None)) {
    return;  // turns only: the vertical command in force stays
  }
  order_.vertical = array_.get(GLIDER_SCI_HOOK_VERTICAL);
  order_.depth_m = array_.get(GLIDER_SCI_HOOK_DEPTH);
  noteRange();
}

void FlightController::noteRange() {
  if (order_.vertical == static_cast<double>(hooks::HookVertical::Ascend)) {
    order_.top_m = order_.depth_m;
  } else if (order_.vertical == static_cast<double>(hooks::HookVertical::Descend)) {
    order_.bottom_m = order_.depth_m;
  }
}

void FlightController::noteTransition() {
  order_.top_m = order_.bottom_m = kNaN;
  noteRange();
}

void FlightController::startAbort(Abort abort, const std::string& why, double now_s) {
  abort_ = abort;
  journal_.add(now_s, "abort", abortName(abort), why);
}

/// Behaviours run no more after an abort: the SBC must see that its time is over, in each cycle,
/// for lines lose frames.
void FlightController::tellHookIsOver() {
  if (aborted() && layers_->hookbeh() != nullptr) {
    array_.set(GLIDER_X_HOOK_STATE, static_cast<double>(hooks::HookState::Complete));
    array_.set(GLIDER_X_HOOK_SESSION, 0);
    array_.set(GLIDER_X_HOOK_GUARD, 0);
  }
}

const hooks::HookbehOutputs* FlightController::hookbeh() const {
  return layers_->hookbeh() == nullptr || aborted() ? nullptr : &layers_->hookbeh()->outputs();
}

void FlightController::restart(double now_s, bool keeps_array) {
  if (aborted() || layers_->quit()) {
    return;
  }
  journal_.add(now_s, "behaviour",
               keeps_array ? "the mission restarts" : "the flight controller restarts");
  if (!keeps_array) {
    array_.clear();
    clothesline_ = hooks::Clothesline();
    dynamics_ = DynamicControl();
  }
  layers_ = std::make_unique<LayeredControl>(mission_);
  mission_start_s_ = now_s;
  cycles_ = 0;
  surfaced_s_ = submerged_s_ = 0;
  order_ = {};
  ordered_sequence_ = kNaN;
}

void FlightController::leaveOver(const Leftover& leftover) {
  hooks::Instruction instruction;
  instruction.session = leftover.session;
  instruction.sequence = leftover.sequence;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Descend;
  instruction.depth_m = leftover.depth_m;
  instruction.pitch_rad = -kAbortPitch;
  instruction = hooks::roundToArray(instruction);
  const std::pair<uint16_t, double> words[] = {
      {GLIDER_SCI_HOOK_HEARTBEAT, 1},
      {GLIDER_SCI_HOOK_SESSION, instruction.session},
      {GLIDER_SCI_HOOK_CONTROL, static_cast<double>(instruction.control)},
      {GLIDER_SCI_HOOK_VERTICAL, static_cast<double>(instruction.vertical)},
      {GLIDER_SCI_HOOK_DEPTH, instruction.depth_m},
      {GLIDER_SCI_HOOK_PITCH, instruction.pitch_rad},
      {GLIDER_SCI_HOOK_LATERAL, static_cast<double>(instruction.lateral)},
      {GLIDER_SCI_HOOK_HEADING, instruction.heading_rad},
      {GLIDER_SCI_HOOK_LAT, instruction.latitude_ddmm},
      {GLIDER_SCI_HOOK_LON, instruction.longitude_ddmm},
      {GLIDER_SCI_HOOK_CHECK, hooks::checkValue(instruction)},
      {GLIDER_SCI_HOOK_SEQUENCE, instruction.sequence}};
  for (const auto& [id, value] : words) {
    array_.set(id, value);
  }
}

void FlightController::failDevice(double now_s) {
  if (abort_ == Abort::None) {
    startAbort(Abort::DeviceError, "a device has failed", now_s);
  }
}

Commands FlightController::decide(const Situation& s) {
  if (abort_ == Abort::None) {
    LayeredControl::Decision decision = layers_->cycle(s, journal_);
    commanded_whole_ = !decision.commands.anyIdle();
    if (decision.abort == Abort::None && !layers_->quit()) {
      layer_ = decision.commands.pitch_layer;
      return decision.commands;
    }
    if (decision.abort != Abort::None) {
      startAbort(decision.abort, decision.why, s.flight_s);
    }
  }
  // Aborted, or over: pump out, nose up.
  tellHookIsOver();
  commanded_whole_ = true;
  layer_ = kNoLayer;
  Commands commands;
  commands.steer({HeadingCommand::Mode::Fin, 0, 0, 0});
  commands.point({PitchCommand::Mode::Servo, kAbortPitch});
  commands.pump(kAbortPump);
  return commands;
}

void FlightController::control(const Commands& commands, const Situation& s, Vehicle& vehicle) {
  double distance = kNaN;
  double bearing = 0;
  const bool to_waypoint = commands.heading->mode == HeadingCommand::Mode::Waypoint;
  waypoint_latitude_ddmm_ = to_waypoint ? commands.heading->latitude_ddmm : kNaN;
  waypoint_longitude_ddmm_ = to_waypoint ? commands.heading->longitude_ddmm : kNaN;
  if (to_waypoint) {
    navigator_.toWaypoint(commands.heading->latitude_ddmm, commands.heading->longitude_ddmm,
                          distance, bearing);
    // The compass is magnetic, and the command with it.
    const double magnetic = std::remainder(bearing + variation(), kTurn);
    bearing = magnetic < 0 ? magnetic + kTurn : magnetic;
  }
  array_.set(GLIDER_M_DIST_TO_WPT, distance);
  dynamics_.cycle(commands,
                  {s.time_s, array_.get(GLIDER_M_PITCH), array_.get(GLIDER_M_HEADING), bearing},
                  cycle_s_, vehicle);
  array_.set(GLIDER_C_PITCH, dynamics_.pitchCommand());
  array_.set(GLIDER_C_HEADING, dynamics_.headingCommand());
  array_.set(GLIDER_C_BALLAST_PUMPED, dynamics_.pumpCommand());
  array_.set(GLIDER_X_MISSION_STATUS, static_cast<double>(abort_));
}

void FlightController::judgeEnd(const Situation& s) {
  if (layers_->quit()) {
    end_ = "the mission has ended normally";
  } else if (s.time_s - submerged_s_ >= kSettledAtSurface && abort_ != Abort::None) {
    end_ = fmt::format("aborted ({}) and at the surface", abortName(abort_));
  } else if (s.time_s - submerged_s_ >= kSettledAtSurface && layers_->nothingLeftToFly(sbc_gone_)) {
    end_ = "at the surface, and nothing is left to fly";
  }
}

void FlightController::cycle(double now_s, const Ocean& ocean, Vehicle& vehicle,
                             const GliderByteStream& clothesline) {
  array_.beginCycle();
  readSensors(now_s, ocean, vehicle);
  receive(clothesline);
  const Situation s = situation(now_s);
  const Commands commands = decide(s);
  noteOrder();
  control(commands, s, vehicle);
  judgeEnd(s);
  send(clothesline);
  ++cycles_;
}

}  // namespace glider::simulator
