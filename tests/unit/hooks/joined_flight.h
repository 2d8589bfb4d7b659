// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/client/client.h"
#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/line_ends.h"
#include "tests/unit/hooks/vehicle_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>

/// Client, hookprog and hookbeh joined: over a line that loses and flips bytes, and over the
/// vehicle's own, whose values are late, each by itself.
namespace glider::hooks {

/// A serial line with a speed and noise, between two ends in memory.
class NoisyLine {
 public:
  NoisyLine(double bytes_a_second, double damage, uint32_t seed)
      : speed_(bytes_a_second), damage_(damage), random_(seed) {}
  GliderByteStream left() { return left_.left(); }
  GliderByteStream right() { return right_.right(); }
  /// Moves what the line carries in `seconds`.
  void carry(double seconds) {
    now_ += seconds;
    move(left_.right(), right_.left(), to_right_, seconds);
    move(right_.left(), left_.right(), to_left_, seconds);
  }
  void setDamage(double damage) { damage_ = damage; }
  void setDelay(double seconds) { delay_ = seconds; }
  /// Behind so great a share of the frames one that came before comes again, however old.
  void setReplays(double share) { replays_ = share; }

 private:
  struct UnderWay {
    uint8_t byte;
    double due;
  };
  struct Way {
    std::vector<uint8_t> frame;  ///< as far as it has come
    std::deque<UnderWay> bytes;
    std::vector<std::vector<uint8_t>> earlier;
  };

  void replay(Way& way) {
    if (replays_ <= 0) {
      return;
    }
    way.earlier.push_back(way.frame);
    if (chance_(random_) < replays_) {
      for (const uint8_t one : way.earlier[random_() % way.earlier.size()]) {
        way.bytes.push_back({one, now_ + delay_});
      }
    }
  }

  void move(const GliderByteStream& from, const GliderByteStream& to, Way& way, double seconds) {
    uint8_t byte = 0;
    for (double budget = speed_ * seconds; budget >= 1 && from.read(from.self, &byte, 1) == 1;
         --budget) {
      if (chance_(random_) < damage_) {
        if (random_() % 2 == 0) {
          continue;
        }
        byte = static_cast<uint8_t>(byte ^ (1U << random_() % 8));
      }
      way.frame.push_back(byte);
      if (byte == 0) {
        for (const uint8_t one : way.frame) {
          way.bytes.push_back({one, now_ + delay_});
        }
        replay(way);
        way.frame.clear();
      }
    }
    for (; !way.bytes.empty() && way.bytes.front().due <= now_; way.bytes.pop_front()) {
      to.write(to.self, &way.bytes.front().byte, 1);
    }
  }

  double speed_;
  double damage_;
  double delay_ = 0, now_ = 0, replays_ = 0;
  Way to_left_, to_right_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> chance_{0, 1};
  MemoryLine left_;
  MemoryLine right_;
};

/// The flight controller: a sensor array, hookbeh, and a vehicle that moves as commanded.
class FlightController {
 public:
  explicit FlightController(bool with_hookbeh = true)
      : hookbeh_(args(), kHull), with_hookbeh_(with_hookbeh) {}

  static HookbehArgs args() {
    HookbehArgs args;
    args.start_secs = 60;
    return args;
  }

  void cycle(VehicleLine& line) {
    time += 4;
    ++cycle_;
    depth = std::max(0.0, depth + (outputs.commanding ? (outputs.pump_cc < 0 ? 0.8 : -0.8) : 0.0));
    for (const SensorUpdate& update : line.atFlight()) {
      array_[update.id] = update.value;
      ++received;
    }
    if (with_hookbeh_) {
      outputs = hookbeh_.cycle(inputs());
    }
    report(line);
  }

  HookbehOutputs outputs;
  double time = 0;
  double depth = 10;
  uint32_t received = 0;
  /// What was reported in each cycle.
  struct Report {
    double depth = 0, latitude = 0;
  };
  std::map<uint32_t, Report> reported;

 private:
  double get(uint16_t id) const {
    const auto found = array_.find(id);
    return found == array_.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }

