// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/extctl/depth_seen.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glider::runtime::extctl {
namespace {

/// From one depth to another by half a metre.
void fly(DepthSeen& seen, double from_m, double to_m) {
  for (double depth_m = from_m; std::fabs(depth_m - to_m) > 0.1;
       depth_m += to_m > from_m ? 0.5 : -0.5) {
    seen.look(depth_m);
  }
  seen.look(to_m);
}

TEST(DepthSeen, IsAsDeepAsTheLastDive) {
  DepthSeen seen(15);
  EXPECT_EQ(seen.deep(), 0);
  fly(seen, 0, 40);
  EXPECT_EQ(seen.deep(), 40) << "as soon as it is there";
  fly(seen, 40, 30);
  EXPECT_EQ(seen.deep(), 40);
  fly(seen, 30, 36);
  EXPECT_EQ(seen.deep(), 40) << "not over yet";
  fly(seen, 36, 34);
  EXPECT_EQ(seen.deep(), 36) << "something turned it";
}

TEST(DepthSeen, ForgetsWhatIsFarBelow) {
  DepthSeen seen(15);
  fly(seen, 0, 40);
  fly(seen, 40, 3);
  EXPECT_EQ(seen.deep(), 18);
  fly(seen, 3, 10);
  EXPECT_EQ(seen.deep(), 18);
  fly(seen, 10, 0.5);
  EXPECT_EQ(seen.deep(), 0) << "at the surface";
}

TEST(DepthSeen, NoiseAndSwellAreNoTurns) {
  DepthSeen seen(15);
  fly(seen, 0, 40);
  fly(seen, 40, 30);
  for (double depth_m = 30; depth_m < 38; depth_m += 0.25) {
    seen.look(depth_m + (std::fmod(depth_m, 0.5) == 0 ? 0.7 : 0));
  }
  EXPECT_EQ(seen.deep(), 40);
  seen.look(NAN);
  EXPECT_EQ(seen.deep(), 40);
}

}  // namespace
}  // namespace glider::runtime::extctl
