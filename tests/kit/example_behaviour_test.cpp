// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The kit's example behaviour does in each cycle what hookbeh does with the same sensors.

#include "kit/example_behaviour.h"

#include "hooks/protocol/sensors.h"

#define GLIDER_DEFINE_DICTIONARY
#include "platforms/slocum_sensors.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <random>
#include <string>

namespace glider::tests {
namespace {

/// A sensor array, and what was commanded in this cycle.
struct Array {
  std::array<double, 64> values{};
  std::array<bool, 64> fresh{};
  bool commanded = false;
  HookbehOutputs command;
};

ExampleFlight flightOn(Array& array) {
  return {
      .self = &array,
      .get = [](void* self, uint16_t id) { return static_cast<Array*>(self)->values.at(id); },
      .isFresh = [](void* self, uint16_t id) { return static_cast<Array*>(self)->fresh.at(id); },
      .set = [](void* self, uint16_t id,
                double value) { static_cast<Array*>(self)->values.at(id) = value; },
      .masked = [](void*) { return uint8_t{0}; },
      .command =
          [](void* self, const HookbehOutputs* outputs) {
            static_cast<Array*>(self)->commanded = true;
            static_cast<Array*>(self)->command = *outputs;
          }};
}

void putInstruction(Array& array, const HookInstruction& instruction) {
  HookInstructionWords words;
  hookWordsOf(&instruction, &words);
  for (const hooks::InstructionWord& one : hooks::kInstructionWords) {
    array.values.at(hookSensorOf(&gliderDictionary, one.role)) = words.*one.word;
  }
}

/// What hookbeh must read from the array.
HookbehInputs inputsFrom(const Array& array) {
  HookbehInputs in;
  const auto& v = array.values;
  in.time_s = v[GLIDER_M_PRESENT_SECS_INTO_MISSION];
  in.wall_time_s = v[GLIDER_M_PRESENT_TIME];
  in.cycle_number = v[GLIDER_M_CYCLE_NUMBER];
  in.depth_m = v[GLIDER_M_DEPTH];
  in.depth_rate_mps = v[GLIDER_M_DEPTH_RATE];
  in.altitude_m = v[GLIDER_M_ALTITUDE];
  in.latitude_ddmm = v[GLIDER_M_LAT];
  in.longitude_ddmm = v[GLIDER_M_LON];
  in.heartbeat = v[GLIDER_SCI_HOOK_HEARTBEAT];
  in.commanded_pump_cc = v[GLIDER_C_BALLAST_PUMPED];
  in.ctd_bar =
      array.fresh[GLIDER_SCI_WATER_PRESSURE] ? v[GLIDER_SCI_WATER_PRESSURE] : hookUnknown();
  for (const hooks::InstructionWord& one : hooks::kInstructionWords) {
    in.words.*one.word = v.at(hookSensorOf(&gliderDictionary, one.role));
  }
  return in;
}

/// An instruction that hookbeh accepts, or one that it does not.
HookInstruction anyInstruction(std::mt19937& dice, uint16_t sequence) {
  HookInstruction one;
  one.session = 7;
  one.sequence = sequence;
  one.control = sequence == 1 ? HookControl::Take : HookControl::Steer;
  one.vertical = static_cast<HookVertical>(1 + dice() % 5);
  one.lateral = static_cast<HookLateral>(dice() % 4);
  one.depth_m = static_cast<double>(dice() % 40);
  one.pitch_rad = one.vertical == HookVertical::Descend ? -0.45 : 0.45;
  one.heading_rad = 0.1 * static_cast<double>(dice() % 4);
  one.latitude_ddmm = 3910.5;
  one.longitude_ddmm = -7349.8;
  one.sampling = dice() % 3 == 0 ? 0 : dice() % 1024;
  return one;
}

TEST(ExampleBehaviour, DoesWhatHookbehDoes) {
  std::mt19937 dice(1);
  Array array;
  array.values.fill(hookUnknown());
  HookbehArgs args;
  args.nap_secs = 120;
  HookHull limits;
  exampleHull(&limits);
  const ExampleFlight flight = flightOn(array);
  exampleBehaviourInit(&flight, &args);
  ::Hookbeh same;
  hookbehInit(&same, &args, &limits);
  size_t commands = 0, accepted = 0;
  for (int cycle = 0; cycle < 5000; ++cycle) {
    auto& v = array.values;
    v[GLIDER_M_PRESENT_SECS_INTO_MISSION] = 4.0 * cycle;
    v[GLIDER_M_PRESENT_TIME] = 1.7e9 + 4.0 * cycle;
    v[GLIDER_M_CYCLE_NUMBER] = cycle;
    v[GLIDER_M_DEPTH] = 15 - 14 * std::cos(0.02 * cycle) + 0.01 * static_cast<double>(dice() % 9);
    v[GLIDER_M_DEPTH_RATE] = 0.07 * std::sin(0.02 * cycle);
    v[GLIDER_M_ALTITUDE] = cycle % 5 == 0 ? 60 - v[GLIDER_M_DEPTH] : hookUnknown();
    v[GLIDER_M_LAT] = 3910.4;
    v[GLIDER_M_LON] = -7349.9;
    v[GLIDER_SCI_HOOK_HEARTBEAT] = cycle / 2 + 1;
    v[GLIDER_SCI_WATER_PRESSURE] = v[GLIDER_M_DEPTH] / 10;
    array.fresh[GLIDER_SCI_WATER_PRESSURE] = cycle % 3 == 0;
    if (cycle > 3 && cycle % 40 == 0) {
      putInstruction(array, anyInstruction(dice, static_cast<uint16_t>(cycle / 40)));
    }
    HookbehInputs in = inputsFrom(array);
    HookbehOutputs out;
    hookbehCycle(&same, &in, &out);
    array.commanded = false;
    exampleBehaviourFly();
    ASSERT_EQ(array.commanded, out.commanding) << cycle;
    if (out.commanding) {
      ASSERT_EQ(array.command.pitch_rad, out.pitch_rad) << cycle;
      ASSERT_EQ(array.command.pump_cc, out.pump_cc) << cycle;
      ASSERT_EQ(array.command.battery_in, out.battery_in) << cycle;
      ASSERT_EQ(array.command.heading_rad, out.heading_rad) << cycle;
      ASSERT_EQ(array.command.sampling, out.sampling) << cycle;
      v[GLIDER_C_BALLAST_PUMPED] = out.pump_cc;
      ++commands;
    }
    ASSERT_EQ(v[GLIDER_X_HOOK_STATE], static_cast<double>(out.state)) << cycle;
    ASSERT_EQ(v[GLIDER_X_HOOK_ANSWER], static_cast<double>(out.answer)) << cycle;
    ASSERT_EQ(v[GLIDER_X_HOOK_SEQUENCE], out.answered_sequence) << cycle;
    ASSERT_EQ(v[GLIDER_X_HOOK_SESSION], out.session) << cycle;
    ASSERT_EQ(v[GLIDER_X_HOOK_GUARD], static_cast<double>(out.guard)) << cycle;
    ASSERT_EQ(v[GLIDER_X_HOOK_NAP_SECS], 120) << cycle;
    accepted += out.answer == HookAnswer::Accepted ? 1U : 0U;
  }
  EXPECT_GT(commands, 1000U);
  EXPECT_GT(accepted, 1000U);
}

}  // namespace
}  // namespace glider::tests
