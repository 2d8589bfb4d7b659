// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Vehicles of a fleet whose SBCs talk by their modems.

#include "hooks/micro_modem/codec.h"
#include "simulator/fleet/fleet.h"
#include "simulator/simulator.h"
#include "tests/unit/simulator/fleet_traces.h"
#include "tests/unit/simulator/flights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

namespace micro_modem = hooks::micro_modem;

constexpr double kSlot_s = 20, kFlight_s = 600;

/// An SBC that knows nothing of the vehicle, and sends a message in each of its slots.
class TalkingSbc final : public SbcPort {
 public:
  TalkingSbc(uint32_t address, uint32_t vehicles) : address_(address), vehicles_(vehicles) {}

  [[nodiscard]] std::string way() const override { return "in-process"; }
  void setTime(double now_s) override { now_s_ = now_s; }
  void deliver(std::span<const uint8_t> /*bytes*/, double /*now_s*/) override {}
  std::vector<uint8_t> collect() override { return {}; }
  void kill() override { killed_ = true; }
  [[nodiscard]] bool alive() const override { return !killed_; }
  [[nodiscard]] std::string exitReason() const override { return killed_ ? "killed" : ""; }

  void hearModem(std::span<const uint8_t> bytes) override {
    for (const uint8_t byte : bytes) {
      micro_modem::DataRequest request;
      if (sentences_.push(byte) && decode(sentences_.text(), request)) {
        micro_modem::Transmit transmit{address_, 0, false, {}};
        transmit.data = {{1, 2, 3}, 3};
        say(transmit);
      }
    }
  }

  std::vector<uint8_t> toModem() override {
    const auto slot = static_cast<int64_t>(std::floor(now_s_ / kSlot_s));
    if (now_s_ == 0) {
      say(micro_modem::SetSetting{hooks::textOf("SRC"), address_});
    }
    if (slot != slot_ && slot % vehicles_ + 1 == address_ && slot > 0) {
      say(micro_modem::StartCycle{address_, 0, 0, false, 1});
    }
    slot_ = slot;
    return std::exchange(out_, {});
  }

 private:
  template <typename Message>
  void say(const Message& message) {
    char text[micro_modem::kMostSentence];
    const uint32_t size = encode(message, text, sizeof text);
    out_.insert(out_.end(), text, text + size);
  }

  uint32_t address_, vehicles_;
  double now_s_ = 0;
  int64_t slot_ = -1;
  hooks::SentenceReader sentences_;
  std::vector<uint8_t> out_;
  bool killed_ = false;
};

FleetMember member(uint32_t number, bool talks, double north_deg = 0, uint32_t vehicles = 3) {
  FleetMember member;
  member.setup = shippedSetup("shelf_slope");
  member.setup.scenario.latitude_deg += north_deg;
  member.setup.duration_s = kFlight_s;
  member.setup.sbc = std::make_unique<TalkingSbc>(number + 1, vehicles);
  member.setup.talks = talks;
  member.number = number;
  return member;
}

std::vector<support::Trace> flyInOrder(const std::vector<uint32_t>& order, bool talks = true) {
  std::vector<FleetMember> members;
  for (const uint32_t number : order) {
    members.push_back(member(number, talks, 0.002 * number));
  }
  auto flight = simulateFleet(shippedSetup("shelf_slope").scenario, std::move(members));
  EXPECT_TRUE(flight.has_value());
  return flight ? tracesOf(*flight) : std::vector<support::Trace>(order.size());
}

size_t count(const support::Trace& trace, EventId id) {
  size_t count = 0;
  for (const support::TraceEvent& event : trace.events) {
    count += event.id == id ? 1 : 0;
  }
  return count;
}

TEST(TalkingFleet, EachHearsTheOthersInTheirSlots) {
  const std::vector<support::Trace> traces = flyInOrder({0, 1, 2});
  uint32_t received = 0;
  for (const support::Trace& trace : traces) {
    ASSERT_TRUE(trace.acoustic);
    const support::AcousticTotals& totals = *trace.acoustic;
    EXPECT_GE(totals.sent, 9U);
    EXPECT_LE(totals.sent, 10U);
    EXPECT_GE(totals.received + totals.lost, 18U);
    EXPECT_LE(totals.received + totals.lost, 20U);
    EXPECT_EQ(totals.on_air_s, 5.5 * totals.sent);
    EXPECT_EQ(count(trace, EventId::MessageSent), totals.sent);
    EXPECT_EQ(count(trace, EventId::MessageReceived), totals.received);
    EXPECT_EQ(count(trace, EventId::MessageLost), totals.lost);
    for (const support::TraceEvent& event : trace.events) {
      if (event.id == EventId::MessageLost) {
        EXPECT_EQ(std::get<std::string>(event.values[1]), "faint");
      }
    }
    received += totals.received;
  }
  EXPECT_GT(received, 40U);
}

