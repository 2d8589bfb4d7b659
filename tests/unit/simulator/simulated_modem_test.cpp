// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The simulated Micro-Modem, by the sentences that it exchanges with its host.

#include "simulator/acoustics/simulated_modem.h"

#include "tests/unit/simulator/test_modem.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

namespace micro_modem = hooks::micro_modem;
using Lines = std::vector<std::string>;

/// Some modems at one place, each with a host that is a test.
class ModemBench : public ::testing::Test {
 protected:
  ModemBench() { build(1); }

  /// Begins again, with other random numbers.
  void build(uint64_t seed) {
    channel_ = std::make_shared<Channel>(seed);
    modems_.clear();
    said_.assign(3, "");
    drawn_J_.assign(3, 0);
    now_s_ = 0;
    powered_.assign(3, true);
    for (uint32_t i = 0; i < 3; ++i) {
      channel_->place(i, {10.0 * i, 0, 0});
      modems_.push_back(std::make_unique<SimulatedModem>(kTestModem, channel_, i));
    }
    run(0.25);
  }

  void run(double seconds) {
    for (const double until_s = now_s_ + seconds; now_s_ < until_s; now_s_ += 0.25) {
      for (size_t i = 0; i < modems_.size(); ++i) {
        if (powered_[i]) {
          const std::vector<uint8_t> bytes = modems_[i]->toHost(now_s_);
          said_[i].append(bytes.begin(), bytes.end());
        }
        drawn_J_[i] += modems_[i]->step(now_s_, powered_[i]);
      }
    }
  }

  template <typename Message>
  void tell(size_t modem, const Message& message) {
    char text[micro_modem::kMostSentence];
    const uint32_t size = encode(message, text, sizeof text);
    ASSERT_NE(size, 0U);
    modems_[modem]->fromHost({reinterpret_cast<const uint8_t*>(text), size}, now_s_);
  }

  /// The bodies of what a modem has said since the last call.
  Lines said(size_t modem) {
    hooks::SentenceReader reader;
    Lines bodies;
    for (const char c : said_[modem]) {
      if (reader.push(static_cast<uint8_t>(c))) {
        bodies.emplace_back(reader.body(), reader.size());
      }
    }
    EXPECT_EQ(reader.bad(), 0U);
    said_[modem].clear();
    return bodies;
  }

  void address(size_t modem) {
    tell(modem, micro_modem::SetSetting{hooks::textOf("SRC"), static_cast<uint32_t>(modem + 1)});
    run(1);
  }

  micro_modem::Transmit hello(size_t modem, uint32_t destination = 0) {
    micro_modem::Transmit transmit{static_cast<uint32_t>(modem + 1), destination, false, {}};
    transmit.data = {{0x0A, 0xB0}, 2};
    return transmit;
  }

  void start(size_t modem, uint32_t destination = 0) {
    tell(modem,
         micro_modem::StartCycle{static_cast<uint32_t>(modem + 1), destination, 0, false, 1});
    run(0.75);
  }

  /// The whole of a message, but not its end.
  void send(size_t modem, uint32_t destination = 0) {
    start(modem, destination);
    tell(modem, hello(modem, destination));
    run(0.5);
  }

  /// All three with their addresses, and a seed with which their first frames are not faint.
  void buildClear() {
    for (uint64_t seed = 1;; ++seed) {
      build(seed);
      uint32_t received = 0;
      for (size_t i = 0; i < 3; ++i) {
        address(i);
        send(i);
        run(10);
      }
      for (size_t i = 0; i < 3; ++i) {
        received += modems_[i]->totals().received;
      }
      if (received == 6) {
        build(seed);
        for (size_t i = 0; i < 3; ++i) {
          address(i);
          said(i);
        }
        return;
      }
    }
  }

  std::vector<News> news(size_t modem) { return std::exchange(modems_[modem]->news(), {}); }

