// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_proofs/flight_check.h"

#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::random_proofs {

using containment::Flight;
using ir::AssumptionKind;
using ir::ListKind;
using ir::Truth;

namespace {

constexpr double kAtOnce = 60;  ///< of GL3109, s

bool isMomentary(const ir::Requirement& requirement) {
  return requirement.condition.valid() && !requirement.monitor.step.valid();
}

/// Whether the claim's list is tried in this tick, before which `before` was current.
bool isTried(const Claim& claim, ir::StateId before) {
  return !claim.state.valid() || claim.state == before;
}

}  // namespace

FlightCheck::FlightCheck(const ir::prove::ProofContext& context, const Watched& watched,
                         const containment::FlightStyle& style, bool narrowed, Met& met)
    : context_(context),
      m_(context.mission),
      watched_(watched),
      style_(style),
      narrowed_(narrowed),
      met_(met),
      holds_(m_.assumptions.size(), true) {
  const double surface = context.platform.world.surface_depth_m;
  for (const auto& verdict : watched.verdicts) {
    monitors_.emplace_back(m_, m_.requirements[verdict.requirement], surface, context.depth);
  }
  for (const ir::Assumption& a : m_.assumptions) {
    assumptions_.emplace_back(m_, a.watch, surface, context.depth);
    if (isMomentary(a.watch)) {
      assumed_.push_back(a.watch.condition);
    }
  }
  for (const ir::Requirement& r : m_.requirements) {
    if (isMomentary(r)) {
      required_.push_back(r.condition);
    }
  }
}

/// Whether an assumption that the proof rests on does not hold in this flight.
bool FlightCheck::excused(const ir::prove::RequirementVerdict& verdict) const {
  return std::ranges::any_of(verdict.assumptions, [&](uint32_t number) {
    return m_.assumptions[number].isWatched() ? !holds_[number] : !narrowed_;
  });
}

std::string FlightCheck::tick(const Flight& flight) {
  const containment::Tick& now = flight.now();
  for (size_t i = 0; i < assumptions_.size(); ++i) {
    if (m_.assumptions[i].isWatched()) {
      assumptions_[i].tick(flight.interpreter(), now.time, now.result, now.depth);
      holds_[i] = holds_[i] && !assumptions_[i].when();
    }
  }
  for (size_t i = 0; i < monitors_.size(); ++i) {
    const auto& verdict = watched_.verdicts[i];
    monitors_[i].tick(flight.interpreter(), now.time, now.result, now.depth);
    if (excused(verdict)) {
      continue;
    }
    met_.verdicts.insert(i);
    if (monitors_[i].when() == now.time) {
      return fmt::format("requirement {} is {}: {}", verdict.requirement,
                         ir::prove::word(verdict.verdict), monitors_[i].words());
    }
  }
  for (size_t i = 0; i < watched_.claims.size(); ++i) {
    bool met = false;
    if (brokenBy(i, flight, met)) {
      return fmt::format("{}: {}", support::code(watched_.claims[i].id), watched_.claims[i].words);
    }
    if (met) {
      met_.claims.insert(i);
    }
  }
  return now.result.stack.size() > watched_.stack_depth ? "the stack is deeper than it can be" : "";
}

std::string FlightCheck::midway(const Flight& flight) {
  for (size_t i = 0; i < watched_.claims.size(); ++i) {
    bool met = false;
    if (brokenMidway(watched_.claims[i], flight, met)) {
      return fmt::format("{}: {}", support::code(watched_.claims[i].id), watched_.claims[i].words);
    }
    if (met) {
      met_.claims.insert(i);
    }
  }
  return "";
}

