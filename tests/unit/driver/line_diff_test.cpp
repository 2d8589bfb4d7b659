// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/line_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

/// What a difference of two texts says, and that it turns the one into the other: applied by a
/// reader of the unified form that shares nothing with its writer.
namespace glider::driver {
namespace {

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text) {
  Lines lines;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    lines.push_back(text.substr(at, end - at));
    at = end;
  }
  return lines;
}

/// What `diff` makes of `before`; every line that it keeps or drops is looked for where its hunk
/// says. `kept`: the lines kept in all.
class Patch {
 public:
  explicit Patch(const std::string& before) : before_(linesOf(before)) {}

  std::string apply(const std::string& diff) {
    const Lines lines = linesOf(diff);
    EXPECT_EQ(lines.at(0), "--- m\n");
    EXPECT_EQ(lines.at(1), "+++ m\n");
    for (size_t i = 2; i < lines.size();) {
      i = hunk(lines, i);
    }
    while (at_ < before_.size()) {
      take(before_[at_++]);
    }
    std::string text;
    for (const std::string& line : out_) {
      text += line;
    }
    return text;
  }

  size_t dropped = 0, added = 0, hunks = 0;

 private:
  size_t hunk(const Lines& lines, size_t i) {
    size_t a = 0, a_count = 0, b = 0, b_count = 0;
    EXPECT_EQ(std::sscanf(lines[i].c_str(), "@@ -%zu,%zu +%zu,%zu @@", &a, &a_count, &b, &b_count),
              4)
        << lines[i];
    ++hunks;
    // A side without lines is numbered by the line before it.
    const size_t begin = a_count == 0 ? a : a - 1;
    EXPECT_GE(begin, at_) << "hunks overlap";
    while (at_ < begin && at_ < before_.size()) {
      take(before_[at_++]);
    }
    EXPECT_EQ(b_count == 0 ? b : b - 1, out_.size()) << lines[i];
    size_t from = 0, to = 0;
    for (++i; i < lines.size() && !lines[i].starts_with("@@"); ++i) {
      std::string line = lines[i].substr(1);
      if (i + 1 < lines.size() && lines[i + 1].starts_with("\\ No newline")) {
        line.pop_back();
      }
      switch (lines[i][0]) {
        case ' ':
        case '-':
          EXPECT_LT(at_, before_.size());
          EXPECT_EQ(line, before_.at(at_)) << "line " << at_ + 1;
          ++at_;
          ++from;
          if (lines[i][0] == ' ') {
            ++to;
            take(line);
          } else {
            ++dropped;
          }
          break;
        case '+':
          ++to;
          ++added;
          take(line);
          break;
        default:
          EXPECT_EQ(lines[i], "\\ No newline at end of file\n");
      }
    }
    EXPECT_EQ(from, a_count);
    EXPECT_EQ(to, b_count);
    return i;
  }

  void take(const std::string& line) { out_.push_back(line); }

  Lines before_, out_;
  size_t at_ = 0;
};

/// The length of the longest common subsequence, by its definition.
size_t longestCommon(const Lines& a, const Lines& b) {
  std::vector<std::vector<size_t>> table(a.size() + 1, std::vector<size_t>(b.size() + 1, 0));
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < b.size(); ++j) {
      table[i + 1][j + 1] =
          a[i] == b[j] ? table[i][j] + 1 : std::max(table[i + 1][j], table[i][j + 1]);
    }
  }
  return table[a.size()][b.size()];
}

TEST(LineDiff, EqualTextsHaveNone) {
  EXPECT_EQ(lineDiff("m", "", ""), "");
  EXPECT_EQ(lineDiff("m", "a\nb", "a\nb"), "");
}

