// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/flight_controller.h"

#include "hooks/protocol/numbers.h"
#include "simulator/geography/ddmm.h"
#include "simulator/slocum/clock.h"
#include "simulator/slocum/flight/hull.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glider::simulator {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kAbortPitch = 0.4538;    // rad, the vehicle's nominal
constexpr double kAbortPump = 1000;       // cc: as far out as it goes
constexpr double kPortModeSurface = 1;    // u_mission_mode (runtime/abi/port_mission.h)
constexpr double kSettledAtSurface = 12;  // s; a mission ends only then
constexpr double kVacuum = 8;             // inHg
constexpr double kDryVoltage = 2.49;      // V, leak detector

DepthState depthState(const Situation& s) {
  return s.at_surface                               ? DepthState::Surface
         : std::fabs(s.depth_rate_mps) < kHoverRate ? DepthState::Hovering
         : s.depth_rate_mps > 0                     ? DepthState::Diving
                                                    : DepthState::Climbing;
}

}  // namespace

FlightController::FlightController(const platforms::Platform& platform,
                                   const slocum::MissionFile& mission,
                                   const SensorSettings& sensors, uint64_t seed,
                                   const LocalFrame& frame, double year, Journal& journal,
                                   Code15 code_15)
    : mission_(mission),
      code_15_(code_15),
      variables_(mission),
      instruments_(platform.instruments),
      array_(platform),
      frame_(frame),
      declination_(year),
      navigator_(frame, platform.motion ? platform.motion->flight : FlightCoefficients{}),
      depth_sensor_(seed, sensors.depth),
      attitude_(seed, sensors.attitude),
      altimeter_(seed, sensors.altimeter),
      gps_(seed, sensors.gps),
      hull_(hullOf(platform)),
      layers_(std::make_unique<LayeredControl>(mission, hull_, variables_, code_15)),
      journal_(journal),
      cycle_s_(platform.envelope.cycle_s) {}

bool FlightController::hookActive() const {
  return abort_ == Abort::None && (layers_->hookbeh() != nullptr
                                       ? layers_->hookbeh()->hookState() == hooks::HookState::Active
                                       : backseat_flies_);
}

hooks::HookState FlightController::hookState() const {
  if (layers_->hookbeh() == nullptr) {
    return hooks::HookState::Absent;
  }
  return aborted() ? hooks::HookState::Complete : layers_->hookbeh()->hookState();
}

/// Magnetic minus true heading, rad, as known to the vehicle from its last fix.
double FlightController::variation() const {
  const double told = array_.get(Sensor::m_gps_mag_var);
  return std::isnan(told) ? 0 : told;
}

double FlightController::felt(Sensor sensor, double truth) const {
  const double held = array_.get(sensor);
  return held == hookAsFloat32(truth) ? truth : held;
}

/// Depth is computed from pressure, and its rate from depth: a fault of one is also in what is
/// computed from it.
void FlightController::readPressure(double now_s, const Ocean& ocean, const Vehicle& vehicle) {
  const double swell = ocean.swellPressure(vehicle.depth(), vehicle.x(), vehicle.y(), now_s);
  const double bar = depth_sensor_.pressure(vehicle.depth() + swell);
  array_.set(Sensor::m_pressure, bar);
  const double pressed = felt(Sensor::m_pressure, bar) * DepthSensor::kMetresPerBar;
  const double truth = pressed < 0 ? 0 : pressed;
  array_.set(Sensor::m_depth, truth);
  const double depth = felt(Sensor::m_depth, truth);
  const double rate = cycles_ == 0 ? 0 : (depth - last_depth_) / (now_s - pressed_s_);
  last_depth_ = depth;
  pressed_s_ = now_s;
  array_.set(Sensor::m_depth_rate, rate);
  depth_rate_ = felt(Sensor::m_depth_rate, rate);
}

void FlightController::readAttitude(double declination, const Vehicle& vehicle) {
  array_.set(Sensor::m_pitch, attitude_.pitch(vehicle.pitch()));
  array_.set(Sensor::m_roll, 0);
  array_.set(Sensor::m_heading, attitude_.heading(vehicle.heading() - declination));
}

