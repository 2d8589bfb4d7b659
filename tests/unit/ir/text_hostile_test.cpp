// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate.h"
#include "ir/text/print.h"
#include "tests/random_missions/random.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/ir/missions.h"

#include <sstream>

namespace glider::ir {
namespace {

/// Any bytes give a valid mission or errors, never both, never neither.
void expectAnswer(const std::string& text) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto mission = read(sources, sources.add("hostile", text), diagnostics);
  ASSERT_NE(mission.has_value(), diagnostics.hasErrors()) << text;
  ASSERT_FALSE(support::render(diagnostics, sources, false).empty() && !mission);
  if (mission) {
    ASSERT_TRUE(validate(*mission).empty()) << text;
    ASSERT_FALSE(print(*mission).empty());
  }
}

TEST(IrTextHostile, EveryTruncation) {
  const std::string text = print(random_missions::flownMission(3));
  for (size_t size = 0; size < std::min<size_t>(text.size(), 2500); ++size) {
    expectAnswer(text.substr(0, size));
  }
}

TEST(IrTextHostile, BytesChangedLostAndDoubled) {
  random_missions::Random random(1);
  std::vector<std::string> texts;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    texts.push_back(print(random_missions::flownMission(seed)));
  }
  constexpr std::string_view kBytes = "()%:,=\"\\# \n0123456789-+.einfx_\xff\x80";
  for (int round = 0; round < 2500; ++round) {
    std::string text = random.pick(texts);
    for (uint32_t changes = random.between(1, 4); changes > 0; --changes) {
      const size_t at = random.below(text.size());
      const size_t length = random.between(1, 12);
      switch (random.below(4)) {
        case 0:
          text[at] = kBytes[random.below(kBytes.size())];
          break;
        case 1:
          text[at] = static_cast<char>(random.below(256));
          break;
        case 2:
          text.erase(at, length);
          break;
        default:
          text.insert(random.below(text.size()), text.substr(at, length));
      }
    }
    expectAnswer(text);
  }
}

TEST(IrTextHostile, WordsExchanged) {
  random_missions::Random random(2);
  std::vector<std::vector<std::string>> missions(20);
  for (uint64_t seed = 0; seed < missions.size(); ++seed) {
    std::istringstream in(print(random_missions::flownMission(seed)));
    for (std::string word; in >> word;) {
      missions[seed].push_back(word);
    }
  }
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::string> words = random.pick(missions);
    for (uint32_t changes = random.between(1, 3); changes > 0; --changes) {
      const uint32_t from = random.below(words.size());
      words[random.below(words.size())] = words[from];
    }
    std::string text;
    for (const std::string& word : words) {
      text += word + " ";
    }
    expectAnswer(text);
  }
}

TEST(IrTextHostile, HugeAndDeep) {
  const auto nested = [](size_t depth, const std::string& open) {
    std::string text = kHeader + "state a route drift () profile glide () case ";
    for (size_t i = 0; i < depth; ++i) {
      text += open;
    }
    return text;
  };
  expectAnswer(nested(1'000'000, "("));
  expectAnswer(nested(1'000'000, "(not "));
  expectAnswer(nested(1'000'000, "%"));
  expectAnswer(std::string(1'000'000, '"'));
  expectAnswer(std::string(1'000'000, '9'));
  expectAnswer(kHeader + "sensor " + std::string(1'000'000, 'x'));
  expectAnswer(kHeader + std::string(1000, '\0'));
  expectAnswer("");
}

}  // namespace
}  // namespace glider::ir
