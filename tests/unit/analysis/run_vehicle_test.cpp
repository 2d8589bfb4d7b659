// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The rules of the environment model in numbers, beside the same rules in SMT-LIB.

#include "analysis/certificates/run_vehicle.h"

#include "ir/certify/vehicle.h"
#include "ir/prove/falsification/depth_limits.h"
#include "tests/unit/certify/judge.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <random>

namespace glider::ir::certify {
namespace {

/// A vehicle that is commanded at random, by each of the three.
class ThreeVehicles {
 public:
  /// `late_s`: until it obeys a command.
  ThreeVehicles(uint64_t seed, double late_s) : platform_(slocum()), random_(seed) {
    platform_.world.command_delay_s = late_s;
    platform_.world.climb_hold_m = late_s / 4;
    const double depth = within(0, platform_.world.start_depth_m);
    rules_ = vehicleAtStart(setting_, out_);
    out_.require(operation("=", {rules_.depth, literal(depth)}));
    numbers_.start(depth);
    limits_ = prove::DepthLimits(platform_, depth);
  }

  /// A dive, a climb, and within the time in which that is obeyed another climb to a deeper
  /// end: the first may never be obeyed.
  void climbTwice() {
    obey(Command::Descend, within(30, 60));
    move(600);
    obey(random_() % 2 == 0 ? Command::Surface : Command::Ascend, within(2, 6));
    move(10);
    obey(Command::Ascend, within(8, 20));
  }

  void command() {
    constexpr std::array kCommands = {Command::Descend, Command::Hover, Command::Ascend,
                                      Command::Surface, Command::Drift};
    obey(kCommands.at(random_() % kCommands.size()),
         random_() % 4 == 0 ? within(0, 1.5) : within(0, 60));
  }

  /// Time passes; the vehicle goes to any depth that it may have then, often the deepest.
  void move() { move(std::round(within(0, random_() % 2 == 0 ? 20 : 600))); }
  void move(double seconds) {
    const double later = now_ + seconds;
    rules_ = vehicleLater(setting_, out_, rules_, literal(now_), literal(later));
    const auto depths = numbers_.later(now_, later);
    least_ = depths.least;
    greatest_ = depths.greatest;
    EXPECT_DOUBLE_EQ(least_, limits_.lowest(now_, later));
    EXPECT_DOUBLE_EQ(greatest_, limits_.highest(now_, later));
    before_ = out_.text();
    // The rules are exact, and the limits here are doubles: not quite at them.
    const double inside = greatest_ - least_ > 1e-8 ? 1e-9 : 0;
    const double depth = std::clamp(random_() % 2 == 0 ? greatest_ : within(least_, greatest_),
                                    least_ + inside, greatest_ - inside);
    out_.require(operation("=", {rules_.depth, literal(depth)}));
    numbers_.moveTo(depth);
    limits_.moveTo(depth);
    now_ = later;
  }

  /// Whether the rules let it be there after the newest move.
  [[nodiscard]] bool mayBe(double depth) const {
    return answersTo("(set-logic ALL)\n" + before_ +
                     fmt::format("(assert (= {} {}))\n(check-sat)\n", rules_.depth,
                                 literal(depth))) == std::vector<std::string>{"sat"};
  }

  double least_ = 0;
  double greatest_ = 0;

 private:
  void obey(Command command, double target) {
    CommandRun run{command, {}, false};
    std::vector<Number> arguments;
    if (command != Command::Surface && command != Command::Drift) {
      run.arguments = {target, 0.4};
      for (const double argument : run.arguments) {
        arguments.push_back({literal(argument), "true"});
      }
    }
    rules_ = commanded(setting_, out_, rules_, command, arguments, literal(now_));
    numbers_.obey(std::vector<Action>{run}, now_);
    limits_.obey(run, now_);
  }
  double within(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  platforms::Platform platform_;
  std::mt19937_64 random_;
  Mission mission_;
  Requirement requirement_;
  Facts facts_;
  Setting setting_{mission_, platform_, requirement_, facts_};
  SmtText out_;
  std::string before_;
  Vehicle rules_;
  analysis::RunVehicle numbers_{platform_};
  prove::DepthLimits limits_{platform_, 0};
  double now_ = 0;
};

void expectAgreement(ThreeVehicles& vehicles) {
  constexpr double kClose = 1e-6;
  ASSERT_LE(vehicles.least_, vehicles.greatest_ + kClose);
  if (vehicles.greatest_ - vehicles.least_ > 3 * kClose) {
    ASSERT_TRUE(vehicles.mayBe(vehicles.least_ + kClose));
    ASSERT_TRUE(vehicles.mayBe(vehicles.greatest_ - kClose));
  }
  ASSERT_FALSE(vehicles.mayBe(vehicles.least_ - kClose));
  ASSERT_FALSE(vehicles.mayBe(vehicles.greatest_ + kClose));
}

TEST(RunVehicle, AgreesWithTheRulesOnWhereTheVehicleMayBe) {
  NEEDS_CVC5();
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    ThreeVehicles vehicles(seed, seed % 2 == 0 ? 0 : 40);
    for (int step = 0; step < 6; ++step) {
      vehicles.command();
      vehicles.move();
      expectAgreement(vehicles);
    }
  }
}

TEST(RunVehicle, AgreesOnAClimbThatAnotherReplacesBeforeItIsObeyed) {
  NEEDS_CVC5();
  bool late = false;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    ThreeVehicles vehicles(seed, 40);
    vehicles.climbTwice();
    // From the first climb on it would be up to 10 s farther up.
    vehicles.move(40 + slocum().world.turn_s + 60);
    expectAgreement(vehicles);
    late = late || vehicles.greatest_ > 30;
  }
  EXPECT_TRUE(late) << "no climb was still on its way";
}

}  // namespace
}  // namespace glider::ir::certify
