// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/hookprog/hookprog.h"
#include "hooks/transport/memory.h"
#include "tests/slocum.h"
#include "tests/unit/hooks/vehicle_line.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

/// A vehicle on the bench: sensor array, hookbeh and hookprog as they are on
/// board, with no water round them. The SBC is polled after every second.
namespace glider::runtime::testing {

class VehicleBench {
 public:
  explicit VehicleBench(const hooks::HookbehArgs& args, bool virtual_time = true)
      : args_(args),
        hookbeh_(args, hooks::kHull),
        hookprog_(gliderDictionary, {.virtual_time = virtual_time}) {
    for (double& value : array_) {
      value = NAN;
    }
  }

  /// Polls the SBC until it has nothing to do.
  std::function<void()> sbc = [] {};
  /// Depth and temperature at a vehicle time.
  std::function<double(double)> depth = [](double) { return 10.0; };
  std::function<double(double)> temperature = [](double) { return 20.0; };
  std::vector<uint16_t>
      reports;               ///< sensors that the vehicle reports in each cycle, beside its own
  bool line_is_cut = false;  ///< the SBC is not polled and receives nothing
  bool forgets_sequence = false;  ///< new instructions do not get into the sensor array

  /// What m_present_time says at time 0, s since 1970; 0: it is not reported.
  double clock_at_start = 0;

  /// The flight controller starts its mission again, with an empty sensor array.
  void restartMission() {
    for (double& value : array_) {
      value = NAN;
    }
    hookbeh_ = hooks::Hookbeh(args_, hooks::kHull);
    mission_start_ = now_;
  }

  [[nodiscard]] GliderByteStream sbcEnd() { return sbc_line_.right(); }
  void closeLine() { sbc_line_.close(); }
  /// Bytes of no frame arrive at the SBC.
  void disturb(const std::string& bytes) {
    const GliderByteStream line = sbc_line_.left();
    line.write(line.self, reinterpret_cast<const uint8_t*>(bytes.data()),
               static_cast<uint32_t>(bytes.size()));
  }
  [[nodiscard]] double now() const { return now_; }
  [[nodiscard]] const hooks::HookbehOutputs& hookbeh() const { return outputs_; }
  [[nodiscard]] double array(uint16_t id) const { return array_[id]; }
  void set(uint16_t id, double value) { array_[id] = value; }

  void run(double until) {
    for (; now_ < until; now_ += 1) {
      if (std::fmod(now_, 4) == 0) {
        controlCycle();
      }
      const auto own = [this](uint16_t id, bool* fresh) { return scienceSensor(id, fresh); };
      hookprog_.run(now_, line_.memory(own), sbc_line_.left());
      hookprog_.run(now_ + 1, line_.memory(own), sbc_line_.left());  // nothing more has come
      if (!line_is_cut) {
        sbc();
      }
      hookprog_.run(now_ + 1, line_.memory(own), sbc_line_.left());
      for (hooks::SeatEvent e = hookprog_.nextEvent(); e.kind != hooks::SeatEvent::Kind::None;
           e = hookprog_.nextEvent()) {
        events.push_back(e);
      }
    }
  }

  std::vector<hooks::SeatEvent> events;
  std::vector<std::string> doings;         ///< what hookbeh did, each change once
  std::vector<hooks::HookAnswer> answers;  ///< each new one
  [[nodiscard]] hooks::SbcView sbcView() const { return hookprog_.sbc(); }

 private:
  double noise_ = 0;

  double scienceSensor(uint16_t id, bool* fresh) {
    *fresh = id == GLIDER_SCI_WATER_TEMP;
    return id == GLIDER_SCI_WATER_TEMP ? temperature(now_) : NAN;
  }

