// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the serial lines carry at saturation and in a usual cycle, and the latency from a sensor's
// change to the command at hookbeh. See bench/link.

#include "hooks/client/client.h"
#include "hooks/clothesline/clothesline.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "hooks/transport/memory.h"
#include "platforms/slocum_sensors.h"
#include "simulator/science/serial_line.h"
#include "simulator/sensors/noise.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

namespace {

using namespace glider;
using namespace glider::hooks;
using simulator::Noise;
using simulator::SerialLine;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFastBaud = 115200, kSlowBaud = 9600;
constexpr double kCycle = 4;

/// Passes bytes on, counts them, and damages some: a flipped bit or a lost byte.
class Tap {
 public:
  Tap(GliderByteStream inner, double damage, Noise noise)
      : inner_(inner), damage_(damage), noise_(noise) {}
  GliderByteStream stream() { return {this, read, write}; }
  uint64_t written = 0;

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    auto& tap = *static_cast<Tap*>(self);
    const int32_t got = tap.inner_.read(tap.inner_.self, bytes, capacity);
    int32_t kept = 0;
    for (int32_t i = 0; i < got; ++i) {
      if (tap.damage_ > 0 && tap.noise_.uniform() < tap.damage_) {
        if (tap.noise_.uniform() < 0.5) {
          continue;
        }
        bytes[i] = static_cast<uint8_t>(bytes[i] ^
                                        (1U << static_cast<uint32_t>(tap.noise_.uniform() * 8)));
      }
      bytes[kept++] = bytes[i];
    }
    return got <= 0 ? got : kept;
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    auto& tap = *static_cast<Tap*>(self);
    const int32_t taken = tap.inner_.write(tap.inner_.self, bytes, count);
    tap.written += taken > 0 ? static_cast<uint64_t>(taken) : 0;
    return taken;
  }

  GliderByteStream inner_;
  double damage_;
  Noise noise_;
};

/// A clock that stands at what it points to.
GliderClock clockAt(double& now) {
  return {&now, [](void* self) { return *static_cast<double*>(self); }};
}

/// The first `count` sensors of the platform that a vehicle reports of itself and the water.
std::vector<Subscription> sensorsToSubscribe(size_t count) {
  std::vector<Subscription> sensors;
  for (uint16_t id = 0; id < sensorCount() && sensors.size() < count; ++id) {
    const bool of_hook = isInstructionSensor(id) || id == GLIDER_SCI_HOOK_HEARTBEAT ||
                         (id >= GLIDER_X_HOOK_STATE && id <= GLIDER_X_HOOK_SESSION);
    if (!of_hook) {
      sensors.push_back({id, 1, 0});
    }
  }
  return sensors;
}

/// Flight cycles as fast as the 115200 line takes their Ticks, each with every subscribed sensor
/// reported and `changing` of them changed.
class Saturation {
 public:
  Saturation(size_t sensors, double changing)
      : subscribed_(sensorsToSubscribe(sensors)),
        changing_(changing),
        client_({"bench", 1, subscribed_.data(), static_cast<uint32_t>(subscribed_.size())}) {}

  void run(double seconds) {
    constexpr double kStep = 0.001;
    for (now_ = 0; now_ < kWarmUp + seconds; now_ += kStep) {
      line_.setNow(now_);
      if (tap_.written - read_ < kUnderWay) {
        flightCycle();
      }
      hookprog_.run(now_, {this, science}, tap_.stream(), memory_.left());
      pollClient();
    }
    const double capacity = seconds * kFastBaud / 10;
    const auto count = static_cast<double>(subscribed_.size());
    fmt::print(
        "  {:3} sensors, {:4.0f} % changed: {:7.1f} ticks/s {:9.0f} readings/s   "
        "wire {:5.1f} %   values {:5.1f} %   with what says whose they are {:5.1f} %\n",
        subscribed_.size(), 100 * changing_, ticks_ / seconds, ticks_ * count / seconds,
        100 * static_cast<double>(tap_.written - written_before_) / capacity,
        100 * value_bytes_ / capacity,
        100 * (value_bytes_ + ticks_ * 2 * std::ceil(count / 8)) / capacity);
  }

 private:
  static constexpr double kWarmUp = 5;
  static constexpr uint64_t kUnderWay = 1200;

  static double science(void* self, uint16_t id, bool* fresh) {
    *fresh = true;
    return static_cast<Saturation*>(self)->valueOf(id);
  }

