// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Checks of a flight that see nothing would be worse than none.

#include "vehicles/lauv/lauv_judge.h"

#include "hooks/imc/codec.h"
#include "hooks/imc/values.h"
#include "platforms/load/load_platform.h"
#include "simulator/flight_observer.h"
#include "simulator/seat/sensor_array.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace glider::lauv {
namespace {

using namespace hooks::imc;
using simulator::JudgeId;
using simulator::Verdict;

constexpr simulator::FloatingPromise kPromise{
    .greatest_depth_m = 50, .overshoot_m = 4.5, .lets_go_s = 18, .turn_s = 45, .rises_m_s = 0.05};

const platforms::Platform& lauv() {
  static const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/lauv.toml");
  return *platform;
}

Reference referenceTo(double depth_m) {
  Reference reference;
  reference.flags = ReferenceFlag::Location | ReferenceFlag::Speed | ReferenceFlag::Z;
  reference.speed = {true, {.value = 1.2, .speed_units = SpeedUnits::MetresPerSecond}};
  reference.z = {true, {.value = static_cast<float>(depth_m), .z_units = ZUnits::Depth}};
  return reference;
}

/// A flight that is looked at each second.
struct JudgedFlight {
  LauvJudge judge{kPromise};
  simulator::SensorArray array{lauv()};
  double now_s = 0;
  bool goes_on = true;