void FlightController::readAltimeter(const Ocean& ocean, const Vehicle& vehicle) {
  const double altitude =
      altimeter_.altitude(vehicle.depth(), ocean.waterDepth(vehicle.x(), vehicle.y()));
  if (!std::isnan(altitude)) {
    array_.set(Sensor::m_altitude, altitude);
    array_.set(Sensor::m_water_depth, last_depth_ + altitude);
  }
}

void FlightController::readSensors(double now_s, const Ocean& ocean, const Vehicle& vehicle) {
  SensorArray& a = array_;
  const auto due = [&](Device& device) { return device.due(variables_, now_s); };
  a.set(Sensor::m_present_time, kStartOfMission + now_s);
  a.set(Sensor::m_present_secs_into_mission, now_s - mission_start_s_);
  a.set(Sensor::m_cycle_number, cycles_);
  if (due(pressure_device_)) {
    readPressure(now_s, ocean, vehicle);
  }
  const GeoPosition truth = frame_.position(vehicle.x(), vehicle.y());
  const double declination = declination_.at(truth.latitude_deg, truth.longitude_deg);
  if (due(attitude_device_)) {
    readAttitude(declination, vehicle);
  }
  // The vehicle's log of comet's SPIRAL.MI: `c_alt_time` is 0 on dives to an altitude, -1
  // elsewhere.
  const bool altimeter_due = due(altimeter_device_);
  if (altimeter_due || altimeter_needed_) {
    readAltimeter(ocean, vehicle);
  }
  if (due(battery_device_)) {
    a.set(Sensor::m_battery, vehicle.battery().voltage());
  }
  a.set(Sensor::m_coulomb_amphr_total, vehicle.battery().ampHours());
  if (due(vacuum_device_)) {
    a.set(Sensor::m_vacuum, kVacuum);
  }
  if (due(leak_device_)) {
    a.set(Sensor::m_leakdetect_voltage, kDryVoltage);
  }
  a.set(Sensor::m_ballast_pumped, vehicle.pumpedCc());
  a.set(Sensor::m_battpos, vehicle.batteryPositionIn());
  a.set(Sensor::m_fin, vehicle.fin());
  locate(now_s, declination, vehicle);
}

/// Stores the fix. False if a fault keeps it from the sensors: the vehicle then has no fix.
bool FlightController::isReported(const Gps::Fix& fix) {
  const GeoPosition at = frame_.position(fix.x, fix.y);
  const auto arrives = [&](Sensor sensor, double degrees) {
    array_.set(sensor, toDdmm(degrees));
    return array_.fresh(sensor) || !array_.has(sensor);
  };
  const bool latitude = arrives(Sensor::m_gps_lat, at.latitude_deg);
  const bool longitude = arrives(Sensor::m_gps_lon, at.longitude_deg);
  return latitude && longitude;
}

/// Dead reckoning, and a GPS fix if there is one.
void FlightController::locate(double now_s, double declination, const Vehicle& vehicle) {
  SensorArray& a = array_;
  const bool at_surface = last_depth_ < kSurfaceDepth;
  const Planar current = at_surface ? Planar{} : currentUsed();
  navigator_.reckon(depth_rate_, a.get(Sensor::m_pitch), a.get(Sensor::m_heading) - variation(),
                    at_surface, cycles_ == 0 ? 0 : took_s_, current);
  auto fix = gps_.fix(vehicle.x(), vehicle.y(), vehicle.depth(), now_s);
  if (fix && !(gps_device_.due(variables_, now_s) && isReported(*fix))) {
    fix.reset();
  }
  has_fix_ = fix.has_value();
  noteCurrent(now_s, at_surface, fix, current);
  if (fix) {
    navigator_.fix(*fix);
  }
  const GeoPosition position = navigator_.position();
  a.set(Sensor::m_lat, toDdmm(position.latitude_deg));
  a.set(Sensor::m_lon, toDdmm(position.longitude_deg));
  a.set(Sensor::m_speed, navigator_.speed());
  if (fix) {
    a.set(Sensor::m_gps_mag_var, Gps::variation(declination));
  }
  noteLocalPosition();
}

