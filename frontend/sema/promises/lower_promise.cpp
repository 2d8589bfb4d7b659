// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/lower_promise.h"

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::frontend {

std::optional<double> promisedNumber(const ast::Expr& expr, const ir::Type& type,
                                     const std::string& what, Scope& scope) {
  const size_t before = scope.mission.exprs.size();
  const auto id = ExprLowering(scope).lowerAs(expr, type, what);
  const auto value = id ? evaluate(scope.mission, *id) : std::nullopt;
  scope.mission.exprs.resize(before);
  if (id && !value) {
    scope.report(support::diagnostics::notConstant, expr.where, scope.text(expr.where), what);
  }
  return value;
}

std::optional<PromiseTime> promisedTime(const ast::Expr& expr, std::string_view word,
                                        Scope& scope) {
  const auto seconds = promisedNumber(expr, quantity(support::dimension::time),
                                      fmt::format("the time of `{}`", word), scope);
  if (seconds && !(*seconds > 0)) {
    scope.report(support::diagnostics::requirementTime, expr.where, word, scope.text(expr.where));
    return std::nullopt;
  }
  return seconds ? std::optional(PromiseTime{*seconds, scope.text(expr.where)}) : std::nullopt;
}

std::optional<std::vector<PromisedPlace>> PromiseLowering::places(
    const std::vector<ast::Expr>& exprs, ast::Manner manner) {
  std::vector<PromisedPlace> places;
  bool right = true;
  for (const ast::Expr& expr : exprs) {
    auto place = lowerPlace(expr, scope_);
    right = right && place;
    const auto same = [&](const PromisedPlace& other) { return other.words == place->words; };
    const bool again =
        place && (manner == ast::Manner::Sequence ? !places.empty() && same(places.back())
                                                  : std::ranges::any_of(places, same));
    if (again) {
      scope_.report(support::diagnostics::placeRepeated, expr.where, scope_.text(expr.where));
      right = false;
    }
    if (place) {
      places.push_back(*std::move(place));
    }
  }
  return right ? std::optional(std::move(places)) : std::nullopt;
}

bool PromiseLowering::finish(const std::function<void(Pattern&)>& write) {
  std::optional<PlacedScope> scope;
  if (node_.scope) {
    auto place = lowerPlace(node_.scope->place, scope_);
    auto to = node_.scope->to ? lowerPlace(*node_.scope->to, scope_) : std::nullopt;
    if (!place || (node_.scope->to && !to)) {
      return false;
    }
    if (to && to->words == place->words) {
      const support::SourceRange& where = node_.scope->to->where;
      scope_.report(support::diagnostics::placeRepeated, where, scope_.text(where));
      return false;
    }
    scope = PlacedScope{node_.scope->kind, *std::move(place), std::move(to)};
  }
  ir::MonitorWriter monitor(scope_.mission,
                            fmt::format("promise {}", scope_.mission.requirements.size() + 1),
                            node_.where);
  writeScoped(scope ? &*scope : nullptr, node_.or_exit, monitor, write);
  monitor.finish(result_);
  return true;
}

bool PromiseLowering::lower(const ast::VisitPromise& promise) {
  const auto where = places(promise.places, promise.manner);
  const auto within = promisedTime(promise.within, "within", scope_);
  return where && within &&
         finish([&](Pattern& pattern) { writeVisit(*where, promise.manner, *within, pattern); });
}

bool PromiseLowering::lower(const ast::PatrolPromise& promise) {
  const auto where = places(promise.places, promise.manner);
  const auto every = promisedTime(promise.every, "every", scope_);
  return where && every &&
         finish([&](Pattern& pattern) { writePatrol(*where, promise.manner, *every, pattern); });
}

bool PromiseLowering::lower(const ast::CountPromise& promise) {
  constexpr double kMostVisits = 1e6;
  const auto place = lowerPlace(promise.place, scope_);
  const auto within = promise.within ? promisedTime(*promise.within, "within", scope_)
                                     : std::optional(PromiseTime());
  const auto times = promisedNumber(promise.times, plainNumber(), "the number of visits", scope_);
  if (times && !(*times >= 1 && *times <= kMostVisits && std::floor(*times) == *times)) {
    scope_.report(support::diagnostics::visitTimes, promise.times.where,
                  scope_.text(promise.times.where));
    return false;
  }
  return place && within && times && finish([&](Pattern& pattern) {
           writeCount(*place, promise.bound, static_cast<uint32_t>(*times), *within, pattern);
         });
}

bool PromiseLowering::neverTrue(ir::ExprId condition) {
  result_.kind = ir::RequirementKind::Always;
  result_.condition = ir::MissionWriter(scope_.mission, node_.where).negation(condition);
  return true;
}

bool PromiseLowering::lower(const ast::AlwaysPromise& promise) {
  const auto place = lowerPlace(promise.condition, scope_);
  return place && finish([&](Pattern& pattern) {
           pattern.monitor.violation(pattern.sight.fails(*place), place->words + " was false");
         });
}

bool PromiseLowering::lower(const ast::NeverPromise& promise) {
  const auto place = lowerPlace(promise.place, scope_);
  const auto event = promise.event ? lowerPlace(*promise.event, scope_) : std::nullopt;
  if (!place || (promise.event && !event)) {
    return false;
  }
  if (isPlain() && !event && place->condition.valid()) {
    return neverTrue(place->condition);
  }
  if (isPlain() && promise.when == ast::NeverWhen::After && place->state.valid() &&
      event->state.valid()) {
    result_.kind = ir::RequirementKind::NeverAfter;
    result_.state = place->state;
    result_.after = event->state;
    return true;
  }
  return finish([&](Pattern& pattern) {
    writeNever(*place, promise.when, event ? &*event : nullptr, pattern);
  });
}

bool PromiseLowering::lower(const ast::ReactionPromise& promise) {
  const auto cause = lowerPlace(promise.cause, scope_);
  const auto response = lowerPlace(promise.response, scope_);
  const auto time =
      promise.time ? promisedTime(*promise.time,
                                  promise.timing == ast::Timing::For ? "for" : "within", scope_)
                   : std::optional(PromiseTime());
  const bool only = promise.trigger == ast::Trigger::WheneverAndOnly;
  if (only && promise.time) {
    scope_.report(support::diagnostics::onlyWhenTime, promise.time->where);
    return false;
  }
  if (!cause || !response || !time) {
    return false;
  }
  const bool conditions = cause->condition.valid() && response->condition.valid();
  if (isPlain() && conditions && promise.timing == ast::Timing::AtOnce &&
      promise.trigger != ast::Trigger::When) {
    ir::MissionWriter write(scope_.mission, node_.where);
    const auto without = [&](ir::ExprId a, ir::ExprId b) {
      return write.both(a, write.negation(b));
    };
    const ir::ExprId wrong = without(cause->condition, response->condition);
    return neverTrue(only ? write.either(wrong, without(response->condition, cause->condition))
                          : wrong);
  }
  return finish(
      [&](Pattern& pattern) { writeReaction(promise, *cause, *response, *time, pattern); });
}

bool PromiseLowering::lower(const ast::HoldPromise& promise) {
  const auto place = lowerPlace(promise.place, scope_);
  const auto until = lowerPlace(promise.until, scope_);
  const auto within = promisedTime(promise.within, "within", scope_);
  return place && until && within &&
         finish([&](Pattern& pattern) { writeHold(*place, *until, *within, pattern); });
}

}  // namespace glider::frontend
