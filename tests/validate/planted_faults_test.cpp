// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Whether the comparison sees faults: those of a wrong lowering, planted before the passes run, and
// those of a wrong pass, planted after. GLIDER_FAULTS_COUNT and GLIDER_FAULTS_SEED widen it:
// scripts/soak/validate.

#include "codegen/llvm/lower/abi_types.h"
#include "compiler/compilation.h"
#include "tests/random_missions/random.h"
#include "tests/validate/built.h"
#include "tests/validate/faults.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <llvm/IR/Constants.h>

#include <gmock/gmock.h>
#include <vector>

namespace glider::validate_test {
namespace {

/// What a fault in a mission's code was, and what the comparison said.
struct Planted {
  std::string words;
  std::string found;
};

/// Of those before the passes one that reaches the code: lowering also makes what the passes drop.
Planted plant(const codegen::Input& input, const char* board, bool in_pass,
              random_missions::Random& random) {
  Planted planted;
  uint32_t draw = 0;
  const auto change = [&](llvm::Module& module) {
    planted.words = plantFault(module, draw % faultsIn(module));
  };
  const std::string usual = codeOf(input, board, 2);
  do {
    draw = random.below(uint64_t{1} << 30U);
  } while (!in_pass && codeOf(input, board, 2, change) == usual);
  planted.found = whatIsNotSame(in_pass ? validate(input, board, 2, {}, change)
                                        : validate(input, board, 2, change));
  return planted;
}

/// The share of faults that may change nothing: what they change cannot happen, or is overwritten.
constexpr double kHarmless = 0.25;

class PlantedFaults : public testing::TestWithParam<const char*> {};

TEST_P(PlantedFaults, AreFound) {
  const std::string path = fmt::format("{}/missions/{}.mission", GLIDER_SOURCE_DIR, GetParam());
  const auto compilation = compiler::compileMission(path);
  ASSERT_TRUE(compilation && compilation->checked);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  random_missions::Random random(setting("GLIDER_FAULTS_SEED", 1));
  const uint64_t count = setting("GLIDER_FAULTS_COUNT", 4);
  uint64_t missed = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const char* board = i % 4 < 2 ? "host" : "ts7800";
    const Planted planted = plant(mission.input(), board, i % 2 == 0, random);
    if (planted.found.empty()) {
      ++missed;
      std::printf("not found on %s: %s\n", board, planted.words.c_str());
    }
  }
  EXPECT_LE(static_cast<double>(missed), kHarmless * static_cast<double>(count));
}

INSTANTIATE_TEST_SUITE_P(Missions, PlantedFaults,
                         testing::Values("gallery/thermocline", "gallery/survey_box",
                                         "gallery/bloom"),
                         [](const auto& param) {
                           std::string name = param.param;
                           return name.substr(name.find('/') + 1);
                         });

/// Another value of the first word of the constants whose names begin so.
void changeFirstWord(llvm::Module& module, llvm::StringRef names, unsigned field) {
  for (llvm::GlobalVariable& variable : module.globals()) {
    if (!variable.getName().starts_with(names)) {
      continue;
    }
    llvm::Constant* list = variable.getInitializer();
    llvm::Constant* row = list->getAggregateElement(0U);
    const auto* held = llvm::cast<llvm::ConstantInt>(row->getAggregateElement(field));
    std::vector<llvm::Constant*> fields;
    for (unsigned i = 0; llvm::Constant* one = row->getAggregateElement(i); ++i) {
      fields.push_back(i == field ? llvm::ConstantInt::get(held->getType(), held->getValue() + 1)
                                  : one);
    }
    std::vector<llvm::Constant*> rows{
        llvm::ConstantStruct::get(llvm::cast<llvm::StructType>(row->getType()), fields)};
    for (unsigned i = 1; llvm::Constant* one = list->getAggregateElement(i); ++i) {
      rows.push_back(one);
    }
    variable.setInitializer(
        llvm::ConstantArray::get(llvm::cast<llvm::ArrayType>(list->getType()), rows));
    return;
  }
  ADD_FAILURE() << "no constant " << names.str();
}

TEST(PlantedFaultsInTables, AreFound) {
  const auto compilation =
      compiler::compileMission(GLIDER_SOURCE_DIR "/missions/gallery/thermocline.mission");
  ASSERT_TRUE(compilation && compilation->checked);
  const compiler::Optimised mission = compiler::optimise(compilation->checked);
  struct Fault {
    const char* names;
    unsigned field;
    const char* found;
  };
  constexpr Fault kFaults[] = {{"cases.", codegen::field::GliderCaseInfo::transition, "transition"},
                               {"cases.", codegen::field::GliderCaseInfo::target, "target"},
                               {"sensors", codegen::field::GliderSensorInfo::id, "sensor"},
                               {"log_items.", codegen::field::GliderLogInfo::sensor, "log"}};
  for (const Fault& fault : kFaults) {
    const auto found = validate(mission.input(), "host", 2, [&](llvm::Module& module) {
      changeFirstWord(module, fault.names, fault.field);
    });
    EXPECT_THAT(whatIsNotSame(found), testing::HasSubstr(fault.found));
  }
}

}  // namespace
}  // namespace glider::validate_test
