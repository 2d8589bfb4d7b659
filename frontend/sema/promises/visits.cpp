// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::frontend {
namespace {

using ir::ExprId;
using ir::VariableId;

/// The places that were visited, each after the one before it if that matters.
class Visits {
 public:
  Visits(const std::vector<PromisedPlace>& places, ast::Manner manner, Pattern& pattern)
      : places_(places), manner_(manner), p_(pattern), m_(pattern.monitor) {
    for (const PromisedPlace& place : places) {
      visited_.push_back(m_.flag("visited " + place.words));
    }
  }

  /// Takes what this tick visits, unless `late` is true; an invalid one is never true.
  void take(ExprId late) {
    if (manner_ == ast::Manner::StrictOrder) {
      refuseAgain();
    }
    for (size_t i = 0; i < places_.size(); ++i) {
      ExprId counts = p_.sight.visited(places_[i]);
      counts = inOrder() && i > 0 ? m_.both(m_.read(visited_[i - 1]), counts) : counts;
      counts = late.valid() ? m_.both(m_.negation(late), counts) : counts;
      m_.when(counts, [&] { m_.set(visited_[i], true); });
      if (isOrdered() && i + 1 < places_.size()) {
        refuseEarly(i);
      }
    }
  }

  /// It is violated where `at` is true and a place is missing.
  void refuseMissing(ExprId at, const std::string& when) {
    for (size_t i = 0; i < places_.size(); ++i) {
      ExprId missing = m_.both(at, m_.negation(m_.read(visited_[i])));
      missing = inOrder() && i > 0 ? m_.both(m_.read(visited_[i - 1]), missing) : missing;
      m_.violation(
          missing,
          fmt::format("{}{} had not been {}{}", when, places_[i].words, places_[i].visited(),
                      inOrder() && i > 0 ? " after " + places_[i - 1].words : ""));
    }
  }

  [[nodiscard]] VariableId last() const { return visited_.back(); }
  void forget() {
    for (const VariableId one : visited_) {
      m_.set(one, false);
    }
  }

 private:
  [[nodiscard]] bool isOrdered() const {
    return manner_ == ast::Manner::Order || manner_ == ast::Manner::StrictOrder;
  }
  [[nodiscard]] bool inOrder() const { return isOrdered() || manner_ == ast::Manner::Sequence; }

  void refuseEarly(size_t i) {
    m_.violation(m_.both(p_.sight.visited(places_[i + 1]), m_.negation(m_.read(visited_[i]))),
                 fmt::format("{} was visited before {}", places_[i + 1].words, places_[i].words));
  }

  /// The first visit to a place is followed by none until the next place is visited.
  void refuseAgain() {
    for (size_t i = 0; i + 1 < places_.size(); ++i) {
      const ExprId begins = p_.sight.begins(places_[i]);
      const ExprId open = m_.both(m_.read(visited_[i]), m_.negation(m_.read(visited_[i + 1])));
      const ExprId next = m_.isTrue(p_.sight.visited(places_[i + 1]));
      m_.violation(
          m_.both(m_.both(begins, open), m_.negation(next)),
          fmt::format("{} was visited again before {}", places_[i].words, places_[i + 1].words));
    }
  }

  const std::vector<PromisedPlace>& places_;
  ast::Manner manner_;
  Pattern& p_;
  ir::MonitorWriter& m_;
  std::vector<VariableId> visited_;
};

}  // namespace

void writeVisit(const std::vector<PromisedPlace>& places, ast::Manner manner,
                const PromiseTime& within, Pattern& pattern) {
  Visits visits(places, manner, pattern);
  visits.take(pattern.late(within));
  visits.refuseMissing(pattern.late(within), fmt::format("{} had passed, and ", within.words));
  visits.refuseMissing(pattern.over, pattern.ended + ", and ");
  if (manner == ast::Manner::Fairly) {
    writeFairness(places, pattern);
  }
}

namespace {

/// Each place by itself.
void patrolEach(const std::vector<PromisedPlace>& places, const PromiseTime& every,
                Pattern& pattern) {
  ir::MonitorWriter& monitor = pattern.monitor;
  for (const PromisedPlace& place : places) {
    const VariableId last = monitor.clock("last " + place.words);
    monitor.violation(pattern.sight.watched(monitor.passed(last, every.seconds)),
                      fmt::format("{} had not been {} for more than {}", place.words,
                                  place.visited(), every.words));
    monitor.when(pattern.sight.visited(place), [&] { monitor.set(last, monitor.now()); });
  }
}

}  // namespace

void writePatrol(const std::vector<PromisedPlace>& places, ast::Manner manner,
                 const PromiseTime& every, Pattern& pattern) {
  ir::MonitorWriter& monitor = pattern.monitor;
  monitor.longest(every.seconds);
  const auto is_state = [](const PromisedPlace& place) { return place.state.valid(); };
  if (!std::ranges::all_of(places, is_state)) {
    monitor.everyTick();  // a tick that is left out would be one without a visit
  }
  if (manner == ast::Manner::AnyOrder || manner == ast::Manner::Fairly) {
    patrolEach(places, every, pattern);
  } else {
    const VariableId round = monitor.clock("round");
    Visits visits(places, ast::Manner::Sequence, pattern);
    visits.refuseMissing(pattern.sight.watched(monitor.passed(round, every.seconds)),
                         fmt::format("more than {} after the last round, ", every.words));
    visits.take({});
    monitor.when(monitor.read(visits.last()), [&] {
      visits.forget();
      monitor.set(round, monitor.now());
    });
  }
  if (manner == ast::Manner::Order || manner == ast::Manner::StrictOrder) {
    writeOrder(places, pattern);
  }
  if (manner == ast::Manner::StrictOrder || manner == ast::Manner::Fairly) {
    writeFairness(places, pattern);
  }
}

}  // namespace glider::frontend
