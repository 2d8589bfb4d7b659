// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/remus100/remus_seat.h"

#include "hooks/recon/codec.h"
#include "simulator/geography/ddmm.h"
#include "simulator/remus100/timeout.h"
#include "simulator/world/start_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace glider::simulator {
namespace {

using namespace hooks::recon;

/// When its flight begins.
constexpr double kStart = kStartUtc_s;
constexpr double kDay_s = 86400;
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

double unknown() {
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

RemusSeat::RemusSeat(const SeatSetup& setup)
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
      ctd_(setup.seed, setup.scenario.sensors.ctd),
      override_(remus100::kTimeoutSecs) {}

double RemusSeat::clockAtStart() const {
  return kStart;
}

void RemusSeat::begin(double now_s, SerialLine& /*sbc*/) {
  now_s_ = now_s;
}

/// The computer restarts: the override is gone.
bool RemusSeat::isDown(double now_s) {
  const bool down = std::ranges::any_of(
      faults().flight, [&](const FlightRestart& restart) { return restart.when.has(now_s); });
  if (down && override_.isOn()) {
    override_.restart();
  }
  return down;
}

double RemusSeat::newest(std::string_view source) const {
  const auto found =
      std::ranges::find(platform_.sensors, source, &platforms::PlatformSensor::source);
  return found != platform_.sensors.end() ? array_.get(found->id) : unknown();
}

/// By the name of its source in the platform file.
void RemusSeat::set(const char* source, double value) {
  const auto found =
      std::ranges::find(platform_.sensors, source, &platforms::PlatformSensor::source);
  if (found != platform_.sensors.end() && std::isfinite(value)) {
    array_.set(found->id, value);
  }
}

void RemusSeat::put(const std::string& sensor, double value) {
  if (const auto* found = platform_.find(sensor)) {
    array_.set(found->id, value);
  }
}

void RemusSeat::steer(double now_s, Vehicle& vehicle) {
  reckoning_.advance(vehicle.aheadMps(), vehicle.heading(), Vehicle::kStep);
  override_.look(now_s);
  auto given = override_.given();
  if (!given) {
    autopilot_.rest(vehicle);
    return;
  }
  given->depth_m = std::min(given->depth_m, platform_.envelope.greatest_depth_m);
  autopilot_.steer(*given, vehicle);
}

void RemusSeat::readSensors(const Vehicle& vehicle) {
  constexpr double kMetresPerBar = DepthSensor::kMetresPerBar;
  const Ocean& ocean = world_.ocean();
  depth_m_ = depth_sensor_.pressure(vehicle.depth()) * kMetresPerBar;
  const double height =
      altimeter_.altitude(vehicle.depth(), ocean.waterDepth(vehicle.x(), vehicle.y()));
  altitude_m_ = std::isfinite(height) ? std::optional(height) : std::nullopt;
  water_ = ctd_.read(
      [&](double depth_m) {
        return Ctd::Water{ocean.temperature(depth_m, vehicle.x(), vehicle.y(), now_s_),
                          ocean.salinity(depth_m, vehicle.x(), vehicle.y(), now_s_)};
      },
      vehicle.depth(), now_s_);
  if (const auto fix = gps_.fix(vehicle.x(), vehicle.y(), vehicle.depth(), now_s_)) {
    reckoning_.fix({fix->x, fix->y});
  }
}

void RemusSeat::cycle(double now_s, bool sbc_gone, Vehicle& vehicle) {
  now_s_ = now_s;
  array_.beginCycle();
  readSensors(vehicle);
  const GeoPosition here =
      world_.frame().position(reckoning_.place().east, reckoning_.place().north);
  set("clock", kStart + now_s);
  set("state.depth", depth_m_);
  set("state.latitude", toDdmm(here.latitude_deg));
  set("state.longitude", toDdmm(here.longitude_deg));
  set("state.heading", vehicle.heading());
  set("state.pitch", vehicle.pitch());
  set("state.speed", vehicle.bodyVelocity().surge);
  set("state.altitude", altitude_m_.value_or(unknown()));
  set("ctd.temperature", water_ ? water_->temperature_degC : unknown());
  noteEnd(sbc_gone);
}

/// Whether nothing is left to fly: the override has ended, and no one will ask for it again.
void RemusSeat::noteEnd(bool sbc_gone) {
  using remus100::OverrideEnd;
  if (const auto how = override_.takeEnd()) {
    over_ = *how == OverrideEnd::Released;
    lost_ = !over_;
    journal_.add(now_s_, EventId::OverrideEnds,
                 {*how == OverrideEnd::TimedOut    ? "its goals have stopped"
                  : *how == OverrideEnd::Restarted ? "the vehicle's computer has restarted"
                                                   : "released by the SBC"});
  }
  if (override_.isOn()) {
    over_ = lost_ = false;
  }
  if (over_ || (lost_ && sbc_gone)) {
    end_ = News{EventId::NothingLeftToFly};
  }
}

template <typename Message>
void RemusSeat::send(const Message& message) {
  std::array<char, kMostLine> bytes;
  const uint32_t count = encode(message, bytes.data(), static_cast<uint32_t>(bytes.size()));
  // What the line has no room for is lost.
  constexpr size_t kMostQueued = 65536;
  if (out_.size() + count < kMostQueued) {
    out_.append(bytes.data(), count);
  }
}

State RemusSeat::stateOf(const Vehicle& vehicle) const {
  const GeoPosition here =
      world_.frame().position(reckoning_.place().east, reckoning_.place().north);
  State state;
  state.time_s = std::fmod(kStart + now_s_, kDay_s);
  state.latitude_deg = here.latitude_deg;
  state.longitude_deg = here.longitude_deg;
  state.depth_m = depth_m_;
  state.altitude_m = altitude_m_.value_or(unknown());
  state.pitch_deg = vehicle.pitch() * kDegreesPerRadian;
  state.roll_deg = 0;
  state.rpm = vehicle.rpm();
  state.speed_m_s = vehicle.bodyVelocity().surge;
  state.heading_deg = vehicle.heading() * kDegreesPerRadian;
  state.heading_rate_deg_s = vehicle.turnRate() * kDegreesPerRadian;
  if (const auto given = override_.given()) {
    state.depth_goal_m = given->depth_m;
    state.heading_goal_deg = given->heading_deg;
  }
  state.mode = override_.isOn() ? Mode::Override : Mode::Launched;
  state.leg = 1;
  return state;
}

/// Once a second; the state is last, since it completes a cycle of the SBC. With a simulated clock
/// the time is sent unasked: the clock waits for an answer to each state.
void RemusSeat::sendAll(const Vehicle& vehicle) {
  if (virtual_time_) {
    send(SimulationText{textOf("virtual-time")});
  }
  if (virtual_time_ || asked_time_) {
    send(TimeSet{kStart + now_s_});
    asked_time_ = false;
  }
  if (water_) {
    hooks::recon::Ctd ctd;
    ctd.temperature_degC = water_->temperature_degC;
    ctd.conductivity = water_->conductivity;
    ctd.salinity = world_.ocean().salinity(vehicle.depth(), vehicle.x(), vehicle.y(), now_s_);
    ctd.depth_m = water_->depth_m;
    send(ctd);
  }
  send(stateOf(vehicle));
}

void RemusSeat::take(const Line& line) {
  story_.heard(now_s_);
  SimulationText text;
  TimeQuery query;
  if (decode(line, text)) {
    story_.take({text.text.bytes, text.text.size});
  } else if (decode(line, query)) {
    asked_time_ = true;
  } else {
    override_.take(line, now_s_);
  }
}

void RemusSeat::hear(const GliderByteStream& sbc) {
  std::array<uint8_t, 256> bytes;
  constexpr int kMostReads = 64;
  for (int reads = 0; reads < kMostReads; ++reads) {
    const int32_t count = sbc.read(sbc.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
    for (int32_t i = 0; i < count; ++i) {
      if (Line line; lines_.push(bytes[static_cast<size_t>(i)], &line)) {
        take(line);
      }
    }
    if (count <= 0) {
      return;
    }
  }
}

bool RemusSeat::serve(double now_s, const Vehicle& vehicle, SerialLine& sbc) {
  now_s_ = now_s;
  const GliderByteStream line = sbc.left();
  hear(line);
  story_.look(now_s);
  sendAll(vehicle);
  flush(line);
  return true;
}

void RemusSeat::flush(const GliderByteStream& sbc) {
  const int32_t taken = sbc.write(sbc.self, reinterpret_cast<const uint8_t*>(out_.data()),
                                  static_cast<uint32_t>(out_.size()));
  out_.erase(0, static_cast<size_t>(std::max(taken, 0)));
}

CycleView RemusSeat::view(double now_s) const {
  return {.time_s = now_s,
          .hook = override_.isOn() ? hooks::HookState::Active : hooks::HookState::Waiting,
          .ended = end_.has_value(),
          .array = array_,
          .mission_s = now_s};
}

}  // namespace glider::simulator
