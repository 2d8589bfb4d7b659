// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The water between acoustic modems.

#include "simulator/acoustics/channel.h"

#include "tests/unit/simulator/test_modem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

constexpr double kLength_s = 5.5;

AcousticFrame frameOf(uint32_t source, uint8_t byte = 7) {
  AcousticFrame frame;
  frame.source = source;
  frame.data.bytes[0] = byte;
  frame.data.size = 1;
  return frame;
}

/// Places vehicles 0, 1, … on a line, m east.
void placeAll(Channel& channel, const std::vector<double>& east_m) {
  for (size_t i = 0; i < east_m.size(); ++i) {
    channel.place(static_cast<uint32_t>(i), {east_m[i], 0, 0});
  }
}

/// The frames that have ended at a vehicle.
std::vector<Reception> framesAt(Channel& channel, uint32_t vehicle, double now_s) {
  std::vector<Reception> all = channel.take(vehicle, now_s);
  std::erase_if(all, [](const Reception& one) { return !one.is_frame; });
  return all;
}

/// The first seed with which none of the first frames of three vehicles is faint.
uint64_t clearSeed() {
  for (uint64_t seed = 1;; ++seed) {
    Channel channel(seed);
    placeAll(channel, {0, 100, 200});
    bool clear = true;
    for (uint32_t sender = 0; sender < 3; ++sender) {
      for (uint32_t frame = 0; frame < 2; ++frame) {
        const double now_s = 100.0 * (sender * 2 + frame);
        channel.send(sender, now_s, frameOf(sender), kTestModem);
        for (uint32_t receiver = 0; receiver < 3; ++receiver) {
          for (const Reception& one : framesAt(channel, receiver, now_s + 50)) {
            clear = clear && one.loss == Loss::None;
          }
        }
      }
    }
    if (clear) {
      return seed;
    }
  }
}

Loss onlyLoss(Channel& channel, uint32_t vehicle, double now_s) {
  const std::vector<Reception> frames = framesAt(channel, vehicle, now_s);
  EXPECT_EQ(frames.size(), 1U);
  return frames.size() == 1 ? frames[0].loss : Loss::Off;
}

TEST(AcousticChannel, AFrameArrivesAfterTheTimeThatSoundNeeds) {
  Channel channel(clearSeed());
  channel.place(0, {0, 0, 10});
  channel.place(1, {300, 400, 1210});  // 1300 m away
  channel.send(0, 10, frameOf(1, 42), kTestModem);
  const double arrives_s = 10 + 1300 / 1500.0;
  EXPECT_TRUE(channel.take(1, arrives_s + 1.5 - 1e-6).empty());
  const std::vector<Reception> announced = channel.take(1, arrives_s + 1.5 + 1e-6);
  ASSERT_EQ(announced.size(), 1U);
  EXPECT_FALSE(announced[0].is_frame);
  EXPECT_EQ(announced[0].loss, Loss::None);
  EXPECT_NEAR(announced[0].begin_s, arrives_s, 1e-9);
  EXPECT_TRUE(channel.take(1, arrives_s + kLength_s - 1e-6).empty());
  const std::vector<Reception> ended = channel.take(1, arrives_s + kLength_s + 1e-6);
  ASSERT_EQ(ended.size(), 1U);
  EXPECT_TRUE(ended[0].is_frame);
  EXPECT_TRUE(ended[0].announced);
  EXPECT_EQ(ended[0].frame.source, 1U);
  EXPECT_EQ(ended[0].frame.data.bytes[0], 42);
  EXPECT_TRUE(channel.take(1, 100).empty());
  EXPECT_TRUE(channel.take(0, 100).empty()) << "the sender does not receive itself";
}

/// As long as an announcement, and without one.
TEST(AcousticChannel, AMiniPacketIsShort) {
  const uint64_t seed = clearSeed();
  AcousticFrame mini;
  mini.source = 1;
  mini.is_mini = true;
  mini.mini_bits = 0x155;
  Channel channel(seed);
  placeAll(channel, {0, 150});
  channel.send(0, 10, mini, kTestModem);
  EXPECT_TRUE(channel.take(1, 11.6 - 1e-6).empty());
  const std::vector<Reception> all = channel.take(1, 11.6 + 1e-6);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(all[0].is_frame);
  EXPECT_FALSE(all[0].announced);
  EXPECT_EQ(all[0].loss, Loss::None);
  EXPECT_EQ(all[0].frame.mini_bits, 0x155U);
  // Another frame meets it only while it is there.
  for (const auto& [second_s, loss] : {std::pair{21.0, Loss::Collision}, {21.75, Loss::None}}) {
    Channel crowded(seed);
    placeAll(crowded, {0, 0, 0});
    crowded.send(0, 20, mini, kTestModem);
    crowded.send(2, second_s, frameOf(3), kTestModem);
    const std::vector<Reception> met = framesAt(crowded, 1, 40);
    ASSERT_EQ(met.size(), 2U);
    EXPECT_EQ(met[0].loss, loss) << second_s;
    EXPECT_EQ(met[1].loss, loss) << second_s;
  }
}

