// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/geography/ddmm.h"
#include "simulator/lauv/lauv_seat.h"

#include <limits>

namespace glider::simulator {
namespace {

constexpr double kNotRecorded = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegreesPerRadian = 180 / 3.14159265358979323846;

/// The sources of a row in a LAUV.
struct LauvMoment : ColumnMoment {
  explicit LauvMoment(const ColumnMoment& moment)
      : ColumnMoment(moment), lauv(static_cast<const LauvSeat&>(moment.seat)) {}
  [[nodiscard]] double get(const char* source) const { return lauv.newest(source); }
  /// Of what the vehicle is given; unknown while there is nothing.
  template <typename Value>
  [[nodiscard]] double told(Value value) const {
    const auto* reference = lauv.reference();
    return reference != nullptr ? value(*reference) : kNotRecorded;
  }

  const LauvSeat& lauv;
};

// The names are those that readers of traces know, from the Slocum; missiontime and state are
// filled in by Recorder::mission.
#define COLUMN(name, unit, value)                         \
  {name, unit, [](const ColumnMoment& moment) -> double { \
     [[maybe_unused]] const LauvMoment m(moment);         \
     return value;                                        \
   }}
constexpr Column kFirst[] = {
    COLUMN("time", "s", m.now_s),
    COLUMN("missiontime", "s", kNotRecorded),
    COLUMN("state", "id", kNotRecorded),
    COLUMN("m_depth", "m", m.get("EstimatedState.depth")),
    COLUMN("true_depth", "m", m.vehicle.depth()),
    COLUMN("m_pitch", "rad", m.get("EstimatedState.theta")),
    COLUMN("m_heading", "rad", m.get("EstimatedState.psi")),
    COLUMN("m_lat", "deg", fromDdmm(m.get("EstimatedState.lat"))),
    COLUMN("m_lon", "deg", fromDdmm(m.get("EstimatedState.lon"))),
    COLUMN("true_lat", "deg", m.truth.latitude_deg),
    COLUMN("true_lon", "deg", m.truth.longitude_deg),
    COLUMN("m_x_lmc", "m", m.lauv.reckoned().east),
    COLUMN("m_y_lmc", "m", m.lauv.reckoned().north),
    COLUMN("true_x", "m", m.vehicle.x()),
    COLUMN("true_y", "m", m.vehicle.y()),
    COLUMN("sci_water_temp", "degC", m.get("Temperature")),
};
constexpr Column kSecond[] = {
    COLUMN("m_speed", "m/s", m.get("EstimatedState.u")),
    COLUMN("m_depth_rate", "m/s", m.get("EstimatedState.vz")),
    COLUMN("m_battery", "V", m.vehicle.battery().voltage()),
    COLUMN("rpm", "", m.vehicle.rpm()),
    COLUMN("hook_active", "", m.lauv.inControl() ? 1 : 0),
    COLUMN("hook_depth", "m",
           m.told([](const auto& told) { return static_cast<double>(told.z.value.value); })),
    COLUMN("commanded_speed", "m/s",
           m.told([](const auto& told) { return told.speed.value.value; })),
    COLUMN("isotherm_depth", "m", m.isotherm_m),
    COLUMN("water_depth", "m", m.water_depth_m),
    COLUMN("c_wpt_lat", "deg",
           m.told([](const auto& told) { return told.lat * kDegreesPerRadian; })),
    COLUMN("c_wpt_lon", "deg",
           m.told([](const auto& told) { return told.lon * kDegreesPerRadian; })),
    COLUMN("m_altitude", "m", m.get("EstimatedState.alt")),
};
#undef COLUMN

}  // namespace

std::span<const Column> LauvSeat::firstColumns() const {
  return kFirst;
}

std::span<const Column> LauvSeat::secondColumns() const {
  return kSecond;
}

}  // namespace glider::simulator
