// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Random instructions over the vehicle's own line: their words are late, each by itself, overtake
// those of the next, are lost, cut off and rounded. hookbeh must accept each that is not replaced
// by the next, and nothing that was not sent.

#include "hooks/hookbeh/hookbeh.h"
#include "simulator/seat/sensor_array.h"
#include "simulator/slocum/line/flight_science_line.h"
#include "tests/slocum.h"
#include "tests/unit/simulator/slocum_vehicle.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

namespace glider::simulator {
namespace {

using hooks::Instruction;
using hooks::InstructionWord;
using hooks::InstructionWords;

uint64_t fromEnvironment(const char* name, uint64_t usual) {
  const char* text = std::getenv(name);
  return text == nullptr ? usual : std::strtoull(text, nullptr, 10);
}

/// What a path may do to a value before the line: none of it changes six decimals by more than one
/// unit of the last.
enum class Path { Plain, CutOff, Narrow, NarrowAndCutOff, Twice };

double over(Path path, double value) {
  const auto cut = [](double x) { return std::trunc(x * 1e6) / 1e6; };
  switch (path) {
    case Path::Plain:
      return value;
    case Path::CutOff:
      return cut(value);
    case Path::Narrow:
      return hookAsFloat32(value);
    case Path::NarrowAndCutOff:
      return cut(hookAsFloat32(value));
    case Path::Twice:
      return hookAsFloat32(cut(hookAsFloat32(value)));
  }
  return value;
}

bool isSame(const Instruction& a, const Instruction& b) {
  bool same = true;
#define WORD(role, sensor, word, field, ...) same = same && a.field == b.field;
#include "hooks/protocol/instruction.def"
  return same;
}

/// Instructions, each with some words of the one before.
class RandomInstructions {
 public:
  explicit RandomInstructions(uint64_t seed) : random_(seed) {}

  const Instruction& next() {
    before_ = newest_;
    Instruction next = newest_;
    next.session = 7;
    next.sequence = hookNextSequence(next.sequence);
    const bool deeper = chance(2);
    if (chance(2)) {
      next.vertical = deeper ? hooks::HookVertical::Descend : hooks::HookVertical::Ascend;
      const double pitch = chance(2) ? 0.4537856 : between(0.2, 0.78);
      next.pitch_rad = deeper ? -pitch : pitch;
    }
    if (chance(2)) {
      next.depth_m = chance(2) ? between(0, 200) : std::round(between(0, 200));
    }
    if (chance(2)) {
      next.lateral = static_cast<hooks::HookLateral>(random_() % 4);
      next.heading_rad =
          next.lateral == hooks::HookLateral::Fin ? between(-0.45, 0.45) : between(-6.283, 6.283);
    }
    if (chance(2)) {
      next.latitude_ddmm = ddmm(89);
      next.longitude_ddmm = ddmm(179);
    }
    newest_ = hooks::inSteps(next);
    return newest_;
  }
  void take() { newest_.control = hooks::HookControl::Take; }
  void steer() { newest_.control = hooks::HookControl::Steer; }
  [[nodiscard]] const Instruction& newest() const { return newest_; }
  [[nodiscard]] const Instruction& before() const { return before_; }

 private:
  bool chance(uint32_t of) { return random_() % of == 0; }
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  double ddmm(double most_degrees) {
    const double value = std::trunc(between(0, most_degrees)) * 100 + between(0, 59.9);
    return chance(2) ? value : -value;
  }

  std::mt19937_64 random_;
  Instruction newest_, before_;
};

/// An SBC that instructs, the line, a sensor array and hookbeh.
class Flight {
 public:
  Flight(uint64_t seed, const LineLag& lag)
      : random_(seed),
        to_flight_({}, LineWay::ToFlight, lag, seed),
        array_(slocumPlatform()),
        hookbeh_(args(), hooks::kHull) {}

  /// Gives `count` instructions, each when the one before is answered or, for one in four, sooner.
  void give(uint64_t count) {
    cycle();  // what is in the array at its start was not meant for it
    for (uint64_t i = 0; i < count && !testing::Test::HasFailure(); ++i) {
      instruct();
      const bool hurries = chance(4);
      const int most = hurries ? static_cast<int>(random_() % 3) : kMostCycles;
      for (int waited = 0; waited < most && !answered(); ++waited) {
        cycle();
        if (!answered() && chance(2)) {
          write();  // the client writes again what has no answer
        }
      }
      if (!answered()) {
        ASSERT_TRUE(hurries) << "instruction " << i << " is not accepted";
      }
    }
  }

  uint64_t accepted = 0, mixtures = 0, cycles = 0;

 private:
  static constexpr int kMostCycles = 40;

  static hooks::HookbehArgs args() {
    hooks::HookbehArgs args;
    args.greatest_depth_m = 200;
    args.steepest_pitch_rad = 0.7854;
    args.silence_secs = 600;
    return args;
  }
  bool chance(uint32_t of) { return random_() % of == 0; }
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }

  void instruct() {
    taken_ ? instructions_.steer() : instructions_.take();
    const Instruction& next = instructions_.next();
    path_ = static_cast<Path>(random_() % 5);
    sent_[next.sequence] = next;
    write();
  }

