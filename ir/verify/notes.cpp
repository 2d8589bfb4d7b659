// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <fmt/format.h>

namespace glider::ir {
namespace {

std::string step(const Structure& structure, const Edge& edge) {
  const std::string& from = structure.mission.states[edge.from].name;
  const std::string& to = structure.mission.states[edge.to].name;
  if (edge.always) {
    return edge.call
               ? fmt::format("in state `{}`, `always` calls `{}`; `{}` waits on the call stack",
                             from, to, from)
               : fmt::format(
                     "in state `{}`, `always` goes to `{}`, which empties the call "
                     "stack",
                     from, to);
  }
  return edge.call ? fmt::format("state `{}` calls `{}` and waits on the call stack", from, to)
                   : fmt::format("state `{}` goes to `{}`, which empties the call stack", from, to);
}

}  // namespace

void notePath(support::DiagnosticBuilder& report, const Structure& structure, const Path& path) {
  const State& first = structure.mission.states.front();
  report.note(first.range, fmt::format("the mission starts in state `{}`", first.name));
  for (size_t i = 0; i < path.size(); ++i) {
    const support::SourceRange range = structure.caseOf(path[i]).range;
    if (!path.keeps(i + 1) && i + 1 < path.size()) {
      const size_t left_out = path.size() - Path::kLast - i;
      report.note(range, left_out == 1
                             ? "transition not shown"
                             : fmt::format("{} transitions not shown, of which this is the first",
                                           left_out));
      i += left_out - 1;
    } else {
      report.note(range, step(structure, path[i]));
    }
  }
}

void noteDeadCase(support::DiagnosticBuilder& report, const Case& c, Dead why,
                  std::string_view list) {
  switch (why) {
    case Dead::Hidden:
      report.note(
          c.range,
          fmt::format("this case never fires: an earlier case of {} always fires first", list));
      return;
    case Dead::Proved:
      report.note(c.range, "this case never fires");
      return;
    case Dead::AlwaysFalse:
    case Dead::No:
      break;
  }
  report.note(c.range, "this case never fires: its guard is always false");
}

}  // namespace glider::ir
