// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/ddmm.h"
#include "simulator/remus100/remus_seat.h"

#include <limits>

namespace glider::simulator {
namespace {

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();

/// The sources of a row in a REMUS.
struct RemusMoment : ColumnMoment {
  explicit RemusMoment(const ColumnMoment& moment)
      : ColumnMoment(moment), remus(static_cast<const RemusSeat&>(moment.seat)) {}
  [[nodiscard]] double get(const char* source) const { return remus.newest(source); }
  /// Of what the vehicle is given; unknown while there is nothing.
  [[nodiscard]] double given(double remus100::Given::* value) const {
    const auto now = remus.given();
    return now ? (*now).*value : kNotRecorded;
  }

  const RemusSeat& remus;
};

// The names are those that readers of traces know, from the Slocum; missiontime and state are
// filled in by Recorder::mission.
#define COLUMN(name, unit, value)                         \
  {name, unit, [](const ColumnMoment& moment) -> double { \
     [[maybe_unused]] const RemusMoment m(moment);        \
     return value;                                        \
   }}
constexpr Column kFirst[] = {
    COLUMN("time", "s", m.now_s),
    COLUMN("missiontime", "s", kNotRecorded),
    COLUMN("state", "id", kNotRecorded),
    COLUMN("m_depth", "m", m.get("state.depth")),
    COLUMN("true_depth", "m", m.vehicle.depth()),
    COLUMN("m_pitch", "rad", m.get("state.pitch")),
    COLUMN("m_heading", "rad", m.get("state.heading")),
    COLUMN("m_lat", "deg", fromDdmm(m.get("state.latitude"))),
    COLUMN("m_lon", "deg", fromDdmm(m.get("state.longitude"))),
    COLUMN("true_lat", "deg", m.truth.latitude_deg),
    COLUMN("true_lon", "deg", m.truth.longitude_deg),
    COLUMN("m_x_lmc", "m", m.remus.reckoned().east),
    COLUMN("m_y_lmc", "m", m.remus.reckoned().north),
    COLUMN("true_x", "m", m.vehicle.x()),
    COLUMN("true_y", "m", m.vehicle.y()),
    COLUMN("sci_water_temp", "degC", m.get("ctd.temperature")),
};
constexpr Column kSecond[] = {
    COLUMN("m_speed", "m/s", m.get("state.speed")),
    COLUMN("m_depth_rate", "m/s", -m.vehicle.upMps()),
    COLUMN("m_battery", "V", m.vehicle.battery().voltage()),
    COLUMN("rpm", "", m.vehicle.rpm()),
    COLUMN("hook_active", "", m.remus.inControl() ? 1 : 0),
    COLUMN("hook_depth", "m", m.given(&remus100::Given::depth_m)),
    COLUMN("commanded_speed", "m/s", m.given(&remus100::Given::speed_m_s)),
    COLUMN("isotherm_depth", "m", m.isotherm_m),
    COLUMN("water_depth", "m", m.water_depth_m),
    COLUMN("commanded_heading", "deg", m.given(&remus100::Given::heading_deg)),
    COLUMN("m_altitude", "m", m.get("state.altitude")),
};
#undef COLUMN

}  // namespace

std::span<const Column> RemusSeat::firstColumns() const {
  return kFirst;
}

std::span<const Column> RemusSeat::secondColumns() const {
  return kSecond;
}

}  // namespace glider::simulator
