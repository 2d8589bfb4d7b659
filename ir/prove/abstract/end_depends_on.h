// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/prove/context/proof_context.h"

#include <vector>

namespace glider::ir::prove {

/// For a mission without an end bound: the sensors that its end depends on, in the order of the
/// mission. If one of them never reported anything, the clocks alone would end the mission; if
/// there is no such sensor, those that the cases await (sensors_awaited.h) which lead out of
/// `states`, where it may stay.
std::vector<SensorId> endDependsOn(const ProofContext& proof_context,
                                   const std::vector<StateId>& states);

}  // namespace glider::ir::prove
