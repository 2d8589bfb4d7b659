// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_propeller.h"

#include "platforms/load/read_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace glider::platforms {
namespace {

constexpr NumberKey<Propeller> kPropeller[] = {
    {"greatest_rpm", &Propeller::greatest_rpm},
    {"rpm_lag_s", &Propeller::rpm_lag_s},
    {"rpm_rate_rpm_s", &Propeller::rpm_rate_rpm_s},
    {"static_thrust_N_s2", &Propeller::static_thrust_n_s2},
    {"advance_loss_N_s2_m", &Propeller::advance_loss_n_s2_m, Least::Zero},
    {"greatest_thrust_N", &Propeller::greatest_thrust_n}};

constexpr NumberKey<Fins> kFins[] = {{"rudder_rad", &Fins::rudder_rad},
                                     {"stern_plane_rad", &Fins::stern_plane_rad},
                                     {"lag_s", &Fins::lag_s},
                                     {"rate_rad_s", &Fins::rate_rad_s}};

constexpr NumberKey<Hull> kHull[] = {
    {"mass_kg", &Hull::mass_kg},
    {"positive_buoyancy_kg", &Hull::positive_buoyancy_kg, Least::Zero},
    {"length_m", &Hull::length_m},
    {"diameter_m", &Hull::diameter_m},
    {"centre_of_mass_m", &Hull::centre_of_mass_m},
    {"inertia_kg_m2", &Hull::inertia_kg_m2},
    {"added_surge_kg", &Hull::added_surge_kg, Least::Zero},
    {"added_side_kg", &Hull::added_side_kg, Least::Zero},
    {"surge_damping_N_s_m", &Hull::surge_damping_n_s_m, Least::Zero},
    {"surge_drag_N_s2_m2", &Hull::surge_drag_n_s2_m2},
    {"creep_s_m", &Hull::creep_s_m, Least::Zero},
    {"cross_flow_drag", &Hull::cross_flow_drag}};

constexpr NumberKey<HullPlane> kPlane[] = {
    {"side_damping_N_s_m", &HullPlane::side_damping_n_s_m, Least::Zero},
    {"turn_damping_Nm_s", &HullPlane::turn_damping_nm_s},
    {"lift_N_s2_m2", &HullPlane::lift_n_s2_m2, Least::Zero},
    {"turn_lift_N_s2_m", &HullPlane::turn_lift_n_s2_m, Least::None},
    {"side_moment_N_s2_m", &HullPlane::side_moment_n_s2_m, Least::None},
    {"turn_moment_N_s2", &HullPlane::turn_moment_n_s2, Least::Zero},
    {"fin_force_N_s2_m2", &HullPlane::fin_force_n_s2_m2},
    {"fin_arm_m", &HullPlane::fin_arm_m}};

/// Reads one table of [motion]; the first failure stays in `failure`.
template <typename T, size_t kCount>
T readPart(const std::string& file, const toml::table& root, const char* part,
           const NumberKey<T> (&keys)[kCount], std::optional<support::Failure>& failure) {
  TomlReader reader = tableOf(file, root["motion"][part], fmt::format("[motion.{}]", part));
  T numbers = readNumbers(reader, keys);
  if (!failure) {
    failure = reader.failure();
  }
  return numbers;
}

/// A fin that moves further than a quarter of a turn has no meaning.
std::optional<support::Failure> checkFins(const std::string& file, const toml::table& root,
                                          const Fins& fins) {
  constexpr double kQuarterTurn = 1.5707963267948966;
  TomlReader reader = tableOf(file, root["motion"]["fins"], "[motion.fins]");
  for (const auto& [key, angle] :
       {std::pair{"rudder_rad", fins.rudder_rad}, {"stern_plane_rad", fins.stern_plane_rad}}) {
    if (angle > kQuarterTurn) {
      reader.refuse(key, "must be at most a quarter of a turn");
    }
  }
  return reader.failure();
}

}  // namespace

support::Result<PropellerMotion> readPropellerMotion(const std::string& file,
                                                     const toml::table& root) {
  TomlReader reader = tableOf(file, root["motion"], "[motion]");
  reader.only({"model", "propeller", "fins", "hull", "horizontal", "vertical"});
  std::optional<support::Failure> failure = reader.failure();
  PropellerMotion motion;
  motion.propeller = readPart(file, root, "propeller", kPropeller, failure);
  motion.fins = readPart(file, root, "fins", kFins, failure);
  motion.hull = readPart(file, root, "hull", kHull, failure);
  motion.horizontal = readPart(file, root, "horizontal", kPlane, failure);
  motion.vertical = readPart(file, root, "vertical", kPlane, failure);
  if (!failure) {
    failure = checkFins(file, root, motion.fins);
  }
  if (failure) {
    return std::unexpected(*failure);
  }
  return motion;
}

PropellerPower readPropellerPower(TomlReader& power, double greatest_rpm) {
  PropellerPower table{power.numbers(kPowerRpm), power.numbers(kPowerWatt)};
  if (table.rpm.size() < 2 || table.rpm.front() != 0 || table.rpm.back() < greatest_rpm ||
      std::ranges::adjacent_find(table.rpm, std::greater_equal<>()) != table.rpm.end()) {
    power.refuse(kPowerRpm, fmt::format("must increase from 0 to `greatest_rpm` ({:g}) or more",
                                        greatest_rpm));
  }
  if (table.watt.size() != table.rpm.size() ||
      std::ranges::any_of(table.watt, [](double watt) { return watt < 0; })) {
    power.refuse(kPowerWatt,
                 fmt::format("must have a number that is not below 0 for each of `{}`", kPowerRpm));
  }
  return table;
}

}  // namespace glider::platforms
