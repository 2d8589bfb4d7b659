// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The terms of a tick, against the ticks of random flights. Each unknown of the terms gets the
// value that the flight gives it; what they say must then be true. A solver is asked only where no
// values are found for what the flight leaves open.

#include "ir/eval/arithmetic.h"
#include "ir/prove/encoding/layout.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/encoding/tick.h"
#include "ir/prove/encoding/world.h"
#include "tests/containment/replay.h"
#include "tests/containment/rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace glider::containment {
namespace {

using namespace ir;
using namespace ir::prove;

ConeOfInfluence everything(const Mission& m) {
  ConeOfInfluence all;
  all.expressions.assign(m.exprs.size(), true);
  all.variables.assign(m.variables.size(), true);
  all.temporals.assign(m.temporals.size(), true);
  all.profiles.assign(m.states.size(), true);
  all.routes.assign(m.states.size(), true);
  all.state_time = all.resume_time = true;
  return all;
}

/// Gives unknowns their values, and finds values for those of which the flight leaves several
/// open.
class Substitution {
 public:
  Substitution(z3::context& context, const Replay& replay)
      : context_(context), replay_(replay), model_(context) {}

  void give(const z3::expr& term, z3::expr value) {
    if (term.is_const() && term.decl().decl_kind() == Z3_OP_UNINTERPRETED) {
      z3::func_decl name = term.decl();
      model_.add_const_interp(name, value);
      given_.insert(Z3_get_ast_id(context_, term));
      equalities_.push_back(term == value);
    }
  }
  void give(const z3::expr& term, bool value) { give(term, context_.bool_val(value)); }
  void give(const z3::expr& term, double value) { give(term, realOf(context_, value)); }
  void give(const NumberTerm& term, double value) {
    give(term.known, isKnown(value));
    give(term.value, isKnown(value) ? value : 0);
  }
  void give(const TruthTerm& term, double value) {
    give(term.is_true, value == 1);
    give(term.is_false, value == 0);
  }
  [[nodiscard]] bool isTrue(const z3::expr& e) const { return model_.eval(e, true).is_true(); }

  /// Where the values of ways that the tick did not take are not found, a solver has the last word.
  Answer ask(const Unknowns& unknowns, const z3::expr& asked) {
    Question question(context_, kEffort);
    for (const z3::expr& equality : equalities_) {
      question.add(equality);
    }
    for (const Fact& fact : unknowns.facts()) {
      question.add(fact.holds);
    }
    question.add(asked);
    return question.ask();
  }

  /// The condition that kept it from finding values.
  [[nodiscard]] const std::string& trouble() const { return trouble_; }

  /// Whether values can be found with which all facts and `asked` are true.
  bool finds(const Unknowns& unknowns, const z3::expr& asked) {
    open_.clear();
    for (size_t i = 0; i < unknowns.made().size(); ++i) {
      const z3::expr& term = unknowns.made()[i];
      if (!given_.contains(Z3_get_ast_id(context_, term))) {
        level_[Z3_get_ast_id(context_, term)] = open_.size();
        open_.push_back({term, candidates(term, unknowns.standFor()[i])});
      }
    }
    checks_.assign(open_.size() + 1, {});
    near_.clear();
    for (const Fact& fact : unknowns.facts()) {
      keepNear(fact.holds);
      checks_[levelOf(fact.holds)].push_back(fact.holds);
    }
    checks_[levelOf(asked)].push_back(asked);
    tried_ = 0;
    return holdsAt(0) && search(0);
  }

 private:
  static constexpr unsigned kEffort = 2000000;
  struct Open {
    z3::expr term;
    std::vector<z3::expr> candidates;
  };

  /// The checks that the first `level` open unknowns decide.
  bool holdsAt(size_t level) {
    for (const z3::expr& e : checks_[level]) {
      if (!isTrue(e)) {
        if (level >= farthest_) {
          farthest_ = level;
          trouble_ = fmt::format("{} after {}", model_.eval(e, false).to_string(),
                                 level == 0 ? "" : open_[level - 1].term.to_string());
        }
        return false;
      }
    }
    return true;
  }

  /// On a way that the tick did not take, a rounded value is the exact one: the unknown is within
  /// `slack` of a term.
  void keepNear(const z3::expr& fact) {
    if (!fact.is_implies() || !fact.arg(1).is_and() || !fact.arg(1).arg(0).is_app() ||
        fact.arg(1).arg(0).decl().decl_kind() != Z3_OP_LE) {
      return;
    }
    const z3::expr difference = fact.arg(1).arg(0).arg(0);
    if (difference.is_app() && difference.decl().decl_kind() == Z3_OP_SUB) {
      near_.emplace(Z3_get_ast_id(context_, difference.arg(0)), difference.arg(1));
    }
  }

