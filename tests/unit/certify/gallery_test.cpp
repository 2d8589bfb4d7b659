// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The scripts of the example missions: cvc5 understands and decides each obligation.

#include "tests/unit/certify/judge.h"
#include "tests/unit/frontend/compile.h"
#include "tests/unit/ir/slocum.h"

#include <algorithm>
#include <filesystem>

namespace glider::ir::certify {
namespace {

std::vector<std::string> gallery() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(GLIDER_SOURCE_DIR "/missions/gallery")) {
    if (entry.path().extension() == ".mission") {
      names.push_back(entry.path().stem());
    }
  }
  std::ranges::sort(names);
  return names;
}

class Gallery : public testing::TestWithParam<std::string> {};

TEST_P(Gallery, IsUnderstoodAndDecided) {
  NEEDS_CVC5();
  const Mission mission = compiled(frontend::testing_support::readWithoutPromises(
                                       "missions/gallery/" + GetParam() + ".mission") +
                                   "require always depth <= 1000 m\n");
  // Whose depths are variables without ranges, of one state.
  const bool has_layer = GetParam() == "thermocline";
  const auto shallow = [&](const std::string& state) -> std::string {
    return has_layer && state == "`track`"
               ? "(and (<= |deepest| 1000.0) (<= |var track.upper| 28.0) "
                 "(<= |var track.lower| 28.0))"
               : "(<= |deepest| 1000.0)";
  };
  const std::vector<Invariant> invariants = invariantsOf(mission, shallow);
  const auto scripts =
      obligationsOf(mission, slocum(), mission.requirements.at(0), invariants, 300);
  EXPECT_EQ(refused(scripts), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(Missions, Gallery, testing::ValuesIn(gallery()),
                         [](const auto& row) { return row.param; });

}  // namespace
}  // namespace glider::ir::certify
