// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/simulated_vehicle.h"
#include "simulator/simulator.h"

namespace glider::simulator {
std::vector<NotCarried> sensorsNotCarried(const Scenario& scenario) {
  std::vector<NotCarried> missing;
  for (const std::unique_ptr<Instrument>& instrument : makeInstruments(0, scenario.sensors)) {
    if (!instrument->carried()) {
      for (const InstrumentSensor& sensor : instrument->sensors()) {
        missing.push_back({std::string(sensor.name), std::string(instrument->setting())});
      }
    }
  }
  return missing;
}

support::Result<support::Trace> simulate(SimulationSetup setup) {
  World world(setup.scenario);
  // With no other vehicle in it.
  auto channel = std::make_shared<Channel>(setup.seed.value_or(setup.scenario.seed));
  const auto vehicle = SimulatedVehicle::make(std::move(setup), world, 0, std::move(channel));
  if (!vehicle) {
    return std::unexpected(vehicle.error());
  }
  while ((*vehicle)->flying()) {
    world.tick();
    (*vehicle)->placeModem();
    (*vehicle)->advance(world.now());
  }
  return (*vehicle)->finish();
}

}  // namespace glider::simulator
