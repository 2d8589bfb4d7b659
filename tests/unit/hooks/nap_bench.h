// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "hooks/hookprog/hookprog.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/line_ends.h"
#include "tests/unit/hooks/vehicle_line.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace glider::hooks {

/// A hookprog with a real client at its line that may sleep. The flight controller and the
/// instruments report random values, the same for the same seed, for anything that the SBC does.
class NapBench {
 public:
  explicit NapBench(std::vector<Subscription> sensors, uint32_t seed = 1,
                    const GliderDictionary& dictionary = gliderDictionary)
      : sensors_(std::move(sensors)),
        hookprog(dictionary),
        client(dictionary, options(sensors_, dictionary)),
        random_(seed) {
    Instruction take;
    take.control = HookControl::Take;
    take.vertical = HookVertical::Surface;
    client.instruct(take);
  }

  /// One second of everything; every fourth begins with a cycle of the flight controller.
  void second() {
    ++now;
    if (cycles && static_cast<int>(now) % 4 == 0) {
      cycle();
    }
    const auto own = [this](uint16_t id, bool* fresh) {
      const auto found = science_.find(id);
      *fresh = found != science_.end();
      const double value = *fresh ? found->second : 0;
      science_.erase(id);
      return value;
    };
    hookprog.run(now, flight_line.memory(own), line.left());
    for (SeatEvent event = hookprog.nextEvent(); event.kind != SeatEvent::Kind::None;
         event = hookprog.nextEvent()) {
      events.push_back(event);
    }
    serveSbc();
  }
  void seconds(int count) {
    for (int i = 0; i < count; ++i) {
      second();
    }
  }
  /// Until the SBC is in control and has answered in it.
  void begin() { seconds(24); }
  /// Until the next Tick is answered with a nap.
  void sleep(const Nap& nap) {
    const uint32_t before = count(SeatEvent::Kind::SbcNap);
    once_ = nap;
    for (int i = 0; i < 10 && count(SeatEvent::Kind::SbcNap) == before; ++i) {
      second();
    }
    once_.reset();
  }

  [[nodiscard]] uint32_t count(SeatEvent::Kind kind) const {
    return static_cast<uint32_t>(std::ranges::count(events, kind, &SeatEvent::kind));
  }
  /// The newest of this kind.
  [[nodiscard]] SeatEvent newest(SeatEvent::Kind kind) const {
    SeatEvent found;
    for (const SeatEvent& event : events) {
      found = event.kind == kind ? event : found;
    }
    return found;
  }
  /// The heartbeats that hookprog has set since the last call.
  std::vector<double> beats() {
    std::vector<double> found;
    for (const SensorUpdate& update : flight_line.takeSet()) {
      if (update.id == GLIDER_SCI_HOOK_HEARTBEAT) {
        found.push_back(update.value);
      }
    }
    return found;
  }

 private:
  std::vector<Subscription> sensors_;  // before its users

 public:
  Hookprog hookprog;
  Client client;
  MemoryLine line;
  VehicleLine flight_line;
  double now = 0;
  double clock_s = 0;        ///< of the SBC
  bool cycles = true;        ///< the flight controller reports
  bool sbc_answers = true;   ///< if not, it is dead
  bool advances = true;      ///< its mission
  double nap_secs = 3600;    ///< hookbeh's
  double time_offset_s = 0;  ///< of the vehicle's time
  double share = 0.5;        ///< of the sensors that are reported in a cycle
  HookState state = HookState::Active;
  uint32_t session = 0;
  double answered = 0;
  double answer = 1;  ///< hookbeh's, once it has answered
  /// What the flight controller reports in place of random values.
  std::map<uint16_t, double> fixed;
  /// The nap that ends the answer to a Tick.
  std::function<std::optional<Nap>(const VehicleTick&)> order;
  /// Frames on their way to the SBC; true: this one is lost.
  std::function<bool(const Frame&)> loses = [](const Frame&) { return false; };
  std::vector<VehicleTick> ticks;  ///< that the client has seen
  std::vector<Frame> sent;         ///< by hookprog
  std::vector<SeatEvent> events;
  uint32_t wake_s = 0;  ///< that the SBC needs
  uint32_t deaf = 0;    ///< frames that came while it could not read

