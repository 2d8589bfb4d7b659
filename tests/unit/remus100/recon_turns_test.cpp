// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Whose turn it is on a line of RECON in virtual time.

#include "simulator/ports/line_turns.h"
#include "tests/unit/remus100/sbc_lines.h"

#include <gtest/gtest.h>

#include <memory>

namespace glider::simulator {
namespace {

using glider::testing::lineOf;

struct Line {
  std::unique_ptr<LineTurns> turns = reconTurns();

  template <typename Message>
  bool toSbc(const Message& message) {
    const std::string line = lineOf(message);
    turns->toSbc(reinterpret_cast<const uint8_t*>(line.data()), static_cast<uint32_t>(line.size()));
    return turns->settled();
  }
  template <typename Message>
  bool fromSbc(const Message& message) {
    const std::string line = lineOf(message);
    turns->fromSbc(reinterpret_cast<const uint8_t*>(line.data()),
                   static_cast<uint32_t>(line.size()));
    return turns->settled();
  }
};

hooks::recon::State stateAt(double time_s) {
  hooks::recon::State state;
  state.time_s = time_s;
  return state;
}

TEST(ReconTurns, AStateOfANewSecondIsAnsweredByTheState) {
  Line line;
  EXPECT_TRUE(line.toSbc(stateAt(1))) << "without a date there is no cycle";
  EXPECT_TRUE(line.toSbc(hooks::recon::TimeSet{1.75e9}));
  EXPECT_FALSE(line.toSbc(stateAt(2)));
  EXPECT_FALSE(line.fromSbc(hooks::recon::KeepAlive()));
  EXPECT_FALSE(line.fromSbc(hooks::recon::SimulationText{hooks::recon::textOf("transition,1")}));
  EXPECT_TRUE(line.fromSbc(hooks::recon::SimulationText{hooks::recon::textOf("state,1,2")}));
  EXPECT_TRUE(line.toSbc(stateAt(2.5))) << "the same second";
  EXPECT_FALSE(line.toSbc(stateAt(3)));
  EXPECT_TRUE(line.fromSbc(hooks::recon::TimeQuery())) << "an SBC that has restarted";
}

}  // namespace
}  // namespace glider::simulator