  std::shared_ptr<Channel> channel_;
  std::vector<std::unique_ptr<SimulatedModem>> modems_;
  std::vector<bool> powered_;
  std::vector<std::string> said_;
  std::vector<double> drawn_J_;
  double now_s_ = 0;
};

TEST_F(ModemBench, ItTakesItsAddress) {
  address(0);
  EXPECT_EQ(said(0), Lines({"CACFG,SRC,1"}));
  tell(0, micro_modem::SetSetting{hooks::textOf("SRC"), 16});
  tell(0, micro_modem::SetSetting{hooks::textOf("SRC"), 0});
  tell(0, micro_modem::SetSetting{hooks::textOf("BND"), 1});
  run(1);
  EXPECT_EQ(said(0), Lines({"CAERR,000001,CFG", "CAERR,000001,CFG", "CAERR,000001,CFG"}));
}

TEST_F(ModemBench, AMessageGoesFromOneToAll) {
  buildClear();
  start(0);
  EXPECT_EQ(said(0), Lines({"CACYC,0,1,0,0,0,1", "CADRQ,000003,1,0,0,32,1"}));
  tell(0, hello(0));
  run(5.75);  // it has the answer in the next step
  EXPECT_EQ(said(0), Lines());
  run(0.5);
  EXPECT_EQ(said(0), Lines({"CATXF,2"}));
  run(1);
  for (const size_t receiver : {1U, 2U}) {
    EXPECT_EQ(said(receiver), Lines({"CACYC,0,1,0,0,0,1", "CARXD,1,0,0,1,0AB0"}));
    EXPECT_EQ(modems_[receiver]->totals().received, 1U);
    EXPECT_EQ(modems_[receiver]->totals().sent, 0U);
    const std::vector<News> heard = news(receiver);
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(textOf(support::makeEvent(0, heard[0].id, heard[0].values)),
              "received 2 bytes from 1");
  }
  EXPECT_EQ(modems_[0]->totals().sent, 1U);
  EXPECT_EQ(modems_[0]->totals().received, 0U);
  EXPECT_EQ(modems_[0]->totals().on_air_s, 5.5);
  const std::vector<News> told = news(0);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(textOf(support::makeEvent(0, told[0].id, told[0].values)), "sent 2 bytes to all");
}

TEST_F(ModemBench, AMiniPacketGoesWithoutACycle) {
  buildClear();
  const double before_J = drawn_J_[0], heard_J = drawn_J_[1];
  const double begin_s = now_s_;
  tell(0, micro_modem::SendMiniPacket{1, 0, 0x123});
  run(0.75);
  EXPECT_EQ(said(0), Lines({"CAMUC,1,0,0123"}));
  tell(0, micro_modem::SendMiniPacket{1, 0, 0x124});  // it is busy for 1.5 s
  tell(0, micro_modem::StartCycle{1, 0, 0, false, 1});
  run(0.75);
  ASSERT_EQ(said(0).size(), 2U);
  run(2);
  EXPECT_EQ(said(0), Lines()) << "its end is not said";
  for (const size_t receiver : {1U, 2U}) {
    EXPECT_EQ(said(receiver), Lines({"CAMUA,1,0,0123"}));
    const std::vector<News> heard = news(receiver);
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(textOf(support::makeEvent(0, heard[0].id, heard[0].values)),
              "received a mini packet from 1");
  }
  const std::vector<News> told = news(0);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(textOf(support::makeEvent(0, told[0].id, told[0].values)), "sent a mini packet to all");
  EXPECT_EQ(modems_[0]->totals().sent, 1U);
  EXPECT_EQ(modems_[0]->totals().on_air_s, 1.5);
  const double listened_J = kTestModem.listen_W * (now_s_ - begin_s);
  EXPECT_NEAR(drawn_J_[0] - before_J, kTestModem.send_mini_J + listened_J, 1e-9);
  EXPECT_NEAR(drawn_J_[1] - heard_J, kTestModem.receive_mini_J + listened_J, 1e-9);
  tell(0, micro_modem::SendMiniPacket{1, 3, 0x125});
  run(3);
  EXPECT_EQ(said(1), Lines()) << "it is for the third";
  EXPECT_EQ(said(0), Lines({"CAMUC,1,3,0125"})) << "it is idle again";
}

