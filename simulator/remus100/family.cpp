// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/family/family.h"

#include "simulator/remus100/remus_seat.h"

#include <algorithm>

namespace glider::simulator {
namespace {

/// What a REMUS flies by itself: nothing that is simulated. A scenario names a mission file of the
/// glider that it was written for, which means nothing here.
struct OwnOfRemus {};

constexpr std::string_view kSources[] = {"clock", "state.depth", "state.latitude",
                                         "state.longitude", "state.heading"};

std::string_view missingSource(const platforms::Platform& platform) {
  for (const std::string_view source : kSources) {
    if (std::ranges::find(platform.sensors, source, &platforms::PlatformSensor::source) ==
        platform.sensors.end()) {
      return source;
    }
  }
  return "";
}

}  // namespace

constinit const Family families::remus100 = {
    .name = "remus100",
    .own_control = "its own mission",
    .missing_sensor = missingSource,
    .provides = [](const platforms::PlatformSensor& sensor) { return !sensor.source.empty(); },
    .load_own =
        [](const std::filesystem::path& /*path*/, support::SourceManager& /*sources*/,
           support::DiagnosticEngine& /*diagnostics*/, std::any& own) {
          own = OwnOfRemus();
          return support::Result<void>();
        },
    .vehicle_keys = {},
    .read_vehicle = [](Fields& /*fields*/, std::any& /*own*/) {},
    .text_of = [](const std::any& /*own*/) { return std::string("a REMUS 100"); },
    .apply_drawn = [](const DrawnFaults& /*drawn*/, std::any& /*own*/) {},
    .overtime_of = [](const std::any& /*own*/) { return 0.0; },
    .raise_overtime = [](std::any& /*own*/, double /*seconds*/) { return std::optional<double>(); },
    .make_seat = [](const SeatSetup& setup) -> std::unique_ptr<SimulatedSeat> {
      return std::make_unique<RemusSeat>(setup);
    }};

}  // namespace glider::simulator
