// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/sensors/sensor_list.h"

#include "simulator/tables/scenario_tables.h"

namespace glider::simulator {
namespace {

template <SensorSettingsOf Settings>
void addKeys(std::string_view table, std::vector<std::string_view>& keys) {
  for (const ScenarioKey& one : Settings::kKeys) {
    if (one.table == table) {
      keys.push_back(one.key);
    }
  }
}

}  // namespace

std::vector<std::string_view> sensorKeys(std::string_view table) {
  std::vector<std::string_view> keys;
#define ROW(name, Class) addKeys<Class::Settings>(table, keys);
  GLIDER_FLIGHT_SENSORS(ROW)
  GLIDER_INSTRUMENTS(ROW)
#undef ROW
  return keys;
}

void SensorSettings::read(ScenarioTables& tables) {
  tables.table("sensors", [](Fields& f) { f.reader().only(sensorKeys("sensors")); });
#define ROW(name, Class) name.read(tables);
  GLIDER_FLIGHT_SENSORS(ROW)
  GLIDER_INSTRUMENTS(ROW)
#undef ROW
}

const std::vector<Proglet>& simulatedProglets() {
  static const std::vector<Proglet> all = [] {
    std::vector<Proglet> proglets;
    for (const std::unique_ptr<Instrument>& instrument : makeInstruments(0, {})) {
      proglets.push_back(instrument->proglet());
    }
    return proglets;
  }();
  return all;
}

std::vector<std::unique_ptr<Instrument>> makeInstruments(uint64_t seed,
                                                         const SensorSettings& settings) {
  std::vector<std::unique_ptr<Instrument>> all;
#define ROW(name, Class) all.push_back(std::make_unique<Class>(seed, settings.name));
  GLIDER_INSTRUMENTS(ROW)
#undef ROW
  return all;
}

}  // namespace glider::simulator
