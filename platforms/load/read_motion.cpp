// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_motion.h"

#include "platforms/load/read_numbers.h"
#include "platforms/load/read_power.h"
#include "platforms/load/read_propeller.h"

namespace glider::platforms {
namespace {

constexpr NumberKey<Motion> kGlider[] = {
    {"pump_rate_cc_s", &Motion::pump_rate_cc_s},
    {"pitch_battery_limit_in", &Motion::pitch_battery_limit_in},
    {"pitch_battery_rate_in_s", &Motion::pitch_battery_rate_in_s},
    {"fin_rate_rad_s", &Motion::fin_rate_rad_s},
    {"trim_pump_per_m3", &Motion::trim_pump_per_m3},
    {"trim_battery_per_m", &Motion::trim_battery_per_m},
    {"trim_offset", &Motion::trim_offset, Least::None},
    {"pitch_lag_s", &Motion::pitch_lag_s},
    {"yaw_gain_rad_s_m2", &Motion::yaw_gain_rad_s_m2},
    {"yaw_lag_s", &Motion::yaw_lag_s},
    {"speed_lag_s", &Motion::speed_lag_s}};

constexpr NumberKey<FlightCoefficients> kFlight[] = {
    {"mass_kg", &FlightCoefficients::mass_kg},
    {"reference_area_m2", &FlightCoefficients::reference_area_m2},
    {"drag", &FlightCoefficients::drag},
    {"induced_drag", &FlightCoefficients::induced_drag},
    {"wing_lift", &FlightCoefficients::wing_lift},
    {"hull_lift", &FlightCoefficients::hull_lift},
    {"compressibility_per_Pa", &FlightCoefficients::compressibility_per_pa}};

/// Any model but that of propellers.
support::Result<Motion> readGlider(const std::string& file, const toml::table& root,
                                   const Envelope& envelope) {
  TomlReader reader = tableOf(file, root["motion"], "[motion]");
  Motion motion = readNumbers(reader, kGlider, {"model", "flight"});
  motion.model = reader.text("model");
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  TomlReader flight = tableOf(file, root["motion"]["flight"], "[motion.flight]");
  motion.flight = readNumbers(flight, kFlight);
  if (flight.failure()) {
    return std::unexpected(*flight.failure());
  }
  if (envelope.fin_rad == 0) {
    TomlReader hull = tableOf(file, root["envelope"], "[envelope]");
    hull.refuse("fin_rad", "must be above 0: the simulator turns the vehicle by its fin");
    return std::unexpected(*hull.failure());
  }
  return motion;
}

support::Result<Motion> readPropelled(const std::string& file, const toml::table& root,
                                      const Envelope& envelope) {
  auto propelled = readPropellerMotion(file, root);
  if (!propelled) {
    return std::unexpected(propelled.error());
  }
  if (envelope.fin_rad > propelled->fins.rudder_rad) {
    TomlReader hull = tableOf(file, root["envelope"], "[envelope]");
    hull.refuse("fin_rad", "must not be above `rudder_rad` of [motion.fins]");
    return std::unexpected(*hull.failure());
  }
  Motion motion;
  motion.model = kPropellerModel;
  motion.propelled = *propelled;
  return motion;
}

}  // namespace

bool isPropelled(const toml::table& root) {
  return root["motion"]["model"].value<std::string>() == kPropellerModel;
}

support::Result<void> readMotionAndPower(const std::string& file, const toml::table& root,
                                         Platform& platform) {
  if (!root.contains("motion")) {
    if (root.contains("power")) {
      TomlReader reader(file, root, "the platform");
      reader.refuse("power", "means nothing without [motion]");
      return std::unexpected(*reader.failure());
    }
    return {};
  }
  auto motion = isPropelled(root) ? readPropelled(file, root, platform.envelope)
                                  : readGlider(file, root, platform.envelope);
  if (!motion) {
    return std::unexpected(motion.error());
  }
  platform.motion = *std::move(motion);
  auto power = readPower(file, root, platform);
  if (!power) {
    return std::unexpected(power.error());
  }
  platform.power = *std::move(power);
  return {};
}

}  // namespace glider::platforms
