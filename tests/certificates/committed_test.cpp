// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What was proved about the example missions (tests/proofs/properties.txt) is accepted by the
// second check.

#include "tests/certificates/issued.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <gtest/gtest.h>

#include <map>

namespace glider::tests {
namespace {

/// The proved requirements of each mission.
const std::map<std::string, std::vector<std::string>>& proved() {
  static const auto all = [] {
    std::map<std::string, std::vector<std::string>> missions;
    for (const Property& property : properties()) {
      if (property.verdict == "proved") {
        missions[property.mission].push_back(property.requirement);
      }
    }
    return missions;
  }();
  return all;
}

std::vector<std::string> missions() {
  std::vector<std::string> names;
  for (const auto& [name, requirements] : proved()) {
    names.push_back(name);
  }
  return names;
}

class CommittedProofs : public testing::TestWithParam<std::string> {};

TEST_P(CommittedProofs, AreAcceptedByTheSecondCheck) {
  if (!solverIsInstalled()) {
    GTEST_SKIP() << "cvc5 is not installed";
  }
  std::string text =
      frontend::testing_support::readWithoutPromises("missions/" + GetParam() + ".mission");
  for (const std::string& requirement : proved().at(GetParam())) {
    text += "require " + requirement + "\n";
  }
  const Issued issued = issue(text);
  ASSERT_EQ(issued.findings.requirements.size(), proved().at(GetParam()).size());
  for (uint32_t i = 0; i < issued.findings.requirements.size(); ++i) {
    SCOPED_TRACE(proved().at(GetParam())[i]);
    const std::string file = issued.file(i);
    ASSERT_FALSE(file.empty()) << "no certificate";
    const analysis::Rechecked found = issued.rechecked(i, file);
    EXPECT_TRUE(found.accepted) << found.reason;
    EXPECT_GT(found.obligations, 0U);
  }
}

std::string nameOf(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Missions, CommittedProofs, testing::ValuesIn(missions()), nameOf);

}  // namespace
}  // namespace glider::tests
