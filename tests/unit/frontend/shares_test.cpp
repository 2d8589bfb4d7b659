// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a mission shares, as the mission IR has it.

#include "ir/core/share_messages.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/vehicle.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;
using testing_support::readSource;

const std::string kDepth = "share depth in 0 m .. 200 m precision 1 m every 10 min\n";
const std::string kFound = "share found: bool = false every 10 min\n";
const std::string kLat = "share lat in 39 N .. 40 N precision 0.001 deg every 2 min\n";

std::string missionWith(const std::string& shares, const std::string& guard = "peer.depth > 9 m") {
  return "mission m\n" + shares +
         "state s\nbegin\n flightprofile surfaced\n sensors missiontime, peer.depth\n events\n "
         "case " +
         guard + " do set found = true end exit\nend\n";
}

ir::Mission compiled(const std::string& text) {
  FrontendRun run(text);
  auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  return mission.value_or(ir::Mission());
}

TEST(Shares, HaveTheirScalesAndWhatIsReceivedOfThem) {
  const ir::Mission mission = compiled(missionWith(kDepth + kFound + kLat));
  ASSERT_EQ(mission.shares.size(), 3U);
  const ir::Share& lat = mission.shares[0];
  EXPECT_EQ(lat.name, "lat") << "the shortest period first";
  EXPECT_EQ(lat.lowest, 39);
  EXPECT_NEAR(lat.step, 0.001, 1e-15) << "in degrees";
  EXPECT_EQ(lat.values, 1001U);
  EXPECT_EQ(lat.period_s, 120);
  EXPECT_TRUE(lat.sensor.valid());
  EXPECT_FALSE(lat.peer.valid()) << "nothing reads it";
  const ir::Share& depth = mission.shares[1];
  EXPECT_EQ(depth.values, 201U);
  ASSERT_TRUE(depth.peer.valid());
  const ir::Sensor& peer = mission[depth.peer];
  EXPECT_TRUE(peer.isHeard());
  EXPECT_EQ(peer.name, "peer.depth");
  EXPECT_EQ(peer.lowest, 0);
  EXPECT_EQ(peer.highest, 200);
  EXPECT_EQ(peer.stale_after_s, 1800);
  EXPECT_EQ(peer.symbol, "");
  const ir::Share& found = mission.shares[2];
  EXPECT_EQ(found.values, 2U);
  EXPECT_TRUE(found.variable.valid());
  EXPECT_EQ(mission[mission.utc].vehicle_name, "m_present_time");
}

TEST(Shares, InAnotherOrderAreTheSameMessages) {
  const auto one = ir::messagesOf(compiled(missionWith(kDepth + kFound + kLat)));
  const auto other = ir::messagesOf(compiled(missionWith(kLat + kFound + kDepth)));
  ASSERT_EQ(one.size(), 2U);
  ASSERT_EQ(other.size(), 2U);
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].signature, other[i].signature);
    EXPECT_EQ(one[i].bytes, other[i].bytes);
  }
  EXPECT_NE(one[0].signature, one[1].signature);
}

TEST(Shares, KeepTheHighestValueWithinTheRangeOfWhatIsReceived) {
  for (const auto& [range, precision] :
       {std::pair("0 m .. 1 m", "0.1 m"), std::pair("0.1 m .. 0.7 m", "0.1 m"),
        std::pair("-1 m .. 1.1 m", "0.3 m"), std::pair("0 m .. 200 m", "0.8 m")}) {
    const ir::Mission mission =
        compiled(missionWith(std::string("share depth in ") + range + " precision " + precision +
                             " every 1 h\n" + kFound));
    const ir::Share& share = mission.shares.back();
    ASSERT_EQ(share.name, "depth");
    EXPECT_EQ(mission[share.peer].highest, share.lowest + (share.values - 1) * share.step) << range;
  }
}

TEST(Shares, NothingIsAssumedAboutWhatIsReceived) {
  for (const char* assumed :
       {"assume peer.depth < 9 m\n", "assume known(peer.depth)\n",
        "assume missiontime < 9 h || peer.depth < 9 m\n", "assume age(peer.depth) < 1 h\n"}) {
    FrontendRun run(missionWith(kDepth + kFound + assumed));
    EXPECT_FALSE(run.compile().has_value()) << assumed;
    EXPECT_TRUE(run.says(support::diagnostics::assumptionReads)) << run.said();
  }
  for (const char* assumed :
       {"assume peer.depth in 0 m .. 9 m\n", "assume peer.depth changes <= 1 m/s\n",
        "assume known peer.depth every 1 h\n"}) {
    FrontendRun run(missionWith(kDepth + kFound + assumed));
    const auto file = run.parse();
    EXPECT_FALSE(file.has_value() && run.compile().has_value()) << assumed;
  }
}

// rejects: GL5217
// accepts: GL5217
TEST(Shares, NeedAModem) {
  auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  ASSERT_TRUE(platform.has_value());
  for (const bool modem : {true, false}) {
    FrontendRun run(missionWith(kDepth + kFound));
    const uint32_t library =
        run.sources.add("standard.mission", readSource("missions/library/standard.mission"));
    const auto standard = parse(run.sources, library, run.diagnostics);
    const auto mission = run.parse();
    if (!modem) {
      platform->modem.reset();
    }
    EXPECT_EQ(
        analyse(*mission, {*platform, {&*standard}, run.sources}, run.diagnostics).has_value(),
        modem)
        << run.said();
    EXPECT_EQ(run.says(support::diagnostics::noModem), !modem);
  }
}

}  // namespace
}  // namespace glider::frontend
