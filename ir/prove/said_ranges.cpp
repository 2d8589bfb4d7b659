// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/said_ranges.h"

#include <iterator>

namespace glider::ir::prove {

void SaidRanges::add(const support::SourceRange& range) {
  if (cover(range)) {
    return;
  }
  const auto from = ends_.lower_bound({range.file, range.begin});
  ends_.erase(from, ends_.lower_bound({range.file, range.end}));
  ends_[{range.file, range.begin}] = range.end;
}

bool SaidRanges::cover(const support::SourceRange& range) const {
  const auto after = ends_.upper_bound({range.file, range.begin});
  if (after == ends_.begin()) {
    return false;
  }
  const auto& [place, end] = *std::prev(after);
  return place.first == range.file && range.end <= end;
}

bool SaidRanges::concern(const support::SourceRange& range) const {
  const auto first = ends_.lower_bound({range.file, range.begin});
  return cover(range) ||
         (first != ends_.end() && first->first.first == range.file && first->second <= range.end);
}

}  // namespace glider::ir::prove