  /// The last of the values to try.
  std::vector<z3::expr> candidatesFor(const Open& open) {
    std::vector<z3::expr> all = open.candidates;
    const auto near = near_.find(Z3_get_ast_id(context_, open.term));
    if (near != near_.end()) {
      all.push_back(model_.eval(near->second, true));
    }
    return all;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as a tick has unknowns
  bool search(size_t level) {
    if (level == open_.size()) {
      return true;
    }
    constexpr size_t kMostTries = 2000;
    z3::func_decl name = open_[level].term.decl();
    std::vector<z3::expr> values = candidatesFor(open_[level]);
    for (z3::expr& value : values) {
      if (++tried_ > kMostTries) {
        return false;
      }
      model_.add_const_interp(name, value);
      if (holdsAt(level + 1) && search(level + 1)) {
        return true;
      }
    }
    return false;
  }

  /// One more than the last open unknown in it.
  size_t levelOf(const z3::expr& root) {
    std::set<unsigned> seen;
    std::vector<z3::expr> pending{root};
    size_t level = 0;
    while (!pending.empty()) {
      const z3::expr e = pending.back();
      pending.pop_back();
      if (!e.is_app() || !seen.insert(Z3_get_ast_id(context_, e)).second) {
        continue;
      }
      if (const auto found = level_.find(Z3_get_ast_id(context_, e)); found != level_.end()) {
        level = std::max(level, found->second + 1);
      }
      for (unsigned i = 0; i < e.num_args(); ++i) {
        pending.push_back(e.arg(i));
      }
    }
    return level;
  }

  std::vector<z3::expr> candidates(const z3::expr& term, std::optional<uint32_t> of) {
    const std::string name = term.decl().name().str();
    const auto is = [&](const char* what) { return name.starts_with(std::string(what) + "!"); };
    std::vector<z3::expr> found;
    const auto add = [&](double value) {
      found.push_back(term.is_bool() ? context_.bool_val(value != 0) : realOf(context_, value));
    };
    if (of && (is("was true") || is("since"))) {
      const Replay::Watched& was = replay_.watchedBefore()[*of];
      const Replay::Watched& now = replay_.watched()[*of];
      if (is("since")) {
        add(now.since);
        add(was.since);
      } else {
        add(was.was ? 1 : 0);
        add(was.was ? 0 : 1);
      }
      return found;
    }
    if (of) {
      const bool window = is("window") || is("window?");
      for (const double value : window ? replay_.windowsOf(*of) : replay_.valuesOf(*of)) {
        const bool asks = is("value?") || is("window?");
        if (asks || isKnown(value)) {
          add(asks ? (isKnown(value) ? 1 : 0) : value);
        }
      }
    }
    constexpr double kDeep = 1e9;  // after a command that the prover does not see
    add(is("deepest") ? kDeep : 0);
    if (term.is_bool()) {
      add(1);
    }
    return found;
  }

  z3::context& context_;
  const Replay& replay_;
  z3::model model_;
  std::set<unsigned> given_;
  std::vector<z3::expr> equalities_;
  std::map<unsigned, size_t> level_;
  std::map<unsigned, z3::expr> near_;
  std::vector<Open> open_;
  std::vector<std::vector<z3::expr>> checks_;
  size_t tried_ = 0;
  size_t farthest_ = 0;
  std::string trouble_;
};

/// Each tick is one of the outcomes of the symbolic tick.
class SymbolicTicks : public Rule {
 public:
  explicit SymbolicTicks(const ProofContext& context)
      : context_(context),
        m_(context.mission),
        relevance_(everything(m_)),
        layout_(context, relevance_, memory_),
        replay_(m_) {}

  void start(const Flight& flight) override {
    replay_.start(flight);
    // Entries may have changed what a temporal watched when it started.
    certain_ = false;
  }
  void begun(const Flight& flight) override { replay_.begun(flight); }
  void tick(const Flight& flight) override {
    replay_.decided(flight);
    if (!same(replay_.variables(), flight.now().result.variables)) {
      ADD_FAILURE() << "the replay is not the tick";
      return;
    }
    if (certain_ && ++checked_[kindOf(flight)] <= kOfEachKind) {
      ++steps;
      check(flight);
    }
    certain_ = true;
  }

 private:
  static bool same(const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b,
                              [](double x, double y) { return x == y || (x != x && y != y); });
  }

