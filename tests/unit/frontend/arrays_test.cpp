// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/mission_writer.h"
#include "ir/eval/interpreter.h"
#include "support/diagnostics/ids/meaning.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <vector>

namespace glider::frontend {
namespace {

using testing_support::FrontendRun;

/// A mission that runs, with the values of its variables by name.
class Flown {
 public:
  explicit Flown(const std::string& text) {
    FrontendRun run(text);
    auto compiled = run.compile();
    EXPECT_TRUE(compiled.has_value()) << run.said() << text;
    if (!compiled) {
      return;
    }
    mission_ = std::move(*compiled);
    for (uint32_t i = 0; i < mission_.variables.size(); ++i) {
      reads_.push_back(ir::MissionWriter(mission_).read(ir::VariableId{i}));
    }
    interpreter_ = std::make_unique<ir::Interpreter>(mission_, 2);
    interpreter_->start();
  }

  void tick(double time, std::vector<ir::SensorUpdate> frame = {}) {
    if (interpreter_) {
      interpreter_->tick(time, frame);
    }
  }
  [[nodiscard]] double operator[](const std::string& name) const {
    for (size_t i = 0; i < reads_.size(); ++i) {
      if (mission_.variables[i].name == name) {
        return ir::asNumber(interpreter_->evaluate(reads_[i]));
      }
    }
    ADD_FAILURE() << "there is no " << name;
    return 0;
  }

