// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission of 10,000 states compiles; bench/frontend has its time. The file is of ordinary size:
// accepts: GL1028 GL1029

#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

std::string bigMission(int states) {
  std::string text = "mission big\n";
  for (int i = 0; i < states; ++i) {
    text += fmt::format(
        "state s{0}\nbegin\n  flightroute nav(39.175 N, 73.830 W)\n  flightprofile yo(5 m, 20 m, "
        "26 deg, 26 deg)\n"
        "  sensors missiontime, depth, pitch, temp every 8 s\n  events\n"
        "    case missiontime >= {0} && depth < 5 m || !(temp > 15 degC) goto s{1}\n"
        "    case clamp(depth, 3 m, 24 m) - 6 m > 2 * depth call s{2}\nend\n",
        i, (i + 1) % states, (i * 7) % states);
  }
  return text;
}

#ifdef __SANITIZE_ADDRESS__
constexpr int kStates = 1000;
#else
constexpr int kStates = 10'000;
#endif

TEST(LargeMission, TenThousandStatesAreAllThere) {
  FrontendRun run(bigMission(kStates));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value());
  EXPECT_EQ(mission->states.size(), size_t{kStates});
}

}  // namespace
}  // namespace glider::frontend