  [[nodiscard]] bool changes(uint16_t id) const {
    return id % 16 < std::lround(16 * changing_) || id == GLIDER_M_PRESENT_SECS_INTO_MISSION ||
           id == GLIDER_M_CYCLE_NUMBER;
  }
  /// A one-byte sensor holds small numbers only.
  [[nodiscard]] double valueOf(uint16_t id) const {
    return changes(id) ? std::fmod(cycle_, sensorWidth(id) == 1 ? 100 : 1e6) : 1;
  }

  void flightCycle() {
    cycle_ += 1;
    std::vector<SensorUpdate> report;
    for (const Subscription& sensor : subscribed_) {
      if (!isScienceSensor(sensor.id) && sensor.id != GLIDER_M_PRESENT_SECS_INTO_MISSION &&
          sensor.id != GLIDER_M_CYCLE_NUMBER) {
        report.push_back({sensor.id, valueOf(sensor.id)});
      }
    }
    report.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, cycle_});
    report.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    flight_.send(report.data(), static_cast<uint32_t>(report.size()));
    std::array<SensorUpdate, 1> none{};
    flight_.poll(memory_.right(), none.data(), 0);
  }

  void pollClient() {
    const GliderByteStream end = counted();
    for (ClientEvent event = ClientEvent::Handled; event != ClientEvent::Nothing;) {
      event = client_.poll(end, clockAt(now_));
      if (event == ClientEvent::Tick) {
        client_.done({}, end);
        countTick();
      }
    }
    if (now_ < kWarmUp) {
      written_before_ = tap_.written;
    }
  }

  void countTick() {
    if (now_ < kWarmUp) {
      return;
    }
    ticks_ += 1;
    for (const Subscription& sensor : subscribed_) {
      value_bytes_ += changes(sensor.id) ? sensorWidth(sensor.id) : 0;
    }
  }

  /// The SBC's end, which counts what it reads.
  GliderByteStream counted() {
    return {this,
            [](void* self, uint8_t* bytes, uint32_t capacity) {
              auto& bench = *static_cast<Saturation*>(self);
              const GliderByteStream end = bench.line_.right();
              const int32_t got = end.read(end.self, bytes, capacity);
              bench.read_ += got > 0 ? static_cast<uint64_t>(got) : 0;
              return got;
            },
            [](void* self, const uint8_t* bytes, uint32_t count) {
              const GliderByteStream end = static_cast<Saturation*>(self)->line_.right();
              return end.write(end.self, bytes, count);
            }};
  }

  std::vector<Subscription> subscribed_;
  double changing_;
  Client client_;
  Hookprog hookprog_{HookprogOptions{}};
  SerialLine line_{kFastBaud};
  Tap tap_{line_.left(), 0, Noise(1, 0)};
  MemoryLine memory_;
  Clothesline flight_;
  double now_ = 0, cycle_ = 0, ticks_ = 0, value_bytes_ = 0;
  uint64_t read_ = 0, written_before_ = 0;
};

/// The whole chain in its usual time, with an SBC that gives an instruction whenever the sensor
/// that it watches has changed.
class Chain {
 public:
  Chain(uint16_t watched, double damage, uint64_t seed)
      : watched_(watched),
        noise_(seed, 10),
        science_side_(sbc_line_.left(), damage, Noise(seed, 11)),
        sbc_side_(sbc_line_.right(), damage, Noise(seed, 12)),
        flight_side_(clothesline_.left(), damage, Noise(seed, 13)),
        prog_side_(clothesline_.right(), damage, Noise(seed, 14)) {
    array_.fill(kNaN);
  }

  /// Cycles from each of `count` changes to the command, sorted.
  std::vector<double> latencies(size_t count) {
    constexpr double kStep = 0.25;
    for (double now = 0; latencies_.size() < count; now += kStep) {
      now_ = now;
      sbc_line_.setNow(now);
      clothesline_.setNow(now);
      if (std::fmod(now, kCycle) == 0) {
        flightCycle();
      }
      if (std::fmod(now, 1) == 0) {
        maybeChange(isScienceSensor(watched_));
        hookprog_.run(now, {this, science}, science_side_.stream(), prog_side_.stream());
      }
      pollClient();
    }
    std::ranges::sort(latencies_);
    return latencies_;
  }
  [[nodiscard]] double seconds() const { return now_; }
  [[nodiscard]] uint64_t toScience() const { return flight_side_.written; }
  [[nodiscard]] uint64_t toFlight() const { return prog_side_.written; }

 private:
  static HookbehArgs args() { return {}; }