  void controlCycle() {
    receive();
    array_[GLIDER_M_PRESENT_SECS_INTO_MISSION] = now_ - mission_start_;
    array_[GLIDER_M_CYCLE_NUMBER] = std::floor((now_ - mission_start_) / 4);
    array_[GLIDER_M_PRESENT_TIME] = clock_at_start > 0 ? clock_at_start + now_ : NAN;
    // No two readings of a sensor in the sea are the same to the last bit.
    constexpr double kNoise = 1e-7;
    noise_ = noise_ == 0 ? kNoise : 0;
    array_[GLIDER_M_DEPTH] = depth(now_) + noise_;
    outputs_ = hookbeh_.cycle(inputs());
    if (outputs_.commanding &&
        (doings.empty() || doings.back() != hookWordsForDoing(outputs_.doing))) {
      doings.emplace_back(hookWordsForDoing(outputs_.doing));
    }
    if (outputs_.answer != hooks::HookAnswer::None &&
        outputs_.answered_sequence != array_[GLIDER_X_HOOK_SEQUENCE]) {
      answers.push_back(outputs_.answer);
    }
    array_[GLIDER_X_HOOK_STATE] = static_cast<double>(outputs_.state);
    array_[GLIDER_X_HOOK_ANSWER] = static_cast<double>(outputs_.answer);
    array_[GLIDER_X_HOOK_SEQUENCE] = outputs_.answered_sequence;
    array_[GLIDER_X_HOOK_SESSION] = outputs_.session;
    report();
  }

  void receive() {
    for (const hooks::SensorUpdate& update : line_.atFlight()) {
      if (!forgets_sequence || update.id != GLIDER_SCI_HOOK_SEQUENCE) {
        array_[update.id] = update.value;
      }
    }
  }

  void report() {
    const uint16_t told[] = {GLIDER_M_DEPTH,
                             GLIDER_X_HOOK_STATE,
                             GLIDER_X_HOOK_ANSWER,
                             GLIDER_X_HOOK_SEQUENCE,
                             GLIDER_X_HOOK_SESSION,
                             GLIDER_M_PRESENT_TIME,
                             GLIDER_M_PRESENT_SECS_INTO_MISSION,
                             GLIDER_M_CYCLE_NUMBER};
    std::vector<hooks::SensorUpdate> updates;
    for (const uint16_t id : told) {
      updates.push_back({id, array_[id]});
    }
    for (const uint16_t id : reports) {
      updates.push_back({id, array_[id]});
    }
    line_.fromFlight(updates);
  }

  [[nodiscard]] hooks::HookbehInputs inputs() const {
    hooks::HookbehInputs in;
    in.time_s = now_ - mission_start_;
    in.depth_m = array_[GLIDER_M_DEPTH];
    in.depth_rate_mps = array_[GLIDER_M_DEPTH_RATE];
    in.altitude_m = NAN;
    in.latitude_ddmm = 3910;
    in.longitude_ddmm = -7349;
    in.heartbeat = array_[GLIDER_SCI_HOOK_HEARTBEAT];
    in.words.session = array_[GLIDER_SCI_HOOK_SESSION];
    in.words.sequence = array_[GLIDER_SCI_HOOK_SEQUENCE];
    in.words.control = array_[GLIDER_SCI_HOOK_CONTROL];
    in.words.vertical = array_[GLIDER_SCI_HOOK_VERTICAL];
    in.words.lateral = array_[GLIDER_SCI_HOOK_LATERAL];
    in.words.hook_depth_m = array_[GLIDER_SCI_HOOK_DEPTH];
    in.words.hook_pitch_rad = array_[GLIDER_SCI_HOOK_PITCH];
    in.words.hook_heading_rad = array_[GLIDER_SCI_HOOK_HEADING];
    in.words.hook_latitude_ddmm = array_[GLIDER_SCI_HOOK_LAT];
    in.words.hook_longitude_ddmm = array_[GLIDER_SCI_HOOK_LON];
    in.words.check = array_[GLIDER_SCI_HOOK_CHECK];
    return in;
  }

  hooks::HookbehArgs args_;
  double now_ = 0;
  double mission_start_ = 0;
  double array_[GLIDER_SENSOR_COUNT];
  hooks::Hookbeh hookbeh_;
  hooks::Hookprog hookprog_;
  hooks::MemoryLine sbc_line_;
  hooks::VehicleLine line_;
  hooks::HookbehOutputs outputs_;
};

}  // namespace glider::runtime::testing
