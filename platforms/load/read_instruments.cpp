// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_instruments.h"

#include "hooks/protocol/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace glider::platforms {
namespace {

/// The sensor that tells the vehicle (hooks/protocol/roles.def).
constexpr std::string_view kSamplingSensor = "sci_hook_sampling";

/// Why an instrument cannot measure `sensor`; empty: it can.
std::string whyNot(const Platform& platform, const std::vector<Instrument>& others,
                   const std::string& sensor) {
  const PlatformSensor* found = platform.find(sensor);
  if (found == nullptr || found->name != sensor || found->computer != Computer::Science) {
    return fmt::format("must name sensors of the science computer, and `{}` is none", sensor);
  }
  return measuring(others, sensor) == nullptr
             ? ""
             : fmt::format("has `{}`, which another instrument measures", sensor);
}

Instrument readInstrument(TomlReader& reader, const Platform& platform,
                          const std::vector<Instrument>& others) {
  Instrument one;
  reader.only({"name", "vehicle_name", "sensors", "shortest_s", "reading_s"});
  one.name = reader.text("name");
  one.vehicle_name = reader.text("vehicle_name");
  one.sensors = reader.texts("sensors");
  one.shortest_s = reader.notNegative("shortest_s");
  one.reading_s = reader.number("reading_s");
  if (!(one.reading_s > 0)) {
    reader.refuse("reading_s", "must be positive");
  }
  if (one.sensors.empty()) {
    reader.refuse("sensors", "must name what the instrument measures");
  }
  for (const std::string& sensor : one.sensors) {
    if (const std::string why = whyNot(platform, others, sensor); !why.empty()) {
      reader.refuse("sensors", why);
    }
  }
  if (!isName(one.name)) {
    reader.refuse("name", "must be letters, digits and `_`, and begin with a letter");
  } else if (std::ranges::find(others, one.name, &Instrument::name) != others.end()) {
    reader.refuse("name", "must not be that of another instrument");
  } else if (platform.find(one.name) != nullptr) {
    reader.refuse("name", "must not be that of a sensor");
  }
  return one;
}

}  // namespace

support::Result<std::vector<Instrument>> readInstruments(const std::string& file,
                                                         const toml::table& root,
                                                         const Platform& platform) {
  std::vector<Instrument> instruments;
  const toml::array* rows = root["instrument"].as_array();
  for (size_t i = 0; rows != nullptr && i < rows->size(); ++i) {
    TomlReader reader =
        tableOf(file, toml::node_view<const toml::node>(rows->get(i)), "[[instrument]]");
    Instrument one = readInstrument(reader, platform, instruments);
    if (i == kHookMostInstruments) {
      reader.refuse("name", fmt::format("is of instrument {}: an instruction has room for {}",
                                        i + 1, static_cast<int>(kHookMostInstruments)));
    }
    if (platform.find(kSamplingSensor) == nullptr) {
      reader.refuse("name", fmt::format("is of an instrument that missions could not switch: the "
                                        "vehicle has no sensor `{}`",
                                        kSamplingSensor));
    }
    if (reader.failure()) {
      return std::unexpected(*reader.failure());
    }
    instruments.push_back(std::move(one));
  }
  return instruments;
}

}  // namespace glider::platforms
