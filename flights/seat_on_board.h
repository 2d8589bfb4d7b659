// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/abi/port_mission.h"
#include "runtime/abi/recon_mission.h"
#include "runtime/checkpoint/checkpoint.h"

#include <functional>
#include <memory>
#include <variant>

namespace glider::flights {

/// What the SBC's program knows of a vehicle that has no hookprog, by the way in which it is
/// steered.
using SeatSettings = std::variant<GliderPortMission, GliderImcMission, GliderReconMission>;

/// The part of the program that stands between it and such a vehicle, in this process.
struct SeatOnBoard {
  std::shared_ptr<void> holder;  ///< null: there is none, and the line is hookprog's
  GliderByteStream stream{};     ///< the program's end
  /// The mission is over: whether the program may end now; empty: it may.
  std::function<bool()> may_end = nullptr;
};

/// `line` is the vehicle's end; `mission` outlives it. `checkpoint`: of the program that it goes on
/// from; null: none.
SeatOnBoard makeSeat(const SeatSettings& settings, const GliderMission& mission,
                     const GliderByteStream& line, const runtime::LinkFacts* checkpoint);

}  // namespace glider::flights
