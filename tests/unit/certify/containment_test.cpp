// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What the interpreter does in a tick of a random mission is among what the rules allow: given what
// was before the tick and its readings, a step may lead to what is after it. GLIDER_CONTAINMENT
// sets the number of missions.

#include "ir/certify/step.h"
#include "ir/core/ops.h"
#include "ir/eval/interpreter.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/random_mission.h"
#include "tests/unit/certify/judge.h"
#include "tests/unit/ir/slocum.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>

namespace glider::ir::certify {
namespace {

constexpr size_t kTicks = 200;
/// Of each mission, this many steps of each kind: what flights do rarely counts as much as what
/// they do all the time.
constexpr size_t kOfEachKind = 4;
constexpr double kContainmentGap = 1000;  ///< s; random streams have steps of up to 700 s

/// What is between two ticks, as far as it can be seen.
struct Seen {
  Configuration at;
  std::map<std::string, std::string> values;
  bool finished = false;
};

Configuration configurationAfter(const TickResult& now) {
  Configuration at{now.state, {}, now.limit, now.just_returned};
  for (const Frame& frame : now.stack) {
    at.stack.push_back({frame.state, frame.limit});
  }
  return at;
}

/// Follows a flight, and what the interpreter does not show: clocks and memories.
class Watcher {
 public:
  Watcher(const Mission& mission, uint32_t depth)
      : mission_(mission),
        interpreter_(mission, depth, random_missions::randomExternals()),
        memory_(mission.temporals.size()) {}

  Seen start(const random_missions::StreamTick& tick, uint64_t seed) {
    now_ = interpreter_.start(tick.frame, random_missions::randomParameters(mission_, seed));
    began(tick);
    entered_ = {0};
    begin(true);
    begin(false);
    return seen();
  }

  Seen tick(const random_missions::StreamTick& tick) {
    const size_t waiting = now_.stack.size();
    const StateId before = now_.state;
    interpreter_.advance(tick.mission_time, tick.frame);
    began(tick);
    for (uint32_t i = 0; i < memory_.size(); ++i) {
      advance(i, before);
    }
    now_ = interpreter_.decide();
    if (now_.moved && !now_.finished) {
      const bool returned = now_.stack.size() < waiting && now_.just_returned;
      entered_.resize(now_.stack.size() + 1);
      if (!returned) {
        entered_.back() = time_;
      }
      resumed_ = time_;
      begin(false);
    }
    return seen();
  }

  [[nodiscard]] const TickResult& result() const { return now_; }

  /// What the rules call the readings of the tick, pinned to what they were.
  [[nodiscard]] std::string readings(const std::map<uint32_t, Reading>& terms) const {
    std::string all;
    for (const auto& [sensor, term] : terms) {
      const double value = interpreter_.readingOf({sensor});
      all += std::isnan(value) ? fmt::format("(assert (not {}))\n", term.value.known)
                               : fmt::format("(assert (and {} (= {} {})))\n", term.value.known,
                                             term.value.value, literal(value));
      if (mission_.sensors[sensor].symbol.empty()) {
        const auto came = came_.find(sensor);
        all += fmt::format("(assert (= {} {}))\n", term.age,
                           literal(time_ - (came == came_.end() ? 0 : came->second)));
      }
    }
    return all;
  }

 private:
  struct Memory {
    std::optional<bool> was;
    std::optional<double> since;
  };

  void began(const random_missions::StreamTick& tick) {
    time_ = std::max(time_, tick.mission_time);
    for (const SensorUpdate& update : tick.frame) {
      came_[update.sensor.index] = time_;
    }
  }

  void begin(bool always) {
    for (uint32_t i = 0; i < memory_.size(); ++i) {
      const Temporal& t = mission_.temporals[i];
      if ((t.list == ListKind::Always) == always && (always || t.state == now_.state)) {
        memory_[i] = {std::nullopt, time_};  // the operand's value then cannot be seen
      }
    }
  }

