// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/core/validate_code.h"

#include "hooks/protocol/sampling.h"
#include "ir/core/ops.h"
#include "ir/core/scopes.h"
#include "ir/core/validate_table.h"
#include "ir/core/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace glider::ir {
namespace {

using support::SourceRange;

constexpr Type kBool{TypeKind::Bool, {}};
constexpr Type kTime{TypeKind::Quantity, support::dimension::time};
constexpr StateId kNoState;

bool ownedByState(VariableKind kind) {
  return kind >= VariableKind::Argument && kind <= VariableKind::Route;
}

bool mayBeLogged(Op op) {
  return op == Op::Sensor || op == Op::MissionTime || op == Op::StateTime || op == Op::ResumeTime;
}

class CodeValidator {
 public:
  CodeValidator(const Mission& mission, Defects& defects)
      : m_(mission),
        defects_(defects),
        reads_(readsOf(mission)),
        block_uses_(m_.blocks.size()),
        arguments_(m_.states.size()) {}

  void run() {
    findWhatEveryTickSets();
    variables();
    temporals();
    for (ExprId condition : m_.conditions) {
      expression(condition, kNoState, kBool, {}, "a condition of the parameters");
      require(launchTime(condition), {}, "a condition reads something other than a parameter");
    }
    require(!m_.states.empty(), {}, "a mission needs at least one state");
    for (uint32_t i = 0; i < m_.blocks.size(); ++i) {
      nestedBlocks(i);
    }
    everyTick();
    const auto always = [] { return std::string("`always`"); };
    for (const Case& c : m_.always) {
      oneCase(c, kNoState, ListKind::Always, always);
    }
    table(m_.always_table, m_.always.size(), always, {});
    std::set<std::string_view> names;
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      const State& s = m_.states[i];
      require(names.insert(s.name).second, s.range, "two states are named `{}`", s.name);
      state({i});
    }
    for (const Requirement& r : m_.requirements) {
      requirement(r);
    }
    for (const Assumption& a : m_.assumptions) {
      assumption(a);
    }
    for (size_t i = 0; i < block_uses_.size(); ++i) {
      require(block_uses_[i] == 1, {}, "block {} is used {} times", i, block_uses_[i]);
    }
  }

 private:
  template <typename... Args>
  void require(bool holds, support::SourceRange range, std::string_view message,
               const Args&... args) {
    defects_.require(holds, range, message, args...);
  }

  bool exists(ExprId id) const { return id.index < m_.exprs.size(); }

  /// Whether code in `state` (kNoState: in `always`) may read what this expression reads.
  bool inScope(ExprId id, StateId state) const {
    const Reads& reads = reads_[id.index];
    return !reads.two_states && (!reads.state.valid() || reads.state == state) &&
           (!reads.monitor || in_monitor_);
  }

  /// Before anything that may read it. A block that is not in order yet is looked at too: blocks
  /// come after those that they hold.
  void findWhatEveryTickSets() {
    if (m_.every_tick.index >= m_.blocks.size()) {
      return;
    }
    std::set<uint32_t> blocks{m_.every_tick.index};
    for (uint32_t i = m_.every_tick.index + 1; i-- > 0;) {
      if (!blocks.contains(i)) {
        continue;
      }
      for (const Statement& s : m_.blocks[i].statements) {
        if (s.kind == StatementKind::Set) {
          set_every_tick_.insert(s.variable.index);
        }
        blocks.insert({s.then.index, s.otherwise.index});
      }
    }
  }

  /// Whether an expression reads a variable that `every tick` sets. The prover does not follow what
  /// runs there, so nothing that decides may.
  [[nodiscard]] bool readsEveryTick(ExprId id) const {
    return !set_every_tick_.empty() && anyIn(m_, id, [&](const Expr& e) {
      return e.op == Op::Variable && set_every_tick_.contains(e.variable.index);
    });
  }

