// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Flights of hookbeh in a vehicle of a few lines: pump, lag, trim, and what its sensors show of
// swell, rare readings and unequal cycles. Quick, so that there are thousands; tests/depths flies
// the simulator's vehicle.

#include "tests/unit/hooks/hookbeh_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>

namespace glider::hooks {
namespace {

using Bench = HookbehBench;

struct Flight {
  double greatest_m = 60;
  double bottom_m = 50, pitch_rad = 0.4538;
  bool hovers = false;
  bool has_ctd = true;
  double pressure_s = 0;                ///< c_pressure_time
  double swell_m = 0, period_s = 10;    ///< in the depth
  double mean_s = 4, long_share = 0;    ///< cycles; the long ones take up to 15 s
  double noise_m = 0.03, repeated = 0;  ///< share of readings that repeat the one before
  double heavy_cc = 0, lift = 1;        ///< trim, and the share of the lift that a layer leaves
  double stuck_s = 1e9, flicker_m = 0;  ///< depth and CTD are stuck from then on, and flicker
  double hours = 1;
};

struct Flown {
  int dives = 0, checks = 0;
  double deepest_m = 0, guarded_s = -1, checking_s = 0, last_m = 0;
  HookGuard guard = HookGuard::None;
};

class FlownVehicle {
 public:
  FlownVehicle(const Flight& flight, unsigned seed)
      : f_(flight), random_(seed), bench_(args(flight)) {
    bench_.raw_depth = true;
    bench_.inputs.depth_m = 0;
  }
  Flown fly() {
    cycle();  // what is in the array at the start is not followed
    command();
    while (time_s_ < f_.hours * 3600) {
      cycle();
    }
    flown_.last_m = true_m_;
    return flown_;
  }

 private:
  static HookbehArgs args(const Flight& flight) {
    HookbehArgs args;
    args.greatest_depth_m = flight.greatest_m;
    args.steepest_pitch_rad = 0.7854;
    return args;
  }
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  double normal(double sd) { return std::normal_distribution<double>(0, 1)(random_) * sd; }

  void command() {
    Instruction next = f_.hovers ? Bench::vertical(HookVertical::Hover, f_.bottom_m)
                       : down_   ? Bench::descend(f_.bottom_m)
                                 : Bench::ascend(4);
    next.pitch_rad = down_ ? -f_.pitch_rad : f_.pitch_rad;
    next.control = taken_ ? HookControl::Steer : HookControl::Take;
    taken_ = true;
    bench_.write(next);
  }
  void move(double step_s) {
    for (double t = 0; t < step_s; t += 0.25) {
      pump_ += std::clamp(out_.pump_cc - pump_, -9.0, 9.0);
      pitch_ += (out_.pitch_rad - pitch_) * 0.08;
      const double cc = pump_ > 0 ? pump_ * f_.lift - f_.heavy_cc : pump_ * f_.lift - f_.heavy_cc;
      const double slope =
          std::fabs(pitch_) < 0.19 ? 0.0073 : 0.0111 + 0.038 * (std::fabs(pitch_) - 0.4538);
      const double up = std::copysign(std::max(slope, 0.005) * std::sqrt(std::fabs(cc)), cc);
      up_mps_ += (up - up_mps_) * 0.03;
      true_m_ = std::max(0.0, true_m_ - up_mps_ * 0.25);
    }
  }
  void sense() {
    const double wave =
        true_m_ < 0.5
            ? 0
            : f_.swell_m * std::sin(2 * std::numbers::pi * time_s_ / f_.period_s + phase_);
    const double shown = std::max(0.0, true_m_ + wave + normal(f_.noise_m));
    HookbehInputs& in = bench_.inputs;
    const bool stuck = time_s_ >= f_.stuck_s;
    if (time_s_ - read_s_ >= f_.pressure_s && uniform() >= f_.repeated) {
      in.depth_rate_mps = (shown - in.depth_m) / std::max(1.0, time_s_ - read_s_);
      in.depth_m = stuck ? stuck_m_ + f_.flicker_m * (2 * uniform() - 1) : shown;
      stuck_m_ = stuck ? stuck_m_ : shown;
      read_s_ = time_s_;
    }
    in.ctd_bar =
        f_.has_ctd ? (stuck ? stuck_m_ + f_.flicker_m * (2 * uniform() - 1) : shown) / 10 : kNan;
    in.ctd_bar = uniform() < 0.2 ? kNan : in.ctd_bar;
  }
  void cycle() {
    const double step_s =
        uniform() < f_.long_share ? 4 + 11 * uniform() : std::max(3.0, f_.mean_s + normal(0.2));
    move(step_s);
    time_s_ += step_s;
    bench_.inputs.time_s += step_s - 4;
    bench_.inputs.wall_time_s = bench_.inputs.time_s + 4;  // one clock alone is not believed
    sense();
    const Doing before = out_.doing;
    out_ = bench_.cycle();
    if (!out_.commanding) {
      out_.pump_cc = 230;
    }
    const bool checks = out_.doing == Doing::CheckDepth;
    flown_.checks += checks && before != Doing::CheckDepth;
    flown_.checking_s += checks ? step_s : 0;
    flown_.deepest_m = std::max(flown_.deepest_m, true_m_);
    if (out_.guard != HookGuard::None && flown_.guard == HookGuard::None) {
      flown_.guard = out_.guard;
      flown_.guarded_s = time_s_;
    }
    const double depth = bench_.inputs.depth_m;
    if (taken_ && !f_.hovers && (down_ ? depth >= f_.bottom_m : depth <= 4)) {
      flown_.dives += down_;
      down_ = !down_;
      command();
    }
  }

