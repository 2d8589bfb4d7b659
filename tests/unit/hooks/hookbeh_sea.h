// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glider::hooks {

/// A vehicle at sea under a hookbeh of its own: it sinks or rises as the pump says.
class HookbehSea {
 public:
  explicit HookbehSea(double greatest_depth_m = 60) : bench(args(greatest_depth_m)) {
    bench.raw_depth = true;
    truth = 0.5;
    cycle();
  }

  /// One cycle: the vehicle moves, then its sensors are read, then `spoil` may change them.
  template <typename Spoil>
  HookbehOutputs cycle(Spoil&& spoil) {
    const double wanted = pump > 100 ? -full_mps : pump < -100 ? full_mps : pump / -1000;
    rate += (wanted - rate) * 0.4;
    rate = held ? 0 : rate;
    truth = std::max(0.0, truth + rate * 4);
    deepest = std::max(deepest, truth);
    noise = -noise;
    bench.inputs.depth_m = std::max(0.0, truth + noise);
    bench.inputs.ctd_bar = has_ctd ? (truth + noise / 2) / 10 : kNan;
    spoil(bench.inputs);
    out = bench.cycle();
    pump = out.commanding ? out.pump_cc : 230;
    return out;
  }
  HookbehOutputs cycle() {
    return cycle([](HookbehInputs&) {});
  }
  /// Dives to `depth` on the way to `target`.
  void diveTo(double depth, double target) {
    take(target);
    for (int i = 0; i < 300 && truth < depth; ++i) {
      cycle();
      ASSERT_EQ(out.guard, HookGuard::None) << truth;
    }
  }
  void take(double target) {
    bench.write(HookbehBench::take(target));
    cycle();
    ASSERT_EQ(out.state, HookState::Active);
  }
  /// Cycles until `guard`; how many it took, at most 500.
  template <typename Spoil>
  int until(HookGuard guard, Spoil&& spoil) {
    int cycles = 0;
    while (cycle(spoil).guard != guard && cycles < 500) {
      ++cycles;
    }
    return cycles;
  }
  template <typename Spoil>
  void run(int cycles, Spoil&& spoil) {
    for (int i = 0; i < cycles; ++i) {
      cycle(spoil);
    }
  }

  static HookbehArgs args(double greatest_depth_m) {
    HookbehArgs args;
    args.greatest_depth_m = greatest_depth_m;
    return args;
  }

  HookbehBench bench;
  double full_mps = 0.3;  ///< at which it moves when driven
  bool has_ctd = false;
  bool held = false;  ///< by the water: it hangs
  double truth = 0, rate = 0, noise = 0.01, pump = 230, deepest = 0;
  HookbehOutputs out;
};

inline constexpr auto kNothing = [](HookbehInputs&) {};

}  // namespace glider::hooks
