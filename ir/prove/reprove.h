// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/core/mission.h"
#include "platforms/load/platform.h"

#include <cstdint>
#include <vector>

namespace glider::ir::prove {

/// What an earlier check has proved a requirement by.
struct EarlierProof {
  std::vector<certify::Invariant> invariants;
  std::vector<uint32_t> assumptions;  ///< numbers of the mission's, on which it rests
};

/// Whether `proof` proves the requirement with that number: asks Z3 each question of ir/certify,
/// within `effort` of its steps. Needs no search, so it is much faster than the proof was.
bool reproves(const Mission& mission, const platforms::Platform& platform, uint32_t requirement,
              const EarlierProof& proof, unsigned effort);

}  // namespace glider::ir::prove
