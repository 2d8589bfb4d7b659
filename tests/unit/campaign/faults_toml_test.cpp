// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What went wrong in a flight, as a scenario file: every fault word for word, and read back.

#include "campaign/campaign.h"
#include "simulator/scenario/scenario.h"
#include "tests/support/command.h"
#include "tests/unit/simulator/slocum_vehicle.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

namespace glider::campaign {
namespace {

using simulator::CardFault;
using simulator::Faults;
using simulator::LineFault;
using simulator::LineWay;
using simulator::SensorFault;
using Kind = SensorFault::Kind;

std::string lineText(const LineFault& fault) {
  Faults faults;
  faults.lines = {fault};
  return faultsToToml(faults);
}

TEST(FaultsToToml, OfNothingIsNothing) {
  EXPECT_EQ(faultsToToml({}), "");
  EXPECT_EQ(lineText({}), "[[faults.line]]\nline = \"to_sbc\"\nfrom_s = 0\n");
}

TEST(FaultsToToml, Lines) {
  EXPECT_EQ(lineText({.way = LineWay::FromSbc, .when = {1.5, 20}, .cut = true}),
            "[[faults.line]]\nline = \"from_sbc\"\nfrom_s = 1.5\nto_s = 20\ncut = true\n");
  LineFault all;
  all.way = LineWay::ToFlight;
  all.when.from_s = 3;
  all.loss = 0.1;
  all.flips = 0.2;
  all.bursts = 0.3;
  all.burst_bytes = 44;
  all.delay_s = 5;
  all.doubled = 0.6;
  all.replayed = 0.7;
  all.heard_at_baud = 57600;
  EXPECT_EQ(lineText(all),
            "[[faults.line]]\nline = \"to_flight\"\nfrom_s = 3\nloss = 0.1\nflips = 0.2\nbursts = "
            "0.3\nburst_bytes = 44\ndelay_s = 5\ndoubled = 0.6\nreplayed = 0.7\nheard_at_baud = "
            "57600\n");
  EXPECT_EQ(lineText({.way = LineWay::FromFlight}),
            "[[faults.line]]\nline = \"from_flight\"\nfrom_s = 0\n");
}

std::string sensorText(Kind kind, double value = 0, double share = 1) {
  Faults faults;
  faults.sensors.push_back({.name = "m_depth", .when = {4}, .kind = kind, .value = value});
  faults.sensors.back().share = share;
  const std::string text = faultsToToml(faults);
  const std::string head = "[[faults.sensor]]\nsensor = \"m_depth\"\nfrom_s = 4\n";
  EXPECT_EQ(text.substr(0, head.size()), head);
  return text.substr(head.size());
}

TEST(FaultsToToml, Sensors) {
  EXPECT_EQ(sensorText(Kind::Frozen), "frozen = true\n");
  EXPECT_EQ(sensorText(Kind::Missing), "missing = true\n");
  EXPECT_EQ(sensorText(Kind::Missing, 0, 0.5), "missing = true\nmissing_share = 0.5\n");
  EXPECT_EQ(sensorText(Kind::Drift, 0.25), "drift_per_s = 0.25\n");
  EXPECT_EQ(sensorText(Kind::Scale, 2), "scale = 2\n");
  EXPECT_EQ(sensorText(Kind::Offset, -7), "offset = -7\n");
  EXPECT_EQ(sensorText(Kind::Jumps, 3, 0.25), "jumps = 3\njumps_share = 0.25\n");
  EXPECT_EQ(sensorText(Kind::Sways, 1.5), "sways = 1.5\nperiod_s = 120\n");
  EXPECT_EQ(sensorText(Kind::Value, -1), "value = -1\n");
  EXPECT_EQ(sensorText(Kind::Value, 9, 0.75), "value = 9\nvalue_share = 0.75\n");
  for (const double sign : {1.0, -1.0}) {
    const double unknown = std::copysign(std::numeric_limits<double>::quiet_NaN(), sign);
    EXPECT_EQ(sensorText(Kind::Value, unknown).substr(sign < 0 ? 9 : 8), "nan\n");
  }
}

TEST(FaultsToToml, Computers) {
  Faults faults;
  faults.power = {{1, 2}, {3}};
  faults.port = {{4, 5}};
  faults.stuck = {{6, 7}};
  faults.modem = {{11, 12}};
  faults.console = {{7, 8}};
  faults.science = {{8, 10.5}};
  faults.clock = {{11, -12}};
  faults.aborts = {13, 14};
  faults.card = {{15, CardFault::Kind::Flips, 16},
                 {17, CardFault::Kind::Cut, 0.5},
                 {18, CardFault::Kind::Zeroed, 0.25}};
  faults.flight = {{{19, 23}, true}, {{30, 31}, false}};
  faults.leftover = {{2, 65535, 12.5}};
  EXPECT_EQ(faultsToToml(faults),
            "[[faults.power]]\nfrom_s = 1\nto_s = 2\n[[faults.power]]\nfrom_s = 3\n"
            "[[faults.port]]\nfrom_s = 4\nto_s = 5\n[[faults.stuck]]\nfrom_s = 6\nto_s = 7\n"
            "[[faults.modem]]\nfrom_s = 11\nto_s = 12\n"
            "[[faults.console]]\nfrom_s = 7\nto_s = 8\n"
            "[[faults.science]]\nat_s = 8\ntakes_s = 2.5\n"
            "[[faults.clock]]\nat_s = 11\nby_s = -12\n"
            "[[faults.abort]]\nat_s = 13\n[[faults.abort]]\nat_s = 14\n"
            "[[faults.card]]\nat_s = 15\nflips = 16\n[[faults.card]]\nat_s = 17\ncut = 0.5\n"
            "[[faults.card]]\nat_s = 18\nzeroed = 0.25\n"
            "[[faults.flight]]\nat_s = 19\ntakes_s = 4\nkeeps_array = true\n"
            "[[faults.flight]]\nat_s = 30\ntakes_s = 1\nkeeps_array = false\n"
            "[[faults.leftover]]\nsession = 2\nsequence = 65535\ndepth_m = 12.5\n");
}

TEST(DrawnToText, SaysWhatElseWasChanged) {
  simulator::DrawnFaults drawn;
  drawn.faults.aborts = {5};
  EXPECT_EQ(drawnToText(drawn), "[[faults.abort]]\nat_s = 5\n");
  drawn.args = simulator::DrawnArgs{1, 2, 3, 4, 5, -6, 7};
  drawn.water_depth_m = 30.5;
  EXPECT_EQ(drawnToText(drawn),
            "[[faults.abort]]\nat_s = 5\n# in the mission file: start_secs 1, max_depth 2, "
            "min_altitude 3, max_pitch 4, hold_secs 5, d_bpump_value -6, c_bpump_value 7\n"
            "# in [ocean]: water_depth_m = 30.5\n");
}

// Everything that a campaign draws is what a scenario file says: its text means the same again.
TEST(FaultsToToml, IsReadBackAsItWas) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path scenarios = GLIDER_SOURCE_DIR "/scenarios";
  std::filesystem::copy(scenarios / "skeleton.mi", folder.path());
  const std::string world = tests::slurp(scenarios / "default.toml");
  for (uint32_t kind = 0; kind < simulator::kFaultKinds; ++kind) {
    for (uint32_t manner = 0; manner < simulator::kManners; ++manner) {
      const Faults drawn =
          drawFaults(static_cast<simulator::FaultKind>(kind),
                     static_cast<simulator::Manner>(manner), 5 + kind, {1000, 30, 900, 30})
              .faults;
      const std::string text = faultsToToml(drawn);
      support::SourceManager sources;
      support::DiagnosticEngine diagnostics;
      const auto scenario =
          simulator::loadScenario(folder.write("drawn.toml", world + "\n" + text),
                                  simulator::slocumPlatform(), sources, diagnostics);
      ASSERT_TRUE(scenario) << text << scenario.error().message;
      const Faults& read = scenario->faults;
      EXPECT_EQ(faultsToToml(read), text);
      EXPECT_EQ(read.first(), drawn.first()) << text;
      EXPECT_NEAR(read.lastEnd(), drawn.lastEnd(), 1e-9) << text;
    }
  }
}

}  // namespace
}  // namespace glider::campaign
