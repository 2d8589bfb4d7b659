// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

#include <vector>

namespace glider::frontend {
namespace {

using ir::ExprId;
using ir::VariableId;

/// Counts up to a number of visits. A few are kept as truth values, for which proofs are found much
/// more often than for a number.
class VisitCounter {
 public:
  VisitCounter(uint32_t most, ir::MonitorWriter& monitor) : m_(monitor), most_(most) {
    constexpr uint32_t kFew = 10;
    if (most > kFew) {
      number_ = m_.counter("visits", most);
      return;
    }
    for (uint32_t i = 1; i <= most; ++i) {
      reached_.push_back(m_.flag(fmt::format("visits {}", i)));
    }
  }

  /// To be written where a visit begins.
  void count() {
    if (reached_.empty()) {
      const ir::Type plain = plainNumber();
      const ExprId before = m_.read(number_);
      const ExprId after = m_.operation(ir::Op::Add, plain, {before, m_.number(1, plain)});
      m_.set(number_, m_.operation(ir::Op::Min, plain, {after, m_.number(most_, plain)}));
      return;
    }
    for (size_t i = reached_.size() - 1; i > 0; --i) {
      m_.when(m_.read(reached_[i - 1]), [&] { m_.set(reached_[i], true); });
    }
    m_.set(reached_.front(), true);
  }

  /// Whether there were so many: from 1 to `most`.
  ExprId atLeast(uint32_t visits) {
    if (!reached_.empty()) {
      return m_.read(reached_.at(visits - 1));
    }
    const ExprId now = m_.read(number_);
    return m_.operation(ir::Op::GreaterEqual, boolean(), {now, m_.number(visits, plainNumber())});
  }

 private:
  ir::MonitorWriter& m_;
  uint32_t most_;
  VariableId number_;
  std::vector<VariableId> reached_;
};

}  // namespace

void writeCount(const PromisedPlace& place, ast::CountBound bound, uint32_t times,
                const PromiseTime& within, Pattern& pattern) {
  ir::MonitorWriter& m = pattern.monitor;
  const bool bounded = bound != ast::CountBound::AtLeast;
  VisitCounter visits(times + (bounded ? 1 : 0), m);
  if (bound == ast::CountBound::AtMost) {
    m.when(pattern.sight.begins(place), [&] { visits.count(); });
  } else {
    const ExprId late = pattern.late(within);
    const ExprId begins = pattern.sight.begins(place);
    const std::string words =
        times == 1 ? fmt::format("{} had not been {}", place.words, place.visited())
                   : fmt::format("{} had been visited fewer than {} times", place.words, times);
    m.violation(m.both(late, m.negation(visits.atLeast(times))),  // this tick comes too late
                fmt::format("{} had passed, and {}", within.words, words));
    m.when(begins, [&] { visits.count(); });
    m.violation(m.both(pattern.over, m.negation(visits.atLeast(times))),
                pattern.ended + ", and " + words);
  }
  if (bounded) {
    m.violation(visits.atLeast(times + 1),
                fmt::format("{} was visited more than {}", place.words,
                            times == 1 ? "once" : fmt::format("{} times", times)));
  }
}

}  // namespace glider::frontend
