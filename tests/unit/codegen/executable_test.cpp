// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// linkExecutable: what comes out, and what happens when the world does not play along.

#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <tuple>

namespace glider::codegen_tests {
namespace {

namespace fs = std::filesystem;

codegen::CodegenOptions optionsFor(const Checked& checked, int level = 2) {
  codegen::CodegenOptions options;
  options.optimisation_level = level;
  options.sources = &checked.sources;
  return options;
}

support::Result<void> build(const Checked& checked, const platforms::Board& target,
                            const fs::path& output) {
  return codegen::linkExecutable(checked.input(), target, optionsFor(checked), output);
}

std::vector<std::string> namesIn(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename());
  }
  return names;
}

/// The exit status of a board's program, and what it says.
std::pair<int, std::string> runOn(const platforms::Board& target, const fs::path& program,
                                  const std::string& arguments) {
  std::string command;
  for (const std::string& word : target.emulator) {
    command += word + " ";
  }
  const std::string said = program.string() + ".said";
  const int status =
      std::system((command + program.string() + " " + arguments + " > " + said + " 2>&1").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, support::readFile(said).value_or("")};
}

/// A mission with parameters, two of which are a position.
Checked withParameters() {
  std::string text =
      support::readFile(GLIDER_SOURCE_DIR "/tests/command/parameters.ir").value_or("");
  const auto add = [&](const std::string& after, const std::string& lines) {
    text.insert(text.find(after) + after.size(), lines);
  };
  add("variable eager: bool parameter\n",
      "variable \"home.latitude\": latitude parameter lowest -90 highest 90\n"
      "variable \"home.longitude\": longitude parameter lowest -180 highest 180\n");
  add("initial eager false\n",
      "initial \"home.latitude\" 39.175:latitude\ninitial \"home.longitude\" -73.83:longitude\n");
  return codegen_tests::checkedMission(text);
}

class OnBoard : public testing::TestWithParam<std::tuple<const char*, int>> {};

TEST_P(OnBoard, Figure2FitsAndStarts) {
  const auto [name, level] = GetParam();
  const Checked checked = figure2();
  const platforms::Board target = board(name);
  const fs::path output = testFolder() / "figure2";
  const auto built =
      codegen::linkExecutable(checked.input(), target, optionsFor(checked, level), output);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  if (target.max_executable_bytes != 0 && level > 0) {
    EXPECT_LE(fs::file_size(output), 68U << 10U) << "Figure 2 is to stay that small";
  }
  const std::string symbols = support::readFile(output.string() + ".debug").value_or("");
  EXPECT_GT(symbols.size(), 0u);
  if (target.max_executable_bytes != 0) {
    EXPECT_THAT(symbols, testing::Not(testing::HasSubstr("malloc"))) << "a board has no heap";
  }
  // Without a port to open it ends by itself, and says why: it ran to its own code.
  const auto [status, said] = runOn(target, output, "--port /nonexistent/port");
  EXPECT_GT(status, 0);
  EXPECT_THAT(said, testing::HasSubstr("/nonexistent/port"));
  EXPECT_THAT(runOn(target, output, "--set top=5m").second,
              testing::HasSubstr("no parameter `top`; it has none"));
}

/// The part of the runtime for parameters uses others that no other mission needs.
TEST_P(OnBoard, AMissionWithParametersTakesThem) {
  const auto [name, level] = GetParam();
  const Checked checked = withParameters();
  const platforms::Board target = board(name);
  const fs::path output = testFolder() / "parameters";
  const auto built =
      codegen::linkExecutable(checked.input(), target, optionsFor(checked, level), output);
  ASSERT_TRUE(built.has_value()) << built.error().message;
  const std::string help = runOn(target, output, "--help").second;
  EXPECT_THAT(help, testing::HasSubstr("\n  bottom = 25 m, 10 m to 30 m\n"));
  EXPECT_THAT(help, testing::HasSubstr("\n  eager = false\n"));
  EXPECT_THAT(help, testing::HasSubstr("\n  home = 39.175 N 73.83 W\n"));
  for (const auto& [setting, problem] :
       {std::pair("bottom=40m", "outside its range, 10 m to 30 m"),
        std::pair("botom=20m", "it has bottom, top, eager, home"),
        std::pair("'home=73 W 39 N'", "the latitude comes first")}) {
    const auto [status, said] = runOn(target, output, std::string("--set ") + setting);
    EXPECT_EQ(status, 2) << setting;
    EXPECT_THAT(said, testing::HasSubstr(problem));
  }
  EXPECT_THAT(runOn(target, output, "--port /nonexistent/port --set 'home=39 10 N 73 W'").second,
              testing::HasSubstr("/nonexistent/port"));
}

