// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/modem_budget.h"

#include "flights/fleet/fleet_file.h"
#include "ir/core/share_messages.h"
#include "platforms/load/modem.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace glider::analysis {
namespace {

using report::Quantity;

constexpr double kDay_s = 86400;

uint64_t roundedUp(double value) {
  return static_cast<uint64_t>(std::ceil(value));
}

std::string namesOf(const ir::Mission& mission, const ir::ShareMessage& message) {
  std::string names;
  for (uint32_t i = 0; i < message.count; ++i) {
    names += (names.empty() ? "" : ", ") + mission.shares[message.first + i].name;
  }
  return names;
}

Quantity messageFigure(const ir::Mission& mission, const ir::ShareMessage& message,
                       const platforms::Modem& modem) {
  const std::string name = fmt::format("every_{:g}_s", mission.shares[message.first].period_s);
  if (message.mini_bits != 0) {
    return {name, message.mini_bits, ir::kMiniPacketBits, "bits of a mini packet",
            namesOf(mission, message)};
  }
  return {name, message.bytes, roundedUp(modem.frame_bytes), "bytes of a frame",
          fmt::format("{} bits: {}", message.bits, namesOf(mission, message))};
}

/// What the messages of a day cost.
struct Day {
  double messages = 0;
  double on_air_s = 0;
  double send_J = 0;
};

Day dayOf(const ir::Mission& mission, const platforms::Modem& modem) {
  Day day;
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    const double count = kDay_s / mission.shares[message.first].period_s;
    const bool mini = message.mini_bits != 0;
    day.messages += count;
    day.on_air_s += count * (modem.cycle_init_s + (mini ? 0 : modem.frame_s));
    day.send_J += count * (mini ? platforms::miniJ(modem, modem.send_j_byte)
                                : modem.send_j_byte * modem.frame_bytes);
  }
  return day;
}

/// "15.7 J for a frame and 3.1 J for a mini packet": of the kinds that the mission sends.
std::string perMessage(const ir::Mission& mission, const platforms::Modem& modem, double j_byte) {
  bool frames = false, minis = false;
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    (message.mini_bits != 0 ? minis : frames) = true;
  }
  const std::string frame = fmt::format("{:.1f} J for a frame", j_byte * modem.frame_bytes);
  const std::string mini =
      fmt::format("{:.1f} J for a mini packet", platforms::miniJ(modem, j_byte));
  return !minis ? frame : !frames ? mini : frame + " and " + mini;
}

Quantity vehiclesFigure(const ir::Mission& mission, double slot_s) {
  const double shortest_s = mission.shares.front().period_s;
  return {"vehicles",
          static_cast<uint64_t>(std::min<double>(flights::kMostAddress, shortest_s / slot_s)),
          {},
          "vehicles",
          "that can take turns within the shortest time of `every`"};
}

}  // namespace

std::vector<report::Budget> modemBudget(const compiler::Optimised& mission) {
  const ir::Mission& m = mission.mission;
  const platforms::Platform& platform = mission.platform();
  if (m.shares.empty() || !platform.modem) {
    return {};
  }
  const platforms::Modem& modem = *platform.modem;
  report::Budget budget{"modem", {}};
  for (const ir::ShareMessage& message : ir::messagesOf(m)) {
    budget.quantities.push_back(messageFigure(m, message, modem));
  }
  const double slot_s = platforms::slotOf(modem, platform.envelope.cycle_s);
  budget.quantities.push_back(
      {"slot",
       roundedUp(slot_s),
       {},
       "s",
       fmt::format("at most {:g} s on air; the rest is for {:g} m of water, the dialogue with the "
                   "modem and two cycles of the slowest vehicle",
                   modem.cycle_init_s + modem.frame_s, modem.interference_m)});
  budget.quantities.push_back(vehiclesFigure(m, slot_s));
  const Day day = dayOf(m, modem);
  budget.quantities.push_back({"on_air",
                               roundedUp(day.on_air_s),
                               {},
                               "s a day",
                               fmt::format("{:.0f} messages", std::ceil(day.messages))});
  const double listen_J = kDay_s * modem.listen_W;
  budget.quantities.push_back({"energy",
                               roundedUp(day.send_J + listen_J),
                               {},
                               "J a day",
                               fmt::format("to send {}, {:.0f} J to listen; and to receive {}",
                                           perMessage(m, modem, modem.send_j_byte), listen_J,
                                           perMessage(m, modem, modem.receive_j_byte))});
  return {std::move(budget)};
}

}  // namespace glider::analysis