TEST(AcousticChannel, BeyondTheRangeNothingIsReceived) {
  for (const auto& [east_m, received] :
       {std::pair{2000.0, 1U}, {2000.1, 0U}, {3000.0, 0U}, {5000.0, 0U}}) {
    Channel channel(1);
    placeAll(channel, {0, east_m});
    channel.send(0, 0, frameOf(1), kTestModem);
    EXPECT_EQ(framesAt(channel, 1, 60).size(), received) << east_m;
  }
}

TEST(AcousticChannel, WhoSendsReceivesNothing) {
  const uint64_t seed = clearSeed();
  // The frame of 0 is at 1, without a delay, from 10 to 15.5 s.
  for (const auto& [at_s, loss] : {std::pair{4.5, Loss::None},
                                   {4.75, Loss::Sending},
                                   {10.0, Loss::Sending},
                                   {15.25, Loss::Sending},
                                   {15.5, Loss::None}}) {
    Channel channel(seed);
    placeAll(channel, {0, 0});
    if (at_s < 10) {
      channel.send(1, at_s, frameOf(2), kTestModem);
    }
    channel.send(0, 10, frameOf(1), kTestModem);
    if (at_s >= 10) {
      channel.send(1, at_s, frameOf(2), kTestModem);
    }
    EXPECT_EQ(onlyLoss(channel, 1, 30), loss) << at_s;
  }
}

TEST(AcousticChannel, TwoFramesThatOverlapAtAThirdDestroyEachOther) {
  const uint64_t seed = clearSeed();
  for (const auto& [second_s, loss] : {std::pair{0.0, Loss::Collision},
                                       {5.25, Loss::Collision},
                                       {5.5, Loss::None},
                                       {20.0, Loss::None}}) {
    Channel channel(seed);
    placeAll(channel, {-100, 100, 0});
    channel.send(0, 0, frameOf(1), kTestModem);
    channel.send(1, second_s, frameOf(2), kTestModem);
    const std::vector<Reception> frames = framesAt(channel, 2, 60);
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_EQ(frames[0].loss, loss) << second_s;
    EXPECT_EQ(frames[1].loss, loss) << second_s;
  }
}

TEST(AcousticChannel, ACollisionIsSeenThoughTheOtherFrameHasBeenTaken) {
  Channel channel(clearSeed());
  placeAll(channel, {-100, 100, 0});
  channel.send(0, 0, frameOf(1), kTestModem);
  channel.send(1, 5, frameOf(2), kTestModem);
  EXPECT_EQ(onlyLoss(channel, 2, 6), Loss::Collision);
  EXPECT_EQ(onlyLoss(channel, 2, 12), Loss::Collision);
  // The same of what the receiver itself sent.
  channel.send(2, 20, frameOf(3), kTestModem);
  channel.send(0, 25, frameOf(1), kTestModem);
  EXPECT_TRUE(channel.take(2, 26).empty());
  EXPECT_EQ(onlyLoss(channel, 2, 40), Loss::Sending);
}

TEST(AcousticChannel, AFrameFromBeyondTheRangeDestroysToo) {
  const uint64_t seed = clearSeed();
  for (const auto& [east_m, loss] : {std::pair{-2900.0, Loss::Collision}, {-3001.0, Loss::None}}) {
    Channel channel(seed);
    placeAll(channel, {100, east_m, 0});
    channel.send(1, 0, frameOf(2), kTestModem);
    channel.send(0, 3, frameOf(1), kTestModem);
    EXPECT_EQ(onlyLoss(channel, 2, 60), loss) << east_m;
  }
}

TEST(AcousticChannel, AnAnnouncementCanBeReceivedWithoutItsFrame) {
  Channel channel(clearSeed());
  placeAll(channel, {0, 0, 0});
  channel.send(0, 0, frameOf(1), kTestModem);
  channel.send(1, 2, frameOf(2), kTestModem);
  const std::vector<Reception> all = channel.take(2, 60);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].loss, Loss::None);
  EXPECT_FALSE(all[0].is_frame);
  EXPECT_EQ(all[1].loss, Loss::Collision) << "the announcement of the second";
  EXPECT_EQ(all[2].loss, Loss::Collision);
  EXPECT_TRUE(all[2].announced);
  EXPECT_EQ(all[3].loss, Loss::Collision);
  EXPECT_FALSE(all[3].announced);
}

