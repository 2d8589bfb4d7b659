// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/wished.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace glider::frontend {
namespace {

/// A name that pilots expect.
struct Wish {
  std::string_view name;
  std::string_view hint;
  std::string_view sensor;    ///< what the hint names; empty: every platform has it
  std::string_view fix = "";  ///< the name that was certainly meant
};

constexpr std::string_view kTimeHint =
    "`missiontime` is the time since the mission began, `statetime` since the state began";
constexpr std::string_view kCountHint =
    "write `yo_number`, the number of dives that have begun since the state was entered";
constexpr std::string_view kCurrentHint =
    "`m_water_vx` and `m_water_vy` are the current, estimated after each dive";
constexpr std::string_view kCtdHint =
    "it is computed from `cond`, `temp` and `scipressure`: list those";
constexpr std::string_view kStateHint = "it is a value of `m_depth_state`: list that to log it";
constexpr std::string_view kClockHint = "it is `m_present_time`: list that to log it";
constexpr Wish kWishes[] = {
    {"now", kTimeHint, ""},
    {"time", kTimeHint, ""},
    {"clock", kTimeHint, ""},
    {"current", kCurrentHint, "m_water_vx"},
    {"yo_count", kCountHint, "m_depth_state"},
    {"dive_count", kCountHint, "m_depth_state"},
    {"yos", kCountHint, "m_depth_state"},
    {"dives", kCountHint, "m_depth_state"},
    {"unknown", "write `known(…)` or `!known(…)`; only a variable begins `= unknown`", ""},
    {"night", "write it by the vehicle's clock, in UTC: `timeofday < 10 h || timeofday > 22 h`",
     "m_present_time"},
    {"daytime", "write it by the vehicle's clock, in UTC: `timeofday >= 10 h && timeofday <= 22 h`",
     "m_present_time"},
    {"deepest", "write `highest(depth, this dive)`", "m_depth"},
    {"max_depth", "write `highest(depth, this dive)`", "m_depth"},
    {"conductivity", "did you mean `cond`?", "cond"},
    {"salinity", kCtdHint, "cond"},
    {"density", kCtdHint, "cond"},
    {"energyleft", "it follows from the vehicle's count of its charge: write `charge`", "charge"},
    {"energyused", "it follows from the vehicle's count of its charge: write `charge`", "charge"},
    {"diving", kStateHint, "m_depth_state"},
    {"climbing", kStateHint, "m_depth_state"},
    {"hovering", kStateHint, "m_depth_state"},
    {"at_surface", kStateHint, "m_depth_state"},
    {"turned", kStateHint, "m_depth_state"},
    {"is_diving", "write `diving`", "m_depth_state", "diving"},
    {"is_climbing", "write `climbing`", "m_depth_state", "climbing"},
    {"is_hovering", "write `hovering`", "m_depth_state", "hovering"},
    {"is_at_surface", "write `at_surface`", "m_depth_state", "at_surface"},
    {"dive", "did you mean `diving`?", "m_depth_state"},
    {"climb", "did you mean `climbing`?", "m_depth_state"},
    {"ascending", "did you mean `climbing`?", "m_depth_state"},
    {"descending", "did you mean `diving`?", "m_depth_state"},
    {"hover", "did you mean `hovering`?", "m_depth_state"},
    {"surface", "did you mean `at_surface`?", "m_depth_state"},
    {"surfaced", "did you mean `at_surface`?", "m_depth_state"},
    {"is_surfaced", "did you mean `at_surface`?", "m_depth_state"},
    {"on_surface", "did you mean `at_surface`?", "m_depth_state"},
    {"utc", kClockHint, "m_present_time"},
    {"timeofday", kClockHint, "m_present_time"},
    {"date", "write `utc`, with a time such as `2026-08-11T14:00Z`", "m_present_time"},
    {"energy", "write `energyleft`, or `energyused`, with a line `pack`", "charge"},
    {"energy_left", "write `energyleft`", "charge", "energyleft"},
    {"energy_used", "write `energyused`", "charge", "energyused"},
    {"altimeter", "write `altitude`", "altitude", "altitude"},
    {"leak", "write `leakvoltage`: a low one means water", "leakvoltage"},
    {"leakdetect", "write `leakvoltage`: a low one means water", "leakvoltage"},
    {"leak_detect", "write `leakvoltage`: a low one means water", "leakvoltage"},
    {"chl", "did you mean `chlorophyll`?", "chlorophyll"},
    {"chla", "did you mean `chlorophyll`?", "chlorophyll"},
    {"sigma_theta", "write `density`", "cond"},
    {"sigma", "write `density`", "cond"},
    {"profile_done", "write `profiledone`", "", "profiledone"},
    {"here", "list `lat` and `lon`", "lat"}};

/// Points of the compass, as angles from true north.
struct Point {
  std::string_view name;
  std::string_view angle;
};
constexpr Point kPoints[] = {
    {"north", "0 deg"},   {"northeast", "45 deg"},  {"east", "90 deg"},  {"southeast", "135 deg"},
    {"south", "180 deg"}, {"southwest", "225 deg"}, {"west", "270 deg"}, {"northwest", "315 deg"}};

}  // namespace

std::optional<Suggestion> insteadOf(std::string_view wish, const platforms::Platform& platform) {
  std::string name(wish);
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (const auto* point = std::ranges::find(kPoints, name, &Point::name);
      point != std::end(kPoints)) {
    return Suggestion{"write `" + std::string(point->angle) + "`", std::string(point->angle)};
  }
  const auto* row = std::ranges::find(kWishes, name, &Wish::name);
  if (row == std::end(kWishes) || (!row->sensor.empty() && platform.find(row->sensor) == nullptr)) {
    return std::nullopt;
  }
  return Suggestion{std::string(row->hint), std::string(row->fix)};
}

std::string_view behaviourInsteadOf(std::string_view wish) {
  struct Row {
    std::string_view name;
    std::string_view behaviour;
  };
  constexpr Row kRows[] = {{"surface_every", "yo_and_surface"},
                           {"surface_yo", "yo_and_surface"},
                           {"yo_surface", "yo_and_surface"},
                           {"yo_with_surface", "yo_and_surface"},
                           {"sawtooth", "yo"},
                           {"undulate", "yo"},
                           {"drift_at_depth", "hover_at"},
                           {"waypoint", "nav"},
                           {"goto_waypoint", "nav"}};
  const auto* row = std::ranges::find(kRows, wish, &Row::name);
  return row == std::end(kRows) ? std::string_view() : row->behaviour;
}

}  // namespace glider::frontend