INSTANTIATE_TEST_SUITE_P(Boards, OnBoard,
                         testing::Combine(testing::ValuesIn(kBoards), testing::Values(0, 1, 2, 3)),
                         [](const auto& param) {
                           return std::string(std::get<0>(param.param)) + "_O" +
                                  std::to_string(std::get<1>(param.param));
                         });

TEST(LinkExecutable, GivesTheSameBytesTwice) {
  const Checked checked = figure2();
  const fs::path folder = testFolder();
  for (const char* name : {"first", "second"}) {
    fs::create_directory(folder / name);
    ASSERT_TRUE(build(checked, board("ts7800"), folder / name / "figure2"));
  }
  for (const char* file : {"figure2", "figure2.debug"}) {
    EXPECT_EQ(support::readFile(folder / "first" / file).value_or("1"),
              support::readFile(folder / "second" / file).value_or("2"));
  }
}

TEST(LinkExecutable, RefusesAMachineWithoutCodeGenerator) {  // GL4002
  platforms::Board target = board("ts7800");
  target.triple = "m68k-unknown-linux-gnu";
  const auto built = build(figure2(), target, testFolder() / "figure2");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::unsupportedMachine);
  target = board("ts7800");  // accepts: GL4002 in OnBoard; a wrong cpu of a right machine is as bad
  target.cpu = "pdp11";
  EXPECT_FALSE(build(figure2(), target, testFolder() / "figure2").has_value());
}

TEST(LinkExecutable, NamesABehaviourThatNothingDefines) {  // GL4003; accepts: GL4003 in OnBoard
  Checked checked = figure2();
  checked.mission.behaviours.front().symbol = "gliderProfileMine";
  const fs::path folder = testFolder();
  const auto built = build(checked, board("ts5500"), folder / "figure2");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::unboundSymbol);
  EXPECT_EQ(built.error().message,
            "undefined symbol `gliderProfileMine`: no linked file defines it");
  EXPECT_THAT(namesIn(folder), testing::IsEmpty());
}

TEST(LinkExecutable, SaysWhatTheLinkerRefuses) {  // GL4004; accepts: GL4004 in OnBoard
  const Checked checked = figure2();
  const fs::path folder = testFolder();
  codegen::CodegenOptions options = optionsFor(checked);
  options.further_inputs = {folder / "absent.o"};
  testing::internal::CaptureStderr();
  const auto built =
      codegen::linkExecutable(checked.input(), board("host"), options, folder / "figure2");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::linkFailed);
  EXPECT_THAT(built.error().message, testing::HasSubstr("absent.o"));
  EXPECT_TRUE(build(checked, board("host"), folder / "figure2")) << "lld does not run again";
}

TEST(LinkExecutable, HoldsTheBoardsLimit) {  // GL4005; accepts: GL4005 in OnBoard
  platforms::Board target = board("ts5500");
  target.max_executable_bytes = 10'000;
  const fs::path folder = testFolder();
  const auto built = build(figure2(), target, folder / "figure2");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::executableTooLarge);
  EXPECT_THAT(namesIn(folder), testing::IsEmpty());
}

TEST(LinkExecutable, RefusesMoreParametersThanALaunchTakes) {  // GL4007; accepts: GL4007 in `most`
  Checked checked = figure2();
  const auto withParameters = [&](uint32_t count) {
    Checked many = checked;
    std::vector<ir::Variable> parameters;
    for (uint32_t i = 0; i < count; ++i) {
      ir::Variable parameter;
      parameter.name = "p" + std::to_string(i);
      parameter.kind = ir::VariableKind::Parameter;
      parameter.initial = {static_cast<uint32_t>(many.mission.exprs.size())};
      many.mission.exprs.emplace_back();
      parameters.push_back(parameter);
    }
    for (ir::Expr& expr : many.mission.exprs) {
      expr.variable.index += expr.variable.valid() ? count : 0;
    }
    for (ir::Block& block : many.mission.blocks) {
      for (ir::Statement& statement : block.statements) {
        statement.variable.index += statement.variable.valid() ? count : 0;
      }
    }
    for (ir::State& state : many.mission.states) {
      for (ir::Activity* activity : {&state.profile, &state.route}) {
        activity->done.index += activity->done.valid() ? count : 0;
      }
    }
    many.mission.variables.insert(many.mission.variables.begin(), parameters.begin(),
                                  parameters.end());
    return many;
  };
  const Checked most = withParameters(64);
  EXPECT_TRUE(build(most, board("ts5500"), testFolder() / "most"));
  const auto built = build(withParameters(65), board("ts5500"), testFolder() / "figure2");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::tooManyParameters);
}

