// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/commands.h"

#include "ir/core/walk.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

using Commands = std::vector<const Statement*>;

void gather(const Mission& mission, BlockId entry, const std::vector<Case>& cases,
            Commands& commands) {
  const auto keep = [&](const Statement& statement) {
    if (statement.kind == StatementKind::Command) {
      commands.push_back(&statement);
    }
  };
  forEachStatement(mission, entry, keep);
  for (const Case& c : cases) {
    forEachStatement(mission, c.action, keep);
  }
}

}  // namespace

std::vector<const Statement*> commandsOf(const Mission& mission, const Activity& activity) {
  Commands commands;
  gather(mission, activity.entry, activity.cases, commands);
  return commands;
}

std::vector<const Statement*> commandsOf(const Mission& mission, const State& state) {
  Commands commands;
  gather(mission, state.entry, state.cases, commands);
  gather(mission, state.profile.entry, state.profile.cases, commands);
  gather(mission, state.route.entry, state.route.cases, commands);
  return commands;
}

std::vector<const Statement*> commandsOfAlways(const Mission& mission) {
  Commands commands;
  gather(mission, {}, mission.always, commands);
  return commands;
}

std::optional<Position> fixedTarget(const Mission& mission, const Statement& statement) {
  if (statement.command != Command::SteerTo) {
    return std::nullopt;
  }
  const Expr& north = mission[statement.values.at(0)];
  const Expr& east = mission[statement.values.at(1)];
  const bool fixed = north.op == Op::Constant && east.op == Op::Constant;
  return fixed ? std::optional(Position{north.number, east.number}) : std::nullopt;
}

std::vector<Position> pathTargets(const Mission& mission, const Statement& statement) {
  if (statement.command != Command::SteerTo) {
    return {};
  }
  const Expr& north = mission[statement.values.at(0)];
  const Expr& east = mission[statement.values.at(1)];
  if (north.op != Op::Element || east.op != Op::Element) {
    return {};
  }
  const std::vector<double>& latitudes = mission[north.table].values;
  const std::vector<double>& longitudes = mission[east.table].values;
  std::vector<Position> places;
  for (size_t i = 0; i < std::min(latitudes.size(), longitudes.size()); ++i) {
    places.push_back({latitudes[i], longitudes[i]});
  }
  return places;
}

bool commandsSurface(const Mission& mission, const State& state) {
  const Statement* last = nullptr;
  if (state.profile.entry.valid()) {
    for (const Statement& statement : mission[state.profile.entry].statements) {
      const bool tells = statement.kind == StatementKind::If || isVertical(statement);
      last = tells ? &statement : last;
    }
  }
  bool route = !mission[state.route.behaviour].symbol.empty();
  forEachStatement(mission, state.route.entry,
                   [&](const Statement& s) { route = route || isVertical(s); });
  return !route && last != nullptr && last->kind == StatementKind::Command &&
         last->command == Command::Surface;
}

bool isVertical(const Statement& statement) {
  return statement.kind == StatementKind::Command && isVertical(statement.command);
}

bool movesActuators(Command command) {
  return command == Command::Pump || command == Command::Battery;
}

bool isVertical(Command command) {
  switch (command) {
    case Command::Descend:
    case Command::Ascend:
    case Command::DescendAt:
    case Command::AscendAt:
    case Command::Hover:
    case Command::Surface:
    case Command::Pump:
    case Command::Battery:
      return true;
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
    case Command::Fin:
      return false;
  }
  return false;
}

}  // namespace glider::ir::prove
