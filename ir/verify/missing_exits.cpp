// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>

namespace glider::ir {
namespace {

using support::DiagnosticId;

/// Who goes to or calls a state.
struct Users {
  std::vector<std::vector<uint32_t>> all;
  explicit Users(const Structure& structure) : all(structure.size()) {
    for (uint32_t s : structure.order) {
      for (const Edge& edge : structure.moves[s].edges) {
        all[edge.to].push_back(s);
      }
    }
  }
};

/// The reached states from which one of `goals` is reached without a return below where they began.
/// A call leads to the called state; that it may come back gains nothing, for the caller's own
/// cases are counted anyway.
std::vector<bool> leadingTo(const Structure& structure, std::vector<bool> goals) {
  const Users users(structure);
  std::deque<uint32_t> pending;
  for (uint32_t s : structure.order) {
    if (goals[s]) {
      pending.push_back(s);
    }
  }
  while (!pending.empty()) {
    const uint32_t state = pending.front();
    pending.pop_front();
    for (uint32_t user : users.all[state]) {
      if (!goals[user]) {
        goals[user] = true;
        pending.push_back(user);
      }
    }
  }
  return goals;
}

/// A return that a `goto` to its state brings to an empty stack.
bool goesToReturn(const Structure& structure, const Edge& edge) {
  return !edge.call && structure.moves[edge.to].return_case;
}

/// The states with an `exit`; with `mistakes_too` also those where a run ends in a mistake that has
/// its own report (a state nothing leaves, a return with an empty stack).
std::vector<bool> endings(const Structure& structure, bool mistakes_too) {
  std::vector<bool> goals(structure.size());
  for (uint32_t s : structure.order) {
    const Moves& moves = structure.moves[s];
    const auto empty = [&](const Edge& edge) { return goesToReturn(structure, edge); };
    goals[s] = moves.exit_case ||
               (mistakes_too && (!moves.leaves() || std::ranges::any_of(moves.edges, empty)));
  }
  return goals;
}

void reportWholeMission(Verification& v) {
  const Mission& m = v.structure.mission;
  auto report = v.diagnostics.report(DiagnosticId::missionWithoutEnd, m.states.front().range);
  for (uint32_t s = 0; s < v.structure.size(); ++s) {
    for (uint32_t c = 0; c < m.states[s].cases.size(); ++c) {
      if (m.states[s].cases[c].transition != Transition::Exit) {
        continue;
      }
      if (v.structure.moves[s].dead[c] != Dead::No) {
        noteDeadCase(report, v.structure, s, c);
      } else {
        report.note(m.states[s].cases[c].range,
                    fmt::format("this `exit` does not count: nothing leads to state `{}`",
                                m.states[s].name));
      }
    }
  }
}

/// The states that belong together get one report, at the one that is nearest to the start.
void reportStates(Verification& v, const std::vector<bool>& endless) {
  constexpr size_t kMost = 8;
  const Mission& m = v.structure.mission;
  const Users users(v.structure);
  std::vector<bool> told(v.structure.size());
  for (uint32_t first : v.structure.order) {
    // Of those that return, only the runs that an endless state began are endless: they are told
    // with it.
    if (!endless[first] || told[first] || v.structure.moves[first].return_case) {
      continue;
    }
    told[first] = true;
    std::vector<uint32_t> group = {first};
    for (size_t i = 0; i < group.size(); ++i) {
      auto join = [&](uint32_t state) {
        if (endless[state] && !told[state]) {
          told[state] = true;
          group.push_back(state);
        }
      };
      std::ranges::for_each(v.structure.moves[group[i]].edges, join, &Edge::to);
      std::ranges::for_each(users.all[group[i]], join);
    }
    const State& state = m.states[first];
    auto report = v.diagnostics.report(DiagnosticId::noWayToExit, state.range, state.name);
    notePath(report, v.structure, v.structure.pathTo(v.structure.nearest(first)));
    for (size_t i = 1; i < group.size() && i <= kMost; ++i) {
      const State& other = m.states[group[i]];
      report.note(other.range, fmt::format("nor can state `{}` reach an `exit`", other.name));
    }
  }
}

}  // namespace

std::vector<bool> statesWithoutEnd(const Structure& structure) {
  const std::vector<bool> ends = leadingTo(structure, endings(structure, true));
  std::vector<bool> endless(structure.size());
  std::deque<uint32_t> pending;
  for (uint32_t s : structure.order) {
    // One that returns goes on with its caller, or is an error of its own.
    if (!ends[s] && !structure.moves[s].return_case) {
      endless[s] = true;
      pending.push_back(s);
    }
  }
  // What an endless state calls may return, but only to it.
  while (!pending.empty()) {
    const uint32_t state = pending.front();
    pending.pop_front();
    for (const Edge& edge : structure.moves[state].edges) {
      if (edge.call && !endless[edge.to]) {
        endless[edge.to] = true;  // if it could reach an end, so could its caller
        pending.push_back(edge.to);
      }
    }
  }
  return endless;
}

void passes::missingExits(Verification& v) {
  if (!leadingTo(v.structure, endings(v.structure, false)).front()) {
    reportWholeMission(v);
    return;
  }
  reportStates(v, statesWithoutEnd(v.structure));
}

}  // namespace glider::ir
