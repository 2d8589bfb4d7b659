// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/messages.h"

#include <cstdint>

namespace glider::simulator {

/// What is sent: addresses, and data or the bits of a mini packet.
struct AcousticFrame {
  uint32_t source = 0;
  uint32_t destination = 0;  ///< 0: all
  hooks::micro_modem::Data data;
  bool is_mini = false;
  uint32_t mini_bits = 0;
};

}  // namespace glider::simulator