TEST(LineDiff, SaysWhatAPilotReads) {
  EXPECT_EQ(lineDiff("yo.mission", "1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nfive\n6\n7\n8\n9\n"),
            "--- yo.mission\n+++ yo.mission\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+five\n 6\n 7\n 8\n");
  EXPECT_EQ(lineDiff("m", "", "a\n"), "--- m\n+++ m\n@@ -0,0 +1,1 @@\n+a\n");
  EXPECT_EQ(lineDiff("m", "a\n", ""), "--- m\n+++ m\n@@ -1,1 +0,0 @@\n-a\n");
  EXPECT_EQ(lineDiff("m", "a", "a\n"),
            "--- m\n+++ m\n@@ -1,1 +1,1 @@\n-a\n\\ No newline at end of file\n+a\n");
}

TEST(LineDiff, ChangesWithinFiveLinesShareAHunk) {
  std::string before, near, far;
  for (int i = 1; i <= 30; ++i) {
    const std::string line = std::to_string(i) + "\n";
    before += line;
    near += i == 10 || i == 16 ? "x\n" : line;
    far += i == 10 || i == 17 ? "x\n" : line;
  }
  Patch one(before), two(before);
  EXPECT_EQ(one.apply(lineDiff("m", before, near)), near);
  EXPECT_EQ(one.hunks, 1U) << "five lines between them";
  EXPECT_EQ(two.apply(lineDiff("m", before, far)), far);
  EXPECT_EQ(two.hunks, 2U) << "six: the hunks touch";
}

TEST(LineDiff, TurnsAnyTextIntoAnyOtherWithTheFewestLines) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto text = [&](const std::string& like) {
      Lines lines = linesOf(like);
      const size_t changes = random() % 4;
      for (size_t k = 0; k < changes; ++k) {
        const size_t at = random() % (lines.size() + 1);
        if (random() % 2 == 0 || at == lines.size()) {
          lines.insert(lines.begin() + static_cast<ptrdiff_t>(at),
                       std::string(1, static_cast<char>('a' + random() % 4)) + "\n");
        } else {
          lines.erase(lines.begin() + static_cast<ptrdiff_t>(at));
        }
      }
      std::string all;
      for (const std::string& line : lines) {
        all += line;
      }
      return all;
    };
    std::string before;
    for (size_t count = random() % 40; count > 0; --count) {
      before += std::string(1, static_cast<char>('a' + random() % 6)) + "\n";
    }
    std::string after = text(before);
    if (random() % 10 == 0 && !after.empty()) {
      after.pop_back();
    }
    const std::string diff = lineDiff("m", before, after);
    if (before == after) {
      ASSERT_EQ(diff, "");
      continue;
    }
    Patch patch(before);
    ASSERT_EQ(patch.apply(diff), after) << diff;
    const Lines a = linesOf(before), b = linesOf(after);
    const size_t common = longestCommon(a, b);
    ASSERT_EQ(patch.dropped, a.size() - common) << diff;
    ASSERT_EQ(patch.added, b.size() - common) << diff;
    if (testing::Test::HasFailure()) {
      FAIL() << before << "---\n" << after << "---\n" << diff;
    }
  }
}

TEST(LineDiff, AnEndThatWasBothSidesIsCountedOnce) {
  // The equal beginning and the equal end would overlap.
  Patch patch("a\na\n");
  EXPECT_EQ(patch.apply(lineDiff("m", "a\na\n", "a\na\na\n")), "a\na\na\n");
  EXPECT_EQ(patch.added, 1U);
  EXPECT_EQ(patch.dropped, 0U);
}

TEST(LineDiff, VeryManyLinesAreOneChange) {
  std::string before, after;
  for (int i = 0; i < 4100; ++i) {
    before += "a" + std::to_string(i) + "\n";
    after += "b" + std::to_string(i) + "\n";
  }
  before += "end\n";
  after += "end\n";
  Patch patch(before);
  EXPECT_EQ(patch.apply(lineDiff("m", before, after)), after);
  EXPECT_EQ(patch.dropped, 4100U);
  EXPECT_EQ(patch.added, 4100U);
  EXPECT_EQ(patch.hunks, 1U);
}

}  // namespace
}  // namespace glider::driver
