// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/lauv/lauv_seat.h"

#include "hooks/imc/values.h"
#include "simulator/geography/ddmm.h"
#include "simulator/sensors/provided.h"
#include "simulator/world/start_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::simulator {
namespace {

using namespace hooks::imc;

/// The address of the simulated vehicle, and when its flight begins.
constexpr uint16_t kAddress = 0x00D1;
constexpr double kStart = kStartUtc_s;
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr double kAfloat_m = 0.5;

double unknown() {
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

LauvSeat::LauvSeat(const SeatSetup& setup)
    : platform_(setup.platform),
      scenario_(setup.scenario),
      world_(setup.world),
      journal_(setup.journal),
      virtual_time_(!setup.real_time),
      array_(setup.platform),
      depth_sensor_(setup.seed, setup.scenario.sensors.depth),
      attitude_(setup.seed, setup.scenario.sensors.attitude),
      altimeter_(setup.seed, setup.scenario.sensors.altimeter),
      gps_(setup.seed, setup.scenario.sensors.gps),
      ctd_(setup.seed, setup.scenario.sensors.ctd) {}

double LauvSeat::clockAtStart() const {
  return kStart;
}

void LauvSeat::begin(double now_s, SerialLine& /*sbc*/) {
  now_s_ = now_s;
}

/// The computer restarts: the plan is gone.
bool LauvSeat::isDown(double now_s) {
  const bool down = std::ranges::any_of(
      faults().flight, [&](const FlightRestart& restart) { return restart.when.has(now_s); });
  if (down && plans_.executes()) {
    plans_.stop();
    (void)plans_.takeEnd();
    lost_ = true;
  }
  return down;
}

double LauvSeat::newest(std::string_view source) const {
  const auto found =
      std::ranges::find(platform_.sensors, source, &platforms::PlatformSensor::source);
  return found != platform_.sensors.end() ? array_.get(found->id) : unknown();
}

/// By the name of its source in the platform file.
void LauvSeat::set(const char* source, double value) {
  const auto found =
      std::ranges::find(platform_.sensors, source, &platforms::PlatformSensor::source);
  if (found != platform_.sensors.end() && std::isfinite(value)) {
    array_.set(found->id, value);
  }
}

void LauvSeat::put(const std::string& sensor, double value) {
  if (const auto* found = platform_.find(sensor)) {
    array_.set(found->id, value);
  }
}

void LauvSeat::steer(double now_s, Vehicle& vehicle) {
  reckoning_.advance(vehicle.aheadMps(), vehicle.heading(), Vehicle::kStep);
  plans_.look(now_s);
  const auto* told = plans_.reference();
  if (told == nullptr) {
    autopilot_.rest(vehicle);
    doing_ = FollowState::Wait;
    return;
  }
  lauv::Target target;
  world_.frame().locate({told->lat / kRadiansPerDegree, told->lon / kRadiansPerDegree},
                        target.place.east, target.place.north);
  target.depth_m =
      std::min(static_cast<double>(told->z.value.value), platform_.envelope.greatest_depth_m);
  target.speed_mps = told->speed.present ? told->speed.value.value : 0;
  doing_ = autopilot_.steer(target, reckoning_.place(), vehicle);
}

void LauvSeat::readSensors(const Vehicle& vehicle) {
  constexpr double kMetresPerBar = DepthSensor::kMetresPerBar;
  const Ocean& ocean = world_.ocean();
  depth_m_ = depth_sensor_.pressure(vehicle.depth()) * kMetresPerBar;
  const double height =
      altimeter_.altitude(vehicle.depth(), ocean.waterDepth(vehicle.x(), vehicle.y()));
  altitude_m_ = std::isfinite(height) ? height : -1;
  water_ = ctd_.read(
      [&](double depth_m) {
        return Ctd::Water{ocean.temperature(depth_m, vehicle.x(), vehicle.y(), now_s_),
                          ocean.salinity(depth_m, vehicle.x(), vehicle.y(), now_s_)};
      },
      vehicle.depth(), now_s_);
  fix_.reset();
  if (const auto fix = gps_.fix(vehicle.x(), vehicle.y(), vehicle.depth(), now_s_)) {
    reckoning_.fix({fix->x, fix->y});
    fix_ = world_.frame().position(fix->x, fix->y);
  }
}

void LauvSeat::cycle(double now_s, bool sbc_gone, Vehicle& vehicle) {
  now_s_ = now_s;
  array_.beginCycle();
  readSensors(vehicle);
  const GeoPosition here =
      world_.frame().position(reckoning_.place().east, reckoning_.place().north);
  set("clock", kStart + now_s);
  set("EstimatedState.depth", depth_m_);
  set("EstimatedState.lat", toDdmm(here.latitude_deg));
  set("EstimatedState.lon", toDdmm(here.longitude_deg));
  set("EstimatedState.psi", vehicle.heading());
  set("EstimatedState.theta", vehicle.pitch());
  set("EstimatedState.vz", -vehicle.upMps());
  set("EstimatedState.u", vehicle.bodyVelocity().surge);
  set("EstimatedState.alt", altitude_m_ >= 0 ? altitude_m_ : unknown());
  set("Temperature", water_ ? water_->temperature_degC : unknown());
  noteEnd(sbc_gone);
}

/// Whether nothing is left to fly: the plan has ended, and no one will start it again.
void LauvSeat::noteEnd(bool sbc_gone) {
  if (const auto how = plans_.takeEnd()) {
    over_ = *how != lauv::PlanEnd::TimedOut;
    lost_ = !over_;
    journal_.add(now_s_, EventId::PlanEnds,
                 {*how == lauv::PlanEnd::TimedOut    ? "its references have stopped"
                  : *how == lauv::PlanEnd::Completed ? "completed"
                  : *how == lauv::PlanEnd::Aborted   ? "aborted"
                                                     : "stopped by the back seat"});
  }
  if (plans_.executes()) {
    over_ = lost_ = false;
  }
  if (over_ || (lost_ && sbc_gone)) {
    end_ = News{EventId::NothingLeftToFly};
  }
}

template <typename Message>
void LauvSeat::send(const Message& message) {
  std::array<uint8_t, kMostPacket> bytes;
  const Header header{.time_s = kStart + now_s_,
                      .source = kAddress,
                      .source_entity = 0,
                      .destination = kAllSystems,
                      .destination_entity = kAnyEntity};
  const uint32_t count = encode(header, message, bytes.data(), bytes.size());
  // What the line has no room for is lost.
  constexpr size_t kMostQueued = 65536;
  if (out_.size() + count < kMostQueued) {
    out_.insert(out_.end(), bytes.begin(), bytes.begin() + count);
  }
}

EstimatedState LauvSeat::stateOf(const Vehicle& vehicle) const {
  EstimatedState state;
  state.lat = world_.origin().latitude_deg * kRadiansPerDegree;
  state.lon = world_.origin().longitude_deg * kRadiansPerDegree;
  state.x = static_cast<float>(reckoning_.place().north);
  state.y = static_cast<float>(reckoning_.place().east);
  state.z = static_cast<float>(depth_m_);
  state.theta = static_cast<float>(vehicle.pitch());
  state.psi = static_cast<float>(std::remainder(vehicle.heading(), 2 * std::numbers::pi));
  state.u = static_cast<float>(vehicle.bodyVelocity().surge);
  state.v = static_cast<float>(vehicle.bodyVelocity().sway);
  state.w = static_cast<float>(vehicle.bodyVelocity().heave);
  state.vx = static_cast<float>(vehicle.aheadMps() * std::cos(vehicle.heading()));
  state.vy = static_cast<float>(vehicle.aheadMps() * std::sin(vehicle.heading()));
  state.vz = static_cast<float>(-vehicle.upMps());
  state.q = static_cast<float>(vehicle.bodyVelocity().pitch);
  state.r = static_cast<float>(vehicle.turnRate());
  state.depth = static_cast<float>(depth_m_);
  state.alt = static_cast<float>(altitude_m_);
  return state;
}

/// Once a second. The vehicle sends most of this more often; the state is last, since it completes
/// a cycle of the back seat.
void LauvSeat::sendAll(const Vehicle& vehicle) {
  if (virtual_time_) {
    Announce announce;
    announce.sys_name = textOf("lauv-glidercc");
    announce.sys_type = SystemType::UnderwaterVehicle;
    announce.services = textOf("glidercc+virtual-time");
    send(announce);
  }
  if (plans_.takeTimeout()) {
    send(plans_.followState(FollowState::Timeout));
  }
  if (const auto answer = plans_.takeAnswer()) {
    send(*answer);
  }
  send(plans_.controlState());
  if (plans_.executes()) {
    send(plans_.followState(doing_));
  }
  hooks::imc::VehicleState vehicle_state;
  vehicle_state.op_mode = plans_.executes() ? OperationMode::Maneuver : OperationMode::Service;
  send(vehicle_state);
  VehicleMedium medium;
  medium.medium = vehicle.depth() < kAfloat_m ? Medium::WaterSurface : Medium::UnderWater;
  send(medium);
  GpsFix fix;
  fix.validity = fix_ ? GpsValidity::Position : 0;
  fix.lat = fix_ ? fix_->latitude_deg * kRadiansPerDegree : 0;
  fix.lon = fix_ ? fix_->longitude_deg * kRadiansPerDegree : 0;
  send(fix);
  FuelLevel fuel;
  fuel.value = static_cast<float>(100 * vehicle.battery().leftJ() /
                                  (vehicle.battery().leftJ() + vehicle.battery().usedJ()));
  send(fuel);
  if (water_) {
    send(Temperature{.value = static_cast<float>(water_->temperature_degC)});
    send(Conductivity{.value = static_cast<float>(water_->conductivity)});
    const double salinity =
        world_.ocean().salinity(vehicle.depth(), vehicle.x(), vehicle.y(), now_s_);
    send(Salinity{.value = static_cast<float>(salinity)});
  }
  send(stateOf(vehicle));
}

/// Its entries for the vehicle's log.
void LauvSeat::takeStory(const Packet& packet) {
  LogBookEntry entry;
  if (packet.id == LogBookEntry::kId && decode(packet, entry) &&
      entry.context == textOf("glidercc")) {
    story_.take({entry.text.bytes, entry.text.size});
  }
  story_.heard(now_s_);
}

void LauvSeat::hear(const GliderByteStream& sbc) {
  std::array<uint8_t, 256> bytes;
  constexpr int kMostReads = 64;
  for (int reads = 0; reads < kMostReads; ++reads) {
    const int32_t count = sbc.read(sbc.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    if (count <= 0) {
      return;
    }
    for (uint32_t taken = 0; taken < static_cast<uint32_t>(count);) {
      taken += packets_.push(bytes.data() + taken, static_cast<uint32_t>(count) - taken);
      Packet packet;
      while (packets_.next(&packet)) {
        takeStory(packet);
        if (packet.header.destination == kAddress || packet.header.destination == kThisDune) {
          plans_.take(packet, now_s_);
        }
      }
    }
  }
}

bool LauvSeat::serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) {
  now_s_ = now_s;
  const GliderByteStream line = sbc.left();
  hear(line);
  story_.look(now_s);
  sendAll(vehicle);
  flush(line);
  return true;
}

void LauvSeat::flush(const GliderByteStream& sbc) {
  const int32_t taken = sbc.write(sbc.self, out_.data(), static_cast<uint32_t>(out_.size()));
  out_.erase(out_.begin(), out_.begin() + std::max(taken, 0));
}

CycleView LauvSeat::view(double now_s) const {
  return {.time_s = now_s,
          .hook = plans_.executes() ? hooks::HookState::Active : hooks::HookState::Waiting,
          .ended = end_.has_value(),
          .array = array_,
          .mission_s = now_s};
}

}  // namespace glider::simulator