  template <typename Message>
  void says(const Message& message) {
    std::array<uint8_t, kMostPacket> bytes;
    const uint32_t size = encode(Header{.time_s = 1.7e9 + now_s, .source = 0x4001}, message,
                                 bytes.data(), static_cast<uint32_t>(bytes.size()));
    ASSERT_GT(size, 0U);
    judge.said({bytes.data(), size}, now_s);
  }
  void second(double depth_m) {
    now_s += 1;
    goes_on = judge.cycle({.time_s = now_s, .true_depth_m = depth_m, .array = array});
  }
  void follow(double told_m, double depth_m, int seconds) {
    for (int i = 0; i < seconds; ++i) {
      says(referenceTo(told_m));
      second(depth_m);
    }
  }
  void stop() {
    PlanControl request;
    request.op = PlanOperation::Stop;
    says(request);
  }
  [[nodiscard]] bool violates(JudgeId id) const {
    const Verdict verdict = judge.verdict();
    return verdict.violations.size() == 1 && verdict.violations.front().judge == id &&
           verdict.outcome == Verdict::Outcome::Violation && !verdict.violation.empty();
  }
  [[nodiscard]] bool isFine() const { return judge.verdict().violations.empty(); }
};

TEST(LauvJudge, AFlightToItsEndIsFine) {
  JudgedFlight flight;
  flight.follow(20, 19, 100);
  flight.follow(50, 54.4, 100);
  flight.follow(0, 0.5, 10);
  EXPECT_TRUE(flight.goes_on);
  flight.stop();
  int seconds = 0;
  for (; flight.goes_on && seconds < 1000; ++seconds) {
    flight.second(0.2);
  }
  EXPECT_LE(seconds, 61);
  EXPECT_TRUE(flight.isFine());
  EXPECT_EQ(flight.judge.verdict().outcome, Verdict::Outcome::Exited);
  EXPECT_EQ(flight.judge.verdict().instructions, 210U);
}

TEST(LauvJudge, SeesAReferenceThatTheVehicleWouldNotObey) {
  std::vector<Reference> wrong;
  for (const double depth_m : {50.1, 1000.0, static_cast<double>(NAN)}) {
    wrong.push_back(referenceTo(depth_m));
  }
  for (const int flag : {ReferenceFlag::Location, ReferenceFlag::Speed, ReferenceFlag::Z}) {
    wrong.push_back(referenceTo(20));
    wrong.back().flags = static_cast<uint8_t>(wrong.back().flags & ~flag);
  }
  wrong.push_back(referenceTo(20));
  wrong.back().z.present = false;
  wrong.push_back(referenceTo(20));
  wrong.back().speed.present = false;
  wrong.push_back(referenceTo(20));
  wrong.back().z.value.z_units = ZUnits::Altitude;
  for (const Reference& reference : wrong) {
    JudgedFlight flight;
    flight.follow(20, 10, 5);
    EXPECT_TRUE(flight.isFine());
    flight.says(reference);
    EXPECT_TRUE(flight.violates(JudgeId::Commands)) << &reference - wrong.data();
  }
}

TEST(LauvJudge, SeesADepthBeyondTheDeepestReference) {
  JudgedFlight flight;
  flight.follow(20, 24.4, 100);
  EXPECT_TRUE(flight.isFine());
  flight.follow(10, 24.6, 1);
  EXPECT_TRUE(flight.violates(JudgeId::Depth));
  JudgedFlight none;
  none.second(0.9);
  EXPECT_TRUE(none.isFine());
  none.second(4.6);
  EXPECT_TRUE(none.violates(JudgeId::Depth)) << "it was never sent down";
}

/// The depth `silent_s` after the last Reference.
template <typename Depth>
JudgedFlight silentFlight(Depth depth) {
  JudgedFlight flight;
  flight.follow(20, 20, 100);
  for (int silent_s = 1; silent_s < 800; ++silent_s) {
    flight.second(depth(silent_s));
  }
  return flight;
}

TEST(LauvJudge, SeesAVehicleThatDoesNotComeUpWithoutReferences) {
  EXPECT_TRUE(silentFlight([](int) { return 20.0; }).violates(JudgeId::Ascent))
      << "a seat that ignores the time-out";
  EXPECT_TRUE(
      silentFlight([](int s) { return std::fmax(0, 20 - 0.02 * s); }).violates(JudgeId::Ascent))
      << "too slow";
  EXPECT_TRUE(
      silentFlight([](int s) { return s < 300 ? 20 - 0.05 * s : 6.0; }).violates(JudgeId::Ascent))
      << "it stays on the way";
  const JudgedFlight fine = silentFlight(
      [](int s) { return s < 60 ? 20 + 0.05 * s : std::fmax(0, 23 - 0.06 * (s - 60)); });
  EXPECT_TRUE(fine.isFine());
  EXPECT_EQ(fine.judge.verdict().outcome, Verdict::Outcome::Released);
  EXPECT_EQ(fine.judge.verdict().releases, 1U);
}

/// The depth `told_s` after the first Reference to `told_m`, which are given all the time.
template <typename Depth>
JudgedFlight risingFlight(double told_m, int seconds, Depth depth) {
  JudgedFlight flight;
  flight.follow(20, 20, 100);
  for (int told_s = 1; told_s <= seconds; ++told_s) {
    flight.follow(told_m, depth(told_s), 1);
  }
  return flight;
}

TEST(LauvJudge, SeesAVehicleThatDoesNotObeyAReferenceAboveIt) {
  const auto stays = [](int) { return 20.0; };
  EXPECT_TRUE(risingFlight(0, 150, stays).isFine()) << "by then it need not be higher";
  EXPECT_TRUE(risingFlight(0, 160, stays).violates(JudgeId::Ascent));
  EXPECT_TRUE(risingFlight(10, 160, stays).violates(JudgeId::Ascent));
  EXPECT_TRUE(risingFlight(16, 1000, stays).isFine()) << "it is within the overshoot";
  const auto slow = [](int s) { return std::fmax(0, 20 - 0.02 * s); };
  EXPECT_TRUE(risingFlight(0, 800, slow).violates(JudgeId::Ascent));
  const auto stops = [](int s) { return std::fmax(3, 20 - 0.2 * s); };
  EXPECT_TRUE(risingFlight(0, 800, stops).violates(JudgeId::Ascent)) << "3 m are not the surface";
  const auto rises = [](int s) { return s < 60 ? 20 : std::fmax(0, 20 - 0.06 * (s - 60)); };
  EXPECT_TRUE(risingFlight(0, 800, rises).isFine());
}

TEST(LauvJudge, ADepthThatIsGivenAgainCounts) {
  JudgedFlight flight;
  flight.follow(20, 20, 1);
  for (int turn = 0; turn < 20; ++turn) {
    flight.follow(0, 20, 100);
    flight.follow(20, 20, 1);
  }
  EXPECT_TRUE(flight.isFine()) << "each time it may go there again";
}

TEST(LauvJudge, AFlightThatGoesOnAfterASilenceIsJudgedFromThen) {
  JudgedFlight flight;
  flight.follow(20, 20, 100);
  for (int silent_s = 0; silent_s < 40; ++silent_s) {
    flight.second(20);
  }
  flight.follow(40, 40, 300);
  for (int silent_s = 0; silent_s < 40; ++silent_s) {
    flight.second(40);
  }
  EXPECT_TRUE(flight.isFine()) << "the depth where it was silent before does not count";
  EXPECT_EQ(flight.judge.verdict().releases, 2U);
}

}  // namespace
}  // namespace glider::lauv
