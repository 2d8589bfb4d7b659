// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/bottom/bottom_flight.h"

#include "hooks/hookbeh/hookbeh.h"
#include "platforms/load/load_platform.h"
#include "simulator/simulator.h"
#include "support/check.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace glider::tests {
namespace {

constexpr double kCycleSecs = 4;
constexpr double kOnBottomM = 0.05;

/// Sees how the vehicle itself fares.
class BottomOnlooker final : public simulator::FlightObserver {
 public:
  void said(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  bool cycle(const simulator::CycleView& view) override {
    const double depth = view.true_depth_m;
    seen.deepest_m = std::max(seen.deepest_m, depth);
    if (depth > 1) {
      seen.clearance_m = std::min(seen.clearance_m, view.clearance_m);
      seen.on_bottom_s += view.clearance_m < kOnBottomM ? kCycleSecs : 0;
    }
    seen.guarded += view.hookbeh != nullptr && view.hookbeh->guard != hooks::HookGuard::None;
    turn(depth);
    return true;
  }
  OverBottom seen;

 private:
  void turn(double depth) {
    extreme_ = sinking_ ? std::max(extreme_, depth) : std::min(extreme_, depth);
    if (std::abs(extreme_ - depth) > 2) {
      seen.dives += sinking_;
      sinking_ = !sinking_;
      extreme_ = depth;
    }
  }

  bool sinking_ = true;
  double extreme_ = 0;
};

Contact contactAt(const support::Trace& trace, double time_s) {
  const int time = trace.column("time"), altitude = trace.column("m_altitude");
  size_t row = 0;
  int echoes = 0;
  while (row + 1 < trace.rowCount() && trace.at(row + 1, time) <= time_s) {
    ++row;
    echoes += altitude >= 0 && !std::isnan(trace.at(row, altitude));
  }
  Contact contact{time_s, trace.at(row, trace.column("true_x")),
                  trace.at(row, trace.column("true_y")),
                  trace.at(row, trace.column("water_depth"))};
  const auto lies = [&] {
    return trace.at(row, trace.column("water_depth")) - trace.at(row, trace.column("true_depth")) <
           kOnBottomM;
  };
  contact.echoes = echoes;
  for (++row; row < trace.rowCount() && lies(); ++row) {
    contact.lasts_s += kCycleSecs;
  }
  return contact;
}

}  // namespace

OverBottom flyOverBottom(const Plan& plan, simulator::Scenario scenario, uint64_t seed) {
  static const auto kPlatform =
      platforms::loadPlatform(std::filesystem::path(GLIDER_SOURCE_DIR) / "platforms/slocum.toml");
  BottomOnlooker observer;
  simulator::SimulationSetup setup;
  setup.platform = *kPlatform;
  setup.scenario = std::move(scenario);
  setup.seed = seed;
  setup.observer = &observer;
  setup.sbc = std::make_unique<simulator::FakeSbc>(plan);
  const auto trace = simulator::simulate(std::move(setup));
  CHECK(trace.has_value(), "the flight could not be flown");
  for (const support::TraceEvent& event : trace->events) {
    if (event.id == support::EventId::TouchesBottom) {
      observer.seen.contacts.push_back(contactAt(*trace, event.time_s));
    }
  }
  return observer.seen;
}

std::vector<Contact> repeated(const std::vector<Contact>& contacts, double near_m,
                              double margin_m) {
  std::vector<Contact> out;
  for (size_t i = 0; i < contacts.size(); ++i) {
    const Contact& now = contacts[i];
    const auto foretold = [&](const Contact& earlier) {
      const double apart = std::hypot(now.east_m - earlier.east_m, now.north_m - earlier.north_m);
      return earlier.lasts_s >= kStopsSecs && apart <= near_m &&
             now.depth_m > earlier.depth_m - margin_m;
    };
    if (std::any_of(contacts.begin(), contacts.begin() + static_cast<std::ptrdiff_t>(i),
                    foretold)) {
      out.push_back(now);
    }
  }
  return out;
}

}  // namespace glider::tests