/// Of the guards and what else is evaluated before any case fires.
bool FlightCheck::brokenMidway(const Claim& claim, const Flight& flight, bool& met) const {
  if (!claim.guard.valid() || !isTried(claim, flight.before().result.state)) {
    return false;
  }
  const auto value = [&] { return ir::asNumber(flight.interpreter().evaluate(claim.guard)); };
  switch (claim.id) {
    case support::diagnostics::guardNeverTrue:
    case support::diagnostics::neverTrueInState:
      met = true;
      return value() == 1;
    case support::diagnostics::guardAlwaysTrue:
      met = true;
      return value() != 1;
    case support::diagnostics::comparisonDecided:
      met = true;
      return value() == (claim.expected ? 0 : 1);
    case support::diagnostics::longerThanState: {
      met = true;
      const double now = value();
      const bool truth = m_[claim.guard].type.kind == ir::TypeKind::Bool;
      return truth ? now == 1 : now == now;
    }
    default:
      return false;
  }
}

bool FlightCheck::fired(const Claim& claim, const Flight& flight) const {
  return flight.now().result.firedIn(claim.list) == claim.number;
}

/// Whether the latest tick has left the claim's state, in which it began.
bool FlightCheck::leaves(const Claim& claim, const Flight& flight) const {
  const ir::TickResult& now = flight.now().result;
  return now.finished || now.state != claim.state;
}

bool FlightCheck::brokenBy(size_t number, const Flight& flight, bool& met) {
  const Claim& claim = watched_.claims[number];
  const ir::TickResult& now = flight.now().result;
  const ir::TickResult& before = flight.before().result;
  const bool first = flight.now().time == 0 && !before.state.valid();
  const bool began_there = !first && claim.state.valid() && before.state == claim.state;
  switch (claim.id) {
    case support::diagnostics::unreachableState:
      met = true;
      return now.state == claim.state;
    case support::diagnostics::deadEndState:
      met = began_there && before.limit <= claim.limit;
      return met && leaves(claim, flight);
    case support::diagnostics::missionWithoutEnd:
      met = true;
      return now.finished;
    case support::diagnostics::noWayToExit:
      if (now.state == claim.state && now.limit <= claim.limit) {
        entered_.insert(number);
      }
      met = entered_.contains(number);
      return met && now.finished;
    case support::diagnostics::callForGood:
      met = began_there;
      return began_there && now.moved && now.moved->list == ListKind::State &&
             m_[claim.state].cases[now.moved->number].transition == ir::Transition::Return;
    case support::diagnostics::guardNeverTrue:
    case support::diagnostics::caseHidden:
      met = !first && isTried(claim, before.state);
      return met && fired(claim, flight);
    case support::diagnostics::endsAtOnce:
      met = !style_.power_cuts;
      return met && flight.now().time > kAtOnce && !before.finished;
    case support::diagnostics::endNeedsReadings:
      met = style_.silent;
      return met && now.finished;
    case support::diagnostics::assumptionsContradict:
      met = true;
      return !assumed_.empty() && allTrue(assumed_, flight) &&
             (flight.now().time == 0 || !claim.words.contains("at the start"));
    case support::diagnostics::requirementsContradict:
      met = true;
      return allTrue(required_, flight);
    case support::diagnostics::requirementVacuous:
      met = true;
      return truthOf(claim.guard, flight) == (claim.expected ? Truth::False : Truth::True);
    default:
      return false;
  }
}

bool FlightCheck::allTrue(const std::vector<ir::ExprId>& conditions, const Flight& flight) const {
  return std::ranges::all_of(conditions,
                             [&](ir::ExprId id) { return truthOf(id, flight) == Truth::True; });
}

/// As requirements read it: the true depth. Unknown where it reads a monitor.
Truth FlightCheck::truthOf(ir::ExprId id, const Flight& flight) const {
  const auto leaf = [&](const ir::Expr& e, std::span<const double>) -> ir::Value {
    if (e.op == ir::Op::Sensor && context_.depth && e.sensor == *context_.depth) {
      return flight.now().depth;
    }
    if (e.op == ir::Op::Variable && ir::isOfMonitor(m_[e.variable].kind)) {
      return ir::asValue(std::numeric_limits<double>::quiet_NaN(), e.type);
    }
    return flight.interpreter().evaluate({static_cast<uint32_t>(&e - m_.exprs.data())});
  };
  return std::get<Truth>(ir::evaluate(m_, id, leaf));
}

}  // namespace glider::random_proofs