TEST(TalkingFleet, TheOrderOfTheVehiclesIsOfNoAccount) {
  const std::vector<support::Trace> one = flyInOrder({0, 1, 2});
  const std::vector<support::Trace> other = flyInOrder({2, 0, 1});
  for (const auto& [first, second] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 0U}}) {
    EXPECT_EQ(eventText(one[first]), eventText(other[second]));
    EXPECT_EQ(traceToCsv(one[first]), traceToCsv(other[second]));
  }
}

/// What the batteries have given by the last row, J.
double usedOf(const support::Trace& trace) {
  constexpr double kJoules = 3600;
  return trace.at(trace.rowCount() - 1, trace.column("energy")) * kJoules;
}

TEST(TalkingFleet, TheBatteryGivesTheEnergyOfTheModem) {
  const std::vector<support::Trace> quiet = flyInOrder({0, 1, 2}, false);
  const std::vector<support::Trace> talking = flyInOrder({0, 1, 2});
  constexpr double kFrame_J = 0.49 * 32;
  for (size_t i = 0; i < 3; ++i) {
    const support::AcousticTotals& totals = *talking[i].acoustic;
    EXPECT_NEAR(totals.sent_J, kFrame_J * totals.sent, 1e-6);
    EXPECT_NEAR(totals.received_J, kFrame_J * (totals.received + totals.lost), kFrame_J + 1e-6)
        << "the last one may be announced and not over";
    EXPECT_NEAR(totals.listen_J, 0.08 * kFlight_s, 0.1);
    const double all_J = totals.sent_J + totals.received_J + totals.listen_J;
    EXPECT_NEAR(usedOf(talking[i]) - usedOf(quiet[i]), all_J, kFrame_J + 1) << "after the last row";
  }
}

TEST(TalkingFleet, WithoutAModemInUseNothingChanges) {
  const std::vector<support::Trace> quiet = flyInOrder({0, 1, 2}, false);
  for (const support::Trace& trace : quiet) {
    EXPECT_FALSE(trace.acoustic);
    EXPECT_EQ(count(trace, EventId::MessageSent), 0U);
  }
  SimulationSetup alone = shippedSetup("shelf_slope");
  alone.duration_s = kFlight_s;
  alone.sbc = std::make_unique<TalkingSbc>(1, 3);
  EXPECT_EQ(traceToCsv(fly(std::move(alone))), traceToCsv(quiet[0]));
}

TEST(TalkingFleet, AVehicleAloneIsHeardByNobody) {
  FleetMember only = member(0, true, 0, 1);
  const support::Trace trace = fly(std::move(only.setup));
  ASSERT_TRUE(trace.acoustic);
  EXPECT_GT(trace.acoustic->sent, 20U);
  EXPECT_EQ(trace.acoustic->received + trace.acoustic->lost, 0U);
}

TEST(TalkingFleet, AVehicleWithoutAModemDoesNotTalk) {
  FleetMember only = member(0, true, 0, 1);
  only.setup.platform.modem.reset();
  EXPECT_FALSE(fly(std::move(only.setup)).acoustic);
}

TEST(TalkingFleet, NoiseAndAPowerCutOfTheScenarioReachTheModem) {
  FleetMember noisy = member(0, true);
  noisy.setup.scenario.faults.modem = {{0, kForever}};
  FleetMember cut = member(1, true);
  cut.setup.scenario.faults.power = {{100, kForever}};
  std::vector<FleetMember> members;
  members.push_back(std::move(noisy));
  members.push_back(std::move(cut));
  auto flight = simulateFleet(shippedSetup("shelf_slope").scenario, std::move(members));
  ASSERT_TRUE(flight);
  const std::vector<support::Trace> traces = tracesOf(*flight);
  const support::AcousticTotals& hidden = *traces[0].acoustic;
  EXPECT_GT(hidden.sent, 8U);
  EXPECT_EQ(hidden.received, 0U);
  EXPECT_GT(hidden.lost, 0U);
  EXPECT_NE(findEvent(traces[0], "lost a message from 2: noise"), nullptr);
  const support::AcousticTotals& short_lived = *traces[1].acoustic;
  EXPECT_EQ(short_lived.sent, 2U);
  EXPECT_NEAR(short_lived.listen_J, 0.08 * 100, 0.1);
}

}  // namespace
}  // namespace glider::simulator
