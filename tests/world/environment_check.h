// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

/// The environment model of proofs (docs/verification.md), as a check of one flight: compares what
/// is seen with the numbers of the platform file. Written from the document, without ir/prove.
namespace glider::tests {

/// What is assumed.
enum class Rule : uint8_t {
  Rate,     ///< it sinks and climbs no faster than vertical_rate_m_s
  Deepest,  ///< a command takes it no further than inflection_overshoot_m beyond
  Climb,    ///< turn_s after a command to climb it climbs at slowest_climb_m_s, until it is there
  Above,    ///< never above the surface
  Start,    ///< control is given at start_depth_m or above
  Surface,  ///< at the surface it is no deeper than surface_depth_m
  Reading,  ///< a known reading of the depth is off by depth_error_m at most
  TickGap,  ///< ticks are no further apart than tick_gap_s
  Range,    ///< a sensor's reading lies in its range
  Drift,    ///< the water moves no faster than drift_m_s
  ThroughWater,  ///< it gets on no faster than through_water_m_s, horizontally
  SurfaceDrift,  ///< floating, it is set no faster than surface_drift_m_s
};
inline constexpr size_t kRules = 12;
inline constexpr std::array<Rule, kRules> kAllRules = {
    Rule::Rate,    Rule::Deepest, Rule::Climb, Rule::Above, Rule::Start,        Rule::Surface,
    Rule::Reading, Rule::TickGap, Rule::Range, Rule::Drift, Rule::ThroughWater, Rule::SurfaceDrift};

/// "vertical_rate_m_s".
const char* nameOf(Rule rule);

/// A rule that was not kept.
struct Broken {
  Rule rule = Rule::Rate;
  double time_s = 0;
  std::string what;
};

/// How often a rule was looked at, and how near a flight came to it: 1 is the limit.
struct Use {
  uint64_t looks = 0;
  double most = -std::numeric_limits<double>::infinity();
};

/// Times are the vehicle's (s), depths m down, nothing is NaN unless said.
class EnvironmentCheck {
 public:
  explicit EnvironmentCheck(const platforms::Platform& platform);

  /// Control is given. `from_surface`: the vehicle's own mission file waits for it at the surface.
  void begin(double time_s, double depth_m, bool from_surface);
  // The command in force, any number of times; `depth_m` is where the vehicle is.
  void commandDown(double target_m, double depth_m);  ///< to dive to a depth, or to hover at it
  void commandUp(double target_m, double depth_m, double time_s);  ///< 0: to the surface
  /// Where the vehicle is; times rise.
  void moved(double time_s, double depth_m);
  /// The vehicle floats, by its own senses.
  void floats(double time_s, double depth_m);
  /// The mission ticks.
  void ticks(double time_s);
  /// The mission sees a depth while the vehicle is at `depth_m`.
  void sees(double time_s, double reading_m, double depth_m);
  /// A sensor reports a number.
  void reports(double time_s, const platforms::PlatformSensor& sensor, double raw);
  /// The water's horizontal speed where the vehicle is, m/s.
  void drifts(double time_s, double speed_mps);
  /// How fast it gets on horizontally, without what the water does, m/s.
  void getsOn(double time_s, double speed_mps);
  /// How fast it goes over ground while it floats, m/s.
  void floatsAlong(double time_s, double speed_mps);

  /// What was broken first; empty: nothing.
  [[nodiscard]] const std::optional<Broken>& broken() const { return broken_; }
  [[nodiscard]] const Use& use(Rule rule) const { return uses_.at(static_cast<size_t>(rule)); }

 private:
  void hold(Rule rule, double time_s, double value, double limit, const char* what);
  [[nodiscard]] double goesOn() const;
  void holdClimb(double time_s, double depth_m);

  const platforms::Envelope& envelope_;
  const platforms::EnvironmentModel& world_;
  std::array<Use, kRules> uses_ = {};
  std::optional<Broken> broken_;

  double last_s_ = 0, last_depth_m_ = 0;  ///< where it was last
  double last_tick_s_ = std::numeric_limits<double>::quiet_NaN();
  double deepest_m_ = 0;  ///< what the commands so far allow
  struct Climb {
    double since_s = 0;   ///< the first of the commands in a row that lead no further up
    double lowest_m = 0;  ///< when it has climbed
  };
  std::optional<Climb> climb_;  ///< the command in force leads up
};

}  // namespace glider::tests