TEST(LinkExecutable, RefusesMoreMemoryThanABoardHas) {  // GL4006; accepts: GL4006 in OnBoard
  Checked checked = figure2();
  checked.facts.stack_depth = 3'000'000;
  const auto built = build(checked, board("ts5500"), testFolder() / "figure2");
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::missionTooLarge);
}

TEST(LinkExecutable, RefusesARuntimeThatIsNone) {  // GL9050; accepts: GL9050 in OnBoard
  const Checked checked = figure2();
  platforms::Board target = board("ts7800");
  target.folder = testFolder();
  const auto build_there = [&] {
    return codegen::linkExecutable(checked.input(), target, optionsFor(checked, 2),
                                   target.folder / "figure2");
  };
  EXPECT_EQ(build_there().error().id, support::diagnostics::cannotRead);
  const std::string whole = support::readFile(board("ts7800").folder / "inline.bc").value();
  for (const std::string& bytes : {std::string(), std::string("hello"), whole.substr(0, 100),
                                   whole.substr(0, whole.size() / 2)}) {
    ASSERT_TRUE(support::writeFileAtomically(target.folder / "inline.bc", bytes));
    const auto built = build_there();
    ASSERT_FALSE(built.has_value());
    EXPECT_EQ(built.error().id, support::diagnostics::badRuntime) << built.error().message;
  }
}

/// For as long as it lives no file of this process may grow beyond `bytes`: a full disk, to a
/// program.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

TEST(LinkExecutable, LeavesNothingOnAFullDisk) {
  const Checked checked = figure2();
  const platforms::Board target = board("ts7800");
  const fs::path folder = testFolder();
  for (const rlim_t room : {rlim_t{100}, rlim_t{20'000}, rlim_t{45'000}}) {
    support::Result<void> built;
    {
      const FullDisk full(room);
      built = build(checked, target, folder / "figure2");
    }
    ASSERT_FALSE(built.has_value()) << room;
    EXPECT_EQ(built.error().id, support::diagnostics::cannotWrite) << built.error().message;
    EXPECT_THAT(namesIn(folder), testing::IsEmpty()) << room;
  }
}

TEST(LinkExecutable, AFailureKeepsBothOldFiles) {
  const Checked checked = figure2();
  const fs::path folder = testFolder();
  for (const char* name : {"figure2", "figure2.debug"}) {
    ASSERT_TRUE(support::writeFileAtomically(folder / name, "old"));
  }
  for (const rlim_t room : {rlim_t{20'000}, rlim_t{45'000}}) {
    support::Result<void> built;
    {
      const FullDisk full(room);
      built = build(checked, board("ts7800"), folder / "figure2");
    }
    ASSERT_FALSE(built.has_value()) << room;
    EXPECT_EQ(support::readFile(folder / "figure2").value_or(""), "old") << room;
    EXPECT_EQ(support::readFile(folder / "figure2.debug").value_or(""), "old") << room;
  }
}

TEST(LinkExecutable, SaysWhereItCannotWrite) {
  EXPECT_EQ(build(figure2(), board("ts5500"), "/dev/full").error().id,
            support::diagnostics::cannotWrite);
  EXPECT_EQ(build(figure2(), board("ts5500"), testFolder() / "no" / "figure2").error().id,
            support::diagnostics::cannotWrite);
}

TEST(LinkExecutable, NeedsSomewhereForTemporaryFiles) {
  const char* before = std::getenv("TMPDIR");
  const std::string old = before != nullptr ? before : "/tmp";
  ::setenv("TMPDIR", "/nonexistent", 1);
  const auto built = build(figure2(), board("ts5500"), testFolder() / "figure2");
  ::setenv("TMPDIR", old.c_str(), 1);
  ASSERT_FALSE(built.has_value());
  EXPECT_EQ(built.error().id, support::diagnostics::cannotWrite);
}

}  // namespace
}  // namespace glider::codegen_tests
