// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/line_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace glider::driver {
namespace {

using Lines = std::vector<std::string_view>;

constexpr size_t kContext = 3;

/// Lines with their `\n`; the last may lack it.
Lines split(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// One line of the comparison: kept (' '), dropped ('-') or new ('+').
struct Edit {
  char sign;
  std::string_view line;
};

/// The longest common subsequence of the lines between the equal beginnings and ends; beyond
/// `kLargest` pairs of lines all of them count as changed.
class Comparison {
 public:
  Comparison(const Lines& before, const Lines& after) : a_(before), b_(after) {}

  std::vector<Edit> run() {
    while (i_ < a_.size() && i_ < b_.size() && a_[i_] == b_[i_]) {
      edits_.push_back({' ', a_[i_++]});
    }
    j_ = i_;
    size_t same_end = 0;
    while (a_.size() - same_end > i_ && b_.size() - same_end > j_ &&
           a_[a_.size() - same_end - 1] == b_[b_.size() - same_end - 1]) {
      ++same_end;
    }
    middle(a_.size() - same_end, b_.size() - same_end);
    for (; i_ < a_.size(); ++i_) {
      edits_.push_back({' ', a_[i_]});
    }
    return std::move(edits_);
  }

 private:
  void middle(size_t a_end, size_t b_end) {
    constexpr size_t kLargest = 16'000'000;
    const size_t rows = a_end - i_ + 1;
    const size_t columns = b_end - j_ + 1;
    if (rows <= kLargest / columns) {
      common(a_end, b_end, columns);
    }
    while (i_ < a_end) {
      edits_.push_back({'-', a_[i_++]});
    }
    while (j_ < b_end) {
      edits_.push_back({'+', b_[j_++]});
    }
  }

  void common(size_t a_end, size_t b_end, size_t columns) {
    // longest[r * columns + c]: of the common subsequences of what follows the lines r and c.
    const size_t a_begin = i_;
    const size_t b_begin = j_;
    std::vector<uint32_t> longest((a_end - a_begin + 1) * columns, 0);
    auto cell = [&](size_t r, size_t c) -> uint32_t& {
      return longest[(r - a_begin) * columns + c - b_begin];
    };
    for (size_t r = a_end; r-- > a_begin;) {
      for (size_t c = b_end; c-- > b_begin;) {
        cell(r, c) =
            a_[r] == b_[c] ? cell(r + 1, c + 1) + 1 : std::max(cell(r + 1, c), cell(r, c + 1));
      }
    }
    while (i_ < a_end && j_ < b_end) {
      if (a_[i_] == b_[j_]) {
        edits_.push_back({' ', a_[i_++]});
        ++j_;
      } else if (cell(i_ + 1, j_) >= cell(i_, j_ + 1)) {
        edits_.push_back({'-', a_[i_++]});
      } else {
        edits_.push_back({'+', b_[j_++]});
      }
    }
  }

  const Lines& a_;
  const Lines& b_;
  size_t i_ = 0;
  size_t j_ = 0;
  std::vector<Edit> edits_;
};

/// The changes from edit `first` to `end`, with the numbers of their lines.
std::string hunk(const std::vector<Edit>& edits, size_t first, size_t end) {
  auto count = [&](size_t from, size_t to, char other) {
    return std::count_if(edits.begin() + static_cast<ptrdiff_t>(from),
                         edits.begin() + static_cast<ptrdiff_t>(to),
                         [other](const Edit& e) { return e.sign != other; });
  };
  const auto a = count(first, end, '+');
  const auto b = count(first, end, '-');
  std::string out = fmt::format("@@ -{},{} +{},{} @@\n", count(0, first, '+') + (a > 0 ? 1 : 0), a,
                                count(0, first, '-') + (b > 0 ? 1 : 0), b);
  for (size_t i = first; i < end; ++i) {
    out += edits[i].sign;
    out += edits[i].line;
    out += edits[i].line.ends_with('\n') ? "" : "\n\\ No newline at end of file\n";
  }
  return out;
}

}  // namespace

std::string lineDiff(std::string_view name, std::string_view before, std::string_view after) {
  if (before == after) {
    return {};
  }
  const Lines a = split(before);
  const Lines b = split(after);
  const std::vector<Edit> edits = Comparison(a, b).run();
  std::string out = fmt::format("--- {0}\n+++ {0}\n", name);
  for (size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].sign == ' ') {
      continue;
    }
    size_t end = i + 1;
    for (size_t next = end; next < edits.size() && next < end + 2 * kContext; ++next) {
      end = edits[next].sign == ' ' ? end : next + 1;
    }
    out += hunk(edits, i - std::min(i, kContext), std::min(edits.size(), end + kContext));
    i = end;
  }
  return out;
}

}  // namespace glider::driver
