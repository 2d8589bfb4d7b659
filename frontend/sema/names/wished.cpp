// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/wished.h"

#include "frontend/compass.h"

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
constexpr std::string_view kHourHint =
    "write `timeofday`, the time of the day in UTC, as in `timeofday < 11 h`";
constexpr std::string_view kLeftHint =
    "write `energyleft`, the share of the line `pack` that is left";
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
    {"hour", kHourHint, "m_present_time"},
    {"hours", kHourHint, "m_present_time"},
    {"hourofday", kHourHint, "m_present_time"},
    {"hour_of_day", kHourHint, "m_present_time"},
    {"date", "write `utc`, with a time such as `2026-08-11T14:00Z`", "m_present_time"},
    {"energy", "write `energyleft`, or `energyused`, with a line `pack`", "charge"},
    {"energy_left", "write `energyleft`", "charge", "energyleft"},
    {"energy_used", "write `energyused`", "charge", "energyused"},
    {"energyremaining", kLeftHint, "charge", "energyleft"},
    {"energy_remaining", kLeftHint, "charge", "energyleft"},
    {"remaining_energy", kLeftHint, "charge", "energyleft"},
    {"chargeleft", kLeftHint, "charge"},
    {"charge_left", kLeftHint, "charge"},
    {"batteryleft", kLeftHint, "charge"},
    {"battery_left", kLeftHint, "charge"},
    {"soc", kLeftHint, "charge"},
    {"consumption", "write `energyused`, with a line `pack`", "charge"},
    {"reserve", "write its share: `energyleft < 20 %`", "charge"},
    {"pack", "what is left of it is `energyleft`, what was used `energyused`", "charge"},
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

/// Whether a point of the compass can be meant by nothing else: two letters may be a name that is
/// spelled wrong, unless they are capitals.
bool isPlainlyPoint(std::string_view wish) {
  constexpr size_t kMostLetters = 3;
  return wish.size() > kMostLetters ||
         std::ranges::all_of(wish, [](unsigned char c) { return std::isupper(c) != 0; });
}

}  // namespace

std::optional<Suggestion> insteadOf(std::string_view wish, const platforms::Platform& platform) {
  const std::string name = inLowerCase(wish);
  if (const std::string angle = compassAngle(wish); !angle.empty()) {
    return Suggestion{"write `" + angle + "`", isPlainlyPoint(wish) ? angle : ""};
  }
  const auto* row = std::ranges::find(kWishes, name, &Wish::name);
  if (row == std::end(kWishes) || (!row->sensor.empty() && platform.find(row->sensor) == nullptr)) {
    return std::nullopt;
  }
  return Suggestion{std::string(row->hint), std::string(row->fix)};
}

std::string_view behaviourInsteadOf(std::string_view wish, size_t arguments) {
  constexpr size_t kAny = 100;
  struct Row {
    std::string_view name;
    std::string_view behaviour;
    size_t most = kAny;  ///< arguments that it takes
  };
  constexpr Row kRows[] = {{"surface_every", "yo_and_surface"},
                           {"surface_yo", "yo_and_surface"},
                           {"yo_surface", "yo_and_surface"},
                           {"yo_with_surface", "yo_and_surface"},
                           {"sawtooth", "yo"},
                           {"undulate", "yo"},
                           {"drift_at_depth", "hover_at"},
                           {"hover", "hover_at", 1},
                           {"drift", "hover_at", 1},
                           {"dive", "dive_to", 2},
                           {"descend", "dive_to", 2},
                           {"climb", "climb_to", 2},
                           {"ascend", "climb_to", 2},
                           {"waypoint", "nav"},
                           {"to", "nav"},
                           {"towards", "nav"},
                           {"goto_waypoint", "nav"}};
  const auto* row = std::ranges::find_if(
      kRows, [&](const Row& one) { return one.name == wish && arguments <= one.most; });
  return row == std::end(kRows) ? std::string_view() : row->behaviour;
}

bool namesWaypointList(std::string_view wish) {
  constexpr std::string_view kFile = "goto_l";
  return wish == "goto_list" || wish == "waypoints" ||
         (wish.starts_with(kFile) && wish.size() > kFile.size() &&
          wish.find_first_not_of("0123456789", kFile.size()) == std::string_view::npos);
}

}  // namespace glider::frontend
