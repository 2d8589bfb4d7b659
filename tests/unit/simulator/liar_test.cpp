// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What disturbs the messages of a fleet: a vehicle that lies, and loss.

#include "simulator/acoustics/liar.h"

#include "simulator/acoustics/channel.h"
#include "tests/unit/simulator/test_modem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace glider::simulator {
namespace {

using hooks::share::MessageReader;
using hooks::share::MessageWriter;

const std::vector<MessageForm> kForms = {{{{0, 0.5, 401}, {0, 1, 2}}, 75, 3},
                                         {{{-2, 0.05, 841}}, 12, 3}};

AcousticFrame truth(double depth_m) {
  MessageWriter writer;
  writer.put(kForms[0].scales[1], 1).put(kForms[0].scales[0], depth_m);
  AcousticFrame frame;
  frame.source = 2;
  frame.data.size = kForms[0].bytes;
  EXPECT_TRUE(writer.end(kForms[0].signature, frame.data.bytes, frame.data.size));
  return frame;
}

/// The values of a message of this form; empty: it is none.
std::vector<double> valuesOf(const MessageForm& form, const hooks::micro_modem::Data& data) {
  MessageReader reader(data.bytes, data.size);
  std::vector<double> values;
  for (const hooks::share::Scale& scale : form.scales) {
    values.push_back(reader.take(scale));
  }
  return reader.end(form.signature, form.bytes) ? values : std::vector<double>();
}

std::vector<uint8_t> bytesOf(const AcousticFrame& frame) {
  return {frame.data.bytes, frame.data.bytes + frame.data.size};
}

TEST(Liar, SendsMessagesOfTheFleetWithAllValuesOfTheirRanges) {
  Liar liar(Lie::Values, kForms, {1, 3}, 1);
  std::set<double> depths;
  int unknown = 0, second = 0;
  for (int i = 0; i < 20000; ++i) {
    const AcousticFrame sent = liar.insteadOf(truth(8));
    EXPECT_EQ(sent.source, 2U);
    if (const auto values = valuesOf(kForms[0], sent.data); !values.empty()) {
      std::isnan(values[0]) ? (void)++unknown : (void)depths.insert(values[0]);
    } else {
      second += valuesOf(kForms[1], sent.data).empty() ? 0 : 1;
    }
  }
  EXPECT_EQ(depths.size(), 401U);
  EXPECT_EQ(*depths.begin(), 0);
  EXPECT_EQ(*depths.rbegin(), 200);
  EXPECT_GT(unknown, 0);
  EXPECT_NEAR(second, 10000, 400);
}

/// It replaces a mini packet by a frame, and a frame by a mini packet.
TEST(Liar, LiesInMiniPacketsToo) {
  const std::vector<MessageForm> forms = {kForms[0], {{{0, 1, 101}}, 0x5D, 2, true}};
  AcousticFrame mini;
  mini.source = 2;
  mini.is_mini = true;
  Liar liar(Lie::Values, forms, {}, 1);
  std::set<double> values;
  int frames = 0;
  for (int i = 0; i < 4000; ++i) {
    const AcousticFrame sent = liar.insteadOf(i % 2 == 0 ? mini : truth(8));
    if (!sent.is_mini) {
      ++frames;
      EXPECT_FALSE(valuesOf(forms[0], sent.data).empty());
      continue;
    }
    MessageReader reader(sent.mini_bits);
    const double value = reader.take(forms[1].scales[0]);
    EXPECT_TRUE(reader.endMini(forms[1].signature));
    EXPECT_EQ(sent.data.size, 0U);
    if (!std::isnan(value)) {
      values.insert(value);
    }
  }
  EXPECT_EQ(values.size(), 101U);
  EXPECT_NEAR(frames, 2000, 200);
  Liar rubbish(Lie::Rubbish, forms, {}, 1);
  std::set<uint32_t> bits;
  for (int i = 0; i < 2000; ++i) {
    bits.insert(rubbish.insteadOf(mini).mini_bits);
  }
  EXPECT_GT(bits.size(), 1500U);
  EXPECT_LT(*bits.rbegin(), 1U << hooks::share::kMiniBits);
}

TEST(Liar, TheSameSeedLiesAlike) {
  for (const Lie lie : {Lie::Values, Lie::Masked, Lie::Rubbish}) {
    Liar one(lie, kForms, {1, 3}, 7), same(lie, kForms, {1, 3}, 7), other(lie, kForms, {1, 3}, 8);
    bool differs = false;
    for (int i = 0; i < 20; ++i) {
      const auto sent = bytesOf(one.insteadOf(truth(i)));
      EXPECT_EQ(sent, bytesOf(same.insteadOf(truth(i))));
      differs = differs || sent != bytesOf(other.insteadOf(truth(i)));
    }
    EXPECT_TRUE(differs);
  }
}

TEST(Liar, OneThatIsFrozenRepeatsItsFirstMessage) {
  Liar liar(Lie::Frozen, kForms, {1, 3}, 1);
  const auto first = bytesOf(truth(8));
  EXPECT_EQ(bytesOf(liar.insteadOf(truth(8))), first);
  EXPECT_EQ(bytesOf(liar.insteadOf(truth(90))), first);
}

TEST(Liar, OneThatIsMaskedSendsAsAnotherVehicle) {
  Liar liar(Lie::Masked, kForms, {1, 3}, 1);
  std::set<uint32_t> sources;
  for (int i = 0; i < 500; ++i) {
    sources.insert(liar.insteadOf(truth(8)).source);
  }
  EXPECT_EQ(sources, (std::set<uint32_t>{1, 3}));
  Liar alone(Lie::Masked, kForms, {}, 1);
  EXPECT_EQ(alone.insteadOf(truth(8)).source, 2U);
}

TEST(Liar, RubbishHasAllSizes) {
  Liar liar(Lie::Rubbish, kForms, {1, 3}, 1);
  std::set<uint32_t> sizes;
  for (int i = 0; i < 2000; ++i) {
    sizes.insert(liar.insteadOf(truth(8)).data.size);
  }
  EXPECT_EQ(sizes.size(), 32U);
  EXPECT_EQ(*sizes.begin(), 1U);
}

/// For each of 1000 frames over 50 m, whether it was received, and what.
std::vector<AcousticFrame> receivedWith(AcousticTrouble trouble) {
  Channel channel(3, std::move(trouble));
  channel.place(0, {0, 0, 0});
  channel.place(1, {50, 0, 0});
  std::vector<AcousticFrame> received;
  for (int i = 0; i < 1000; ++i) {
    channel.send(0, 20.0 * i, truth(8), kTestModem);
    for (const Reception& one : channel.take(1, 20.0 * i + 19)) {
      if (one.is_frame && one.loss == Loss::None) {
        received.push_back(one.frame);
      }
    }
  }
  return received;
}

TEST(AcousticTrouble, LosesTheShareThatItSays) {
  const auto without = static_cast<double>(receivedWith({}).size());
  EXPECT_NEAR(without, 950, 25);
  EXPECT_NEAR(static_cast<double>(receivedWith({.loss = 0.4, .liars = {}}).size()), 0.6 * without,
              45);
  EXPECT_TRUE(receivedWith({.loss = 1, .liars = {}}).empty());
}

TEST(AcousticTrouble, OnlyTheLiarLies) {
  AcousticTrouble trouble;
  trouble.liars.emplace(0, Liar(Lie::Rubbish, kForms, {1, 3}, 1));
  int true_ones = 0;
  for (const AcousticFrame& frame : receivedWith(trouble)) {
    true_ones += bytesOf(frame) == bytesOf(truth(8)) ? 1 : 0;
  }
  EXPECT_EQ(true_ones, 0);
  trouble.liars.clear();
  trouble.liars.emplace(1, Liar(Lie::Rubbish, kForms, {1, 3}, 1));
  for (const AcousticFrame& frame : receivedWith(trouble)) {
    EXPECT_EQ(bytesOf(frame), bytesOf(truth(8)));
  }
}

}  // namespace
}  // namespace glider::simulator