  /// Of each mission, so many ticks that fire the same: what flights do rarely counts as much.
  static constexpr size_t kOfEachKind = 3;
  static std::string kindOf(const Flight& flight) {
    std::string kind = std::to_string(flight.before().result.state.index);
    for (const auto& fired : flight.now().result.fired) {
      kind += fired ? fmt::format(" {}", *fired) : " -";
    }
    return kind;
  }

  void give(Substitution& s, const Configuration& c, const Flight& flight) const {
    const Tick& before = flight.before();
    s.give(c.mission_time, before.time);
    for (size_t i = 0; i < before.result.stack.size(); ++i) {
      s.give(c.entered[i], before.result.stack[i].entered);
    }
    s.give(c.entered.back(), before.entered);
    s.give(c.resumed, before.resumed);
    for (const auto& [index, term] : c.store.numbers) {
      s.give(term, before.result.variables[index]);
    }
    for (const auto& [index, term] : c.store.truths) {
      s.give(term, before.result.variables[index]);
    }
    for (const auto& [index, watched] : c.watched) {
      s.give(watched.was_true, replay_.watchedBefore()[index].was);
      s.give(watched.since, replay_.watchedBefore()[index].since);
    }
  }

  /// That `c` is what the tick left.
  z3::expr isLeft(const Configuration& c, const Flight& flight) const {
    z3::context& context = c.mission_time.ctx();
    const Tick& now = flight.now();
    const auto equal = [&](const z3::expr& term, double value) {
      return term == realOf(context, value);
    };
    z3::expr all = equal(c.mission_time, now.time) && equal(c.entered.back(), now.entered) &&
                   equal(c.resumed, now.resumed) &&
                   context.bool_val(c.control == controlOf(now.result));
    for (const auto& [index, term] : c.store.numbers) {
      const double value = now.result.variables[index];
      if (keeps(c.control, index)) {
        all = all && (isKnown(value) ? term.known && equal(term.value, value) : !term.known);
      }
    }
    for (const auto& [index, term] : c.store.truths) {
      const double value = now.result.variables[index];
      if (keeps(c.control, index)) {
        all = all && term.is_true == context.bool_val(value == 1) &&
              term.is_false == context.bool_val(value == 0);
      }
    }
    for (const auto& [index, watched] : c.watched) {
      all = all && watched.was_true == context.bool_val(replay_.watched()[index].was) &&
            equal(watched.since, replay_.watched()[index].since);
    }
    return all;
  }

  [[nodiscard]] bool keeps(const Control& control, uint32_t variable) const {
    const Variable& v = m_.variables[variable];
    return !v.owner.valid() || control.holds(v.owner);
  }

  [[nodiscard]] static bool isSame(const Outcome& outcome, const TickResult& result) {
    return outcome.fired.has_value() == result.moved.has_value() &&
           (!result.moved ||
            (outcome.list == result.moved->list && *outcome.fired == result.moved->number));
  }

  void check(const Flight& flight) {
    z3::context context;
    Unknowns unknowns(context);
    Substitution s(context, replay_);
    const Configuration from = layout_.make(controlOf(flight.before().result), unknowns);
    give(s, from, flight);
    SymbolicState moment(unknowns, context_);
    const z3::expr now = realOf(context, flight.now().time);
    moment.setClocks(now, now, now);
    for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
      s.give(moment.reading({i}), flight.interpreter().readingOf({i}));
      if (m_.sensors[i].symbol.empty()) {  // of the others it cannot be seen
        s.give(moment.age({i}), flight.now().ages[i]);
      }
    }
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const Expr& e = m_.exprs[i];
      if (e.op == Op::Call) {  // the same for each use in the whole tick
        s.give(moment.numberOf(e.use), flight.interpreter().number({i}));
      }
    }
    const auto outcomes =
        SymbolicTick(context_, relevance_, unknowns).run(from, now, moment, Pace::Many);
    for (const Outcome& outcome : outcomes) {
      if (isSame(outcome, flight.now().result)) {
        const z3::expr left =
            outcome.after ? isLeft(*outcome.after, flight) : context.bool_val(true);
        const z3::expr same = outcome.condition && left;
        EXPECT_TRUE(s.finds(unknowns, same) || s.ask(unknowns, same) != Answer::No)
            << "not among the outcomes: " << s.trouble();
        return;
      }
    }
    ADD_FAILURE() << "no such outcome";
  }

  const ProofContext& context_;
  const Mission& m_;
  ConeOfInfluence relevance_;
  std::vector<MemoryTerm> memory_;
  Layout layout_;
  Replay replay_;
  bool certain_ = false;
  std::map<std::string, size_t> checked_;
};

TEST(Containment, SymbolicTick) {
  holds<SymbolicTicks>({.flights = 3, .ticks = 100, .share = 0.05});
}

}  // namespace
}  // namespace glider::containment
