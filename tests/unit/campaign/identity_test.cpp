// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a campaign's flights depend on, and the command that flies one again.

#include "campaign/campaign.h"
#include "simulator/scenario/scenario.h"
#include "simulator/slocum/own_mission.h"
#include "support/diagnostics/ids/files.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <set>

namespace glider::campaign {
namespace {

/// A campaign with everything that it can have, all of it in one folder.
class Identity : public ::testing::Test {
 protected:
  Identity() {
    setenv("GLIDERCC_SHARE", folder_.path().c_str(), 1);
    std::filesystem::create_directory(folder_.path() / "platforms");
    write("platforms/slocum.toml", "a platform");
    write("world.toml", "a world");
    write("skeleton.mi", "a mission file");
    write("p", "bottom = 1");
    options_.user_code = {write("code.o", "code")};
    options_.launch = {{"x=1", "y=2"}, write("parameters", "z = 3")};
    options_.faults = {"byte loss"};
    plan_.flights = 10;
    plan_.seed = 3;
    plan_.board_percent = 20;
    plan_.boards = {"ts5500"};
    plan_.scenario.path = folder_.path() / "world.toml";
    plan_.scenario.skeleton_path = folder_.path() / "skeleton.mi";
    simulator::missionFileOf(plan_.scenario).behaviours = {
        {"abend", {}, {{"overdepth", "m", 70, {}, {}}}}};
    plan_.missions.resize(2);
    plan_.missions[0].file = write("a.mission", "a");
    plan_.missions[1].file = write("b.mission", "b");
    plan_.missions[1].platform.name = "slocum";
    plan_.missions[1].platform.family = "slocum";
    plan_.missions[0].platform.name = "slocum";
    plan_.missions[0].platform.family = "slocum";
    plan_.missions[0].program = "its digest";
  }
  ~Identity() override { unsetenv("GLIDERCC_SHARE"); }

  std::string write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text).string();
  }
  [[nodiscard]] std::string now() const {
    const auto identity = identityOf(plan_, options_);
    EXPECT_TRUE(identity);
    return identity.value_or("");
  }
  /// Why there is none.
  [[nodiscard]] support::DiagnosticId failure() const {
    const auto identity = identityOf(plan_, options_);
    EXPECT_FALSE(identity);
    return identity ? support::DiagnosticId() : identity.error().id;
  }

  const tests::TemporaryFolder folder_;
  CampaignPlan plan_;
  CampaignOptions options_;
};

TEST_F(Identity, IsADigestAndTheSameForTheSame) {
  EXPECT_EQ(now().size(), 64U);
  EXPECT_EQ(now(), now());
}

TEST_F(Identity, IsDifferentAfterAnyChange) {
  const std::function<void()> changes[] = {
      [&] { ++plan_.flights; }, [&] { ++plan_.seed; }, [&] { ++plan_.board_percent; },
      [&] { plan_.boards.emplace_back("ts7800"); },
      [&] { options_.faults.emplace_back("line cut"); }, [&] { write("a.mission", "changed"); },
      [&] { std::swap(plan_.missions[0].file, plan_.missions[1].file); },
      [&] { plan_.missions.pop_back(); }, [&] { write("code.o", "changed"); },
      [&] { options_.user_code.clear(); }, [&] { write("parameters", "z = 4"); },
      [&] { options_.launch.file.clear(); }, [&] { options_.launch.settings[1] = "y=3"; },
      [&] { options_.launch.settings.pop_back(); },
      [&] { write("platforms/slocum.toml", "changed"); }, [&] { write("world.toml", "changed"); },
      [&] { write("skeleton.mi", "changed"); },
      // Of an argument file beside the mission file, and of what a mission imports.
      [&] { simulator::missionFileOf(plan_.scenario).behaviours[0].arguments[0].value = 71; },
      [&] {
        simulator::missionFileOf(plan_.scenario).behaviours[0].arguments[0].name = "undervolts";
      },
      [&] { plan_.missions[0].program = "another"; }};
  std::set<std::string> all = {now()};
  for (const auto& change : changes) {
    change();
    EXPECT_TRUE(all.insert(now()).second) << "change " << all.size();
  }
}

TEST_F(Identity, HowManyFlyAtATimeIsNotPartOfIt) {
  const std::string before = now();
  plan_.jobs = 7;
  options_.jobs = 7;
  options_.csv = "x";
  options_.resume = {"y"};
  EXPECT_EQ(now(), before);
}

TEST_F(Identity, NeedsEveryFile) {
  for (const char* name : {"a.mission", "code.o", "parameters", "platforms/slocum.toml",
                           "world.toml", "skeleton.mi"}) {
    const std::string text = tests::slurp(folder_.path() / name);
    std::filesystem::remove(folder_.path() / name);
    EXPECT_EQ(failure(), support::diagnostics::cannotRead) << name;
    write(name, text);
  }
  EXPECT_EQ(now().size(), 64U);
}

TEST(ShellWord, IsQuotedWhereAShellWouldTakeItApart) {
  EXPECT_EQ(shellWord("missions/a-b_2.mission"), "missions/a-b_2.mission");
  EXPECT_EQ(shellWord("bottom=20,5+3:@%"), "bottom=20,5+3:@%");
  EXPECT_EQ(shellWord(""), "''");
  EXPECT_EQ(shellWord("two words"), "'two words'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord("$HOME"), "'$HOME'");
  EXPECT_EQ(shellWord("Tiefe_\xC3\xA4"), "'Tiefe_\xC3\xA4'");
}

TEST(CommandOf, HasWhatIsNotAsUsual) {
  CampaignOptions options;
  options.missions = {"a.mission", "b c.mission"};
  EXPECT_EQ(commandOf(options), "glidercc campaign a.mission 'b c.mission' --seed 1");
  options.scenario = "figure5";
  options.launch = {{"x=1", "y=2 m"}, "p file"};
  options.user_code = {"c.o", "d.o"};
  options.board_percent = 0;
  options.faults = {"byte loss", "none"};
  options.seed = 18446744073709551615U;
  EXPECT_EQ(commandOf(options),
            "glidercc campaign a.mission 'b c.mission' --scenario figure5 --set x=1 --set 'y=2 m' "
            "--parameters 'p file' --link c.o --link d.o --boards 0 --fault 'byte loss' --fault "
            "none --seed 18446744073709551615");
}

}  // namespace
}  // namespace glider::campaign