  /// Its words, in any order; some are lost.
  void write() {
    const InstructionWords words = hooks::wordsOf(instructions_.newest());
    std::array<InstructionWord, std::size(hooks::kInstructionWords)> order;
    std::ranges::copy(hooks::kInstructionWords, order.begin());
    std::ranges::shuffle(order, random_);
    for (const InstructionWord& one : order) {
      if (!chance(50)) {
        const uint16_t id = hooks::sensorOf(gliderDictionary, one.role);
        const bool wide = hooks::sensorWidth(id) == 8;
        const double value = words.*one.word;
        to_flight_.send({.id = id,
                         .value = wide ? over(chance(2) ? Path::CutOff : Path::Plain, value)
                                       : over(path_, value)});
      }
    }
  }

  void cycle() {
    ++cycles;
    now_s_ += chance(900) ? 15 : between(4, 4.5);
    to_flight_.setNow(now_s_);
    while (const auto one = to_flight_.next()) {
      array_.set(one->id, one->value);
    }
    hooks::HookbehInputs in;
    for (const InstructionWord& one : hooks::kInstructionWords) {
      in.words.*one.word = array_.get(hooks::sensorOf(gliderDictionary, one.role));
    }
    in.time_s = now_s_;
    in.depth_m = 10 + between(-0.1, 0.1);
    in.altitude_m = std::nan("");
    in.heartbeat = ++beats_;
    out_ = hookbeh_.cycle(in);
    mixtures += out_.answer == hooks::HookAnswer::BadCheck ? 1 : 0;
    judge(in.words);
  }

  void judge(const InstructionWords& words) {
    if (out_.answer == hooks::HookAnswer::None || out_.answer == hooks::HookAnswer::BadCheck ||
        out_.answer == hooks::HookAnswer::OldSequence || out_.answered_sequence == judged_) {
      return;
    }
    judged_ = out_.answered_sequence;
    ASSERT_EQ(out_.answer, hooks::HookAnswer::Accepted);
    Instruction obeyed;
    ASSERT_TRUE(hooks::instructionOf(words, &obeyed));
    ASSERT_TRUE(sent_.contains(judged_));
    ASSERT_TRUE(isSame(obeyed, sent_.at(judged_)))
        << "instruction " << judged_ << " was taken with words of another";
    taken_ = true;
    ++accepted;
  }

  [[nodiscard]] bool answered() const { return judged_ == instructions_.newest().sequence; }

  std::mt19937_64 random_;
  LineDirection to_flight_;
  SensorArray array_;
  hooks::Hookbeh hookbeh_;
  hooks::HookbehOutputs out_;
  RandomInstructions instructions_{random_()};
  std::map<uint16_t, Instruction> sent_;
  Path path_ = Path::Plain;
  uint16_t judged_ = 0;
  uint32_t beats_ = 0;
  double now_s_ = 0;
  bool taken_ = false;
};

void fly(const char* what, const LineLag& lag) {
  constexpr uint64_t kShare = 50000;
  const uint64_t count = fromEnvironment("GLIDER_LINE_INSTRUCTIONS", kShare);
  const uint64_t seed = fromEnvironment("GLIDER_LINE_SEED", 1);
  Flight flight(seed, lag);
  flight.give(count);
  fmt::print(
      "{}, seed {}: {} instructions, {} accepted, {} replaced by the next before that, 0 taken "
      "wrongly; {} cycles, {} of them with words of several\n",
      what, seed, count, flight.accepted, count - flight.accepted, flight.cycles, flight.mixtures);
  EXPECT_GT(flight.accepted, count * 3 / 4);
  EXPECT_GT(flight.mixtures, count / 5);
}

TEST(SpreadInstructions, AreAllAcceptedAndNoneIsTakenWrongly) {
  fly("the usual line", kLagToFlight);
}

TEST(SpreadInstructions, AreAllAcceptedOverALineThatIsLaterThanPromised) {
  fly("a late line", {.least_s = 0, .usual_s = 12, .most_s = 40, .waits_share = 0.1});
}

// Every mixture of the words of two instructions, one after the other.
TEST(SpreadInstructions, AMixtureOfTwoIsNone) {
  constexpr uint64_t kPairs = 500;
  const uint64_t pairs = fromEnvironment("GLIDER_LINE_PAIRS", kPairs);
  RandomInstructions random(fromEnvironment("GLIDER_LINE_SEED", 1));
  constexpr size_t kWords = std::size(hooks::kInstructionWords);
  uint64_t mixtures = 0;
  uint64_t wrong = 0;
  for (uint64_t pair = 0; pair < pairs; ++pair) {
    const InstructionWords before = hooks::wordsOf(random.next());
    const InstructionWords after = hooks::wordsOf(random.next());
    for (uint32_t set = 1; set + 1 < 1U << kWords; ++set) {
      InstructionWords words = before;
      for (size_t i = 0; i < kWords; ++i) {
        const auto word = hooks::kInstructionWords[i].word;
        words.*word = (set >> i & 1U) != 0 ? after.*word : before.*word;
      }
      Instruction got;
      ++mixtures;
      const bool taken = hooks::instructionOf(words, &got);
      wrong += taken && !isSame(got, random.before()) && !isSame(got, random.newest()) ? 1U : 0U;
    }
  }
  fmt::print("{} mixtures of {} pairs, {} taken wrongly\n", mixtures, pairs, wrong);
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace glider::simulator
