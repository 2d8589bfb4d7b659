// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/acoustics/modem_settings.h"

namespace glider::simulator {

/// The modem of these tests.
inline constexpr ModemSettings kTestModem{.range_m = 2000,
                                          .interference_m = 3000,
                                          .cycle_init_s = 1.5,
                                          .frame_s = 4,
                                          .frame_bytes = 32,
                                          .send_J = 16,
                                          .receive_J = 8,
                                          .send_mini_J = 6,
                                          .receive_mini_J = 3,
                                          .listen_W = 0.5};

}  // namespace glider::simulator
