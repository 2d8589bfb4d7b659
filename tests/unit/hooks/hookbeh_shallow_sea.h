// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/unit/hooks/hookbeh_bench.h"

#include <algorithm>
#include <functional>

namespace glider::hooks {

inline constexpr double kMetresPerMinute = 1852;  // of latitude

/// A vehicle in a sea with a bottom, on a yo under a hookbeh of its own: it flies north at 0.3 m/s
/// and sinks or rises as the pump says. Its altimeter is dead.
class ShallowSea {
 public:
  explicit ShallowSea(HookbehArgs args = wide()) : bench(args) {
    bench.raw_depth = true;
    truth = 0.5;
    cycle();
    bench.write(HookbehBench::take(55));
    cycle();
  }

  HookbehOutputs cycle() {
    const double wanted = pump > 100 ? -full_mps : pump < -100 ? full_mps : pump / -1000;
    rate += (wanted - rate) * 0.4;
    const double water = bottom(north);
    const double next = std::max(0.0, truth + rate * 4);
    lies = next >= water && !rises();
    touches += lies && !lay;
    lay = lies || (lay && water - next < 1);
    truth = std::min(next, water);
    north += lies ? 0 : 1.2;
    deepest = std::max(deepest, truth);
    noise = -noise;
    auto& in = bench.inputs;
    in.depth_m = std::max(0.0, truth + noise);
    in.latitude_ddmm = knows_position ? 3910 + north / kMetresPerMinute : kNan;
    in.altitude_m = altitude(water - truth + noise / 3);
    in.ctd_bar = has_ctd ? (truth + noise / 2) / 10 : kNan;
    spoil(in);
    out = bench.cycle();
    pump = out.commanding ? out.pump_cc : 230;
    return out;
  }
  /// A yo between 4 and 55 m.
  void yo(double hours) {
    for (int i = 0; i < hours * 900; ++i) {
      cycle();
      const double depth = bench.inputs.depth_m;
      if (dives ? depth >= 55 : depth <= 4) {
        dives = !dives;
        bench.write(dives ? HookbehBench::descend(55) : HookbehBench::ascend(4));
      }
      if (out.guard != HookGuard::None && dives) {
        guarded += out.guard == HookGuard::NearBottom;
      }
    }
  }

  static HookbehArgs wide() {
    HookbehArgs args;
    args.greatest_depth_m = 60;
    return args;
  }
  [[nodiscard]] bool rises() const { return pump > 0; }

  HookbehBench bench;
  std::function<double(double north)> bottom = [](double) { return 40; };
  std::function<double(double height)> altitude = [](double) { return kNan; };
  std::function<void(HookbehInputs&)> spoil = [](HookbehInputs&) {};
  double full_mps = 0.2;  ///< at which it moves when driven
  bool knows_position = true, has_ctd = false;
  double truth = 0, north = 0, rate = 0, noise = 0.03, pump = 230, deepest = 0;
  bool lies = false, lay = false, dives = true;
  int touches = 0, guarded = 0;
  HookbehOutputs out;
};

}  // namespace glider::hooks
