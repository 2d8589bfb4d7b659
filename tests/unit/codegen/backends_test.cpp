// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The table of back ends, as those see it who ask for a product and not for a back end.

#include "ir/text/print.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"
#include "tests/unit/codegen/compiled_mission.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <regex>
#include <sstream>

namespace glider::codegen_tests {
namespace {

namespace fs = std::filesystem;
using codegen::findProduct;
using testing::ElementsAre;
using testing::HasSubstr;

/// A computer without a processor that LLVM knows.
platforms::Board boardWithoutMachine() {
  platforms::Board bare = board("host");
  bare.name = "stock";
  bare.triple = "";
  return bare;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const codegen::Product* product : codegen::products()) {
    all.emplace_back(product->name);
  }
  return all;
}

TEST(BackEnds, MakeEveryProductForEveryBoard) {
  EXPECT_THAT(names(), ElementsAre("ir", "header", "llvm", "asm", "obj", "exe"));
  const Checked checked = figure2();
  for (const char* target : kBoards) {
    for (const std::string& name : names()) {
      const codegen::Product* product = findProduct(name, board(target));
      ASSERT_NE(product, nullptr) << name << target;
      EXPECT_EQ(product->name, name);
      const auto made = product->make(checked.input(), board(target), {});
      ASSERT_TRUE(made.has_value()) << name << target << made.error().message;
      EXPECT_FALSE(made->empty()) << name << target;
    }
  }
  EXPECT_EQ(findProduct("poem", board("host")), nullptr);
}

TEST(BackEnds, WriteWhatTheyMake) {
  const Checked checked = figure2();
  const fs::path folder = testFolder();
  for (const std::string& name : names()) {
    const codegen::Product& product = *findProduct(name, board("ts7800"));
    codegen::CodegenOptions options;
    options.debug = false;  // with it, an executable names the file that holds its line tables
    ASSERT_TRUE(
        codegen::writeProduct(product, checked.input(), board("ts7800"), options, folder / name));
    EXPECT_EQ(support::readFile(folder / name).value_or(""),
              product.make(checked.input(), board("ts7800"), options).value_or("none"))
        << name;
  }
}

TEST(BackEnds, GiveABoardWithoutAMachineTextsOnly) {
  const platforms::Board stock = boardWithoutMachine();
  for (const std::string& name : names()) {
    const codegen::Product* product = findProduct(name, stock);
    const bool text = name == "ir" || name == "header";
    EXPECT_EQ(product != nullptr, text) << name;
    EXPECT_EQ(findProduct(name, board("ts5500"))->for_board, !text) << name;
  }
  const Checked checked = figure2();
  const auto executable =
      codegen::linkExecutable(checked.input(), stock, {}, testFolder() / "figure2");
  const auto shared = codegen::linkShared(checked.input(), stock, {});
  const auto measured = codegen::measureBudget(checked.input(), stock, {});
  ASSERT_FALSE(executable || shared || measured);
  for (const support::Failure& failure : {executable.error(), shared.error(), measured.error()}) {
    EXPECT_EQ(failure.id, support::diagnostics::unsupportedMachine);
    EXPECT_THAT(failure.message, HasSubstr("`stock`"));
  }
}

TEST(BackEnds, PrintTheMissionAsItWasWrittenAtLevelZero) {
  const Checked checked = figure2();
  ir::Mission written = checked.mission;
  written.name = "asWritten";
  const codegen::Input input{checked.mission, checked.platform, 1, &written};
  const codegen::Product& product = *findProduct("ir", board("host"));
  codegen::CodegenOptions options;
  EXPECT_EQ(product.make(input, board("host"), options).value_or(""), ir::print(checked.mission));
  options.optimisation_level = 0;
  EXPECT_EQ(product.make(input, board("host"), options).value_or(""), ir::print(written));
  EXPECT_EQ(product.make(checked.input(), board("host"), options).value_or(""),
            ir::print(checked.mission));
}

TEST(BackEnds, DeclareInCWhatTheMissionDeclaresUsedOrNot) {
  const Checked checked = figure2();
  ir::CInterface declared;
  ir::Sensor salinity;
  salinity.name = "salinity";
  salinity.symbol = "glider.sensor.salinity.number";
  declared.sensors.push_back(salinity);
  const codegen::Product& product = *findProduct("header", board("host"));
  EXPECT_THAT(
      product.make({checked.mission, checked.platform, 1, nullptr, &declared}, board("host"), {})
          .value_or(""),
      HasSubstr("salinity"));
  EXPECT_THAT(product.make(checked.input(), board("host"), {}).value_or("salinity"),
              testing::Not(HasSubstr("salinity")));
}

// docs/architecture.md, the last column of the stages: what `--emit` names, in its order.
TEST(BackEnds, AreInTheTableOfStages) {
  std::istringstream page(
      support::readFile(GLIDER_SOURCE_DIR "/docs/architecture.md").value_or(""));
  std::vector<std::string> documented;
  const std::regex row(R"(\|[^|]*\|[^|]*\|[^|]*\|((?: `\w+`)+) \|)");
  const std::regex word(R"(\w+)");
  for (std::string line; std::getline(page, line);) {
    if (std::smatch cells; std::regex_match(line, cells, row)) {
      const std::string values = cells[1];
      for (std::sregex_iterator it(values.begin(), values.end(), word), end; it != end; ++it) {
        documented.push_back(it->str());
      }
    }
  }
  std::vector<std::string> expected = names();
  expected.insert(expected.begin(), {"ast", "symbols"});  // of the front end
  EXPECT_EQ(documented, expected);
}

}  // namespace
}  // namespace glider::codegen_tests