TEST_F(ModemBench, AMessageToOneIsNotGivenToAnother) {
  buildClear();
  send(0, 3);
  run(10);
  EXPECT_EQ(said(1), Lines({"CACYC,0,1,3,0,0,1"}));
  EXPECT_EQ(said(2), Lines({"CACYC,0,1,3,0,0,1", "CARXD,1,3,0,1,0AB0"}));
  EXPECT_EQ(modems_[1]->totals().received + modems_[1]->totals().lost, 0U);
  EXPECT_EQ(modems_[2]->totals().received, 1U);
}

TEST_F(ModemBench, WhatItDoesNotDoIsRefused) {
  buildClear();
  const micro_modem::StartCycle cycles[] = {
      {2, 0, 0, false, 1}, {1, 0, 1, false, 1}, {1, 0, 0, true, 1}, {1, 0, 0, false, 2}};
  for (const micro_modem::StartCycle& cycle : cycles) {
    tell(0, cycle);
    run(1);
    const Lines lines = said(0);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].ends_with(",CYC")) << lines[0];
  }
  tell(0, hello(0));                                  // nothing asked for it
  tell(0, micro_modem::MiniPacketReceived{1, 2, 3});  // of a modem
  tell(0, micro_modem::SendMiniPacket{2, 0, 3});      // of another address
  run(1);
  const Lines lines = said(0);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_TRUE(lines[0].ends_with(",TXD")) << lines[0];
  EXPECT_TRUE(lines[1].ends_with(",NMEA")) << lines[1];
  EXPECT_TRUE(lines[2].ends_with(",MUC")) << lines[2];
  start(0);
  tell(0, hello(0, 2));  // of another destination
  tell(0, hello(1));     // of another source
  run(1);
  EXPECT_EQ(said(0).size(), 4U);
  EXPECT_EQ(modems_[0]->totals().sent, 0U);
  run(10);
  EXPECT_EQ(said(1), Lines());
}

TEST_F(ModemBench, WithoutAnAddressItSendsNothing) {
  tell(0, micro_modem::StartCycle{0, 0, 0, false, 1});
  run(1);
  EXPECT_EQ(said(0), Lines({"CAERR,000000,CYC"}));
}

TEST_F(ModemBench, ItWaitsForTheDataForTwoSeconds) {
  buildClear();
  start(0);
  said(0);
  run(3);
  const Lines lines = said(0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].ends_with(",DTO")) << lines[0];
  send(0);
  EXPECT_EQ(modems_[0]->totals().sent, 1U) << "and can then start again";
}

TEST_F(ModemBench, EmptyDataEndTheCycle) {
  buildClear();
  start(0);
  said(0);
  micro_modem::Transmit nothing = hello(0);
  nothing.data.size = 0;
  tell(0, nothing);
  run(10);
  EXPECT_EQ(said(0), Lines());
  EXPECT_EQ(said(1), Lines());
  EXPECT_EQ(modems_[0]->totals().sent, 0U);
}

TEST_F(ModemBench, WhileItSendsItStartsNoCycle) {
  buildClear();
  send(0);
  said(0);
  start(0);
  const Lines lines = said(0);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines[0].ends_with(",CYC")) << lines[0];
  run(10);
  EXPECT_EQ(modems_[0]->totals().sent, 1U);
}

TEST_F(ModemBench, TwoThatSendAtOnceAreLostAndCounted) {
  buildClear();
  for (const size_t sender : {0U, 1U}) {
    tell(sender, micro_modem::StartCycle{static_cast<uint32_t>(sender + 1), 0, 0, false, 1});
  }
  run(0.75);
  for (const size_t sender : {0U, 1U}) {
    tell(sender, hello(sender));
  }
  run(10);
  EXPECT_EQ(said(2), Lines()) << "not even announced";
  EXPECT_EQ(modems_[2]->totals().lost, 2U);
  EXPECT_EQ(modems_[0]->totals().lost, 1U);
  const std::vector<News> lost = news(2);
  ASSERT_EQ(lost.size(), 2U);
  EXPECT_EQ(textOf(support::makeEvent(0, lost[0].id, lost[0].values)),
            "lost a message from 2: collision")
      << "the nearer of the two ends first";
}

