// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/boards.h"
#include "compiler/vehicles.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/power_table.h"
#include "driver/terminal.h"
#include "frontend/sema/names/commands.h"
#include "platforms/generate/sensor_header.h"
#include "platforms/load/default_platform.h"
#include "platforms/load/dictionary.h"
#include "platforms/load/platform.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>

namespace glider::driver {
namespace {

using nlohmann::ordered_json;
using platforms::Envelope;
using platforms::Platform;
using platforms::PlatformSensor;

struct PlatformOptions {
  std::string name{platforms::kDefaultPlatform};
  bool json = false;
  bool header = false;
};

std::string_view computerOf(const PlatformSensor& sensor) {
  return sensor.computer == platforms::Computer::Science ? "science" : "flight";
}

std::string_view unitOf(const PlatformSensor& sensor) {
  return sensor.unit == "1"                               ? "-"
         : sensor.unit == "timestamp"                     ? "s"
         : sensor.kind != platforms::SensorKind::Quantity ? "ddmm.mm"
                                                          : std::string_view(sensor.unit);
}

std::string finText(const Envelope& envelope) {
  return envelope.fin_rad > 0
             ? fmt::format("{:.4g} deg to either side", envelope.fin_rad * 180 / std::numbers::pi)
             : "none to command";
}

std::string pumpText(const Envelope& envelope) {
  return envelope.pump_cc > 0 ? fmt::format("{:.6g} cc to either side", envelope.pump_cc)
                              : "none to command";
}

std::string batteryText(const Envelope& envelope) {
  return envelope.battery_in > 0 ? fmt::format("{:.4g} inch to either side", envelope.battery_in)
                                 : "none to command";
}

/// What a command to go to a depth also says.
std::string slopeText(const Envelope& envelope) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  return envelope.steersBySpeed()
             ? fmt::format(
                   "speeds                  {:.4g} to {:.4g} m/s, {:.4g} m/s if none is named",
                   envelope.slowest_m_s, envelope.fastest_m_s, envelope.usual_speed_m_s)
             : fmt::format(
                   "pitches                 {:.4g} to {:.4g} deg, {:.4g} deg if none is named",
                   envelope.shallowest_pitch_rad * kDegrees, envelope.steepest_pitch_rad * kDegrees,
                   envelope.usual_pitch_rad * kDegrees);
}

std::string overshootText(const Envelope& envelope) {
  const std::string usual = fmt::format("{:.6g} m", envelope.inflection_overshoot_m);
  constexpr double kDegrees = 180 / std::numbers::pi;
  return envelope.steep_overshoot_m > 0
             ? fmt::format("{}, {:.6g} m beyond {:.3g} deg", usual, envelope.steep_overshoot_m,
                           envelope.overshoot_pitch_rad * kDegrees)
             : usual;
}

std::string envelopeText(const Envelope& envelope) {
  return fmt::format(
      "  greatest depth          {:.6g} m\n"
      "  fastest vertical rate   {:.6g} m/s\n"
      "  {}\n"
      "  inflection overshoot    {}\n"
      "  strongest current       {:.6g} m/s\n"
      "  fin                     {}\n"
      "  pump                    {}\n"
      "  pitch battery           {}\n"
      "  control cycle           {:.6g} s\n",
      envelope.greatest_depth_m, envelope.vertical_rate_m_s, slopeText(envelope),
      overshootText(envelope), envelope.drift_m_s, finText(envelope), pumpText(envelope),
      batteryText(envelope), envelope.cycle_s);
}

std::string worldText(const platforms::EnvironmentModel& world) {
  return fmt::format(
      "  control begins at       {:.6g} m or above\n"
      "  the surface is          {:.6g} m or above\n"
      "  slowest climb           {:.6g} m/s, {:.6g} s after the command\n"
      "  error of depth          at most {:.6g} m\n"
      "  time between ticks      at most {:.6g} s\n"
      "  speed through water     at most {:.6g} m/s, {:.6g} m off the straight leg\n"
      "  drift at the surface    at most {:.6g} m/s\n"
      "  line between computers  at most {:.6g} s late\n",
      world.start_depth_m, world.surface_depth_m, world.slowest_climb_m_s, world.turn_s,
      world.depth_error_m, world.tick_gap_s, world.through_water_m_s, world.steering_error_m,
      world.surface_drift_m_s, world.line_lag_s);
}

/// "hooks, extctl".
std::string seatsText(const Platform& platform) {
  return platform.front_seats.empty()
             ? "no way is known: missions can be checked, not built or flown"
             : fmt::format("{}", fmt::join(platform.front_seats, ", "));
}

/// What missions switch by `sample`.
std::string instrumentsText(const Platform& platform) {
  std::string out = platform.instruments.empty()
                        ? ""
                        : "\nInstruments that missions switch\n  name          measures\n";
  for (const platforms::Instrument& one : platform.instruments) {
    std::vector<std::string> measured;
    for (const std::string& sensor : one.sensors) {
      const PlatformSensor* row = platform.find(sensor);
      measured.push_back(row->alias.empty() ? row->name : row->alias);
    }
    out += fmt::format("  {:<12}  {}; on for {:g} s for each reading, {:g} s apart at least\n",
                       one.name, fmt::join(measured, ", "), one.reading_s, one.shortest_s);
  }
  return out;
}

std::string text(const Platform& platform, const std::optional<platforms::Board>& board) {
  std::string out = fmt::format(
      "{}: {}\n\nFrom the SBC: {}\n\nEnvelope\n{}\nEnvironment model of proofs\n{}\nCommands\n",
      platform.name, platform.description, seatsText(platform), envelopeText(platform.envelope),
      worldText(platform.world));
  for (const frontend::VehicleCommand& command : frontend::vehicleCommands(platform)) {
    out += fmt::format("  {}\n", command.signature.text);
  }
  out += instrumentsText(platform);
  out += powerText(platform, board);
  out +=
      fmt::format("\nSensors\n  {:<12} {:<27} {:<8} {:>12} {:>12} {:>10} {:>9} {:>10}  {:<8} {}\n",
                  "name", "vehicle's name", "unit", "lowest", "highest", "stale, s", "every, s",
                  "dead band", "computer", "");
  for (const PlatformSensor& sensor : platform.sensors) {
    out += fmt::format(
        "  {:<12} {:<27} {:<8} {:>12.6g} {:>12.6g} {:>10.6g} {:>9.6g} {:>10.6g}  {:<8} {}\n",
        sensor.alias, sensor.name, unitOf(sensor), sensor.lowest, sensor.highest,
        sensor.stale_after_s, sensor.every_s, sensor.dead_band, computerOf(sensor), sensor.what);
  }
  return out;
}

ordered_json instrumentsJson(const Platform& platform) {
  ordered_json instruments = ordered_json::array();
  for (const platforms::Instrument& one : platform.instruments) {
    instruments.push_back({{"name", one.name},
                           {"vehicle_name", one.vehicle_name},
                           {"sensors", one.sensors},
                           {"shortest_s", one.shortest_s},
                           {"reading_s", one.reading_s}});
  }
  return instruments;
}

std::string json(const Platform& platform, const std::optional<platforms::Board>& board) {
  const Envelope& envelope = platform.envelope;
  ordered_json sensors = ordered_json::array();
  for (const PlatformSensor& sensor : platform.sensors) {
    ordered_json row{{"name", sensor.name},
                     {"unit", sensor.unit},
                     {"lowest", sensor.lowest},
                     {"highest", sensor.highest},
                     {"every_s", sensor.every_s},
                     {"dead_band", sensor.dead_band},
                     {"stale_after_s", sensor.stale_after_s},
                     {"noise", sensor.noise},
                     {"computer", computerOf(sensor)},
                     {"what", sensor.what}};
    if (!sensor.alias.empty()) {
      row["alias"] = sensor.alias;
    }
    sensors.push_back(std::move(row));
  }
  ordered_json commands = ordered_json::array();
  for (const frontend::VehicleCommand& command : frontend::vehicleCommands(platform)) {
    commands.push_back(command.signature.text);
  }
  const ordered_json all{{"name", platform.name},
                         {"description", platform.description},
                         {"front_seats", platform.front_seats},
                         {"envelope",
                          {{"greatest_depth_m", envelope.greatest_depth_m},
                           {"steepest_pitch_rad", envelope.steepest_pitch_rad},
                           {"shallowest_pitch_rad", envelope.shallowest_pitch_rad},
                           {"usual_pitch_rad", envelope.usual_pitch_rad},
                           {"slowest_m_s", envelope.slowest_m_s},
                           {"usual_speed_m_s", envelope.usual_speed_m_s},
                           {"fastest_m_s", envelope.fastest_m_s},
                           {"vertical_rate_m_s", envelope.vertical_rate_m_s},
                           {"inflection_overshoot_m", envelope.inflection_overshoot_m},
                           {"steep_overshoot_m", envelope.steep_overshoot_m},
                           {"overshoot_pitch_rad", envelope.overshoot_pitch_rad},
                           {"drift_m_s", envelope.drift_m_s},
                           {"fin_rad", envelope.fin_rad},
                           {"pump_cc", envelope.pump_cc},
                           {"battery_in", envelope.battery_in},
                           {"cycle_s", envelope.cycle_s}}},
                         {"world",
                          {{"start_depth_m", platform.world.start_depth_m},
                           {"surface_depth_m", platform.world.surface_depth_m},
                           {"slowest_climb_m_s", platform.world.slowest_climb_m_s},
                           {"turn_s", platform.world.turn_s},
                           {"depth_error_m", platform.world.depth_error_m},
                           {"tick_gap_s", platform.world.tick_gap_s},
                           {"through_water_m_s", platform.world.through_water_m_s},
                           {"steering_error_m", platform.world.steering_error_m},
                           {"surface_drift_m_s", platform.world.surface_drift_m_s},
                           {"line_lag_s", platform.world.line_lag_s}}},
                         {"power", powerJson(platform, board)},
                         {"commands", commands},
                         {"instruments", instrumentsJson(platform)},
                         {"sensors", sensors}};
  return all.dump(2) + "\n";
}

int show(const PlatformOptions& options) {
  const auto platform = compiler::loadVehicle(options.name);
  if (!platform) {
    return inFormat(options.json, "platform",
                    [&](Json*) { return reportFailure(platform.error()); });
  }
  if (auto roles = platforms::checkRoles(*platform); options.header && !roles) {
    return reportFailure(roles.error());
  }
  const auto board = compiler::usualBoard(*platform);
  if (!board) {
    return inFormat(options.json, "platform", [&](Json*) { return reportFailure(board.error()); });
  }
  const auto printed = printOut(options.header ? platforms::sensorHeader(*platform)
                                : options.json ? json(*platform, *board)
                                               : text(*platform, *board));
  return printed ? kFine : reportFailure(printed.error());
}

}  // namespace

void addPlatformCommand(CLI::App& app, int& status) {
  CLI::App* command =
      app.add_subcommand("platform", "List a vehicle's sensors, commands, limits and power");
  auto options = std::make_shared<PlatformOptions>();
  command->add_option("NAME", options->name,
                      fmt::format("Vehicle [{}]", platforms::kDefaultPlatform));
  CLI::Option* as_json = command->add_flag("--json", options->json, "The same as --format json");
  addFormatOption(*command, options->json);
  command
      ->add_flag("--header", options->header,
                 "Write the C header of its sensors, for hooks and missions in C")
      ->excludes(as_json)
      ->excludes("--format");
  command->callback([options, &status] { status = show(*options); });
}

}  // namespace glider::driver
