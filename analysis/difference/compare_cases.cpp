// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/compare_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace glider::analysis {
namespace {

using Pairs = std::vector<std::pair<size_t, size_t>>;

/// A longest common subsequence of the two lists: cases that are the same, in the same order.
Pairs commonCases(const std::vector<ListedCase>& before, const std::vector<ListedCase>& after) {
  const size_t rows = before.size();
  const size_t columns = after.size();
  std::vector<std::vector<uint32_t>> longest(rows + 1, std::vector<uint32_t>(columns + 1, 0));
  for (size_t i = rows; i-- > 0;) {
    for (size_t k = columns; k-- > 0;) {
      longest[i][k] = before[i].all == after[k].all
                          ? longest[i + 1][k + 1] + 1
                          : std::max(longest[i + 1][k], longest[i][k + 1]);
    }
  }
  Pairs common;
  for (size_t i = 0, k = 0; i < rows && k < columns;) {
    if (before[i].all == after[k].all) {
      common.emplace_back(i++, k++);
    } else if (longest[i + 1][k] >= longest[i][k + 1]) {
      ++i;
    } else {
      ++k;
    }
  }
  return common;
}

/// The cases that have no partner yet.
class UnmatchedCases {
 public:
  UnmatchedCases(const std::vector<ListedCase>& before, const std::vector<ListedCase>& after)
      : before_(before), after_(after), old_partner_(before.size()), new_partner_(after.size()) {}

  void pair(size_t was, size_t is) {
    old_partner_[was] = is;
    new_partner_[is] = was;
  }

  /// Pairs those for which `same` holds, in order; calls `tell` for each pair.
  template <typename Same, typename Tell>
  void pairIf(Same same, Tell tell) {
    for (size_t k = 0; k < after_.size(); ++k) {
      for (size_t i = 0; i < before_.size() && !new_partner_[k]; ++i) {
        if (!old_partner_[i] && same(i, k)) {
          pair(i, k);
          tell(i, k);
        }
      }
    }
  }

  /// Whether both come after the same case.
  [[nodiscard]] bool sameBefore(size_t was, size_t is) const {
    return was == 0 || is == 0 ? was == is : old_partner_[was - 1] == is - 1;
  }

  [[nodiscard]] bool isRemoved(size_t was) const { return !old_partner_[was]; }
  [[nodiscard]] bool isAdded(size_t is) const { return !new_partner_[is]; }

 private:
  const std::vector<ListedCase>& before_;
  const std::vector<ListedCase>& after_;
  std::vector<std::optional<size_t>> old_partner_, new_partner_;
};

}  // namespace

std::vector<std::string> compareCases(const std::vector<ListedCase>& before,
                                      const std::vector<ListedCase>& after) {
  UnmatchedCases rest(before, after);
  for (const auto& [was, is] : commonCases(before, after)) {
    rest.pair(was, is);
  }
  std::vector<std::string> lines;
  const auto changed = [&](size_t was, size_t is) {
    lines.push_back(fmt::format("changed: {} → {}", before[was].written, after[is].written));
  };
  rest.pairIf([&](size_t was, size_t is) { return before[was].all == after[is].all; },
              [&](size_t, size_t is) { lines.push_back("moved: " + after[is].written); });
  rest.pairIf([&](size_t was, size_t is) { return before[was].guard == after[is].guard; }, changed);
  rest.pairIf([&](size_t was, size_t is) { return rest.sameBefore(was, is); }, changed);
  for (size_t i = 0; i < before.size(); ++i) {
    if (rest.isRemoved(i)) {
      lines.push_back("removed: " + before[i].written);
    }
  }
  for (size_t k = 0; k < after.size(); ++k) {
    if (rest.isAdded(k)) {
      lines.push_back("added: " + after[k].written);
    }
  }
  return lines;
}

}  // namespace glider::analysis
