// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/hookbeh_needs.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::slocum::rules {

const std::vector<SensorNeed>& sensorNeeds() {
  static const std::vector<SensorNeed> kNeeds = {
      // hookbeh accepts cycles of up to 20 s, and takes a depth that is the same for 16 s of a
      // dive for a frozen one.
      {"c_pressure_time", 16, "hookbeh has no depth, and makes the vehicle climb",
       "hookbeh takes the depth for frozen, and ends every dive"},
      // The vehicle's pitch and heading are held by it; missions read it too.
      {"c_att_time", 16, "the vehicle holds neither pitch nor heading, as hookbeh commands",
       "the vehicle does not hold pitch and heading, as hookbeh commands"},
      // In 12 s the vehicle sinks by 5 m at most (vertical_rate_m_s): the usual min_altitude.
      {"c_alt_time", 12, "hookbeh does not see the bottom, and its min_altitude has no effect",
       "the vehicle may sink past min_altitude between two echoes", true},
  };
  return kNeeds;
}

std::vector<Doubt> unmetNeeds(const slocum::MissionFile& vehicle) {
  const auto hookbeh =
      std::ranges::find(vehicle.behaviours, "hookbeh", &slocum::BehaviourBlock::name);
  const bool no_altimeter =
      hookbeh != vehicle.behaviours.end() && hookbeh->value("min_altitude") < 0;
  std::vector<Doubt> unmet;
  for (const SensorNeed& need : sensorNeeds()) {
    const SettingInForce setting = settingInForce(vehicle, need.setting);
    const bool met = setting.value >= 0 && setting.value <= need.slowest_s;
    if (met || (need.altimeter && no_altimeter)) {
      continue;
    }
    const bool parameter = slocum::missionParameter(setting.value).has_value();
    unmet.push_back(
        {fmt::format("{} {:.7g}: {}", need.setting, setting.value,
                     parameter           ? "a mission parameter, which may change in flight"
                     : setting.value < 0 ? need.never
                                         : need.seldom),
         fmt::format("give `{}` a time of 0 s (in every cycle) to {:g} s{}", need.setting,
                     need.slowest_s,
                     need.altimeter ? ", or hookbeh a negative min_altitude if the vehicle has no "
                                      "altimeter"
                                    : ""),
         setting.range});
  }
  return unmet;
}

}  // namespace glider::slocum::rules
