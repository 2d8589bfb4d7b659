// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/protocol/notices.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

namespace glider::hooks {
namespace {

/// "field number" → how its meaning begins.
using Notices = std::map<std::string, std::string>;

Notices listed() {
  Notices notices;
#define TRANSITION(name, number, word) notices["transition " #number] = "`" word "`";
#define CASE_LIST(name, number, word) notices["list " #number] = "`" word "`";
#define NOTE_KIND(name, number, meaning) notices["kind " #number] = meaning;
#include "hooks/protocol/notices.def"
  return notices;
}

/// The table of README.md, "Notices".
Notices documented() {
  std::ifstream in(GLIDER_SOURCE_DIR "/hooks/protocol/README.md");
  Notices notices;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    inside = line.starts_with("## ") ? line == "## Notices" : inside;
    const size_t number = line.find(" | "), meaning = line.find(" | ", number + 1);
    if (inside && line.starts_with("| ") && !line.starts_with("| field") &&
        meaning != std::string::npos) {
      notices[line.substr(2, number - 2) + line.substr(number + 2, meaning - number - 2)] =
          line.substr(meaning + 3);
    }
  }
  return notices;
}

TEST(Notices, AreTheTableOfTheProtocol) {
  const Notices table = documented();
  EXPECT_EQ(table.size(), listed().size());
  for (const auto& [number, meaning] : listed()) {
    ASSERT_TRUE(table.contains(number)) << number;
    EXPECT_TRUE(table.at(number).starts_with(meaning)) << number << ": " << table.at(number);
  }
}

/// Logs and vehicles of earlier versions rely on them.
TEST(Notices, KeepTheirNumbers) {
  EXPECT_EQ(static_cast<int>(Transition::Goto), 0);
  EXPECT_EQ(static_cast<int>(Transition::Exit), 3);
  EXPECT_EQ(static_cast<int>(CaseList::Always), 0);
  EXPECT_EQ(static_cast<int>(NoteKind::UnknownSet), 1);
  EXPECT_STREQ(transitionWord(2), "return");
  EXPECT_EQ(transitionWord(6), nullptr);
  EXPECT_EQ(transitionWord(256), nullptr) << "more than a byte";
}

}  // namespace
}  // namespace glider::hooks
