// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/ddmm.h"
#include "simulator/slocum/slocum_seat.h"

#include <limits>

namespace glider::simulator {
namespace {

static_assert(support::kHoverCommanded == static_cast<double>(hooks::HookVertical::Hover));

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();

/// The sources of a row in a Slocum.
struct SlocumMoment : ColumnMoment {
  explicit SlocumMoment(const ColumnMoment& moment)
      : ColumnMoment(moment), flight(static_cast<const SlocumSeat&>(moment.seat).flight()) {}
  [[nodiscard]] double get(Sensor sensor) const { return flight.array().get(sensor); }

  const FlightController& flight;
};

/// True if the scenario specifies a sloping bottom, seamounts or an altimeter.
bool wantsAltitude(const Scenario& s) {
  const BottomSettings& bottom = s.ocean.bottom;
  return bottom.slope != 0 || !bottom.seamounts.empty() || s.sensors.altimeter.given;
}

// missiontime and state are filled in by Recorder::mission.
#define COLUMN(name, unit, value, ...)              \
  {name, unit,                                      \
   [](const ColumnMoment& moment) -> double {       \
     [[maybe_unused]] const SlocumMoment m(moment); \
     return value;                                  \
   },                                               \
   __VA_ARGS__}
constexpr Column kFirst[] = {
    COLUMN("time", "s", m.now_s),
    COLUMN("missiontime", "s", kNotRecorded),
    COLUMN("state", "id", kNotRecorded),
    COLUMN("m_depth", "m", m.get(Sensor::m_depth)),
    COLUMN("true_depth", "m", m.vehicle.depth()),
    COLUMN("m_pitch", "rad", m.get(Sensor::m_pitch)),
    COLUMN("c_pitch", "rad", m.get(Sensor::c_pitch)),
    COLUMN("m_heading", "rad", m.get(Sensor::m_heading)),
    COLUMN("c_heading", "rad", m.get(Sensor::c_heading)),
    COLUMN("m_lat", "deg", fromDdmm(m.get(Sensor::m_lat))),
    COLUMN("m_lon", "deg", fromDdmm(m.get(Sensor::m_lon))),
    COLUMN("true_lat", "deg", m.truth.latitude_deg),
    COLUMN("true_lon", "deg", m.truth.longitude_deg),
    COLUMN("m_x_lmc", "m", m.flight.reckoned().east),
    COLUMN("m_y_lmc", "m", m.flight.reckoned().north),
    COLUMN("true_x", "m", m.vehicle.x()),
    COLUMN("true_y", "m", m.vehicle.y()),
};
// The columns of instruments that every vehicle has are between these two lists, those of the
// others after both.
constexpr Column kSecond[] = {
    COLUMN("m_ballast_pumped", "cc", m.get(Sensor::m_ballast_pumped)),
    COLUMN("c_ballast_pumped", "cc", m.get(Sensor::c_ballast_pumped)),
    COLUMN("m_battery", "V", m.get(Sensor::m_battery)),
    COLUMN("m_depth_rate", "m/s", m.get(Sensor::m_depth_rate)),
    COLUMN("hook_active", "", m.flight.hookActive() ? 1 : 0),
    COLUMN("hook_vertical", "", m.flight.obeyed().vertical),
    COLUMN("hook_depth", "m", m.flight.obeyed().depth_m),
    COLUMN("commanded_top", "m", m.flight.obeyed().top_m),
    COLUMN("commanded_bottom", "m", m.flight.obeyed().bottom_m),
    COLUMN("isotherm_depth", "m", m.isotherm_m),
    COLUMN("water_depth", "m", m.water_depth_m),
    COLUMN("c_wpt_lat", "deg", fromDdmm(m.flight.waypointLatitude())),
    COLUMN("c_wpt_lon", "deg", fromDdmm(m.flight.waypointLongitude())),
    COLUMN("layer", "", m.flight.layer() == kNoLayer ? kNotRecorded : m.flight.layer()),
    // NaN in a cycle without an echo.
    COLUMN("m_altitude", "m",
           m.flight.array().fresh(Sensor::m_altitude) ? m.get(Sensor::m_altitude) : kNotRecorded,
           wantsAltitude),
    COLUMN("m_water_vx", "m/s", m.flight.waterVelocity().east),
    COLUMN("m_water_vy", "m/s", m.flight.waterVelocity().north),
};
#undef COLUMN

}  // namespace

std::span<const Column> SlocumSeat::firstColumns() const {
  return kFirst;
}

std::span<const Column> SlocumSeat::secondColumns() const {
  return kSecond;
}

}  // namespace glider::simulator
