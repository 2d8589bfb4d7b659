// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "platforms/load/read_power.h"

#include "platforms/load/read_numbers.h"
#include "platforms/load/read_propeller.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace glider::platforms {
namespace {

constexpr NumberKey<Power> kPack[] = {
    {"capacity_kJ", &Power::capacity_kj},
    {"full_V", &Power::full_V},
    {"empty_V", &Power::empty_V},
    {"resistance_ohm", &Power::resistance_ohm, Least::Zero},
};

constexpr NumberKey<EnergyModel> kBounds[] = {
    {"glide_m_s", &EnergyModel::glide_m_s},
    {"pitch_off_deg", &EnergyModel::pitch_off_deg},
    {"hover_pump_cc_s", &EnergyModel::hover_pump_cc_s},
    {"hover_swell_cc_s", &EnergyModel::hover_swell_cc_s},
    {"pitch_battery_share", &EnergyModel::pitch_battery_share},
    {"pitch_battery_turn_s", &EnergyModel::pitch_battery_turn_s},
    {"dive_start_s", &EnergyModel::dive_start_s},
};

/// The key of the number of a row.
std::string_view amountKey(DrawWhen when) {
  return when == DrawWhen::PumpOut || when == DrawWhen::PumpIn ? "J_per_cc" : unitOf(when);
}

void readSensors(TomlReader& reader, const Platform& platform, Draw& draw) {
  draw.sensors = reader.texts("sensors");
  for (const std::string& sensor : draw.sensors) {
    if (platform.find(sensor) == nullptr) {
      reader.refuse("sensors",
                    fmt::format("must name sensors of the vehicle, and `{}` is none", sensor));
    }
  }
}

Draw readDraw(TomlReader& reader, const Platform& platform) {
  Draw draw;
  draw.device = reader.text("device");
  const std::string when = reader.text("when");
  const auto known = drawWhenOf(when);
  if (!known) {
    reader.refuse("when", fmt::format("must be one of {}", drawWords()));
    return draw;
  }
  draw.when = *known;
  std::vector<std::string_view> keys = {"device", "when", "spread", "source", amountKey(draw.when)};
  draw.amount = reader.notNegative(amountKey(draw.when));
  if (draw.when == DrawWhen::PumpOut) {
    keys.emplace_back("J_per_cc_m");
    draw.amount_per_m = reader.notNegative("J_per_cc_m");
  }
  if (draw.when == DrawWhen::Read) {
    keys.emplace_back("sensors");
    readSensors(reader, platform, draw);
  }
  draw.spread = reader.share("spread");
  draw.source = reader.text("source");
  reader.only(keys);
  return draw;
}

/// Why the table cannot have `row`; empty: it can.
std::string whyRefused(const Power& power, const Draw& row) {
  if (row.device.empty()) {
    return "must not be empty";
  }
  for (const std::string_view own : {kPropellerDevice, kSbcDevice, kModemDevice}) {
    if (row.device == own) {
      return fmt::format("`{}` has no row: its power is elsewhere", own);
    }
  }
  const bool twice = std::ranges::any_of(power.draws, [&](const Draw& other) {
    return other.device == row.device && other.when == row.when;
  });
  return twice ? fmt::format("`{}` already has a row for \"{}\"", row.device, wordOf(row.when))
               : "";
}

support::Result<void> readDraws(const std::string& file, const toml::table& root,
                                const Platform& platform, Power& power) {
  const toml::array* rows = root["power"]["draw"].as_array();
  for (size_t i = 0; rows != nullptr && i < rows->size(); ++i) {
    TomlReader reader =
        tableOf(file, toml::node_view<const toml::node>(rows->get(i)), "[[power.draw]]");
    Draw draw = readDraw(reader, platform);
    if (const std::string why = whyRefused(power, draw); !reader.failure() && !why.empty()) {
      reader.refuse("device", why);
    }
    if (reader.failure()) {
      return std::unexpected(*reader.failure());
    }
    power.draws.push_back(std::move(draw));
  }
  return {};
}

bool has(const Power& power, DrawWhen when) {
  return std::ranges::any_of(power.draws, [&](const Draw& draw) { return draw.when == when; });
}

}  // namespace

support::Result<Power> readPower(const std::string& file, const toml::table& root,
                                 const Platform& platform) {
  const Motion& motion = *platform.motion;
  TomlReader reader = tableOf(file, root["power"], "[power]");
  std::vector<std::string_view> others = {"board", "draw"};
  if (motion.propelled) {
    others.insert(others.end(), {kPowerRpm, kPowerWatt});
  } else {
    others.emplace_back("bounds");
  }
  Power power = readNumbers(reader, kPack, std::move(others));
  power.board = reader.textOr("board", "");
  if (!(power.empty_V < power.full_V)) {
    reader.refuse("empty_V", "must be below `full_V`");
  }
  if (motion.propelled) {
    power.propeller = readPropellerPower(reader, motion.propelled->propeller.greatest_rpm);
  }
  if (root["power"]["bounds"] && !motion.propelled && !reader.failure()) {
    TomlReader bounds = tableOf(file, root["power"]["bounds"], "[power.bounds]");
    power.bounds = readNumbers(bounds, kBounds, {});
    if (bounds.failure()) {
      return std::unexpected(*bounds.failure());
    }
  }
  if (!reader.failure()) {
    if (auto read = readDraws(file, root, platform, power); !read) {
      return std::unexpected(read.error());
    }
    const auto need = [&](DrawWhen when) {
      if (!has(power, when)) {
        reader.refuse("draw", fmt::format("must have a row with `when = \"{}\"`", wordOf(when)));
      }
    };
    need(DrawWhen::Always);
    if (!motion.propelled) {
      need(DrawWhen::PumpOut);
      need(DrawWhen::PumpIn);
    }
  }
  if (reader.failure()) {
    return std::unexpected(*reader.failure());
  }
  return power;
}

}  // namespace glider::platforms
