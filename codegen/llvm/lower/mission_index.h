// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <cstdint>
#include <vector>

namespace glider::codegen {

/// The elements of each state, and the places in a running mission's arrays: computed once, so that
/// lowering stays linear.
struct MissionIndex {
  /// The variables that start when the state is entered, in the order of the mission's vector.
  std::vector<std::vector<ir::VariableId>> state_variables;
  /// The temporals of the state's three lists, and of `always`, in the same way.
  std::vector<std::vector<ir::TemporalId>> state_temporals;
  std::vector<ir::TemporalId> always_temporals;
  /// Each temporal's first slot in GliderContext::temporals, which holds its value.
  std::vector<uint32_t> temporal_slots;
  uint32_t slot_count = 0;
  /// Where the tables of `always` and of each state store their state in GliderContext::intervals.
  uint32_t always_table_memory = 0;
  std::vector<uint32_t> table_memory;
  uint32_t interval_count = 0;
  uint32_t parameter_count = 0;
  /// Blocks of behaviour memory, one for each use of a C function: for each state its profile's and
  /// its route's, UINT32_MAX for one that is written in the language.
  struct Blocks {
    uint32_t profile = UINT32_MAX;
    uint32_t route = UINT32_MAX;
  };
  std::vector<Blocks> memory_blocks;
  uint32_t memory_count = 0;
  bool samples = false;  ///< each state commands how often instruments read: ir::samples
};

MissionIndex indexMission(const ir::Mission& mission);

}  // namespace glider::codegen
