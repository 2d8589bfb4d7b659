// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Lists, transitions, entering and resuming: README, steps 4 and 5, L and E.

#include "ir/certify/tick.h"

#include "support/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::ir::certify {

Tick::Tick(const Setting& setting, SmtText& out, const Configuration& at, const Term& time,
           const Term& depth)
    : setting_(setting), out_(out), at_(at), expressions_(setting, out, time, depth) {}

/// E8. Steps 1 and 2 are those of the readings.
std::vector<Outcome> Tick::start(Store store) {
  Path path{"true", std::move(store)};
  path.store.entered = {expressions_.time()};
  path.store.resumed = expressions_.time();
  for (uint32_t i = 0; i < setting_.mission.variables.size(); ++i) {
    const VariableKind kind = setting_.mission.variables[i].kind;
    if (kind == VariableKind::Mission || kind == VariableKind::Monitor) {
      initialise({i}, path);
    }
  }
  updateTemporals(true, {}, TemporalMoment::Start, path.store);
  enter({0}, path);
  end(path, "it", Configuration{{0}, {}, kNoLimit, false}, {0});
  return std::move(outcomes_);
}

std::vector<Outcome> Tick::run(Store store) {
  Path path{"true", std::move(store)};
  updateTemporals(true, {}, TemporalMoment::Advance, path.store);
  updateTemporals(false, at_.state, TemporalMoment::Advance, path.store);
  const ListKind first = at_.just_returned ? ListKind::State : ListKind::Always;
  const ListKind second = at_.just_returned ? ListKind::Always : ListKind::State;
  for (const ListKind list : {first, second, ListKind::Profile, ListKind::Route}) {
    tryList(list, path);
  }
  Configuration to = at_;
  to.just_returned = false;
  end(path, "a tick that leaves no state", to);
  return std::move(outcomes_);
}

const std::vector<Case>& Tick::casesOf(ListKind list) const {
  const State& state = setting_.mission[at_.state];
  switch (list) {
    case ListKind::Always:
      return setting_.mission.always;
    case ListKind::State:
      return state.cases;
    case ListKind::Profile:
      return state.profile.cases;
    case ListKind::Route:
      return state.route.cases;
  }
  CHECK(false, "a list without cases");
}

/// L1.
bool Tick::mayFire(ListKind list, uint32_t number) const {
  if (list != ListKind::Always) {
    return true;
  }
  const StateId target = setting_.mission.always[number].target;
  const bool in_use = target == at_.state ||
                      std::ranges::find(at_.stack, target, &Waiting::state) != at_.stack.end();
  return number < at_.limit && !(target.valid() && in_use);
}

/// Step 4 for one list: the first case that may fire and whose guard is true. All guards read the
/// values that the lists before have left. `path` becomes that of the ticks that try the next list.
void Tick::tryList(ListKind list, Path& path) {
  const State& state = setting_.mission[at_.state];
  const bool activity = list == ListKind::Profile || list == ListKind::Route;
  const Activity& own = list == ListKind::Profile ? state.profile : state.route;
  if (activity && !setting_.mission[own.behaviour].symbol.empty()) {
    path.store.vehicle = commandedInC(out_, path.store.vehicle);  // step 5
    return;
  }
  const std::vector<Case>& cases = casesOf(list);
  Term none = path.taken;  // of the cases so far has fired
  std::vector<Path> stays;
  for (uint32_t i = 0; i < cases.size(); ++i) {
    if (!mayFire(list, i)) {
      continue;
    }
    const Term guard = expressions_.truth(cases[i].guard, path.store).is_true;
    Path fired{out_.boolean(conjunction({none, guard})), path.store};
    none = out_.boolean(conjunction({none, negation(guard)}));
    run(cases[i].action, fired);
    if (cases[i].transition == Transition::Done) {
      fired.store.variables.at(own.done.index) = Truths{"true", "false"};
    }
    if (cases[i].transition == Transition::Stay || cases[i].transition == Transition::Done) {
      stays.push_back(std::move(fired));
    } else {
      move(list, i, std::move(fired));
    }
  }
  Path next{none, path.store};
  for (const Path& stay : stays) {
    next = {out_.boolean(disjunction({next.taken, stay.taken})),
            merged(out_, stay.taken, stay.store, next.store)};
  }
  path = std::move(next);
}