  /// Whether an expression's value is fixed when the mission is launched.
  bool launchTime(ExprId id) const {
    const Reads* reads = exists(id) ? &reads_[id.index] : nullptr;
    return reads != nullptr && !reads->state.valid() && !reads->moment && !reads->mission &&
           !reads->monitor && reads->temporals_end == 0;
  }

  static bool isArea(const Geofence& fence) {
    const size_t corners = fence.corners.size();
    const bool outline =
        fence.isDisc() ? corners == 1 && std::isfinite(fence.radius_m) : corners >= 3;
    return outline && fence.radius_m >= 0 &&
           std::ranges::all_of(fence.corners, [](const Position& p) {
             return std::fabs(p.latitude) <= 90 && std::fabs(p.longitude) <= 180;
           });
  }

  void everyTick() {
    in_every_tick_ = true;
    action(m_.every_tick, kNoState, {});
    in_every_tick_ = false;
  }

  void requirement(const Requirement& r) {
    in_monitor_ = true;
    parts(r);
    monitor(r);
    in_monitor_ = false;
  }

  void assumption(const Assumption& a) {
    require(std::isfinite(a.limit) && a.limit >= 0, a.range, "an assumption with the limit {}",
            a.limit);
    const bool inside = a.kind == AssumptionKind::StartInside;
    require(!inside || (isArea(a.area) && a.area.keep_in && !a.area.isDisc()), a.range,
            "an assumption with an invalid area");
    const bool range = a.kind == AssumptionKind::Range;
    require(!range || (a.sensor.index < m_.sensors.size() && a.lowest <= a.highest), a.range,
            "an assumption about an invalid range");
    require(a.watch.kind == RequirementKind::Always && a.watch.geofences.empty() &&
                a.watch.monitor.observations.empty(),
            a.range, "an assumption about what the mission does");
    require(a.isWatched() || !a.watch.condition.valid(), a.range,
            "an assumption that is not watched, with a condition");
    if (a.isWatched()) {
      requirement(a.watch);
    }
  }

  void parts(const Requirement& r) {
    const bool about_states =
        r.kind == RequirementKind::Reach || r.kind == RequirementKind::NeverAfter;
    const bool timed =
        r.kind == RequirementKind::ExitWithin || r.kind == RequirementKind::SurfacesEvery;
    if (r.kind == RequirementKind::Always) {
      expression(r.condition, kNoState, kBool, r.range, "a requirement");
      require(exists(r.condition) && reads_[r.condition.index].temporals_end == 0, r.range,
              "a requirement observes something over time");
    }
    require(r.geofences.empty() || r.kind == RequirementKind::Always, r.range,
            "a requirement of another kind with an area");
    require(std::ranges::all_of(r.geofences, isArea), r.range, "an invalid area");
    require(!timed || (r.seconds > 0 && std::isfinite(r.seconds)), r.range,
            "a requirement without a time above 0 s");
    require(
        !about_states || (r.state.index < m_.states.size() &&
                          (r.kind == RequirementKind::Reach || r.after.index < m_.states.size())),
        r.range, "a requirement about an unknown state");
  }

  void monitor(const Requirement& r) {
    const Monitor& monitor = r.monitor;
    if (!monitor.step.valid()) {
      require(monitor.observations.empty() && monitor.violations.empty(), r.range,
              "a monitor without a step");
      return;
    }
    require(r.kind == RequirementKind::Always && r.geofences.empty(), r.range,
            "a requirement of another kind with a monitor");
    require(std::isfinite(monitor.horizon_s) && monitor.horizon_s >= 0, r.range,
            "a monitor with the horizon {}", monitor.horizon_s);
    for (const Observation& o : monitor.observations) {
      observation(o, r.range);
    }
    action(monitor.step, kNoState, r.range);
    for (const Violation& violation : monitor.violations) {
      expression(violation.condition, kNoState, kBool, r.range, "a violation");
      require(exists(violation.condition) && reads_[violation.condition.index].temporals_end == 0,
              r.range, "a violation observes something over time");
      require(!violation.since.valid() || (violation.since.index < m_.variables.size() &&
                                           isOfMonitor(m_[violation.since].kind)),
              r.range, "a violation is due since something other than a clock of a monitor");
    }
  }