 private:
  ir::Mission mission_;
  std::vector<ir::ExprId> reads_;
  std::unique_ptr<ir::Interpreter> interpreter_;
};

/// A mission of one state that runs `statements` when it begins.
std::string entering(const std::string& declarations, const std::string& statements) {
  return "mission m\n" + declarations +
         "state s begin flightprofile surfaced sensors missiontime entry do\n" + statements +
         " end events case missiontime > 1 h exit end\n";
}

TEST(Arrays, OfPositionsAndConditions) {
  const Flown flown(entering(
      "var n: number = 1\nvar far: number = 7\nvar half: number = 0.5\n"
      "var places[2]: position = [39 N 73 W, 40 N 74 W]\nvar seen[3]: bool = [false, true, false]\n"
      "var copy: position = unknown\nvar a: bool = false\nvar b: bool = true\nvar c: bool = true\n"
      "var d: number = 5\nvar e: number = 0\n",
      "set copy = places[n] set places[n - 1] = places[n] set seen[n + 1] = true\n"
      "set places[far] = 1 N 1 W set seen[half] = true\n"
      "set a = seen[n] set b = seen[far] set c = seen[half]\n"
      "if known(distance(places[far], copy)) then set d = 6 end\n"
      "if seen[far] || true then set e = 1 end\n"));
  EXPECT_EQ(flown["copy.latitude"], 40);
  EXPECT_EQ(flown["copy.longitude"], -74);
  EXPECT_EQ(flown["places[0].latitude"], 40);
  EXPECT_EQ(flown["places[0].longitude"], -74);
  EXPECT_EQ(flown["places[1].longitude"], -74);
  EXPECT_EQ(flown["seen[0]"], 0);
  EXPECT_EQ(flown["seen[2]"], 1);
  EXPECT_EQ(flown["a"], 1);
  EXPECT_EQ(flown["b"], 1);  // what was read is unknown, so it kept its value
  EXPECT_EQ(flown["c"], 1);
  EXPECT_EQ(flown["d"], 5);
  EXPECT_EQ(flown["e"], 1);
}

TEST(Arrays, AConditionOutsideIsUnknownWhateverTheElementsAre) {
  for (const char* all : {"true", "false"}) {
    const Flown flown(entering(
        fmt::format("var far: number = 7\nvar seen[3]: bool = {}\nvar t: number = 0\n", all),
        "if seen[far] then set t = 1 else set t = 2 end if !seen[far] then set t = 3 end\n"));
    EXPECT_EQ(flown["t"], 0) << all;
  }
}

TEST(Arrays, OfTheLargestSize) {
  const Flown flown(
      entering("var n: number = 63\nvar a[64]: length = 0 m\nvar last: length = 0 m\nvar sum: "
               "length = 0 m\n",
               "for i in 0 .. 63 do set a[i] = i * 1 m end set last = a[n] set a[n - 1] = 500 m\n"
               "set sum = mean(a) * count(a)\n"));
  EXPECT_EQ(flown["last"], 63);
  EXPECT_EQ(flown["a[62]"], 500);
  EXPECT_EQ(flown["a[61]"], 61);
  EXPECT_NEAR(flown["sum"], 63 * 64 / 2 - 62 + 500, 1e-9);
}

TEST(Arrays, OfAStateBeginAgainWithItAndStayDuringCalls) {
  Flown flown(
      "mission m\nvar last: number = -1\n"
      "state s begin flightprofile surfaced sensors missiontime var a[2]: number = 5\n"
      "events case became(missiontime > 5 s) do set a[1] = 8 end call t\n"
      "case became(missiontime > 25 s) do set last = a[1] end goto s\n"
      "case missiontime > 1 h exit end\n"
      "state t begin flightprofile surfaced sensors statetime var a[3]: number = 1\n"
      "entry do set a[0] = 2 end events case statetime >= 4 s return end\n");
  EXPECT_EQ(flown["s.a[1]"], 5);
  flown.tick(8);
  EXPECT_EQ(flown["s.a[1]"], 8);
  EXPECT_EQ(flown["t.a[0]"], 2);
  flown.tick(12);
  flown.tick(16);
  EXPECT_EQ(flown["s.a[1]"], 8);
  flown.tick(28);
  EXPECT_EQ(flown["last"], 8);
  EXPECT_EQ(flown["s.a[1]"], 5);
}

TEST(Arrays, PushForgetsTheOldestAndIgnoresWhatIsUnknown) {
  const Flown flown(
      entering("var u: number = unknown\nvar r[3]: number = unknown\nvar mid: number = 0\n"
               "var full[2]: number = [1, 2]\n",
               "push(r, 1) push(r, u) push(r, 2) set mid = mean(r)\n"
               "push(full, 3) push(full, 4)\n"));
  EXPECT_EQ(flown["r[0]"], 2);
  EXPECT_EQ(flown["r[1]"], 1);
  EXPECT_TRUE(std::isnan(flown["r[2]"]));
  EXPECT_EQ(flown["mid"], 1.5);
  EXPECT_EQ(flown["full[0]"], 4);
  EXPECT_EQ(flown["full[1]"], 3);
}

TEST(Arrays, TheWordsNameOtherThingsToo) {
  const Flown flown(entering(
      "const array = 2\nvar for: number = 1\nvar push: number = 3\nvar unknown: number = 4\n"
      "var in: number = 0\n",
      "set for = for + array for i in 0 .. array do set in = for + i set for = in end\n"
      "set push = for set unknown = unknown + 1\n"));
  EXPECT_EQ(flown["in"], 6);  // 1 + 2, then 0, 1 and 2 more
  EXPECT_EQ(flown["push"], 6);
  EXPECT_EQ(flown["unknown"], 5);
}

TEST(Loops, AreLimitedAsAWhole) {
  const auto said = [](const std::string& loops) {
    FrontendRun run(entering("var n: number = 0\n", loops));
    const bool compiled = run.compile().has_value();
    EXPECT_EQ(compiled, !run.says(support::diagnostics::loopTooLong)) << run.said();
    return run.said();
  };
  EXPECT_EQ(said("for i in 0 .. 999 do set n = n + i end").find("GL2116"), std::string::npos);
  EXPECT_NE(said("for i in 0 .. 99999 do set n = n + i end").find("about 500000 operations"),
            std::string::npos);
  EXPECT_NE(said("for i in 0 .. 1e15 do end").find("GL2116"), std::string::npos);
  const std::string nested =
      said("for i in 1 .. 200 do for j in 1 .. 200 do set n = n + j end end");
  EXPECT_NE(nested.find("about 200"), std::string::npos) << nested;
  EXPECT_EQ(nested.find("GL2116"), nested.rfind("GL2116")) << nested;
}

}  // namespace
}  // namespace glider::frontend
