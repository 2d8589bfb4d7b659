// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/varied.h"

#include "ir/core/mission_writer.h"
#include "ir/prove/abstract/state_depths.h"
#include "tests/random_missions/random.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::random_proofs {
namespace {

/// With cases of some states that are due at a depth near the deepest that it commands, or up to
/// 3 m above or below.
ir::Mission withDepths(ir::Mission mission, const platforms::Platform& platform, uint64_t seed) {
  random_missions::Random random(seed);
  const ir::prove::ProofContext context(mission, platform);
  if (!context.depth || random.chance(0.5)) {
    return mission;
  }
  const std::vector<double> deepest = ir::prove::deepestByState(context);
  ir::MissionWriter write(mission);
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    if (!std::isfinite(deepest[i])) {
      continue;
    }
    const ir::ExprId depth = write.read(*context.depth);
    const double near = deepest[i] + random.uniform(-3, 3);
    ir::Case added;
    added.guard = write.operation(ir::Op::GreaterEqual, ir::boolean(),
                                  {depth, write.number(near, mission[depth].type)});
    added.transition = random.chance(0.5) ? ir::Transition::Exit : ir::Transition::Stay;
    mission.states[i].cases.push_back(added);
  }
  return mission;
}

/// With all fixed places within some 50 km, in half of the missions: an area to stay in is of no
/// use to one that steers across the globe.
ir::Mission withNearPlaces(ir::Mission mission, uint64_t seed) {
  random_missions::Random random(seed);
  const auto is_place = [](const ir::Variable& v) {
    return v.type.kind == ir::TypeKind::Latitude || v.type.kind == ir::TypeKind::Longitude;
  };
  if (random.chance(0.5) || std::ranges::any_of(mission.variables, is_place)) {
    return mission;
  }
  for (ir::Expr& e : mission.exprs) {
    if (e.op == ir::Op::Constant && e.type.kind == ir::TypeKind::Latitude) {
      e.number = random.uniform(39, 39.4);
    } else if (e.op == ir::Op::Constant && e.type.kind == ir::TypeKind::Longitude) {
      e.number = random.uniform(2.5, 2.9);
    }
  }
  return mission;
}

/// Without its commands.
void silence(ir::Mission& mission, ir::BlockId block) {
  std::vector<ir::BlockId> open{block};
  while (!open.empty()) {
    const ir::BlockId next = open.back();
    open.pop_back();
    if (next.valid()) {
      auto& statements = mission.blocks[next.index].statements;
      std::erase_if(statements,
                    [](const ir::Statement& s) { return s.kind == ir::StatementKind::Command; });
      for (const ir::Statement& s : statements) {
        open.insert(open.end(), {s.then, s.otherwise});
      }
    }
  }
}

/// With a state that does nothing but surface, in half of the missions whose profiles are written.
ir::Mission withSurfacing(ir::Mission mission, uint64_t seed) {
  random_missions::Random random(seed);
  ir::State& state = mission.states[random.below(mission.states.size())];
  const bool written = mission[state.profile.behaviour].symbol.empty() &&
                       mission[state.route.behaviour].symbol.empty();
  if (!written || random.chance(0.5)) {
    return mission;
  }
  ir::Statement up;
  up.kind = ir::StatementKind::Command;
  up.command = ir::Command::Surface;
  for (const auto* cases :
       {&mission.always, &state.cases, &state.profile.cases, &state.route.cases}) {
    for (const ir::Case& c : *cases) {
      silence(mission, c.action);
    }
  }
  for (const ir::BlockId entry : {state.entry, state.profile.entry, state.route.entry}) {
    silence(mission, entry);
  }
  if (!state.profile.entry.valid()) {
    mission.blocks.emplace_back();
    state.profile.entry = {static_cast<uint32_t>(mission.blocks.size() - 1)};
  }
  mission.blocks[state.profile.entry.index].statements.push_back(up);
  return mission;
}

}  // namespace

ir::Mission varied(ir::Mission mission, const platforms::Platform& platform, uint64_t seed) {
  mission = withSurfacing(std::move(mission), seed + 2);
  mission = withNearPlaces(std::move(mission), seed + 1);
  return withDepths(std::move(mission), platform, seed);
}

}  // namespace glider::random_proofs
