// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/rules/port_commands.h"

#include "ir/prove/context/commands.h"
#include "support/diagnostics/ids/target.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace glider::slocum::rules {
namespace {

/// A command that no stock behaviour that the port can start carries out.
struct Missing {
  ir::Command command;
  const char* word;
  const char* nearest;
  const char* instead = nullptr;  ///< of a profile that commands it; null: `nearest` too
};

constexpr Missing kMissing[] = {
    {ir::Command::Hover, "hover",
     "the port holds a depth by a yo, so `descend(to = DEPTH, pitch = ANGLE)` is the nearest: the "
     "vehicle then stays between DEPTH and a few metres above",
     "the port holds a depth by a yo: use a profile of your own, `flightprofile at_depth(at: "
     "length) "
     "begin entry do descend(at, usual_pitch) end end`, with `ascend` if it lies above; the "
     "vehicle "
     "then stays between that depth and a few metres above"},
    {ir::Command::Pump, "pump",
     "the port moves the pump only by its dives and climbs, so `descend(to = DEPTH, pitch = "
     "ANGLE)` "
     "or `ascend(to = DEPTH, pitch = ANGLE)` is the nearest"},
    {ir::Command::Battery, "battery",
     "the port sets a pitch, and the vehicle moves the battery to it: `descend(to = DEPTH, pitch = "
     "ANGLE)` or `ascend(to = DEPTH, pitch = ANGLE)` is the nearest"},
    {ir::Command::Fin, "fin",
     "the nearest is `steer` with a heading that is changed each time that the vehicle has reached "
     "it"},
};

/// One of the commands is enough. A command in another file, such as the library, is reported
/// where the state uses what gives it: `uses` has the places of the profile and the route.
void check(const std::vector<const ir::Statement*>& commands, const support::SourceRange& otherwise,
           const std::function<support::SourceRange(const ir::Statement*)>& uses,
           support::DiagnosticEngine& diagnostics) {
  for (const Missing& missing : kMissing) {
    const auto found = std::ranges::find(commands, missing.command, &ir::Statement::command);
    if (found == commands.end()) {
      continue;
    }
    const support::SourceRange& range = (*found)->range;
    const bool written = range.end > range.begin;
    const bool elsewhere = written && otherwise.valid() && range.file != otherwise.file;
    auto report = diagnostics.report(
        support::diagnostics::notOnPort,
        elsewhere ? uses(*found)
        : written ? range
                  : otherwise,
        missing.word, elsewhere && missing.instead != nullptr ? missing.instead : missing.nearest);
    if (elsewhere) {
      report.note(range, "it is commanded here");
    }
  }
}

}  // namespace

void checkPortCommands(const ir::Mission& mission, support::DiagnosticEngine& diagnostics) {
  if (mission.nap_s) {
    diagnostics.report(support::diagnostics::notOnPort, mission.states.front().head, "nap",
                       "without hookprog nothing keeps what happens while the SBC sleeps: delete "
                       "the line `nap at most`");
  }
  check(ir::prove::commandsOfAlways(mission), {}, {}, diagnostics);
  for (const ir::State& state : mission.states) {
    if (!state.sampling.empty()) {
      diagnostics.report(support::diagnostics::notOnPort, state.head, "sample",
                         "a behaviour `sample` of the vehicle's mission file says there how often "
                         "an instrument reads");
    }
    const auto uses = [&](const ir::Statement* command) {
      const auto of_route = ir::prove::commandsOf(mission, state.route);
      const bool route = std::ranges::find(of_route, command) != of_route.end();
      return route ? state.route.range : state.profile.range;
    };
    check(ir::prove::commandsOf(mission, state), state.range, uses, diagnostics);
  }
}

}  // namespace glider::slocum::rules
