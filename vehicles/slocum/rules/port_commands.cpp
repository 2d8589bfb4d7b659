// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port_commands.h"

#include "ir/prove/context/commands.h"
#include "support/diagnostics/ids/target.h"

namespace glider::slocum::rules {
namespace {

void check(const std::vector<const ir::Statement*>& commands, const support::SourceRange& otherwise,
           support::DiagnosticEngine& diagnostics) {
  for (const ir::Statement* command : commands) {
    if (command->command == ir::Command::Hover) {
      diagnostics.report(
          support::diagnostics::notOnPort,
          command->range.end > command->range.begin ? command->range : otherwise, "hover",
          "the port holds a depth by a yo, so `descend(to = DEPTH, pitch = ANGLE)` is "
          "the nearest: the vehicle then stays between DEPTH and a few metres above");
      return;  // one of a profile is enough
    }
  }
}

}  // namespace

void checkPortCommands(const ir::Mission& mission, support::DiagnosticEngine& diagnostics) {
  check(ir::prove::commandsOfAlways(mission), {}, diagnostics);
  for (const ir::State& state : mission.states) {
    check(ir::prove::commandsOf(mission, state), state.range, diagnostics);
  }
}

}  // namespace glider::slocum::rules
