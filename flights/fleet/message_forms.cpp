// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/fleet/message_forms.h"

#include "ir/core/share_messages.h"

namespace glider::flights {

std::vector<simulator::MessageForm> messageForms(const ir::Mission& mission) {
  std::vector<simulator::MessageForm> forms;
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    simulator::MessageForm form;
    for (uint32_t i = 0; i < message.count; ++i) {
      const ir::Share& share = mission.shares[message.first + i];
      form.scales.push_back({share.lowest, share.step, share.values});
    }
    form.signature = static_cast<uint8_t>(message.signature);
    form.bytes = message.bytes;
    form.is_mini = message.mini_bits != 0;
    forms.push_back(std::move(form));
  }
  return forms;
}

}  // namespace glider::flights
