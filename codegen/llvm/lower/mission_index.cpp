// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/mission_index.h"

#include "ir/core/ops.h"
#include "ir/core/sampling.h"
#include "ir/core/window_shape.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/leg.h"
#include "runtime/abi/window.h"

namespace glider::codegen {
namespace {

/// The slots of a temporal: its value; for Became also whether the operand was true, for Held that
/// and since when; for a window those of runtime/abi/window.h.
uint32_t slotsOf(const ir::Temporal& temporal) {
  switch (temporal.kind) {
    case ir::TemporalKind::Became:
      return 2;
    case ir::TemporalKind::Held:
      return 3;
    case ir::TemporalKind::Mean:
    case ir::TemporalKind::Lowest:
    case ir::TemporalKind::Highest:
    case ir::TemporalKind::Spread:
    case ir::TemporalKind::Slope:
    case ir::TemporalKind::AtLowest:
    case ir::TemporalKind::AtHighest:
    case ir::TemporalKind::Steepest:
    case ir::TemporalKind::AtSteepest:
    case ir::TemporalKind::Number:
      break;
  }
  if (temporal.leg != ir::Leg::None) {
    return ir::isOfSteepest(temporal.kind) ? GLIDER_STEEPEST_MEMORY : GLIDER_LEG_MEMORY;
  }
  return GLIDER_WINDOW_HEADER + GLIDER_WINDOW_SLOT * ir::windowShape(temporal).bins;
}

void indexVariables(const ir::Mission& mission, MissionIndex& index) {
  index.state_variables.resize(mission.states.size());
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    const ir::Variable& variable = mission.variables[i];
    switch (variable.kind) {
      case ir::VariableKind::Parameter:
        ++index.parameter_count;
        break;
      case ir::VariableKind::State:
      case ir::VariableKind::Profile:
      case ir::VariableKind::Route:
        index.state_variables.at(variable.owner.index).push_back({i});
        break;
      case ir::VariableKind::Mission:
      case ir::VariableKind::Argument:
      case ir::VariableKind::Monitor:  // dropped with the requirements
      case ir::VariableKind::Momentary:
        break;
    }
  }
}

void indexTemporals(const ir::Mission& mission, MissionIndex& index) {
  index.state_temporals.resize(mission.states.size());
  for (uint32_t i = 0; i < mission.temporals.size(); ++i) {
    const ir::Temporal& temporal = mission.temporals[i];
    index.temporal_slots.push_back(index.slot_count);
    index.slot_count += slotsOf(temporal);
    if (temporal.list == ir::ListKind::Always) {
      index.always_temporals.push_back({i});
    } else {
      index.state_temporals.at(temporal.state.index).push_back({i});
    }
  }
}

uint32_t memoryOf(const ir::GuardTable& table) {
  const auto columns = static_cast<uint32_t>(table.columns.size());
  const auto words = static_cast<uint32_t>((table.rows.size() + 31) / 32);
  return table.empty() ? 0 : gliderGuardMemory(columns, words);
}

void indexTables(const ir::Mission& mission, MissionIndex& index) {
  index.interval_count = memoryOf(mission.always_table);
  for (const ir::State& state : mission.states) {
    index.table_memory.push_back(index.interval_count);
    index.interval_count += memoryOf(state.table);
  }
}

}  // namespace

MissionIndex indexMission(const ir::Mission& mission) {
  MissionIndex index;
  indexVariables(mission, index);
  indexTemporals(mission, index);
  indexTables(mission, index);
  index.samples = ir::samples(mission);
  auto block = [&](const ir::Activity& activity) {
    return mission[activity.behaviour].symbol.empty() ? UINT32_MAX : index.memory_count++;
  };
  for (const ir::State& state : mission.states) {
    const uint32_t profile = block(state.profile);
    index.memory_blocks.push_back({profile, block(state.route)});
  }
  return index;
}

}  // namespace glider::codegen