  Flight f_;
  std::mt19937 random_;
  Bench bench_;
  HookbehOutputs out_;
  Flown flown_;
  double time_s_ = 0, true_m_ = 0, up_mps_ = 0, pump_ = 230, pitch_ = 0, read_s_ = -100,
         stuck_m_ = 0, phase_ = 1;
  bool down_ = true, taken_ = false;
};

int wanted(int standard) {
  const char* text = std::getenv("GLIDER_HOOKBEH_FLIGHTS");
  return text == nullptr ? standard : std::atoi(text);
}

TEST(HookbehFlights, NoGuardIntervenesInAHealthyVehicle) {
  constexpr double kPeriods[] = {0, 0, 0, 4, 5, 6, 8, 10, 12, 16};
  int failed = 0;
  for (int i = 1; i <= wanted(60); ++i) {
    std::mt19937 draw(static_cast<unsigned>(i));
    const auto within = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(draw);
    };
    Flight f;
    f.hovers = within(0, 1) < 0.25;
    f.has_ctd = within(0, 1) < 0.5;
    f.pressure_s = kPeriods[static_cast<size_t>(within(0, 10))];
    f.swell_m = within(0, 1) < 0.5 ? 0 : within(0, 1);
    f.period_s = within(6, 14);
    f.mean_s = within(0, 1) < 0.5 ? 4 : within(4, 4.6);
    f.long_share = within(0, 1) < 0.5 ? 0 : within(0, 0.06);
    f.noise_m = within(0.005, 0.1);
    // A pressure that is read seldom and then not renewed looks stuck.
    f.repeated = within(0, 1) < 0.8 || f.pressure_s > 8 ? 0 : 0.05;
    f.pitch_rad = within(0.32, 0.75);
    f.bottom_m = within(12, f.pitch_rad > 0.6 ? 44 : 49);
    f.heavy_cc = within(-50, 50);
    f.lift = within(f.has_ctd ? 0.4 : 0.6, 1);
    const Flown flown = FlownVehicle(f, static_cast<unsigned>(i)).fly();
    Flight calm = f;
    calm.swell_m = calm.pressure_s = calm.long_share = calm.repeated = 0;
    const Flown ideal = FlownVehicle(calm, static_cast<unsigned>(i)).fly();
    failed += flown.guard != HookGuard::None;
    EXPECT_EQ(flown.guard, HookGuard::None)
        << i << ": at " << flown.guarded_s << " s, hovers " << f.hovers << " ctd " << f.has_ctd
        << " pressure " << f.pressure_s << " swell " << f.swell_m << " m " << f.period_s
        << " s, cycles " << f.mean_s << " long " << f.long_share << " noise " << f.noise_m
        << " repeated " << f.repeated << " to " << f.bottom_m << " at " << f.pitch_rad << " heavy "
        << f.heavy_cc << " lift " << f.lift << " deepest " << flown.deepest_m;
    EXPECT_GE(flown.dives, ideal.dives - 1 - ideal.dives / 5) << i;
  }
  EXPECT_EQ(failed, 0) << "flights with a guard";
}

TEST(HookbehFlights, AHoverWhoseSensorsAreAllStuckStaysNearItsLimit) {
  double past = -1e9;
  unsigned seed = 1;
  for (const double greatest : {30.0, 60.0, 120.0, 200.0}) {
    for (const double share : {0.66, 0.9}) {
      for (const double heavy : {-50.0, 0.0, 50.0}) {
        for (const double flicker : {0.02, 0.3, 0.8, 1.6}) {
          Flight f;
          f.greatest_m = greatest;
          f.bottom_m = greatest * share;
          f.hovers = true;
          f.heavy_cc = heavy;
          f.flicker_m = flicker;
          f.stuck_s = 1500;
          f.hours = 2;
          const Flown flown = FlownVehicle(f, seed++).fly();
          const double bound = std::max(greatest, f.bottom_m + 30) + 5;
          past = std::max(past, flown.deepest_m - greatest);
          EXPECT_LT(flown.deepest_m, bound) << greatest << " m, hover at " << f.bottom_m
                                            << ", heavy " << heavy << " cc, flicker " << flicker;
          EXPECT_LT(flown.last_m, 40);
        }
      }
    }
  }
  RecordProperty("past_max_depth_cm", static_cast<int>(past * 100));
  std::printf("past max_depth %.1f m at most\n", past);
}

TEST(HookbehFlights, TheShortClimbsOfAHoverAreRareAndShort) {
  for (const double greatest : {60.0, 200.0}) {
    Flight f;
    f.greatest_m = greatest;
    f.bottom_m = 50;
    f.hovers = true;
    f.hours = 4;
    const Flown flown = FlownVehicle(f, 3).fly();
    EXPECT_EQ(flown.guard, HookGuard::None);
    std::printf("%g m: %d checks, %.0f s each\n", greatest, flown.checks,
                flown.checking_s / std::max(1, flown.checks));
    EXPECT_LE(flown.checks, 4 * 12);
    EXPECT_GE(flown.checks, 4 * 4);
    EXPECT_LE(flown.checking_s, 45 * flown.checks);
  }
}

}  // namespace
}  // namespace glider::hooks
