// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/power_table.h"

#include "platforms/load/power.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string_view>
#include <vector>

namespace glider::driver {
namespace {

using nlohmann::ordered_json;
using platforms::Draw;
using platforms::DrawWhen;
using platforms::Platform;
using platforms::Power;

/// A line of the table.
struct Line {
  std::string device;
  std::string_view when;
  std::string draws;
  std::string spread;
  std::string source;
};

std::string spreadText(double share) {
  return fmt::format("+-{:.0f} %", 100 * share);
}

/// "0.29 J/cc + 0.018 J/cc/m".
std::string drawText(const Draw& draw) {
  const std::string deeper =
      draw.amount_per_m > 0 ? fmt::format(" + {:.4g} J/cc/m", draw.amount_per_m) : "";
  return fmt::format("{:.4g} {}{}", draw.amount, unitOf(draw.when), deeper);
}

std::vector<Line> linesOf(const Power& power, const std::optional<platforms::Board>& board) {
  std::vector<Line> lines;
  for (const Draw& draw : power.draws) {
    lines.push_back(
        {draw.device, describe(draw.when), drawText(draw), spreadText(draw.spread), draw.source});
  }
  if (!power.propeller.rpm.empty()) {
    lines.push_back({std::string(platforms::kPropellerDevice), "straight between these speeds",
                     fmt::format("up to {:.4g} W at {:.4g} rpm", power.propeller.watt.back(),
                                 power.propeller.rpm.back()),
                     "", ""});
  }
  if (board && board->power) {
    lines.push_back({fmt::format("{} ({})", platforms::kSbcDevice, board->name),
                     "while a mission runs", fmt::format("{:.4g} W", board->power->running_W),
                     spreadText(board->power->spread), board->power->source});
    if (const auto& sleep = board->power->sleep) {
      lines.push_back({"", fmt::format("while it naps; it wakes in {:.4g} s", sleep->wake_s),
                       fmt::format("{:.4g} W", sleep->asleep_W), spreadText(board->power->spread),
                       ""});
    }
  }
  return lines;
}

}  // namespace

std::string powerText(const Platform& platform, const std::optional<platforms::Board>& board) {
  if (!platform.motion) {
    return "";
  }
  const Power& power = platform.power;
  constexpr double kJoulesPerWattHour = 3.6;  // in kJ
  std::string out = fmt::format(
      "\nPower\n  pack                    {:.6g} kJ ({:.6g} Wh), {:.4g} V full, {:.4g} V empty, "
      "{:.4g} ohm\n",
      power.capacity_kj, power.capacity_kj / kJoulesPerWattHour, power.full_V, power.empty_V,
      power.resistance_ohm);
  for (const Line& line : linesOf(power, board)) {
    out += fmt::format("  {:<23} {:<45} {:<26} {:<8} {}\n", line.device, line.when, line.draws,
                       line.spread, line.source);
  }
  if (power.bounds) {
    const platforms::EnergyModel& model = *power.bounds;
    out += fmt::format(
        "  bounds assume           {:.4g} m/s along its path at most, up to {:.4g} degrees steeper "
        "than "
        "commanded; a hover pumps {:.4g} cc/s out and in, and near the surface in a swell {:.4g} "
        "more; the pitch battery moves {:.4g} % of a leg and {:.4g} s for the steepest turn; a "
        "dive leaves "
        "the surface within {:.4g} s\n",
        model.glide_m_s, model.pitch_off_deg, model.hover_pump_cc_s, model.hover_swell_cc_s,
        model.pitch_battery_share * 100, model.pitch_battery_turn_s, model.dive_start_s);
  }
  return out;
}

ordered_json powerJson(const Platform& platform, const std::optional<platforms::Board>& board) {
  if (!platform.motion) {
    return nullptr;
  }
  const Power& power = platform.power;
  ordered_json draws = ordered_json::array();
  for (const Draw& draw : power.draws) {
    ordered_json row{{"device", draw.device}, {"when", wordOf(draw.when)},
                     {"amount", draw.amount}, {"unit", unitOf(draw.when)},
                     {"spread", draw.spread}, {"source", draw.source}};
    if (draw.when == DrawWhen::PumpOut) {
      row["amount_per_m"] = draw.amount_per_m;
    }
    if (draw.when == DrawWhen::Read) {
      row["sensors"] = draw.sensors;
    }
    draws.push_back(std::move(row));
  }
  ordered_json out{{"capacity_kJ", power.capacity_kj},
                   {"full_V", power.full_V},
                   {"empty_V", power.empty_V},
                   {"resistance_ohm", power.resistance_ohm},
                   {"draws", std::move(draws)}};
  if (!power.propeller.rpm.empty()) {
    out["propeller"] = {{"rpm", power.propeller.rpm}, {"W", power.propeller.watt}};
  }
  if (power.bounds) {
    out["bounds"] = {{"glide_m_s", power.bounds->glide_m_s},
                     {"pitch_off_deg", power.bounds->pitch_off_deg},
                     {"hover_pump_cc_s", power.bounds->hover_pump_cc_s},
                     {"hover_swell_cc_s", power.bounds->hover_swell_cc_s},
                     {"pitch_battery_share", power.bounds->pitch_battery_share},
                     {"pitch_battery_turn_s", power.bounds->pitch_battery_turn_s},
                     {"dive_start_s", power.bounds->dive_start_s}};
  }
  if (board && board->power) {
    out["sbc"] = {{"board", board->name},
                  {"running_W", board->power->running_W},
                  {"spread", board->power->spread},
                  {"source", board->power->source}};
    if (const auto& sleep = board->power->sleep) {
      out["sbc"]["asleep_W"] = sleep->asleep_W;
      out["sbc"]["wake_s"] = sleep->wake_s;
    }
  }
  return out;
}

}  // namespace glider::driver