/// Local mission coordinates: from where the mission started, along magnetic east and north.
void FlightController::noteLocalPosition() {
  const Planar at{navigator_.eastOfStart(), navigator_.northOfStart()};
  if (!geography_) {
    geography_.emplace(
        GeoPosition{fromDdmm(array_.get(Sensor::m_lat)), fromDdmm(array_.get(Sensor::m_lon))},
        variation());
    origin_ = at;
  }
  const Planar local = geography_->toLocal({at.east - origin_.east, at.north - origin_.north});
  array_.set(Sensor::m_x_lmc, local.east);
  array_.set(Sensor::m_y_lmc, local.north);
}

Planar FlightController::reckoned() const {
  const Planar from_origin =
      geography_->fromLocal(array_.get(Sensor::m_x_lmc), array_.get(Sensor::m_y_lmc));
  return {origin_.east + from_origin.east, origin_.north + from_origin.north};
}

Planar FlightController::waterVelocity() const {
  return geography_->fromLocal(array_.get(Sensor::m_water_vx), array_.get(Sensor::m_water_vy));
}

/// The current that the reckoning and the steering count on: u_use_current_correction.
Planar FlightController::currentUsed() const {
  return variables_.get("u_use_current_correction") != 0 ? current_.current().value_or(Planar{})
                                                         : Planar{};
}

void FlightController::noteCurrent(double now_s, bool at_surface,
                                   const std::optional<Gps::Fix>& fix, Planar used) {
  current_.observe(now_s, at_surface, navigator_.at(),
                   fix ? std::optional<Planar>({fix->x, fix->y}) : std::nullopt, used);
  array_.set(Sensor::x_dr_state, static_cast<double>(current_.state()));
  if (const auto& found = current_.current(); found && at_surface && geography_) {
    const Planar local = geography_->toLocal(*found);
    array_.set(Sensor::m_water_vx, local.east);
    array_.set(Sensor::m_water_vy, local.north);
  }
}

void FlightController::receive(LineDirection& line) {
  while (const std::optional<PassingValue> one = line.next()) {
    if (one->id == hooks::kNoSensor) {
      put(one->name, one->value);
    } else if (one->id < array_.size() && array_.ofScience(one->id)) {
      // Science may write its own sensors only.
      array_.set(one->id, one->value);
    }
  }
}

void FlightController::send(LineDirection& line) const {
  for (uint16_t id = 0; id < array_.size(); ++id) {
    if (!array_.ofScience(id) && array_.fresh(id)) {
      line.send({.id = id, .value = array_.get(id)});
    }
  }
}

Situation FlightController::situation(double now_s) {
  Situation s;
  s.flight_s = now_s;
  s.time_s = now_s - mission_start_s_;
  s.depth_m = array_.get(Sensor::m_depth);
  s.depth_rate_mps = array_.get(Sensor::m_depth_rate);
  s.altitude_m = array_.fresh(Sensor::m_altitude) ? array_.get(Sensor::m_altitude) : kNaN;
  s.voltage = array_.get(Sensor::m_battery);
  s.latitude_ddmm = array_.get(Sensor::m_lat);
  s.longitude_ddmm = array_.get(Sensor::m_lon);
  s.waypoint_distance_m = array_.get(Sensor::m_dist_to_wpt);
  s.primary_distance_m = variables_.find("m_dist_to_primary_wpt").value_or(kNaN);
  s.at_surface = s.depth_m < kSurfaceDepth;
  s.gps_fix = has_fix_;
  s.array = &array_;
  if (!s.at_surface) {
    submerged_s_ = s.time_s;
  }
  tickled_s_ = has_fix_ ? s.time_s : tickled_s_;
  s.silent_s = s.time_s - contact_s_;
  s.untickled_s = s.time_s - std::max(tickled_s_, contact_s_);
  s.utc_s = array_.get(Sensor::m_present_time);
  s.mission_mode = variables_.get("u_mission_mode");
  s.science_wants_surface = variables_.get("sci_wants_surface") != 0;
  s.geography = &*geography_;
  countInflections(s);
  s.inflections = inflections_;
  s.depth_state = depthState(s);
  array_.set(Sensor::m_depth_state, static_cast<double>(s.depth_state));
  return s;
}

/// Changes between sinking and rising since the vehicle was last at the surface.
void FlightController::countInflections(const Situation& s) {
  if (s.at_surface) {
    inflections_ = last_moving_ = 0;
    return;
  }
  const double moving =
      std::fabs(s.depth_rate_mps) < kHoverRate ? 0 : std::copysign(1, s.depth_rate_mps);
  if (moving != 0) {
    inflections_ += last_moving_ != 0 && moving != last_moving_ ? 1 : 0;
    last_moving_ = moving;
  }
}

