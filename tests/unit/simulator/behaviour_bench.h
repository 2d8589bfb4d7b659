// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/slocum/flight/behaviour.h"
#include "simulator/slocum/flight/behaviours/source.h"
#include "simulator/slocum/flight/geography.h"
#include "tests/slocum.h"
#include "vehicles/slocum/mission_files/read.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace glider::simulator {

/// The first behaviour of a mission file's text, run cycle by cycle.
class BehaviourBench {
 public:
  explicit BehaviourBench(const std::string& text) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    const auto mission = slocum::readMission(sources, sources.add("test.mi", text), diagnostics);
    EXPECT_TRUE(mission) << text;
    variables = std::make_unique<MissionVariables>(*mission);
    behaviour = makeBehaviour({mission->behaviours.at(0), hooks::kHull, *variables});
  }

  /// One cycle on top of what the behaviours below command.
  void run(const Situation& situation, const Commands& below = {}) {
    commands = below;
    const Geography here(GeoPosition{39.175, -73.83}, 0);
    Situation placed = situation;
    placed.geography = placed.geography == nullptr ? &here : placed.geography;
    behaviour->run(placed, commands);
  }
  [[nodiscard]] Behaviour::State state() const { return behaviour->state(); }

  std::unique_ptr<MissionVariables> variables;
  std::unique_ptr<Behaviour> behaviour;
  Commands commands;  ///< after the newest cycle
};

}  // namespace glider::simulator