  HookbehInputs inputs() const {
    HookbehInputs in;
    in.time_s = time;
    in.depth_m = depth;
    in.altitude_m = std::numeric_limits<double>::quiet_NaN();
    in.heartbeat = get(GLIDER_SCI_HOOK_HEARTBEAT);
    in.words.session = get(GLIDER_SCI_HOOK_SESSION);
    in.words.sequence = get(GLIDER_SCI_HOOK_SEQUENCE);
    in.words.control = get(GLIDER_SCI_HOOK_CONTROL);
    in.words.vertical = get(GLIDER_SCI_HOOK_VERTICAL);
    in.words.lateral = get(GLIDER_SCI_HOOK_LATERAL);
    in.words.hook_depth_m = get(GLIDER_SCI_HOOK_DEPTH);
    in.words.hook_pitch_rad = get(GLIDER_SCI_HOOK_PITCH);
    in.words.hook_heading_rad = get(GLIDER_SCI_HOOK_HEADING);
    in.words.hook_latitude_ddmm = get(GLIDER_SCI_HOOK_LAT);
    in.words.hook_longitude_ddmm = get(GLIDER_SCI_HOOK_LON);
    in.words.check = get(GLIDER_SCI_HOOK_CHECK);
    in.words.sampling = get(GLIDER_SCI_HOOK_SAMPLING);
    return in;
  }

  void report(VehicleLine& line) {
    std::vector<SensorUpdate> report{
        {GLIDER_M_DEPTH, depth}, {GLIDER_M_PITCH, 0.1}, {GLIDER_M_LAT, latitude()}};
    reported[static_cast<uint32_t>(cycle_)] = {static_cast<double>(static_cast<float>(depth)),
                                               latitude()};
    if (with_hookbeh_) {
      report.push_back({GLIDER_X_HOOK_STATE, static_cast<double>(outputs.state)});
      report.push_back({GLIDER_X_HOOK_SEQUENCE, static_cast<double>(outputs.answered_sequence)});
      report.push_back({GLIDER_X_HOOK_ANSWER, static_cast<double>(outputs.answer)});
      report.push_back({GLIDER_X_HOOK_SESSION, static_cast<double>(outputs.session)});
    }
    report.push_back({GLIDER_M_PRESENT_SECS_INTO_MISSION, time});
    report.push_back({GLIDER_M_CYCLE_NUMBER, cycle_});
    line.fromFlight(report);
  }

  /// Changes now and then, back and forth.
  double latitude() const { return 3910 + std::floor(cycle_ / 3) - 2 * std::floor(cycle_ / 6); }

  Hookbeh hookbeh_;
  bool with_hookbeh_;
  std::map<uint16_t, double> array_;
  double cycle_ = 0;
};

/// A mission on the SBC: takes control, flies a yo whose pitch differs each time, releases control
/// after a while.
class Mission {
 public:
  explicit Mission(double release_s, uint32_t session = 1, float dead_band = 0)
      : give_back_s_(release_s), client_(gliderDictionary, options(session, dead_band)) {}

  static ClientOptions options(uint32_t session, float dead_band) {
    static Subscription sensors[2];
    sensors[0] = {GLIDER_M_DEPTH, 1, dead_band};
    sensors[1] = {GLIDER_M_LAT};
    ClientOptions options;
    options.features.needs = kFeatureSampling;
    options.mission_name = "yo";
    options.session = session;
    options.sensors = sensors;
    options.sensor_count = 2;
    return options;
  }

  void step(const GliderByteStream& line, double now) {
    clock_.seconds = now;
    while (true) {
      const ClientEvent event = client_.poll(line, clock_.clock());
      if (event == ClientEvent::Tick) {
        if (!stuck) {
          decide();
          newest_s_ = now;
        }
        client_.done({newest_s_, 0, 0, MissionPhase::Flying}, line);
      } else if (event != ClientEvent::Handled) {
        return;
      }
    }
  }

  /// The instruction sent to hookbeh under each sequence number.
  std::map<uint16_t, Instruction> told;
  bool finished = false;
  bool stuck = false;  ///< it answers, but that is all
  /// Sees each tick.
  std::function<void(const VehicleTick&)> watch = [](const VehicleTick&) {};

