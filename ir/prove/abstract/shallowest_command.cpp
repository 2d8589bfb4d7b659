// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/shallowest_command.h"

#include "ir/prove/abstract/bounds_by_state.h"
#include "ir/prove/abstract/held_ranges.h"
#include "ir/prove/context/commands.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr Interval kEver{0, std::numeric_limits<double>::max(), false};

/// How far a vehicle that hovers may rise above its depth, m.
constexpr double kHovering = 1;

}  // namespace

ShallowestCommands::ShallowestCommands(const ProofContext& proof_context)
    : seen_(proof_context.withDepthKnown()),
      m_(seen_.mission),
      values_(anyValues(m_)),
      held_(heldIntervals(m_)),
      possible_(seen_, values_, {kEver, kEver, kEver}) {}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void ShallowestCommands::addBlock(BlockId block, std::vector<const Statement*>& commands) const {
  if (!block.valid()) {
    return;
  }
  for (const Statement& statement : m_[block].statements) {
    if (statement.kind == StatementKind::If) {
      const Truths& condition = possible_.truth(statement.value);
      addBlock(condition.is_true ? statement.then : BlockId(), commands);
      addBlock(condition.is_false ? statement.otherwise : BlockId(), commands);
    } else if (statement.kind == StatementKind::Command && isVertical(statement.command)) {
      commands.push_back(&statement);
    }
  }
}

void ShallowestCommands::addCases(const std::vector<Case>& cases,
                                  std::vector<const Statement*>& commands) const {
  for (const Case& c : cases) {
    if (possible_.truth(c.guard).is_true) {
      addBlock(c.action, commands);
    }
  }
}

std::optional<Shallowest> ShallowestCommands::of(StateId id) const {
  const State& state = m_[id];
  if (!m_[state.profile.behaviour].symbol.empty() || !m_[state.route.behaviour].symbol.empty()) {
    return std::nullopt;
  }
  std::vector<const Statement*> commands;
  for (const BlockId entry : {state.entry, state.profile.entry, state.route.entry}) {
    addBlock(entry, commands);
  }
  for (const auto* cases : {&m_.always, &state.cases, &state.profile.cases, &state.route.cases}) {
    addCases(*cases, commands);
  }
  const platforms::Platform& platform = seen_.platform;
  std::optional<Shallowest> least;
  for (const Statement* command : commands) {
    if (movesActuators(command->command)) {
      return std::nullopt;  // they may lead to the surface
    }
    const Interval target =
        command->command == Command::Surface ? Interval{} : held_[command->values.at(0).index];
    if (target.empty || target.lowest <= platform.world.surface_depth_m) {
      return std::nullopt;
    }
    const bool hovers = command->command == Command::Hover;
    // By the port, what holds a depth is a yo.
    const double rise =
        hovers ? kHovering : platform.envelope.inflection_overshoot_m + platform.world.climb_hold_m;
    const double reading = target.lowest - rise - platform.world.depth_error_m;
    if (!least || reading < least->reading_m) {
      least = Shallowest{target.lowest, reading};
    }
  }
  return least;
}

}  // namespace glider::ir::prove
