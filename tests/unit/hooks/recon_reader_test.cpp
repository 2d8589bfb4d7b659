// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Finding lines in what arrives.

#include "hooks/recon/line_reader.h"
#include "tests/fuzz/recon_hostile.h"
#include "tests/unit/hooks/recon_described.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace glider::hooks::recon {
namespace {

using recon_described::described;
using recon_described::lineOf;
using recon_described::randomValues;
using recon_described::summed;

using Lines = std::vector<std::string>;

struct Found {
  Lines lines;
  uint32_t skipped = 0, held = 0;
};

Found linesIn(const std::string& bytes) {
  LineReader reader;
  Found found;
  for (const char byte : bytes) {
    Line line;
    if (reader.push(static_cast<uint8_t>(byte), &line)) {
      found.lines.emplace_back(line.text, line.size);
    }
  }
  found.skipped = reader.skippedBytes();
  found.held = reader.held();
  return found;
}

constexpr char kOn[] = "#E,1,*1B\n";
constexpr char kQuery[] = "#s,Time,query,*09\n";

TEST(ReconReader, GivesLinesInTheirOrder) {
  const Found found = linesIn(std::string(kOn) + kQuery + kOn);
  EXPECT_EQ(found.lines, Lines({"#E,1,", "#s,Time,query,", "#E,1,"}));
  EXPECT_EQ(found.skipped, 0U);
  EXPECT_EQ(found.held, 0U);
}

TEST(ReconReader, ALineWithAnotherSumIsSkipped) {
  for (const char* line :
       {"#E,1,*1C\n", "#E,1,*1b\n", "#E,1,*B1\n", "#E,0,*1B\n", "#E,1,1B\n", "#E,1,*1B \n",
        "#E,1,* 1B\n", "#E,1,*1\n", "E,1,*F8\n", "*2A\n", "\n", "#E\x01,1,*1C\n", "#E,1,*1B1B\n"}) {
    const Found found = linesIn(std::string(line) + "\n" + kOn);
    EXPECT_EQ(found.lines, Lines({"#E,1,"})) << line;
  }
  EXPECT_EQ(linesIn("#E,1,*1C\n").skipped, 9U);
}

TEST(ReconReader, EveryWrongByteIsSeen) {
  const std::string line = kQuery;
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    for (int other = 0; other < 256; ++other) {
      std::string wrong = line;
      wrong[i] = static_cast<char>(other);
      if (wrong != line) {
        EXPECT_TRUE(linesIn(wrong).lines.empty()) << wrong;
      }
    }
  }
}

TEST(ReconReader, ALineThatWasCutOffCostsOnlyItself) {
  const std::string state = "#S,T15:46:20.5,LAT41N3";
  const Found found = linesIn(state + kOn);
  EXPECT_EQ(found.lines, Lines({"#E,1,"}));
  EXPECT_EQ(found.skipped, state.size());
  EXPECT_EQ(linesIn("\xFF\x00noise" + std::string(kOn)).lines, Lines({"#E,1,"}));
}

TEST(ReconReader, TextsMayHoldTheMarks) {
  for (const char* text : {"#m,MSG_DATA,1,2,a#b,*", "#m,MSG_DATA,1,2,a*b,*", "#m,*41,#E,1,*"}) {
    const std::string line = summed(text);
    EXPECT_EQ(linesIn(line).lines, Lines({line.substr(0, line.size() - 4)}));
  }
}

TEST(ReconReader, ACarriageReturnMayStandBeforeTheLineFeed) {
  const Found found = linesIn("#E,1,*1B\r\n\r\n#E,1,*1B\r\r\n");
  EXPECT_EQ(found.lines, Lines({"#E,1,"}));
  EXPECT_EQ(found.skipped, 2U + 11U);
}

TEST(ReconReader, ALineHasAtMost1024Bytes) {
  const std::string most = summed("#G," + std::string(1024 - 8, 'x') + ",*");
  ASSERT_EQ(most.size(), kMostLine);
  EXPECT_EQ(linesIn(most).lines.size(), 1U);
  const std::string more = summed("#G," + std::string(1024 - 7, 'x') + ",*");
  const Found found = linesIn(more + kOn);
  EXPECT_EQ(found.lines, Lines({"#E,1,"}));
  EXPECT_EQ(found.skipped, more.size());
  const Found noise = linesIn(std::string(5000, '#') + "\n" + kOn);
  EXPECT_EQ(noise.lines, Lines({"#E,1,"}));
  EXPECT_EQ(noise.skipped, 5001U);
  // A line that begins within one that is too long is lost with it.
  EXPECT_TRUE(linesIn(std::string(2000, 'x') + kOn).lines.empty());
}

int count() {
  const char* const given = std::getenv("GLIDER_RECON_LINES");
  return given != nullptr ? std::atoi(given) : 10000;
}

/// A share of what tests/fuzz/recon_fuzzer.cpp does.
TEST(ReconHostile, StreamsAreReadAsASlowReaderReadsThem) {
  std::mt19937 random(7);
  const std::vector<std::string> names = described();
  for (int done = 0; done < count(); done += 8) {
    recon_hostile::Bytes stream;
    for (int i = 0; i < 8; ++i) {
      const std::string& name = names[random() % names.size()];
      std::string line = lineOf(name, randomValues(name, random));
      if (random() % 4 == 0) {
        line.resize(random() % line.size());
      } else if (random() % 4 == 0) {
        line[random() % line.size()] ^= static_cast<char>(1U << random() % 8);
      }
      stream.insert(stream.end(), line.begin(), line.end());
      for (auto n = random() % 12; n > 8; --n) {
        stream.push_back(static_cast<uint8_t>("#*\n,A0"[random() % 6]));
      }
    }
    recon_hostile::requireReader(stream);
  }
}

}  // namespace
}  // namespace glider::hooks::recon
