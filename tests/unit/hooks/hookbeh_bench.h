// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/hookbeh/hookbeh.h"
#include "tests/slocum.h"

#include <cmath>
#include <limits>

namespace glider::hooks {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A hookbeh on the bench: the test is the sensor array and the SBC. Every cycle takes 4 s and
/// beats the heart, unless `alive` is false. To a depth far off, the vehicle moves in cycles of its
/// own, and no two readings of the depth are the same to the last bit, unless `raw_depth`.
class HookbehBench {
 public:
  explicit HookbehBench(const HookbehArgs& args = {}) : hookbeh(args, kHull) {
    inputs.depth_m = 10;
    inputs.altitude_m = kNan;
    inputs.latitude_ddmm = 3910;
    inputs.longitude_ddmm = -7350;
    inputs.heartbeat = inputs.words.session = inputs.words.sequence = inputs.words.control =
        inputs.words.vertical = inputs.words.lateral = kNan;
    inputs.words.check = kNan;
  }

  HookbehOutputs cycle() {
    constexpr double kStride = 2;
    HookbehInputs way = last_;
    for (double far = inputs.depth_m - way.depth_m;
         begun_ && !raw_depth && std::fabs(far) > kStride; far = inputs.depth_m - way.depth_m) {
      way.depth_m += std::copysign(kStride, far);
      way.time_s += 4;
      inputs.time_s += 4;
      run(way);
    }
    inputs.time_s += 4;
    const HookbehOutputs out = run(inputs);
    begun_ = true;
    last_ = inputs;
    return out;
  }

  /// Writes an instruction to the sensor array, with the next sequence number.
  void write(Instruction instruction) {
    instruction.sequence = ++sequence;
    Instruction carried;
    hookInSteps(&instruction, &carried);
    inputs.words.session = carried.session;
    inputs.words.sequence = carried.sequence;
    inputs.words.control = static_cast<double>(carried.control);
    inputs.words.vertical = static_cast<double>(carried.vertical);
    inputs.words.lateral = static_cast<double>(carried.lateral);
    inputs.words.hook_depth_m = carried.depth_m;
    inputs.words.hook_pitch_rad = carried.pitch_rad;
    inputs.words.hook_heading_rad = carried.heading_rad;
    inputs.words.hook_latitude_ddmm = carried.latitude_ddmm;
    inputs.words.hook_longitude_ddmm = carried.longitude_ddmm;
    inputs.words.check = hookCheckValue(&carried);
  }

  HookbehOutputs give(const Instruction& instruction) {
    write(instruction);
    return cycle();
  }

  static Instruction descend(double depth, HookControl control = HookControl::Steer,
                             uint32_t session = 1) {
    Instruction instruction;
    instruction.session = session;
    instruction.control = control;
    instruction.vertical = HookVertical::Descend;
    instruction.depth_m = depth;
    instruction.pitch_rad = -0.4;
    return instruction;
  }
  static Instruction ascend(double depth) {
    Instruction instruction = descend(depth);
    instruction.vertical = HookVertical::Ascend;
    instruction.pitch_rad = 0.4;
    return instruction;
  }
  static Instruction vertical(HookVertical vertical, double depth = 0) {
    Instruction instruction = descend(depth);
    instruction.vertical = vertical;
    return instruction;
  }
  static Instruction actuators(double pump_cc, double battery_in) {
    Instruction instruction = vertical(HookVertical::Actuators, pump_cc);
    instruction.pitch_rad = battery_in;
    return instruction;
  }
  static Instruction take(double depth = 20, uint32_t session = 1) {
    return descend(depth, HookControl::Take, session);
  }
  static Instruction giveBack(uint32_t session = 1) {
    Instruction instruction;
    instruction.session = session;
    instruction.control = HookControl::Release;
    return instruction;
  }

  Hookbeh hookbeh;
  HookbehInputs inputs;
  bool alive = true;
  bool raw_depth = false;
  double beats = 0;
  uint16_t sequence = 0;

 private:
  HookbehOutputs run(HookbehInputs& with) {
    if (alive) {
      inputs.heartbeat = with.heartbeat = ++beats;
    }
    HookbehInputs read = with;
    constexpr double kNoise = 1e-7;
    noise_ = !raw_depth && with.depth_m == depth_m_ && noise_ == 0 ? kNoise : 0;
    depth_m_ = with.depth_m;
    read.depth_m += noise_;
    return hookbeh.cycle(read);
  }

  HookbehInputs last_;
  bool begun_ = false;
  double depth_m_ = kNan, noise_ = 0;
};

}  // namespace glider::hooks
