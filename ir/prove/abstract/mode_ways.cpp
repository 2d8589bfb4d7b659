// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/abstract/mode_ways.h"

#include "ir/core/walk.h"
#include "ir/prove/context/commands.h"

#include <algorithm>
#include <cmath>

namespace glider::ir::prove {

ModeWays::ModeWays(const ProofContext& proof_context, const Activity& profile)
    : known_(proof_context.known),
      profile_(profile),
      modes_(proof_context.mission, profile, &proof_context.known) {}

bool ModeWays::explore() {
  const bool plain = std::ranges::all_of(modes_.own(), [&](VariableId id) {
    return known_.variables[id.index] && id != profile_.done;
  });
  if (!plain || modes_.own().size() > ProfileModes::kMostTruths) {
    return false;
  }
  std::vector<Mode> open;
  const auto arrive = [&](const std::set<Mode>& modes) {
    for (const Mode& mode : modes) {
      if (ways_.try_emplace(mode).second) {
        open.push_back(mode);
      }
    }
  };
  arrive(modes_.begin());
  while (!open.empty()) {
    const Mode mode = open.back();
    open.pop_back();
    arrive(resumed(mode));
    for (size_t i = 0; i < profile_.cases.size(); ++i) {
      const Truth guard = modes_.judge(profile_.cases[i].guard, mode);
      if (guard == Truth::False) {
        continue;
      }
      const std::set<Mode> after = modes_.run(profile_.cases[i].action, {mode});
      for (const Mode& to : after) {
        ways_[mode].push_back({to, i});
      }
      arrive(after);
      if (guard == Truth::True) {
        break;  // it hides the rest
      }
    }
  }
  return true;
}

std::set<Mode> ModeWays::resumed(const Mode& from) const {
  return modes_.run(profile_.entry, {Mode{from.truths, std::nullopt}});
}

namespace {

bool isOfProfile(const Mission& mission, StateId state, VariableId id) {
  return mission[id].kind == VariableKind::Profile && mission[id].owner == state;
}

bool beginsAsTime(const Expr& initial) {
  return initial.op == Op::MissionTime || (initial.op == Op::Constant && initial.number <= 0);
}

}  // namespace

bool othersInterfere(const Mission& mission, StateId id) {
  const State& state = mission[id];
  bool found = !mission[state.profile.behaviour].symbol.empty() ||
               !mission[state.route.behaviour].symbol.empty();
  const auto commands = [&](const Statement& s) { found = found || isVertical(s); };
  const auto remembers = [&](const Statement& s) {
    found = found || (s.kind == StatementKind::Set && isOfProfile(mission, id, s.variable));
  };
  forEachStatement(mission, state.route.entry, commands);
  for (const BlockId block : {mission.every_tick, state.entry, state.route.entry}) {
    forEachStatement(mission, block, remembers);
  }
  for (const auto* cases : {&mission.always, &state.cases, &state.route.cases}) {
    for (const Case& c : *cases) {
      forEachStatement(mission, c.action, remembers);
      if (staysIn(c.transition)) {
        forEachStatement(mission, c.action, commands);
      }
    }
  }
  return found;
}

std::vector<VariableId> timersOfProfile(const Mission& mission, const TimerGuards& guards,
                                        StateId state) {
  std::vector<VariableId> found;
  for (uint32_t i = 0; i < mission.variables.size(); ++i) {
    const Variable& variable = mission.variables[i];
    if (isOfProfile(mission, state, {i}) && variable.type.kind == TypeKind::Quantity &&
        !std::isfinite(variable.lowest) && !std::isfinite(variable.highest) &&
        beginsAsTime(mission[variable.initial]) && guards.holdsTimesOnly({i})) {
      found.push_back({i});
    }
  }
  return found;
}

bool setsForSure(const Mission& mission, BlockId block, VariableId id) {
  return block.valid() && std::ranges::any_of(mission[block].statements, [&](const Statement& s) {
           return s.kind == StatementKind::Set && s.variable == id;
         });
}

}  // namespace glider::ir::prove