  static double science(void* self, uint16_t id, bool* fresh) {
    *fresh = true;
    return id == static_cast<Chain*>(self)->watched_ ? static_cast<Chain*>(self)->value_ : 1;
  }

  /// The watched sensor changes now and then, once the chain is at rest.
  void maybeChange(bool its_time) {
    constexpr double kShare = 0.05;
    if (its_time && at_rest_ && state_ == HookState::Active && noise_.uniform() < kShare) {
      value_ = value_ == 10 ? 11 : 10;
      changed_at_ = now_;
      at_rest_ = false;
    }
  }

  void flightCycle() {
    ++cycle_;
    maybeChange(!isScienceSensor(watched_));
    std::array<SensorUpdate, 64> updates{};
    const uint32_t count = flight_.poll(flight_side_.stream(), updates.data(), updates.size());
    for (uint32_t i = 0; i < count; ++i) {
      array_[updates[i].id] = updates[i].value;
    }
    const HookbehOutputs out = hookbeh_.cycle(inputs());
    state_ = out.state;
    const bool obeys = out.state == HookState::Active && out.answer == HookAnswer::Accepted &&
                       out.answered_sequence == array_[GLIDER_SCI_HOOK_SEQUENCE] &&
                       array_[GLIDER_SCI_HOOK_DEPTH] == depthFor(value_);
    if (!at_rest_ && obeys) {
      latencies_.push_back((now_ - changed_at_) / kCycle);
      at_rest_ = true;
    }
    report(out);
  }

  [[nodiscard]] HookbehInputs inputs() const {
    const auto& a = array_;
    HookbehInputs in;
    in.time_s = now_;
    in.depth_m = 10;
    in.altitude_m = kNaN;
    in.heartbeat = a[GLIDER_SCI_HOOK_HEARTBEAT];
    in.session = a[GLIDER_SCI_HOOK_SESSION];
    in.sequence = a[GLIDER_SCI_HOOK_SEQUENCE];
    in.control = a[GLIDER_SCI_HOOK_CONTROL];
    in.vertical = a[GLIDER_SCI_HOOK_VERTICAL];
    in.lateral = a[GLIDER_SCI_HOOK_LATERAL];
    in.hook_depth_m = a[GLIDER_SCI_HOOK_DEPTH];
    in.hook_pitch_rad = a[GLIDER_SCI_HOOK_PITCH];
    in.hook_heading_rad = a[GLIDER_SCI_HOOK_HEADING];
    in.hook_latitude_ddmm = a[GLIDER_SCI_HOOK_LAT];
    in.hook_longitude_ddmm = a[GLIDER_SCI_HOOK_LON];
    in.check = a[GLIDER_SCI_HOOK_CHECK];
    return in;
  }

  /// All sensors of the flight controller, as in each cycle of a vehicle.
  void report(const HookbehOutputs& out) {
    std::vector<SensorUpdate> updates;
    for (uint16_t id = 0; id < sensorCount(); ++id) {
      const bool last = id == GLIDER_M_PRESENT_SECS_INTO_MISSION || id == GLIDER_M_CYCLE_NUMBER;
      if (!isScienceSensor(id) && !last) {
        const double value = id == watched_                 ? value_
                             : id == GLIDER_X_HOOK_STATE    ? static_cast<double>(out.state)
                             : id == GLIDER_X_HOOK_ANSWER   ? static_cast<double>(out.answer)
                             : id == GLIDER_X_HOOK_SEQUENCE ? out.answered_sequence
                             : id == GLIDER_X_HOOK_SESSION  ? out.session
                                                            : cycle_;
        updates.push_back({id, value});
      }
    }
    updates.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, now_});
    updates.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    flight_.send(updates.data(), static_cast<uint32_t>(updates.size()));
    std::array<SensorUpdate, 1> none{};
    flight_.poll(flight_side_.stream(), none.data(), 0);
  }

  void pollClient() {
    const GliderByteStream end = sbc_side_.stream();
    for (ClientEvent event = ClientEvent::Handled; event != ClientEvent::Nothing;) {
      event = client_.poll(end, clockAt(now_));
      if (event == ClientEvent::Tick) {
        decide();
        client_.done({now_, 0, 0, MissionPhase::Flying}, end);
      }
    }
  }

  void decide() {
    const VehicleTick& tick = client_.tick();
    double value = known_;
    for (uint32_t i = 0; i < tick.reading_count; ++i) {
      value = tick.readings[i].id == watched_ ? tick.readings[i].value : value;
    }
    const bool take = !tick.obeys_us && tick.hook_state != HookState::Active && !taking_;
    taking_ = take || (taking_ && !tick.obeys_us && tick.hook_state != HookState::Silent);
    if (take || value != known_) {
      instruct(take ? HookControl::Take : HookControl::Steer, value);
    }
    known_ = value;
  }

  /// The instruction tells by its depth which value caused it.
  static double depthFor(double value) { return 10 + value; }

  void instruct(HookControl control, double value) {
    Instruction instruction;
    instruction.control = control;
    instruction.vertical = HookVertical::Descend;
    instruction.depth_m = depthFor(value);
    instruction.pitch_rad = -0.4;
    client_.instruct(instruction);
  }

  uint16_t watched_;
  Noise noise_;
  SerialLine sbc_line_{kFastBaud}, clothesline_{kSlowBaud};
  Tap science_side_, sbc_side_, flight_side_, prog_side_;
  Clothesline flight_;
  Hookprog hookprog_{HookprogOptions{}};
  Hookbeh hookbeh_{args()};
  std::array<double, GLIDER_SENSOR_COUNT> array_{};
  std::array<Subscription, 1> subscribed_{{{watched_, 1, 0}}};
  Client client_{{"bench", 1, subscribed_.data(), 1}};
  double now_ = 0, cycle_ = 0, value_ = 10, known_ = kNaN, changed_at_ = 0;
  HookState state_ = HookState::Absent;
  bool at_rest_ = true, taking_ = false;
  std::vector<double> latencies_;
};

