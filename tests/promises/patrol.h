// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/load_platform.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::tests {

inline const platforms::Platform& slocum() {
  static const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *platform;
}

/// A mission that looks at the bottom for an hour, with `lines` at its head.
inline std::string patrol(const std::string& lines) {
  return "mission patrol\n" + lines + R"(
state look
begin
  flightprofile yo(5 m, 25 m, 26 deg, 26 deg)
  sensors       missiontime, altitude, temp, pressure
  events
    case altitude < 5 m && missiontime < 1 h call up
    case missiontime >= 1 h                  exit
end
state up
begin
  flightprofile surfaced
  sensors       altitude, statetime
  events
    case altitude > 20 m && statetime > 1 min return
end
)";
}

/// Fails the test if it has errors.
inline ir::Mission compiled(const std::string& text) {
  frontend::testing_support::FrontendRun run(text);
  auto mission = run.compile();
  EXPECT_TRUE(mission.has_value()) << run.said();
  return mission.value_or(ir::Mission());
}

}  // namespace glider::tests
