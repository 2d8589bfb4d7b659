// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/outage_watch.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace glider::flights {
namespace {

using Times = std::vector<double>;
using Span = std::pair<double, double>;

/// The outages of an SBC that starts as often as there are lists of mission times, by poll.
std::vector<Span> outagesOf(const std::vector<Times>& starts) {
  OutageWatch watch;
  for (size_t start = 1; start <= starts.size(); ++start) {
    for (const double time : starts[start - 1]) {
      watch.look(start, time, 0, 0);
    }
  }
  std::vector<Span> found;
  for (const Outage& outage : watch.found()) {
    found.emplace_back(outage.from_s, outage.to_s);
  }
  return found;
}

TEST(OutageWatch, LostTicksAreNoOutage) {
  EXPECT_TRUE(outagesOf({{0, 4, 60, 60, 64}}).empty());
}

TEST(OutageWatch, EndsWithTheFirstTickAfterARestart) {
  EXPECT_EQ(outagesOf({{0, 4, 8}, {90, 94}}), (std::vector<Span>{{8, 90}}));
}

/// Until the vehicle has said how things stand, the SBC shows the time of its checkpoint.
TEST(OutageWatch, EndsAfterPollsWithoutATick) {
  EXPECT_EQ(outagesOf({{0, 4, 8}, {4, 4, 90, 94}}), (std::vector<Span>{{8, 90}}));
  EXPECT_EQ(outagesOf({{0, 4, 8}, {8, 90}, {90}, {90, 200}}),
            (std::vector<Span>{{8, 90}, {90, 200}}));
}

TEST(OutageWatch, AMissionThatBeginsAnewHasHadNone) {
  EXPECT_TRUE(outagesOf({{0, 4, 8}, {0, 0, 4, 8, 12, 60}}).empty());
  EXPECT_EQ(outagesOf({{0, 4, 80}, {0, 4}, {4, 40}}), (std::vector<Span>{{4, 40}}));
}

}  // namespace
}  // namespace glider::flights