TEST(AcousticChannel, NoiseHidesWhatArrives) {
  const uint64_t seed = clearSeed();
  for (const auto& [when, loss] : {std::pair{Span{1, 2}, Loss::Jammed},
                                   {Span{5.4, 6}, Loss::Jammed},
                                   {Span{5.5, 6}, Loss::None}}) {
    Channel channel(seed);
    placeAll(channel, {0, 0, 0});
    channel.jam(1, {when});
    channel.send(0, 0, frameOf(1), kTestModem);
    EXPECT_EQ(onlyLoss(channel, 1, 60), loss);
    EXPECT_EQ(onlyLoss(channel, 2, 60), Loss::None) << "only at that vehicle";
  }
}

TEST(AcousticChannel, WhoIsOutOfTheWaterReceivesAndSendsNothing) {
  Channel channel(clearSeed());
  placeAll(channel, {0, 0, 0});
  channel.leave(1);
  channel.send(0, 0, frameOf(1), kTestModem);
  channel.send(1, 0, frameOf(2), kTestModem);
  EXPECT_TRUE(channel.take(1, 60).empty());
  EXPECT_EQ(onlyLoss(channel, 2, 60), Loss::None);
}

/// The share of 20 000 frames that is lost between two vehicles.
double lostShare(uint64_t seed, double east_m) {
  constexpr int kFrames = 20000;
  Channel channel(seed);
  placeAll(channel, {0, east_m});
  int lost = 0;
  for (int i = 0; i < kFrames; ++i) {
    channel.send(0, 10.0 * i, frameOf(1), kTestModem);
    lost += onlyLoss(channel, 1, 10.0 * i + 9) == Loss::Faint ? 1 : 0;
  }
  return static_cast<double>(lost) / kFrames;
}

TEST(AcousticChannel, FramesAreLostByChanceAndMoreOftenFarAway) {
  EXPECT_DOUBLE_EQ(faintLoss(0, 2000), 0.05);
  EXPECT_DOUBLE_EQ(faintLoss(1000, 2000), 0.05 + 0.45 / 4);
  EXPECT_DOUBLE_EQ(faintLoss(2000, 2000), 0.5);
  for (const double east_m : {0.0, 1000.0, 2000.0}) {
    const double expected = faintLoss(east_m, 2000);
    const double four_deviations = 4 * std::sqrt(expected * (1 - expected) / 20000);
    EXPECT_NEAR(lostShare(1, east_m), expected, four_deviations) << east_m;
    EXPECT_NEAR(lostShare(2, east_m), expected, four_deviations) << east_m;
  }
  EXPECT_NE(lostShare(1, 1000), lostShare(2, 1000));
}

/// All that several vehicles receive in a time in which they send at random moments; they take
/// their turns in this order in each step.
std::string storyOf(const std::vector<uint32_t>& order) {
  Channel channel(5);
  std::vector<std::string> stories(order.size());
  for (int step = 0; step < 4000; ++step) {
    const double now_s = step * 0.25;
    for (const uint32_t vehicle : order) {
      channel.place(vehicle, {400.0 * vehicle + 0.1 * step, 0, 10.0 * vehicle});
    }
    for (const uint32_t vehicle : order) {
      for (const Reception& one : channel.take(vehicle, now_s)) {
        stories[vehicle] += std::to_string(one.end_s) + (one.is_frame ? " frame " : " call ") +
                            std::to_string(one.frame.source) + " " +
                            std::to_string(static_cast<int>(one.loss)) + "\n";
      }
      if ((step * 7 + static_cast<int>(vehicle) * 13) % (61 + static_cast<int>(vehicle)) == 0) {
        channel.send(vehicle, now_s, frameOf(vehicle), kTestModem);
      }
    }
  }
  std::string all;
  for (const std::string& story : stories) {
    all += story + "--\n";
  }
  return all;
}

TEST(AcousticChannel, TheOrderOfTheVehiclesWithinAStepIsOfNoAccount) {
  std::vector<uint32_t> order = {0, 1, 2, 3};
  const std::string story = storyOf(order);
  for (const char* loss : {" 0\n", " 1\n", " 3\n", " 4\n"}) {
    EXPECT_NE(story.find(loss), std::string::npos) << loss;
  }
  while (std::ranges::next_permutation(order).found) {
    EXPECT_EQ(storyOf(order), story);
  }
}

}  // namespace
}  // namespace glider::simulator
