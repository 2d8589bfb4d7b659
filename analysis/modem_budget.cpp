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
  return {fmt::format("every_{:g}_s", mission.shares[message.first].period_s), message.bytes,
          roundedUp(modem.frame_bytes), "bytes of a frame",
          fmt::format("{} bits: {}", message.bits, namesOf(mission, message))};
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
  double messages = 0;
  for (const ir::ShareMessage& message : ir::messagesOf(m)) {
    budget.quantities.push_back(messageFigure(m, message, modem));
    messages += kDay_s / m.shares[message.first].period_s;
  }
  const double slot_s = platforms::slotOf(modem, platform.envelope.cycle_s);
  const double on_air_s = modem.cycle_init_s + modem.frame_s;
  const auto vehicles = static_cast<uint64_t>(
      std::min<double>(flights::kMostAddress, m.shares.front().period_s / slot_s));
  const double send_J = modem.send_j_byte * modem.frame_bytes;
  const double receive_J = modem.receive_j_byte * modem.frame_bytes;
  budget.quantities.push_back(
      {"slot",
       roundedUp(slot_s),
       {},
       "s",
       fmt::format("{:g} s on air; the rest is for {:g} m of water, the dialogue with the modem "
                   "and two cycles of the slowest vehicle",
                   on_air_s, modem.interference_m)});
  budget.quantities.push_back({"vehicles",
                               vehicles,
                               {},
                               "vehicles",
                               "that can take turns within the shortest time of `every`"});
  budget.quantities.push_back({"on_air",
                               roundedUp(messages * on_air_s),
                               {},
                               "s a day",
                               fmt::format("{:.0f} messages", std::ceil(messages))});
  budget.quantities.push_back(
      {"energy",
       roundedUp(messages * send_J + kDay_s * modem.listen_W),
       {},
       "J a day",
       fmt::format("{:.1f} J for each message sent, {:.0f} J to listen; and {:.1f} J for each that "
                   "is received",
                   send_J, kDay_s * modem.listen_W, receive_J)});
  return {std::move(budget)};
}

}  // namespace glider::analysis
