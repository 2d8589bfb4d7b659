// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/step.h"

#include "ir/certify/between.h"
#include "ir/certify/tick.h"

#include <fmt/format.h>

namespace glider::ir::certify {
namespace {

/// The meaning of each kind of requirement (docs/language.md, Requirements): whether a start or
/// tick that ends so violates it. The monitors are those of before the tick, but `surfaced` counts
/// the tick itself.
Term violation(const Setting& setting, Expressions& expressions, const Outcome& outcome,
               const Remembered& remembered) {
  const Requirement& r = setting.requirement;
  switch (r.kind) {
    case RequirementKind::Always:
      return expressions.promise(r.condition, outcome.store).is_false;
    case RequirementKind::ExitWithin:
      return operation(">", {expressions.time(), literal(r.seconds)});
    case RequirementKind::NeverAfter:
      return outcome.entered.valid() && outcome.entered == r.state ? remembered.after_seen
                                                                   : "false";
    case RequirementKind::SurfacesEvery:
      return operation(
          ">", {operation("-", {expressions.time(), remembered.surfaced}), literal(r.seconds)});
    case RequirementKind::StackAtMost:
      return outcome.to && outcome.to->stack.size() > r.depth ? "true" : "false";
    case RequirementKind::Reach:
      break;
  }
  return "true";
}

/// What `never S after A` remembers after the outcome.
Remembered rememberedAfter(const Setting& setting, const Outcome& outcome, Remembered remembered) {
  const bool seen = outcome.entered.valid() && outcome.entered == setting.requirement.after;
  if (setting.requirement.kind == RequirementKind::NeverAfter && seen) {
    remembered.after_seen = "true";
  }
  return remembered;
}

Ending endingOf(const Setting& setting, SmtText& out, Tick& tick, Outcome outcome,
                const Remembered& remembered) {
  Ending ending{outcome.condition, outcome.words, outcome.to, outcome.impossible, {}, "", "true"};
  ending.violates = out.boolean(violation(setting, tick.expressions(), outcome, remembered));
  if (outcome.to) {
    const Between after{outcome.store, tick.expressions().time(),
                        rememberedAfter(setting, outcome, remembered)};
    ending.values = valuesOf(setting, *outcome.to, after);
    ending.well_formed = out.boolean(wellFormed(setting, *outcome.to, after));
  }
  return ending;
}

Step finished(const Setting& setting, SmtText& out, Tick& tick, std::vector<Outcome> outcomes,
              const Remembered& remembered) {
  Step step;
  for (Outcome& outcome : outcomes) {
    if (outcome.condition != "false") {
      tick.observe(outcome);
      step.endings.push_back(endingOf(setting, out, tick, std::move(outcome), remembered));
    }
  }
  step.leaves_range = tick.leavesRange();
  step.readings = tick.expressions().readings();
  step.text = out.text();
  return step;
}

/// Parameters are the same in the whole flight, and meet the mission's conditions.
void requireConditions(const Setting& setting, SmtText& out, Tick& tick, const Store& store) {
  for (const ExprId condition : setting.mission.conditions) {
    out.require(tick.expressions().truth(condition, store).is_true);
  }
}

void declareNames(const Setting& setting, SmtText& out, const Configuration& at) {
  for (const Name& name : namesIn(setting.mission, setting.requirement, at)) {
    out.declare(name.text, name.truth ? "Bool" : "Real");
  }
}

/// The values that the parameters are launched with, and nothing else.
Store launched(const Setting& setting, SmtText& out) {
  Store store = emptyStore(setting.mission);
  for (uint32_t i = 0; i < setting.mission.variables.size(); ++i) {
    if (setting.mission.variables[i].kind != VariableKind::Parameter) {
      continue;
    }
    if (auto* n = std::get_if<Number>(&store.variables[i])) {
      *n = {out.fresh("Real"), "true"};
      const Range& range = setting.facts.declared[i];
      out.require(operation("<=", {literal(range.lowest), n->value, literal(range.highest)}));
    } else {
      const Term is = out.fresh("Bool");
      store.variables[i] = Truths{is, out.boolean(negation(is))};
    }
  }
  store.vehicle = vehicleAtStart(setting, out);
  return store;
}

}  // namespace

Step startOf(const Setting& setting) {
  SmtText out;
  const Store store = launched(setting, out);
  const Configuration none;
  Tick tick(setting, out, none, "0.0", store.vehicle.depth);
  requireConditions(setting, out, tick, store);
  return finished(setting, out, tick, tick.start(store), {});
}

Step stepOf(const Setting& setting, const Configuration& at, double longest_gap_s) {
  SmtText out;
  declareNames(setting, out, at);
  Between before = namedIn(setting, at);
  out.require(wellFormed(setting, at, before));
  requireRanges(setting, out, at, before.store);
  const Term time = out.fresh("Real");
  out.require(
      operation("<=", {before.time, time, operation("+", {before.time, literal(longest_gap_s)})}));
  Store store = before.store;
  store.vehicle = vehicleLater(setting, out, before.store.vehicle, before.time, time);
  if (setting.requirement.kind == RequirementKind::SurfacesEvery) {
    const Term surface = literal(setting.platform.world.surface_depth_m);
    before.remembered.surfaced = out.real(
        choice(operation("<=", {store.vehicle.depth, surface}), time, before.remembered.surfaced));
  }
  Tick tick(setting, out, at, time, store.vehicle.depth);
  requireConditions(setting, out, tick, store);
  return finished(setting, out, tick, tick.run(store), before.remembered);
}

std::string wordsOf(const Mission& mission, const Configuration& at) {
  std::string words = fmt::format("`{}`", mission[at.state].name);
  for (size_t k = at.stack.size(); k-- > 0;) {
    words += fmt::format(", called by `{}`", mission[at.stack[k].state].name);
  }
  if (at.limit != kNoLimit) {
    words += fmt::format(", only cases of `always` before {}", at.limit + 1);
  }
  return words + (at.just_returned ? ", just returned to" : "");
}

}  // namespace glider::ir::certify
