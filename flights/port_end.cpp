// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/port_end.h"

namespace glider::flights {

std::unique_ptr<simulator::LineTurns> PortEnd::turns() const {
  return std::holds_alternative<GliderImcMission>(mission)     ? simulator::imcTurns()
         : std::holds_alternative<GliderReconMission>(mission) ? simulator::reconTurns()
                                                               : simulator::portTurns(clock);
}

}  // namespace glider::flights
