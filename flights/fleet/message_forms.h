// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "simulator/acoustics/liar.h"

#include <vector>

namespace glider::flights {

/// How each message of a mission is packed; empty: it shares nothing.
std::vector<simulator::MessageForm> messageForms(const ir::Mission& mission);

}  // namespace glider::flights