void latency(const char* name, uint16_t watched, double damage, uint64_t seed) {
  constexpr size_t kChanges = 10000;
  const auto chain = std::make_unique<Chain>(watched, damage, seed);
  const std::vector<double> sorted = chain->latencies(kChanges);
  const auto at = [&](double share) {
    return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  fmt::print("  {:<24} {:7.3f} % of bytes damaged: p50 {:5.2f}  p99 {:5.2f}  most {:6.2f} cycles\n",
             name, 100 * damage, at(0.5), at(0.99), sorted.back());
}

void slowLine(uint64_t seed) {
  const auto chain = std::make_unique<Chain>(GLIDER_M_DEPTH, 0, seed);
  (void)chain->latencies(1000);
  const double capacity = chain->seconds() * kSlowBaud / 10;
  fmt::print("  to science {:.1f} % of it, to flight {:.1f} %\n",
             100 * static_cast<double>(chain->toScience()) / capacity,
             100 * static_cast<double>(chain->toFlight()) / capacity);
}

/// Reports of 4-byte sensors as fast as the 9600 line takes them.
void slowSaturation() {
  constexpr double kSeconds = 60;
  SerialLine line(kSlowBaud);
  Clothesline sender, receiver;
  const std::vector<SensorUpdate> report(40, {GLIDER_M_DEPTH, 12.34567});
  double given = 0, arrived = 0;
  std::array<SensorUpdate, 64> updates{};
  for (double now = 0; now < kSeconds; now += 0.125) {
    line.setNow(now);
    while (given - arrived < 600 && sender.send(report.data(), 40)) {
      sender.poll(line.left(), updates.data(), 0);
      given += 240;
    }
    arrived += 6.0 * receiver.poll(line.right(), updates.data(), 64);
  }
  fmt::print("  at saturation {:.1f} % are sensor numbers and values\n",
             100 * arrived / (kSeconds * kSlowBaud / 10));
}

}  // namespace

int main(int argc, char** argv) {
  const uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1;
  constexpr double kSeconds = 60;
  fmt::print("115200 baud, 8N1, Ticks back to back for {} s, shares of 11520 bytes/s:\n", kSeconds);
  for (const size_t sensors : {4U, 8U, 16U, 32U, 64U}) {
    std::make_unique<Saturation>(sensors, 1)->run(kSeconds);
  }
  std::make_unique<Saturation>(64, 0.25)->run(kSeconds);
  fmt::print(
      "\n9600 baud, 8N1, a usual flight: every flight sensor in each cycle of 4 s, "
      "instructions:\n");
  slowLine(seed);
  slowSaturation();
  fmt::print(
      "\nFrom a sensor's change on board to hookbeh obeying the instruction that it caused, 10,000 "
      "changes, seed {}:\n",
      seed);
  for (const double damage : {0.0, 0.0001, 0.001}) {
    latency("flight sensor (depth)", GLIDER_M_DEPTH, damage, seed);
    latency("science sensor (temp)", GLIDER_SCI_WATER_TEMP, damage, seed);
  }
  return 0;
}