/// Step 4, from `exit` to `return`; L3, L4.
void Tick::move(ListKind list, uint32_t number, Path path) {
  const Case& fired = casesOf(list)[number];
  const bool always = list == ListKind::Always;
  std::string words =
      fmt::format("case {} of `{}` ({}{})", number + 1,
                  always ? "always" : setting_.mission[at_.state].name, wordOf(fired.transition),
                  fired.target.valid() ? " `" + setting_.mission[fired.target].name + "`" : "");
  Configuration to = at_;
  to.just_returned = false;
  if (fired.transition == Transition::Exit) {
    end(path, std::move(words), std::nullopt);
    return;
  }
  if (fired.transition == Transition::Return) {
    if (at_.stack.empty()) {
      outcomes_.push_back({path.taken, std::move(words), std::nullopt, true, {}, path.store});
      return;
    }
    resume(to, path);
    end(path, std::move(words), to);
    return;
  }
  giveArguments(fired, path);
  if (fired.transition == Transition::Call) {
    to.stack.push_back({at_.state, at_.limit});
    to.limit = always ? number : at_.limit;
    path.store.entered.push_back(expressions_.time());
  } else {
    to.stack.clear();
    to.limit = always ? number : kNoLimit;
    path.store.entered = {expressions_.time()};
  }
  to.state = fired.target;
  enter(fired.target, path);
  end(path, std::move(words), to, fired.target);
}

/// The arguments of a `goto` or `call` are all evaluated before a parameter changes (E2).
void Tick::giveArguments(const Case& fired, Path& path) {
  std::vector<Value> values;
  for (const ExprId argument : fired.arguments) {
    values.push_back(expressions_.evaluate(argument, path.store));
  }
  const std::vector<VariableId>& parameters = setting_.mission[fired.target].parameters;
  for (size_t i = 0; i < parameters.size(); ++i) {
    assign(parameters[i], fired.arguments.at(i), values.at(i), path);
  }
}

/// E1 to E4; the parameters have their arguments, and `entered` its time.
void Tick::enter(StateId target, Path& path) {
  path.store.entered.back() = expressions_.time();
  path.store.resumed = expressions_.time();
  for (uint32_t i = 0; i < setting_.mission.variables.size(); ++i) {
    const Variable& v = setting_.mission.variables[i];
    if (v.owner == target && v.kind != VariableKind::Argument) {
      initialise({i}, path);
    }
  }
  updateTemporals(false, target, TemporalMoment::Start, path.store);
  const State& state = setting_.mission[target];
  run(state.entry, path);
  startActivity(state.profile, path);
  startActivity(state.route, path);
}

/// `return`, E5: the top frame becomes current again.
void Tick::resume(Configuration& at, Path& path) {
  at.state = at.stack.back().state;
  at.limit = at.stack.back().limit;
  at.stack.pop_back();
  at.just_returned = true;
  path.store.entered.pop_back();
  path.store.resumed = expressions_.time();
  updateTemporals(false, at.state, TemporalMoment::Resume, path.store);
  startActivity(setting_.mission[at.state].profile, path);
  startActivity(setting_.mission[at.state].route, path);
}

/// E4, E5.
void Tick::startActivity(const Activity& activity, Path& path) {
  if (setting_.mission[activity.behaviour].symbol.empty()) {
    run(activity.entry, path);
  } else {
    path.store.vehicle = commandedInC(out_, path.store.vehicle);
  }
}

void Tick::end(const Path& path, std::string words, std::optional<Configuration> to,
               StateId entered) {
  outcomes_.push_back({path.taken, std::move(words), std::move(to), false, entered, path.store});
}

}  // namespace glider::ir::certify
