// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"
#include "ir/prove/energy/energy_lines.h"
#include "ir/prove/energy/profile_legs.h"

namespace glider::ir::prove {

/// The energy of a state while it is current, from one transition to the next.
struct StateEnergy {
  EnergyLines lines;
  double fastest_m_s = 0;  ///< it sinks or climbs no faster on average
  bool restless = false;   ///< how often it turns is not known: its pump hardly rests
};

/// What a vehicle takes at most in any flight that goes no deeper: pump and pitch battery work all
/// the time, at the surface or below, where it takes more. The platform has Power::bounds.
EnergyLine restlessLine(const GreatestPower& power, const platforms::Platform& platform,
                        double deepest_m);

/// `deepest_m`: of the state. The platform has Power::bounds.
StateEnergy energyOf(const LegContext& context, const GreatestPower& power, StateId state,
                     double deepest_m);

}  // namespace glider::ir::prove
