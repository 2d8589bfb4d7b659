// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_motion.h"

#include "platforms/load/read_numbers.h"
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
    {"speed_lag_s", &Motion::speed_lag_s},
    {"pump_out_j_cc", &Motion::pump_out_j_cc},
    {"pump_out_j_cc_m", &Motion::pump_out_j_cc_m},
    {"pump_in_j_cc", &Motion::pump_in_j_cc}};

constexpr NumberKey<FlightCoefficients> kFlight[] = {
    {"mass_kg", &FlightCoefficients::mass_kg},
    {"reference_area_m2", &FlightCoefficients::reference_area_m2},
    {"drag", &FlightCoefficients::drag},
    {"induced_drag", &FlightCoefficients::induced_drag},
    {"wing_lift", &FlightCoefficients::wing_lift},
    {"hull_lift", &FlightCoefficients::hull_lift},
    {"compressibility_per_Pa", &FlightCoefficients::compressibility_per_pa}};

constexpr NumberKey<Power> kPower[] = {{"capacity_kJ", &Power::capacity_kj},
                                       {"full_V", &Power::full_V},
                                       {"empty_V", &Power::empty_V},
                                       {"hotel_W", &Power::hotel_W}};

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

support::Result<Power> readPower(const std::string& file, const toml::table& root,
                                 const Motion& motion) {
  TomlReader reader = tableOf(file, root["power"], "[power]");
  std::vector<std::string_view> others = {"sbc_W"};
  if (motion.propelled) {
    others.insert(others.end(), {kPowerRpm, kPowerWatt});
  }
  Power power = readNumbers(reader, kPower, std::move(others));
  power.sbc_W = reader.numberOr("sbc_W", 0);
  if (!(power.sbc_W >= 0)) {
    reader.refuse("sbc_W", "must not be below 0");
  }
  if (!(power.empty_V < power.full_V)) {
    reader.refuse("empty_V", "must be below `full_V`");
  }
  if (motion.propelled) {
    power.propeller = readPropellerPower(reader, motion.propelled->propeller.greatest_rpm);
  }
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  return power;
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
  auto power = readPower(file, root, *motion);
  if (!power) {
    return std::unexpected(power.error());
  }
  platform.motion = *std::move(motion);
  platform.power = *std::move(power);
  return {};
}

}  // namespace glider::platforms
