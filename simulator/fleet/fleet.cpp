// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/fleet/fleet.h"

#include "simulator/simulated_vehicle.h"
#include "simulator/world/world.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace glider::simulator {
namespace {

using Vehicles = std::vector<std::unique_ptr<SimulatedVehicle>>;

/// What has flown.
struct Flown {
  World world;
  Vehicles vehicles;
};

constexpr double kProgress_s = 100;

support::Result<Vehicles> makeVehicles(std::vector<FleetMember> members, const World& world,
                                       const std::shared_ptr<Channel>& channel) {
  Vehicles vehicles;
  for (FleetMember& member : members) {
    auto vehicle = SimulatedVehicle::make(std::move(member.setup), world, member.number, channel);
    if (!vehicle) {
      return std::unexpected(vehicle.error());
    }
    vehicles.push_back(std::move(*vehicle));
  }
  return vehicles;
}

size_t flyingOf(const Vehicles& vehicles) {
  return static_cast<size_t>(
      std::ranges::count_if(vehicles, [](const auto& vehicle) { return vehicle->flying(); }));
}

}  // namespace

support::Result<FleetFlight> simulateFleet(
    const Scenario& world_of, std::vector<FleetMember> members,
    const std::function<void(double now_s, size_t flying)>& progress, AcousticTrouble trouble) {
  const auto flown = std::make_shared<Flown>(World(world_of), Vehicles());
  World& world = flown->world;
  auto made = makeVehicles(std::move(members), world,
                           std::make_shared<Channel>(world_of.seed, std::move(trouble)));
  if (!made) {
    return std::unexpected(made.error());
  }
  const Vehicles& vehicles = flown->vehicles = std::move(*made);
  FleetFlight flight{{}, Separations(vehicles.size()), [flown](size_t vehicle) {
                       return flown->vehicles.at(vehicle)->finish();
                     }};
  for (const auto& vehicle : vehicles) {
    flight.starts.push_back(vehicle->place());
  }
  std::vector<std::optional<TruePlace>> places(vehicles.size());
  double told_s = 0;
  while (flyingOf(vehicles) != 0) {
    world.tick();
    for (const auto& vehicle : vehicles) {
      vehicle->placeModem();
    }
    for (size_t i = 0; i < vehicles.size(); ++i) {
      SimulatedVehicle& vehicle = *vehicles[i];
      vehicle.advance(world.now());
      places[i] = vehicle.flying() ? std::optional(vehicle.place()) : std::nullopt;
    }
    flight.separations.look(world.now(), places);
    if (progress && world.now() >= told_s + kProgress_s) {
      told_s = world.now();
      progress(told_s, flyingOf(vehicles));
    }
  }
  return flight;
}

}  // namespace glider::simulator