 private:
  static ClientOptions options(const std::vector<Subscription>& sensors,
                               const GliderDictionary& dictionary) {
    ClientOptions options;
    const bool has = dictionary.roles[kGliderRoleHookNapSecs] != GLIDER_NO_SENSOR;
    options.features.needs = has ? kFeatureNaps : 0;
    options.session = 7;
    options.sensors = sensors.data();
    options.sensor_count = static_cast<uint32_t>(sensors.size());
    return options;
  }

  /// Few values, so that some repeat and some are near each other; rarely one that is unknown.
  double drawn() {
    const auto kind = random_() % 20;
    const double value = 10 + 0.1 * static_cast<double>(random_() % 40);
    return kind == 0 ? std::numeric_limits<double>::quiet_NaN() : value;
  }

  void cycle() {
    ++cycle_;
    std::vector<SensorUpdate> report;
    for (const Subscription& wanted : sensors_) {
      const bool reported = static_cast<double>(random_() % 1000) < 1000 * share;
      const double value = drawn();
      if (!reported) {
        continue;
      }
      if (isScienceSensor(wanted.id)) {
        science_[wanted.id] = value;
      } else if (!fixed.contains(wanted.id)) {
        report.push_back({wanted.id, value});
      }
    }
    for (const auto& [id, value] : fixed) {
      report.push_back({id, value});
    }
    obey();
    report.push_back({GLIDER_X_HOOK_STATE, static_cast<double>(state)});
    report.push_back({GLIDER_X_HOOK_SESSION, static_cast<double>(session)});
    report.push_back({GLIDER_X_HOOK_SEQUENCE, answered});
    report.push_back({GLIDER_X_HOOK_ANSWER, answered > 0 ? answer : 0.0});
    report.push_back({GLIDER_X_HOOK_NAP_SECS, nap_secs});
    report.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, 4.0 * cycle_ + time_offset_s});
    report.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    flight_line.fromFlight(report);
  }

  void obey() {
    for (const SensorUpdate& update : flight_line.atFlight()) {
      if (update.id == GLIDER_SCI_HOOK_SESSION) {
        session = static_cast<uint32_t>(update.value);
      }
      answered = update.id == GLIDER_SCI_HOOK_SEQUENCE ? update.value : answered;
    }
  }

  /// The SBC's end of the line: while it sleeps or wakes, what comes is lost.
  void serveSbc() {
    slept_ = slept_ || !hookprog.wantsSbc();
    woken_ = hookprog.wantsSbc() ? woken_ + 1 : 0;
    const bool reads = !slept_ || woken_ > wake_s;
    slept_ = !reads;
    while (reader_.next(line.right()) == FrameReader::Result::Frame) {
      const Frame& frame = reader_.frame();
      sent.push_back(frame);
      deaf += reads ? 0 : 1;
      if (reads && sbc_answers && !loses(frame)) {
        put(to_sbc_.left(), frame);
        takeFrames();
      }
    }
  }

  void takeFrames() {
    HandClock clock{clock_s};
    const GliderByteStream end{this, readSbc, writeSbc};
    while (true) {
      const ClientEvent event = client.poll(end, clock.clock());
      if (event == ClientEvent::Tick) {
        const VehicleTick& tick = client.tick();
        ticks.push_back(tick);
        mission_s_ = advances ? tick.vehicle_time_s : mission_s_;
        std::optional<Nap> nap = order ? order(tick) : std::nullopt;
        if (!tick.kept && once_) {
          nap = std::exchange(once_, std::nullopt);
        }
        if (nap) {
          client.nap(*nap);
        }
        client.done({mission_s_, 0, 0, MissionPhase::Flying}, end);
      } else if (event != ClientEvent::Handled) {
        return;
      }
    }
  }
  static int32_t readSbc(void* self, uint8_t* bytes, uint32_t count) {
    const GliderByteStream from = static_cast<NapBench*>(self)->to_sbc_.right();
    return from.read(from.self, bytes, count);
  }
  static int32_t writeSbc(void* self, const uint8_t* bytes, uint32_t count) {
    const GliderByteStream to = static_cast<NapBench*>(self)->line.right();
    return to.write(to.self, bytes, count);
  }

  std::optional<Nap> once_;
  FrameReader reader_;  // the line takes a part of a frame at a time
  MemoryLine to_sbc_;
  std::mt19937 random_;
  std::map<uint16_t, double> science_;
  double cycle_ = 0, mission_s_ = 0;
  uint32_t woken_ = 0;
  bool slept_ = false;
};

}  // namespace glider::hooks