TEST_F(ModemBench, ADamagedFrameIsReportedIfItWasAnnounced) {
  buildClear();
  send(0);
  run(1.75);
  send(1);  // over the frame, not over its announcement
  run(10);
  EXPECT_EQ(said(2), Lines({"CACYC,0,1,0,0,0,1", "CAMSG,BAD_CRC,1"}));
  EXPECT_EQ(modems_[2]->totals().lost, 2U);
  for (const std::string& line : said(1)) {
    EXPECT_FALSE(line.starts_with("CAMSG")) << "who sends does not listen";
  }
}

TEST_F(ModemBench, SlotsThatDoNotOverlapLoseNothingByCollision) {
  buildClear();
  for (int round = 0; round < 20; ++round) {
    for (size_t i = 0; i < 3; ++i) {
      send(i);
      run(8.75);  // a slot of 10 s
    }
  }
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(modems_[i]->totals().sent, 20U);
    EXPECT_EQ(modems_[i]->totals().received + modems_[i]->totals().lost, 40U);
    EXPECT_GT(modems_[i]->totals().received, 30U);
    for (const News& one : news(i)) {
      if (one.id == EventId::MessageLost) {
        EXPECT_EQ(std::get<std::string>(one.values[1]), "faint");
      }
    }
  }
}

TEST_F(ModemBench, ItsEnergyIsThatOfWhatItDid) {
  buildClear();
  const double begin_s = now_s_;
  const std::vector<double> before_J = drawn_J_;
  send(0);
  run(10);
  const double listen_J = 0.5 * (now_s_ - begin_s);
  EXPECT_NEAR(drawn_J_[0] - before_J[0], listen_J + 16, 1e-9);
  EXPECT_NEAR(drawn_J_[1] - before_J[1], listen_J + 8, 1e-9);
  EXPECT_EQ(modems_[0]->totals().sent_J, 16);
  EXPECT_EQ(modems_[0]->totals().received_J, 0);
  EXPECT_EQ(modems_[1]->totals().received_J, 8);
  EXPECT_NEAR(drawn_J_[1], modems_[1]->totals().listen_J + 8, 1e-9);
  // It listens to a frame for another, too.
  send(0, 3);
  run(10);
  EXPECT_EQ(modems_[1]->totals().received_J, 16);
}

TEST_F(ModemBench, WithoutPowerItDoesNothing) {
  buildClear();
  send(0);
  powered_[1] = false;
  const double before_J = drawn_J_[1];
  run(4);
  EXPECT_EQ(drawn_J_[1], before_J);
  powered_[1] = true;  // too late for this frame
  run(4);
  EXPECT_NEAR(drawn_J_[1] - before_J, 0.5 * 3.75, 1e-9) << "from the step in which it comes on";
  EXPECT_EQ(modems_[1]->totals().received, 0U);
  EXPECT_EQ(modems_[1]->totals().lost, 1U);
  EXPECT_EQ(said(1), Lines());
  const std::vector<News> lost = news(1);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(std::get<std::string>(lost[0].values[1]), "the modem had no power");
  said(0);
  send(1);  // it has kept its address
  EXPECT_EQ(modems_[1]->totals().sent, 1U);
}

TEST_F(ModemBench, ACycleDoesNotOutliveThePower) {
  buildClear();
  start(0);
  powered_[0] = false;
  run(0.5);
  powered_[0] = true;
  run(0.25);
  said(0);
  tell(0, hello(0));
  run(1);
  EXPECT_EQ(modems_[0]->totals().sent, 0U);
}

}  // namespace
}  // namespace glider::simulator