void FlightController::noteInstruction() {
  if (!hookActive()) {
    obeyed_ = {};
    obeyed_sequence_ = kNaN;
    return;
  }
  const double sequence = array_.get(Sensor::x_hook_sequence);
  const bool accepted =
      array_.get(Sensor::x_hook_answer) == static_cast<double>(hooks::HookAnswer::Accepted);
  if (!accepted || sequence == obeyed_sequence_) {
    return;
  }
  obeyed_sequence_ = sequence;
  if (array_.get(Sensor::sci_hook_vertical) == static_cast<double>(hooks::HookVertical::None)) {
    return;  // turns only: the vertical command in force stays
  }
  obeyed_.vertical = array_.get(Sensor::sci_hook_vertical);
  const bool actuators =
      obeyed_.vertical == static_cast<double>(hooks::HookVertical::Actuators);  // no depth
  obeyed_.depth_m = actuators ? kNaN : array_.get(Sensor::sci_hook_depth);
  noteRange();
}

void FlightController::noteRange() {
  if (obeyed_.vertical == static_cast<double>(hooks::HookVertical::Ascend)) {
    obeyed_.top_m = obeyed_.depth_m;
  } else if (obeyed_.vertical == static_cast<double>(hooks::HookVertical::Descend)) {
    obeyed_.bottom_m = obeyed_.depth_m;
  }
}

void FlightController::noteTransition() {
  obeyed_.top_m = obeyed_.bottom_m = kNaN;
  noteRange();
}

void FlightController::startAbort(Abort abort, const std::string& why, double now_s) {
  abort_ = abort;
  journal_.add(now_s, EventId::Aborts, {std::string(abortName(abort))}, why);
}

/// Behaviours do not run after an abort. The SBC must be informed that its control has ended, and
/// in each cycle, because lines lose frames.
void FlightController::tellHookIsOver() {
  if (aborted() && layers_->hookbeh() != nullptr) {
    array_.set(Sensor::x_hook_state, static_cast<double>(hooks::HookState::Complete));
    array_.set(Sensor::x_hook_session, 0);
    array_.set(Sensor::x_hook_guard, 0);
    array_.set(Sensor::x_hook_masked, 0);
    array_.set(Sensor::x_hook_nap_secs, 0);
  }
}

const hooks::HookbehOutputs* FlightController::hookbeh() const {
  return layers_->hookbeh() == nullptr || aborted() ? nullptr : &layers_->hookbeh()->outputs();
}

void FlightController::restart(double now_s, bool keeps_array) {
  if (aborted() || layers_->quit()) {
    return;
  }
  journal_.add(now_s, keeps_array ? EventId::MissionRestarts : EventId::FlightRestarts);
  if (!keeps_array) {
    array_.clear();
    dynamics_ = DynamicControl();
  }
  variables_ = MissionVariables(mission_);
  layers_ = std::make_unique<LayeredControl>(mission_, hull_, variables_, code_15_);
  geography_.reset();
  current_ = {};
  inflections_ = 0;
  mission_start_s_ = now_s;
  cycles_ = 0;
  contact_s_ = tickled_s_ = submerged_s_ = 0;
  obeyed_ = {};
  obeyed_sequence_ = kNaN;
}