 private:
  void decide() {
    const VehicleTick& tick = client_.tick();
    watch(tick);
    if (tick.instruction_sequence != 0) {  // the client may have given it another number
      told.emplace(tick.instruction_sequence, last_);
    }
    for (uint32_t i = 0; i < tick.reading_count; ++i) {
      if (tick.readings[i].id == GLIDER_M_DEPTH) {
        depth_ = tick.readings[i].value;
      }
    }
    if (finished || tick.hook_state == HookState::Waiting) {
      return;
    }
    if (tick.vehicle_time_s >= give_back_s_) {
      finished = true;
      tell(HookControl::Release);
    } else if ((tick.hook_state == HookState::Ready && !asked_) ||
               tick.hook_state == HookState::Silent) {
      asked_ = true;
      down_ = true;
      tell(HookControl::Take);
    } else if (depth_ >= 20 && down_) {
      down_ = false;
      tell(HookControl::Steer);
    } else if (depth_ <= 5 && !down_) {
      down_ = true;
      tell(HookControl::Steer);
    }
  }

  void tell(HookControl control) {
    Instruction instruction;
    instruction.control = control;
    instruction.vertical = down_ ? HookVertical::Descend : HookVertical::Ascend;
    instruction.depth_m = down_ ? 20.1 : 5.1;
    turn_ = (turn_ + 1) % 20;
    instruction.pitch_rad = (down_ ? -1 : 1) * (0.2 + 0.01 * turn_);
    instruction.sampling = static_cast<uint32_t>(turn_ % 3);
    const uint16_t sequence = client_.instruct(instruction);
    last_ = inSteps(instruction);
    told[sequence] = last_;
  }

  double give_back_s_;
  Instruction last_;
  Client client_;
  HandClock clock_;
  double depth_ = 10, newest_s_ = 0;
  bool down_ = true;
  bool asked_ = false;
  int turn_ = 0;
};

/// The whole vehicle for some seconds.
class Vehicle {
 public:
  /// `damage`: share of the bytes between SBC and science computer, and of the values between the
  /// two computers of the vehicle.
  Vehicle(double damage, uint32_t seed, bool with_hookbeh = true)
      : sbc_line(11520, damage, seed), flight_line(seed + 1000), flight(with_hookbeh) {
    flight_line.setLoss(damage);
  }

  /// One second; `mission` may be null: no SBC.
  void second(Mission* mission) {
    if (now_ % 4 == 0) {
      flight.cycle(flight_line);
    }
    flight_line.passTime(1);
    hookprog.run(now_, flight_line.memory(), sbc_line.left());
    sbc_line.carry(0.5);
    if (mission != nullptr) {
      mission->step(sbc_line.right(), now_);
    }
    sbc_line.carry(0.5);
    ++now_;
  }

  NoisyLine sbc_line;
  VehicleLine flight_line;
  FlightController flight;
  Hookprog hookprog{gliderDictionary};

 private:
  int now_ = 0;
};

/// Checks in every second that what hookbeh does is what the mission last told and hookbeh
/// accepted.
class Witness {
 public:
  void look(const FlightController& flight, const Mission& mission) {
    const HookbehOutputs& out = flight.outputs;
    if (out.answer == HookAnswer::Accepted && out.answered_sequence != accepted_) {
      accepted_ = out.answered_sequence;
      ASSERT_TRUE(mission.told.contains(accepted_)) << "an instruction that was never given";
      ASSERT_TRUE(seen_.insert(accepted_).second) << "a command twice";
    }
    if (!out.commanding) {
      return;
    }
    if (out.doing == Doing::DiveTo || out.doing == Doing::ClimbTo || out.doing == Doing::Hold) {
      ASSERT_TRUE(mission.told.contains(accepted_));
      EXPECT_EQ(out.sampling, mission.told.at(accepted_).sampling);
      EXPECT_EQ(out.pitch_rad, mission.told.at(accepted_).pitch_rad)
          << "at " << flight.time << " s";
    }
  }
  [[nodiscard]] size_t accepted() const { return seen_.size(); }

 private:
  uint16_t accepted_ = 0;
  std::set<uint16_t> seen_;
};

}  // namespace glider::hooks