  void advance(uint32_t i, StateId state) {
    const Temporal& t = mission_.temporals[i];
    if (isWindow(t.kind) || (t.list != ListKind::Always && t.state != state)) {
      return;
    }
    const bool is = interpreter_.truthOf(t.operand) == Truth::True;
    Memory& m = memory_[i];
    if (is && !m.was) {
      m.since.reset();
    } else if (is && !*m.was) {
      m.since = time_;
    }
    m.was = is;
  }

  Seen seen() const {
    Seen seen{configurationAfter(now_), {}, now_.finished};
    seen.values["|time|"] = literal(time_);
    seen.values["|resumed|"] = literal(resumed_);
    for (size_t k = 0; k < entered_.size(); ++k) {
      seen.values[fmt::format("|entered {}|", k)] = literal(entered_[k]);
    }
    for (uint32_t i = 0; i < memory_.size(); ++i) {
      if (memory_[i].was) {
        seen.values[fmt::format("|was {}|", i)] = *memory_[i].was ? "true" : "false";
      }
      if (memory_[i].since) {
        seen.values[fmt::format("|since {}|", i)] = literal(*memory_[i].since);
      }
    }
    for (uint32_t i = 0; i < mission_.variables.size(); ++i) {
      addVariable(seen, mission_.variables[i], now_.variables[i]);
    }
    return seen;
  }

  static void addVariable(Seen& seen, const Variable& v, double value) {
    const std::string name = "|var " + v.name;
    if (v.type.kind == TypeKind::Bool) {
      seen.values[name + " true|"] = value == 1 ? "true" : "false";
      seen.values[name + " false|"] = value == 0 ? "true" : "false";
      return;
    }
    seen.values[name + " known|"] = std::isnan(value) ? "false" : "true";
    if (!std::isnan(value)) {
      seen.values[name + "|"] = literal(value);
    }
  }

  const Mission& mission_;
  Interpreter interpreter_;
  TickResult now_;
  double time_ = 0;
  std::vector<double> entered_;
  double resumed_ = 0;
  std::map<uint32_t, double> came_;
  std::vector<Memory> memory_;
};

/// What random streams may do and a vehicle may not: nothing is assumed of readings of the depth.
const platforms::Platform& anyVehicle() {
  static const platforms::Platform platform = [] {
    platforms::Platform p = slocum();
    p.sensors.clear();
    return p;
  }();
  return platform;
}

/// Steps of one mission, one script for each configuration.
class Containment {
 public:
  explicit Containment(uint64_t seed)
      : mission_(random_missions::randomMission(seed)), facts_(factsOf(mission_)), seed_(seed) {
    requirement_.kind = RequirementKind::ExitWithin;
    requirement_.seconds = 1e6;
  }

  void check() {
    support::DiagnosticEngine diagnostics;
    Watcher watcher(mission_, verify(mission_, diagnostics).stack_depth);
    const auto stream = random_missions::randomStream(mission_, seed_, kTicks);
    Seen before = watcher.start(stream[0], seed_);
    begin(before, watcher);
    for (size_t i = 1; i < stream.size() && !before.finished; ++i) {
      Seen after = watcher.tick(stream[i]);
      if (checked_[kindOf(before, watcher.result())]++ < kOfEachKind) {
        add(before, after, watcher, i);
      }
      before = std::move(after);
    }
    for (const auto& [at, script] : scripts_) {
      judge(script);
    }
  }

  size_t steps = 0;

 private:
  struct Script {
    std::string text;
    std::vector<std::string> checks;
  };

