// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Certificates that are a run: no vehicle flies the forged ones.

#include "tests/certificates/issued.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <string>

namespace glider::tests {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kReaching = R"(mission reaching
resume within 1 min

assume temp in 2 degC .. 28 degC
assume start depth <= 2 m

require reach warm
require reach late
require reach below

state look
begin
  flightprofile yo(5 m, 20 m, 26 deg, 26 deg)
  sensors       missiontime, depth, temp
  events
    case temp > 20 degC        goto warm
    case depth > 20 m          goto below
    case missiontime >= 10 min goto late
end

state warm
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end

state below
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end

state late
begin
  flightprofile surfaced
  sensors       statetime
  events
    case statetime >= 10 min exit
end
)";

enum RunRequirements : uint32_t { kWarm, kLate, kBelow };

class CertifiedRuns : public testing::Test {
 protected:
  static const Issued& reaching() {
    static const Issued issued = issue(kReaching);
    return issued;
  }

  /// A run that a certificate could have.
  struct Run {
    json file;
    explicit Run(uint32_t requirement) : file(json::parse(reaching().file(requirement))) {}
    [[nodiscard]] size_t columns() const { return file["run"]["columns"].size(); }
    [[nodiscard]] size_t rows() const { return file["run"]["rows"].size() / columns(); }
    [[nodiscard]] size_t column(const std::string& name) const {
      size_t i = 0;
      while (file["run"]["columns"].at(i)["name"] != name) {
        ++i;
      }
      return i;
    }
    json& at(size_t row, const std::string& name) {
      return file["run"]["rows"].at(row * columns() + column(name));
    }
    void setTime(size_t row, double time) { at(row, "time") = at(row, "missiontime") = time; }
    void setDepth(size_t row, double depth) {
      at(row, "true_depth") = depth;
      at(row, "m_depth") = depth;
    }
    /// Without all rows but the first ones.
    void keep(size_t count) {
      json& all = file["run"]["rows"];
      all.erase(all.begin() + static_cast<json::difference_type>(count * columns()), all.end());
    }
  };

  static analysis::Rechecked judged(uint32_t requirement, const Run& run) {
    return reaching().rechecked(requirement, run.file.dump());
  }
  static std::string reason(uint32_t requirement, const Run& run) {
    const analysis::Rechecked found = judged(requirement, run);
    return found.accepted ? "accepted" : found.reason;
  }
};

TEST_F(CertifiedRuns, ThoseOfTheProverAreAccepted) {
  for (const uint32_t requirement : {kWarm, kLate, kBelow}) {
    const analysis::Rechecked found = judged(requirement, Run(requirement));
    EXPECT_TRUE(found.accepted) << found.reason;
    EXPECT_TRUE(found.assumptions.empty()) << "they are flights under any assumptions";
  }
}

TEST_F(CertifiedRuns, AVehicleThatMovesTooFastIsRefused) {
  Run run(kLate);
  ASSERT_GT(run.rows(), 3U);
  run.setDepth(1, 150);
  EXPECT_THAT(reason(kLate, run), HasSubstr("no vehicle flies its run: at 4 s the vehicle is at"));
}

TEST_F(CertifiedRuns, AVehicleAboveTheSurfaceIsRefused) {
  Run run(kLate);
  run.at(1, "true_depth") = -0.5;
  run.at(1, "m_depth") = 0;
  EXPECT_THAT(reason(kLate, run), HasSubstr("the vehicle is at -0.5 m"));
}

TEST_F(CertifiedRuns, AVehicleThatStartsTooDeepIsRefused) {
  Run run(kLate);
  run.setDepth(0, 2.5);
  EXPECT_THAT(reason(kLate, run), HasSubstr("at 0 s the vehicle is at 2.5 m"));
}

TEST_F(CertifiedRuns, AVehicleDeeperThanItsCommandIsRefused) {
  Run run(kLate);
  for (size_t row = 0; row < run.rows(); ++row) {
    run.setDepth(row, std::min(1.2 * static_cast<double>(row), 26.0));
  }
  EXPECT_THAT(reason(kLate, run), HasSubstr("can only be between"));
}

TEST_F(CertifiedRuns, ADepthReadingFarFromTheDepthIsRefused) {
  Run run(kBelow);
  for (size_t row = 0; row < run.rows(); ++row) {
    run.at(row, "true_depth") = 0;
  }
  EXPECT_THAT(reason(kBelow, run), HasSubstr("at a depth of 0 m"));
}

TEST_F(CertifiedRuns, AGapThatNoOutageLeavesIsRefused) {
  Run run(kLate);
  run.keep(2);
  run.setTime(1, 3000);
  EXPECT_THAT(reason(kLate, run), HasSubstr("3000 s have passed since the tick before"));
}

TEST_F(CertifiedRuns, ClocksThatGoBackOrBeginLateAreRefused) {
  Run back(kLate);
  back.setTime(2, 2);
  EXPECT_THAT(reason(kLate, back), HasSubstr("goes back"));
  Run late(kLate);
  late.setTime(0, 4);
  EXPECT_THAT(reason(kLate, late), HasSubstr("not at mission time 0"));
  Run odd(kLate);
  odd.setTime(1, 4.1);
  EXPECT_THAT(reason(kLate, odd), HasSubstr("not one of the vehicle's clock"));
}

TEST_F(CertifiedRuns, AReadingOutsideOfItsRangeIsRefused) {
  Run run(kLate);
  run.at(1, "sci_water_temp") = 4000;
  EXPECT_THAT(reason(kLate, run), HasSubstr("outside of its range"));
}

TEST_F(CertifiedRuns, OneThatBreaksAnAssumptionIsRefused) {
  Run run(kWarm);
  run.at(run.rows() - 1, "sci_water_temp") = 40;
  EXPECT_THAT(reason(kWarm, run), HasSubstr("breaks the assumption `temp in 2 degC .. 28 degC`"));
}

TEST_F(CertifiedRuns, WithoutTheVehiclesDepthIsRefused) {
  Run run(kWarm);
  run.file["run"]["columns"].at(run.column("true_depth"))["name"] = "some_depth";
  EXPECT_THAT(reason(kWarm, run), HasSubstr("how deep"));
  Run unknown(kWarm);
  unknown.at(0, "true_depth") = nullptr;
  EXPECT_NE(reason(kWarm, unknown), "accepted");
}

}  // namespace
}  // namespace glider::tests
