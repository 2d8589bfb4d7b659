// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/patterns.h"

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace glider::random_proofs {
namespace {

using frontend::Pattern;
using frontend::PromisedPlace;
namespace ast = glider::ast;

class Patterns {
 public:
  Patterns(ir::Mission& mission, Conditions& conditions, random_missions::Random& random)
      : m_(mission), conditions_(conditions), random_(random) {}

  void write(uint32_t chosen, ir::Requirement& requirement) {
    ir::MonitorWriter monitor(m_, fmt::format("require {}", m_.requirements.size() + 1),
                              requirement.range);
    std::optional<frontend::PlacedScope> scope;
    if (random_.chance(0.4)) {
      scope = frontend::PlacedScope{static_cast<ast::ScopeKind>(random_.below(5)), place(), {}};
      scope->to = scope->kind == ast::ScopeKind::FromTo ? std::optional(place()) : std::nullopt;
    }
    frontend::writeScoped(scope ? &*scope : nullptr, random_.chance(0.4), monitor,
                          [&](Pattern& pattern) { write(chosen, pattern); });
    monitor.finish(requirement);
  }

 private:
  void write(uint32_t chosen, Pattern& pattern) {
    const auto manner = static_cast<ast::Manner>(random_.below(5));
    switch (chosen) {
      case 0:
        return frontend::writeVisit(places(), manner, time(), pattern);
      case 1:
        return frontend::writePatrol(places(), manner, time(), pattern);
      case 2:
        return frontend::writeCount(place(), static_cast<ast::CountBound>(random_.below(3)),
                                    random_.between(1, 3), time(), pattern);
      case 3: {
        const PromisedPlace event = place();
        const auto when = static_cast<ast::NeverWhen>(random_.below(3));
        return frontend::writeNever(place(), when, when == ast::NeverWhen::Ever ? nullptr : &event,
                                    pattern);
      }
      case 4:
        return reaction(pattern);
      case 6:
        return climb(pattern);
      default: {
        const PromisedPlace held = place();
        return frontend::writeHold(held, place(), time(), pattern);
      }
    }
  }

  void reaction(Pattern& pattern) {
    ast::ReactionPromise node;
    node.timing = static_cast<ast::Timing>(random_.below(4));
    const bool both_ways =
        node.timing == ast::Timing::AtOnce || node.timing == ast::Timing::NextTick;
    node.trigger = static_cast<ast::Trigger>(random_.below(both_ways ? 3 : 2));
    const PromisedPlace cause = place();
    frontend::writeReaction(node, cause, place(), time(), pattern);
  }

  /// A state that climbs is followed by a small depth in about the time that the climb takes.
  void climb(Pattern& pattern) {
    const auto& climbs = conditions_.bounds().climbs;
    if (climbs.empty()) {
      return reaction(pattern);
    }
    const auto chosen = std::next(climbs.begin(), random_.below(climbs.size()));
    const PromisedPlace cause =
        random_.chance(0.3) ? place()
                            : PromisedPlace{m_.states[chosen->first].name, {chosen->first}, {}};
    constexpr double kDepths[] = {1, 1.5, 2, 3, 5, 10};
    const ir::ExprId up = conditions_.depthAtMost(random_.pick(kDepths));
    const PromisedPlace response{fmt::format("condition {}", up.index), {}, up};
    const double climb = chosen->second + conditions_.bounds().tick_gap_s;
    const double seconds = std::max(
        1.0, conditions_.near(random_.chance(0.3) ? climb * random_.uniform(0.3, 1.1) : climb));
    const frontend::PromiseTime within{seconds, fmt::format("{} s", seconds)};
    if (random_.chance(0.3)) {
      return frontend::writeVisit({response}, ast::Manner::AnyOrder, within, pattern);
    }
    ast::ReactionPromise node;
    node.timing = ast::Timing::Within;
    node.trigger = static_cast<ast::Trigger>(random_.below(2));
    frontend::writeReaction(node, cause, response, within, pattern);
  }

  /// Two at least, all of them different.
  std::vector<PromisedPlace> places() {
    std::vector<PromisedPlace> all = {place()};
    while (all.size() < 2 || random_.chance(0.2)) {
      const PromisedPlace next = place();
      const bool again = next.state.valid() && std::ranges::any_of(all, [&](const auto& p) {
                           return p.state == next.state;
                         });
      if (!again) {
        all.push_back(next);
      }
    }
    return all;
  }

  PromisedPlace place() {
    if (random_.chance(0.5)) {
      const uint32_t state = random_.below(m_.states.size());
      return {m_.states[state].name, {state}, {}};
    }
    const ir::ExprId condition = conditions_.any();
    return {fmt::format("condition {}", condition.index), {}, condition};
  }

  frontend::PromiseTime time() {
    const double seconds = conditions_.time();
    return {seconds, fmt::format("{} s", seconds)};
  }

  ir::Mission& m_;
  Conditions& conditions_;
  random_missions::Random& random_;
};

}  // namespace

std::span<const char* const> patterns() {
  static constexpr const char* kNames[] = {"visit",    "patrol", "count", "never",
                                           "reaction", "hold",   "climb"};
  return kNames;
}

void writePattern(uint32_t pattern, ir::Mission& mission, ir::Requirement& requirement,
                  Conditions& conditions, random_missions::Random& random) {
  Patterns(mission, conditions, random).write(pattern, requirement);
}

}  // namespace glider::random_proofs