void FlightController::leaveOver(const Leftover& leftover) {
  hooks::Instruction instruction;
  instruction.session = leftover.session;
  instruction.sequence = leftover.sequence;
  instruction.control = hooks::HookControl::Take;
  instruction.vertical = hooks::HookVertical::Descend;
  instruction.depth_m = leftover.depth_m;
  instruction.pitch_rad = -kAbortPitch;
  instruction = hooks::inSteps(instruction);
  const hooks::InstructionWords words = hooks::wordsOf(instruction);
  std::array<std::pair<Sensor, double>, std::size(hooks::kInstructionWords)> on_line;
#define WORD(role, sensor, word, field, bytes, steps, line) \
  on_line.at(line) = {Sensor::sensor, words.word};
#define CHECK_WORD(role, sensor, word, line) on_line.at(line) = {Sensor::sensor, words.word};
#define LATER_WORD(role, sensor, word, field, line) on_line.at(line) = {Sensor::sensor, words.word};
#include "hooks/protocol/instruction.def"
  array_.set(Sensor::sci_hook_heartbeat, 1);
  for (const auto& [sensor, value] : on_line) {
    array_.set(sensor, value);
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
    contact_s_ = layers_->lastContact();
    commanded_whole_ = !decision.commands.anyIdle();
    sample_periods_ = simulator::samplePeriods(decision.commands.samples, variables_);
    sampling_ = decision.commands.sampling;
    orderSamples(sampling_, instruments_, sample_periods_);
    if (decision.abort == Abort::None && !layers_->quit()) {
      layer_ = decision.commands.pitch_layer;
      return decision.commands;
    }
    if (decision.abort != Abort::None) {
      startAbort(decision.abort, decision.why, s.flight_s);
    }
  }
  // Aborted, or over: pump out, nose up.
  sampling_ = 0;
  tellHookIsOver();
  commanded_whole_ = true;
  layer_ = kNoLayer;
  Commands commands;
  commands.steer({HeadingCommand::Mode::Fin, 0, 0, 0});
  commands.point({PitchCommand::Mode::Servo, kAbortPitch});
  commands.pump(kAbortPump);
  commands.at_once = true;
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
    const double heading = navigator_.headingFor(bearing, currentUsed());
    // The compass is magnetic, and the command with it.
    const double magnetic = std::remainder(heading + variation(), kTurn);
    bearing = magnetic < 0 ? magnetic + kTurn : magnetic;
  }
  array_.set(Sensor::m_dist_to_wpt, distance);
  dynamics_.cycle(commands,
                  {s.time_s, array_.get(Sensor::m_pitch), array_.get(Sensor::m_heading), bearing},
                  took_s_, vehicle);
  array_.set(Sensor::c_pitch, dynamics_.pitchCommand());
  array_.set(Sensor::c_heading, dynamics_.headingCommand());
  array_.set(Sensor::c_ballast_pumped, dynamics_.pumpCommand());
  array_.set(Sensor::x_mission_status, static_cast<double>(abort_));
}

void FlightController::judgeEnd(const Situation& s) {
  if (layers_->quit()) {
    const Behaviour& quitter = *layers_->quitter();
    end_ = News{
        EventId::MissionEndsNormally,
        {},
        fmt::format("{} has ended it; it started by {}", quitter.label(), quitter.whyStarted())};
  } else if (s.time_s - submerged_s_ >= kSettledAtSurface && abort_ != Abort::None) {
    end_ = News{EventId::AbortedAtSurface, {std::string(abortName(abort_))}};
  } else if (s.time_s - submerged_s_ >= kSettledAtSurface && layers_->nothingLeftToFly(sbc_gone_)) {
    end_ = News{EventId::NothingLeftToFly};
  } else if (waitsForOperator(s)) {
    end_ = News{EventId::WaitsForOperator};
  }
}

/// Whether the vehicle is at the surface for good by its port for a backseat driver: the SBC's last
/// command was to surface, and the vehicle obeys it until an operator ends its mission.
bool FlightController::waitsForOperator(const Situation& s) const {
  constexpr double kMostForFix = 300;  // s, as in the mission file for the port
  const double up_s = s.time_s - submerged_s_;
  const bool surface = s.science_wants_surface || s.mission_mode == kPortModeSurface;
  return sbc_gone_ && layers_->hookbeh() == nullptr && surface && up_s >= kSettledAtSurface &&
         (s.gps_fix || up_s >= kMostForFix);
}

void FlightController::cycle(double now_s, const Ocean& ocean, Vehicle& vehicle,
                             FlightScienceLine& line) {
  took_s_ = cycles_ == 0 ? cycle_s_ : now_s - cycle_at_s_;
  cycle_at_s_ = now_s;
  array_.beginCycle();
  readSensors(now_s, ocean, vehicle);
  receive(line.to_flight);
  const Situation s = situation(now_s);
  const Commands commands = decide(s);
  altimeter_needed_ = commands.altimeter;
  noteInstruction();
  control(commands, s, vehicle);
  judgeEnd(s);
  send(line.to_science);
  ++cycles_;
}

}  // namespace glider::simulator
