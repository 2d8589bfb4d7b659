// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A mission of 10,000 states compiles in seconds. The bounds are generous: they catch what grows
// with the square of the size, not a busy machine. The file is of ordinary size: accepts: GL1028
// accepts: GL1029

#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <chrono>

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

TEST(Speed, ManyStates) {
  FrontendRun run(bigMission(kStates));
  const auto start = std::chrono::steady_clock::now();
  const auto mission = run.compile();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  ASSERT_TRUE(mission.has_value());
  EXPECT_EQ(mission->states.size(), size_t{kStates});
  RecordProperty("seconds", fmt::format("{:.3f}", took.count()));
  fmt::print("{} states, {} bytes: {:.2f} s\n", kStates, run.sources.text(run.file).size(),
             took.count());
  EXPECT_LT(took.count(), 60);
}

}  // namespace
}  // namespace glider::frontend
