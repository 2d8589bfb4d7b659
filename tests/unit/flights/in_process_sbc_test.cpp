// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/in_process_sbc.h"

#include "compiler/compilation.h"
#include "flights/launch_choice.h"
#include "platforms/load/load_platform.h"
#include "simulator/simulator.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gmock/gmock.h>

namespace glider::flights {
namespace {

const std::filesystem::path kSource = GLIDER_SOURCE_DIR;

std::shared_ptr<const codegen::LoadedMission> figure2() {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  const auto file = kSource / "missions/figure2.mission";
  const auto compiled = compiler::compileText(file, *support::readFile(file));
  const auto optimised = compiler::optimise(compiled->checked);
  return std::make_shared<const codegen::LoadedMission>(std::move(*loadHere(optimised, {})));
}

/// Bit 20 of the number of the current state flips at 300 s of mission time.
TEST(InProcessSbc, AFlippedBitSilencesItAndTheVehicleClimbs) {
  const auto platform = platforms::loadPlatform(kSource / "platforms/slocum.toml");
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  simulator::SimulationSetup setup;
  setup.platform = *platform;
  setup.scenario =
      *simulator::loadScenario(kSource / "scenarios/default.toml", *platform, sources, diagnostics);
  setup.duration_s = 900;
  const auto card = std::make_shared<Card>();
  auto sbc = std::make_unique<InProcessSbc>(figure2(), std::vector<double>{}, card);
  bool flipped = false;
  sbc->watch([&](const GliderContext& context, double) {
    if (!flipped && context.mission_time >= 300) {
      flipped = true;
      const_cast<GliderContext&>(context).state ^= 1U << 20U;
    }
  });
  setup.sbc = std::move(sbc);
  const auto trace = simulator::simulate(std::move(setup));
  ASSERT_TRUE(trace);
  EXPECT_TRUE(flipped);
  const auto gone =
      std::ranges::find(trace->events, support::EventId::SbcGone, &support::TraceEvent::id);
  ASSERT_NE(gone, trace->events.end());
  EXPECT_EQ(gone->why,
            "exited with status 3: internal check failed: the current state is not one of the "
            "mission");
  const auto released = std::ranges::find_if(gone, trace->events.end(), [](const auto& event) {
    return textOf(event).find("silent") != std::string::npos;
  });
  ASSERT_NE(released, trace->events.end()) << "hookbeh ended its control";
  EXPECT_LE(released->time_s, gone->time_s + 40);
  const int depth = trace->column("true_depth");
  EXPECT_LT(trace->at(trace->rowCount() - 1, depth), 1.0);
  const InProcessSbc again(figure2(), {}, card);
  EXPECT_TRUE(again.kept()) << "the checkpoint by which a restarted program leaves control";
}

}  // namespace
}  // namespace glider::flights