  /// What a step shows: how it began, which lists fired, and how it ended.
  [[nodiscard]] std::string kindOf(const Seen& before, const TickResult& now) const {
    const State& state = mission_[before.at.state];
    const auto transition = [&](ListKind list, const std::vector<Case>& cases) {
      const auto fired = now.firedIn(list);
      return fired ? static_cast<int>(cases[*fired].transition) : -1;
    };
    return fmt::format("{} {} {} {} {} {}", before.at.just_returned, before.at.limit == kNoLimit,
                       transition(ListKind::Always, mission_.always),
                       transition(ListKind::State, state.cases),
                       transition(ListKind::Profile, state.profile.cases),
                       transition(ListKind::Route, state.route.cases));
  }

  [[nodiscard]] std::string equal(const Configuration& at, const Seen& seen,
                                  const std::vector<Term>& terms) const {
    std::vector<Term> all{"true"};
    const std::vector<Name> names = namesIn(mission_, requirement_, at);
    for (size_t i = 0; i < names.size(); ++i) {
      if (const auto found = seen.values.find(names[i].text); found != seen.values.end()) {
        all.push_back(operation("=", {terms[i], found->second}));
      }
    }
    return conjunction(all);
  }

  [[nodiscard]] std::string leadsTo(const Step& step, const Seen& after) const {
    std::vector<Term> ways{"false"};
    for (const Ending& e : step.endings) {
      if (after.finished && !e.to && !e.impossible) {
        ways.push_back(e.condition);
      } else if (!after.finished && e.to == after.at) {
        ways.push_back(conjunction({e.condition, e.well_formed, equal(after.at, after, e.values)}));
      }
    }
    return fmt::format("(assert {})\n(assert (not {}))\n", disjunction(ways), step.leaves_range);
  }

  void begin(const Seen& after, const Watcher& watcher) {
    const Step step = startOf(setting_);
    judge({"(set-logic ALL)\n" + step.text + watcher.readings(step.readings) +
               leadsTo(step, after) + "(check-sat)\n",
           {"the start"}});
  }

  void add(const Seen& before, const Seen& after, const Watcher& watcher, size_t tick) {
    const auto [found, is_new] = steps_.try_emplace(before.at);
    if (is_new) {
      found->second = stepOf(setting_, before.at, kContainmentGap);
      scripts_[before.at].text = "(set-logic ALL)\n" + found->second.text;
    }
    std::vector<Term> symbols;
    for (const Name& name : namesIn(mission_, requirement_, before.at)) {
      symbols.push_back(name.text);
    }
    Script& script = scripts_[before.at];
    script.text += fmt::format(
        "(push 1)\n(assert {})\n{}{}(check-sat)\n(pop 1)\n", equal(before.at, before, symbols),
        watcher.readings(found->second.readings), leadsTo(found->second, after));
    script.checks.push_back(fmt::format("tick {} in {}", tick, wordsOf(mission_, before.at)));
  }

  void judge(const Script& script) {
    const std::vector<std::string> answers = answersTo(script.text);
    for (size_t i = 0; i < script.checks.size(); ++i) {
      ++steps;
      const std::string answer = i < answers.size() ? answers[i] : "no answer";
      EXPECT_EQ(answer, "sat") << "mission " << seed_ << ", " << script.checks[i];
    }
  }

  Mission mission_;
  Facts facts_;
  Requirement requirement_;
  Setting setting_{mission_, anyVehicle(), requirement_, facts_};
  uint64_t seed_;
  std::map<std::string, size_t> checked_;
  std::map<Configuration, Step> steps_;
  std::map<Configuration, Script> scripts_;
};

TEST(Containment, OfTheTicksOfRandomMissions) {
  NEEDS_CVC5();
  const char* const wanted = std::getenv("GLIDER_CONTAINMENT");
  const uint64_t missions = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 30;
  size_t steps = 0;
  for (uint64_t seed = 0; seed < missions; ++seed) {
    Containment containment(seed);
    containment.check();
    steps += containment.steps;
  }
  EXPECT_GT(steps, missions * 10);
  RecordProperty("steps", static_cast<int>(steps));
}

}  // namespace
}  // namespace glider::ir::certify