  void observation(const Observation& o, SourceRange range) {
    const bool there = o.variable.index < m_.variables.size();
    require(there && m_[o.variable].kind == VariableKind::Momentary && m_[o.variable].type == kBool,
            range, "an observation of something other than a momentary truth value");
    const bool of_state = o.kind != ObservationKind::Ended;
    require(of_state ? o.state.index < m_.states.size() : !o.state.valid(), range,
            "an observation of an unknown state");
  }

  /// Each `what` and `where` is a text, or a function that returns it.
  template <typename Text>
  void expression(ExprId id, StateId state, Type type, SourceRange range, const Text& what) {
    if (!exists(id) || m_[id].type != type) {
      require(false, range, "{} is missing or of the wrong type", what);
    } else {
      require(inScope(id, state), range, "{} reads another state's variables", what);
      require(in_every_tick_ || !readsEveryTick(id), range,
              "{} reads what only `every tick` may read", what);
    }
  }

  template <typename Text>
  void numberOrTruth(ExprId id, StateId state, SourceRange range, const Text& what) {
    expression(id, state, exists(id) ? m_[id].type : kBool, range, what);
  }

  void variables() {
    bool parameters = true;
    bool monitors = false;
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const Variable& v = m_.variables[i];
      const bool known = v.kind <= VariableKind::Momentary;
      require(known && (ownedByState(v.kind) ? v.owner.index < m_.states.size() : !v.owner.valid()),
              v.range, "variable `{}` has no owner, or one too many", v.name);
      require(parameters || v.kind != VariableKind::Parameter, v.range,
              "parameter `{}` does not stand before the variables", v.name);
      parameters &= v.kind == VariableKind::Parameter;
      require(!monitors || isOfMonitor(v.kind), v.range,
              "variable `{}` comes after those of monitors", v.name);
      monitors |= isOfMonitor(v.kind);
      require(v.kind != VariableKind::Momentary || v.type == kBool, v.range,
              "momentary variable `{}` is not a truth value", v.name);
      if (v.kind == VariableKind::Argument || v.kind == VariableKind::Momentary) {
        require(!v.initial.valid(), v.range, "`{}` has an initial value", v.name);
      } else {
        initial(i, v);
      }
      if (v.kind == VariableKind::Argument && v.owner.index < m_.states.size()) {
        ++arguments_[v.owner.index];
      }
    }
  }

  void initial(uint32_t number, const Variable& v) {
    const auto what = [&] { return fmt::format("the initial value of `{}`", v.name); };
    require(!isOfMonitor(v.kind) || launchTime(v.initial), v.range, "{} is not fixed at launch",
            what);
    in_every_tick_ = set_every_tick_.contains(number);
    expression(v.initial, v.owner, v.type, v.range, what);
    in_every_tick_ = false;
    if (!exists(v.initial)) {
      return;
    }
    const Reads& reads = reads_[v.initial.index];
    require(reads.variables_end <= number, v.range, "{} reads a variable that comes later", what);
    require(reads.temporals_end == 0, v.range, "{} watches a guard over time", what);
    const Op op = m_[v.initial].op;
    require(v.kind != VariableKind::Parameter || op == Op::Constant || op == Op::True ||
                op == Op::False,
            v.range, "{} is not a constant", what);
  }

  void temporals() {
    for (uint32_t i = 0; i < m_.temporals.size(); ++i) {
      const Temporal& w = m_.temporals[i];
      const bool always = w.list == ListKind::Always;
      if (w.list > ListKind::Route || w.kind > TemporalKind::Number || w.leg > Leg::Last ||
          (always ? w.state.valid() : w.state.index >= m_.states.size())) {
        require(false, w.range, "temporal {} has no list", i);
        continue;
      }
      isWindow(w.kind) ? window(i, w) : guard(i, w);
      for (ExprId id : {w.operand, w.duration, w.along}) {
        require(!exists(id) || reads_[id.index].temporals_end <= i, w.range,
                "temporal {} watches itself or a later one", i);
      }
    }
  }

  void guard(uint32_t i, const Temporal& w) {
    expression(w.operand, w.state, kBool, w.range,
               [&] { return fmt::format("what temporal {} watches", i); });
    if (w.kind == TemporalKind::Held) {
      expression(w.duration, w.state, kTime, w.range,
                 [&] { return fmt::format("the time of temporal {}", i); });
    }
    require((w.kind == TemporalKind::Held || !w.duration.valid()) && !w.along.valid() &&
                w.length == 0 && w.leg == Leg::None,
            w.range, "temporal {} has what only others have", i);
  }

  void window(uint32_t i, const Temporal& w) {
    numberOrTruth(w.operand, w.state, w.range,
                  [&] { return fmt::format("what temporal {} watches", i); });
    const bool compares = w.kind == TemporalKind::AtLowest || w.kind == TemporalKind::AtHighest ||
                          isOfSteepest(w.kind);
    require(exists(w.operand) && m_[w.operand].type != kBool && w.duration.valid() == compares,
            w.range, "window {} is not over a number", i);
    require(!w.along.valid() || (exists(w.along) && m_[w.along].op == Op::Sensor), w.range,
            "window {} is not stretched along a sensor", i);
    if (w.leg != Leg::None) {
      leg(i, w, compares);
      return;
    }
    require(w.kind <= TemporalKind::Slope, w.range, "window {} is not over a leg", i);
    require(std::isfinite(w.length) && w.length > 0, w.range, "window {} has the length {}", i,
            w.length);
  }

  void leg(uint32_t i, const Temporal& w, bool compares) {
    if (compares) {
      numberOrTruth(w.duration, w.state, w.range,
                    [&] { return fmt::format("what temporal {} compares", i); });
      require(exists(w.duration) && m_[w.duration].type != kBool, w.range,
              "window {} compares no numbers", i);
    }
    require(w.kind != TemporalKind::Slope && w.along.valid() && w.length == 0 &&
                std::isfinite(w.dive) && std::isfinite(w.climb),
            w.range, "window {} is not one over a leg", i);
  }

  /// Counts the uses of blocks by block `i`, which must come after them.
  void nestedBlocks(uint32_t i) {
    for (const Statement& s : m_.blocks[i].statements) {
      if (s.kind != StatementKind::If) {
        require(!s.then.valid() && !s.otherwise.valid(), s.range,
                "a statement other than `if` has blocks");
        continue;
      }
      for (BlockId id : {s.then, s.otherwise}) {
        const bool earlier = id.index < i;
        require(earlier || (id == s.otherwise && !id.valid()), s.range,
                "block {} holds one that does not stand before it", i);
        block_uses_[earlier ? id.index : 0] += earlier ? 1 : 0;
      }
    }
  }

  /// Checks the block of a `do` or `entry`; `state` is where it runs.
  void action(BlockId id, StateId state, SourceRange range) {
    if (!id.valid()) {
      return;
    }
    if (id.index >= m_.blocks.size()) {
      require(false, range, "an unknown block");
      return;
    }
    ++block_uses_[id.index];
    std::vector<BlockId> pending = {id};
    while (!pending.empty()) {
      const Block& block = m_[pending.back()];
      const uint32_t number = pending.back().index;
      pending.pop_back();
      for (const Statement& s : block.statements) {
        statement(s, state);
        for (BlockId nested : {s.then, s.otherwise}) {
          if (nested.index < number) {  // otherwise a defect that nestedBlocks reports
            pending.push_back(nested);
          }
        }
      }
    }
  }

  void statement(const Statement& s, StateId state) {
    require(!in_monitor_ || s.kind == StatementKind::Set || s.kind == StatementKind::If, s.range,
            "a monitor does more than watch");
    require(!in_monitor_ || !exists(s.value) || reads_[s.value.index].temporals_end == 0, s.range,
            "a monitor observes something over time");
    require(!in_every_tick_ || everyTickMay(s), s.range,
            "what runs in every tick reads a temporal, or commands");
    switch (s.kind) {
      case StatementKind::Set:
        set(s, state);
        return;
      case StatementKind::If:
        expression(s.value, state, kBool, s.range, "the condition of an `if`");
        return;
      case StatementKind::Log:
        for (ExprId value : s.values) {
          numberOrTruth(value, state, s.range, "a value of `log`");
        }
        return;
      case StatementKind::Command:
        command(s, state);
        return;
    }
    require(false, s.range, "a statement of unknown kind");
  }

  [[nodiscard]] bool everyTickMay(const Statement& s) const {
    const auto timeless = [&](ExprId id) {
      return !exists(id) || reads_[id.index].temporals_end == 0;
    };
    return s.kind != StatementKind::Command && timeless(s.value) &&
           std::ranges::all_of(s.values, timeless);
  }

  void set(const Statement& s, StateId state) {
    if (s.variable.index >= m_.variables.size()) {
      require(false, s.range, "`set` of an unknown variable");
      return;
    }
    const Variable& v = m_[s.variable];
    require(v.kind != VariableKind::Parameter && v.kind != VariableKind::Argument &&
                isOfMonitor(v.kind) == in_monitor_,
            s.range, "`{}` cannot be set", v.name);
    require(!v.owner.valid() || v.owner == state, s.range, "`{}` belongs to another state", v.name);
    expression(s.value, state, v.type, s.range,
               [&] { return fmt::format("what `{}` is set to", v.name); });
  }

  void command(const Statement& s, StateId state) {
    if (static_cast<size_t>(s.command) >= commands().size()) {
      require(false, s.range, "an unknown command");
      return;
    }
    const CommandInfo& info = commands()[static_cast<size_t>(s.command)];
    arguments(s.values, info.parameters, state, s.range,
              [&] { return fmt::format("`{}`", info.text); });
  }

  /// The elements of `parameters` have a `type`.
  template <typename Parameters, typename Text>
  void arguments(const std::vector<ExprId>& values, const Parameters& parameters, StateId state,
                 SourceRange range, const Text& what) {
    if (values.size() != parameters.size()) {
      require(false, range, "{} takes {} arguments, not {}", what, parameters.size(),
              values.size());
      return;
    }
    for (size_t i = 0; i < values.size(); ++i) {
      expression(values[i], state, parameters[i].type, range,
                 [&] { return "an argument of " + what(); });
    }
  }

  template <typename Text>
  void oneCase(const Case& c, StateId state, ListKind list, const Text& where) {
    expression(c.guard, state, kBool, c.range, [&] { return "a guard of " + where(); });
    action(c.action, state, c.range);
    const bool behaviour = list == ListKind::Profile || list == ListKind::Route;
    const bool allowed = behaviour
                             ? staysIn(c.transition)
                             : c.transition < Transition::Done &&
                                   (list == ListKind::State || c.transition != Transition::Return);
    require(allowed, c.range, "a case of {} has a transition it cannot have", where);
    const bool targeted = c.transition == Transition::Goto || c.transition == Transition::Call;
    if (!targeted || c.target.index >= m_.states.size()) {
      require(!targeted && !c.target.valid() && c.arguments.empty(), c.range,
              "a case of {} has no target, or one too many", where);
      return;
    }
    std::vector<Parameter> parameters;
    for (VariableId id : m_[c.target].parameters) {
      if (id.index < m_.variables.size()) {
        parameters.push_back({m_[id].name, m_[id].type});
      }
    }
    arguments(c.arguments, parameters, state, c.range,
              [&] { return fmt::format("state `{}`", m_[c.target].name); });
  }

  template <typename Text>
  void table(const GuardTable& table, size_t case_count, const Text& where, SourceRange range) {
    const std::string defect = defectOf(table, m_, case_count);
    require(defect.empty(), range, "the table of {} has {}", where, defect);
  }

  void state(StateId id) {
    const State& s = m_[id];
    const auto where = [&] { return fmt::format("state `{}`", s.name); };
    activity(id, s.route, BehaviourKind::Route, "route");
    activity(id, s.profile, BehaviourKind::Profile, "profile");
    parameters(id, where);
    for (const LogItem& item : s.log) {
      require(exists(item.value) && mayBeLogged(m_[item.value].op), s.range,
              "{} logs `{}`, which is neither a sensor nor a clock", where, item.name);
      require(item.period_s >= 0 && std::isfinite(item.period_s), s.range,
              "{} logs `{}` every {} s", where, item.name, item.period_s);
    }
    sampling(id, where);
    action(s.entry, id, s.range);
    for (const Case& c : s.cases) {
      oneCase(c, id, ListKind::State, where);
    }
    table(s.table, s.cases.size(), where, s.range);
  }

  template <typename Text>
  void sampling(StateId id, const Text& where) {
    const State& s = m_[id];
    uint32_t next = 0;
    for (const Sampling& one : s.sampling) {
      require(one.place >= next && one.place < kHookMostInstruments, s.range,
              "{} has instruments out of their order", where);
      next = one.place + 1;
      expression(one.code, id, Type{TypeKind::Quantity, {}}, s.range, where);
      if (one.period.valid()) {
        expression(one.period, id, kTime, s.range, where);
      }
    }
  }

  /// A state's parameters are the arguments that it owns, each once; the first state has none.
  template <typename Text>
  void parameters(StateId id, const Text& where) {
    const State& s = m_[id];
    std::set<uint32_t> own;
    for (VariableId p : s.parameters) {
      const bool there = p.index < m_.variables.size();
      require(there && m_[p].kind == VariableKind::Argument && m_[p].owner == id &&
                  own.insert(p.index).second,
              s.range, "{} has a parameter that is not its own", where);
    }
    require(id.index != 0 || s.parameters.empty(), s.range,
            "{} is where the mission starts, but has parameters", where);
    require(arguments_[id.index] == own.size(), s.range, "{} lacks one of its parameters", where);
  }

  void activity(StateId id, const Activity& a, BehaviourKind kind, std::string_view what) {
    const State& s = m_[id];
    if (a.behaviour.index >= m_.behaviours.size() || m_[a.behaviour].kind != kind) {
      require(false, s.range, "state `{}` has no {}", s.name, what);
      return;
    }
    const Behaviour& b = m_[a.behaviour];
    const auto where = [&] { return fmt::format("`{}` in state `{}`", b.name, s.name); };
    if (!b.symbol.empty()) {
      require(!a.entry.valid() && a.cases.empty() && !a.done.valid(), a.range,
              "{} is a C function with a body", where);
      arguments(a.arguments, b.parameters, id, a.range, where);
      return;
    }
    require(a.arguments.empty(), a.range, "{} has arguments and a body", where);
    action(a.entry, id, a.range);
    const bool profile = kind == BehaviourKind::Profile;
    for (const Case& c : a.cases) {
      oneCase(c, id, profile ? ListKind::Profile : ListKind::Route, where);
      require(c.transition != Transition::Done || a.done.valid(), c.range,
              "{} has a `done` that nothing keeps", where);
    }
    if (a.done.valid()) {
      const Variable* v = a.done.index < m_.variables.size() ? &m_[a.done] : nullptr;
      require(v != nullptr && v->type == kBool && v->owner == id &&
                  v->kind == (profile ? VariableKind::Profile : VariableKind::Route),
              a.range, "{} keeps its `done` in something that is not its variable", where);
    }
  }

  const Mission& m_;
  Defects& defects_;
  const std::vector<Reads> reads_;
  std::vector<uint32_t> block_uses_;
  std::vector<size_t> arguments_;      ///< how many each state owns
  bool in_monitor_ = false;            ///< what is checked belongs to a requirement
  bool in_every_tick_ = false;         ///< what is checked is Mission::every_tick
  std::set<uint32_t> set_every_tick_;  ///< the variables that Mission::every_tick sets
};

}  // namespace

void validateCode(const Mission& mission, Defects& defects) {
  CodeValidator(mission, defects).run();
}

}  // namespace glider::ir
