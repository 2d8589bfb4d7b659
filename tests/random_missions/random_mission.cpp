// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_mission.h"

#include "hooks/protocol/sampling.h"
#include "ir/core/ops.h"
#include "ir/core/types.h"
#include "ir/eval/interpreter.h"
#include "ir/verify/verify.h"
#include "tests/random_missions/external_functions.h"
#include "tests/random_missions/random_blocks.h"
#include "tests/random_missions/random_expressions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <span>

namespace glider::random_missions {
namespace {

using ir::quantity;
using ir::Transition;
using ir::Type;
using ir::TypeKind;
namespace dimension = support::dimension;

constexpr uint32_t kMostStates = 12;
constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Type kLatitude = ir::latitude();
constexpr Type kLongitude = ir::longitude();

/// Every kind of sensor that the rules of a reading tell apart.
struct SensorKind {
  const char* name;
  Type type;
  ir::Encoding encoding;
  double to_si, lowest, highest;
};
constexpr SensorKind kSensors[] = {
    {"depth", quantity(dimension::length), ir::Encoding::Linear, 1, -1, 100},
    {"altitude", quantity(dimension::length), ir::Encoding::Linear, 0.3048, 0, 300},
    {"temp", quantity(dimension::temperature), ir::Encoding::Linear, 1, -2, 40},
    {"heading", quantity(dimension::angle), ir::Encoding::Linear, 0.017453292519943295, 0, 360},
    {"speed", quantity(dimension::speed), ir::Encoding::Linear, 0.01, -50, 50},
    {"link_gap", quantity(dimension::time), ir::Encoding::Linear, 60, 0, 30},
    {"lat", kLatitude, ir::Encoding::DegreesMinutes, 1, -9000, 9000},
    {"lon", kLongitude, ir::Encoding::DegreesMinutes, 1, -18000, 18000},
    {"fix_lat", kLatitude, ir::Encoding::Linear, 1, -90, 90},
    {"count", quantity(dimension::number), ir::Encoding::Linear, 1, -kHuge, kHuge},
    {"tiny", quantity(dimension::number), ir::Encoding::Linear, 1e-307, -1e3, 1e3},
    {"vast", quantity(dimension::number), ir::Encoding::Linear, 1e306, -kInfinity, kInfinity},
};

class MissionMaker {
 public:
  explicit MissionMaker(uint64_t seed)
      : seed_(seed), random_(seed), expressions_(m_, random_), blocks_(m_, random_, expressions_) {
    m_.name = fmt::format("random{}", seed);
    m_.platform = "slocum";
  }

  /// `flown`: with Mission::every_tick.
  ir::Mission run(bool flown) {
    sensors();
    behaviours();
    functions();
    m_.states.resize(random_.between(1, kMostStates));
    variables();
    initialValuesFrom(0);
    states();
    always();
    if (seed_ % 5 == 2) {
      sampling();
    }
    if (flown) {  // nothing else may read what it sets
      everyTick();
    }
    if (seed_ % 4 == 3) {
      m_.compass = ir::Compass{{}, static_cast<double>(seed_ % 300) / 100 - 1.5};
    }
    return std::move(m_);
  }

 private:
  void sensors() {
    uint16_t id = 0;
    for (const SensorKind& kind : kSensors) {
      id = static_cast<uint16_t>(id + random_.between(1, 9));
      if (random_.chance(0.5) || (m_.sensors.empty() && &kind == std::end(kSensors) - 1)) {
        constexpr double kStale[] = {4, 12, 20, 60, 600};
        m_.sensors.push_back({kind.name, fmt::format("m_{}", kind.name), id, kind.type,
                              kind.encoding, kind.to_si, kind.lowest, kind.highest,
                              random_.pick(kStale)});
      }
    }
    if (random_.chance(0.4)) {
      m_.sensors.push_back({"ping", "", ir::kFirstOwnSensor, quantity(dimension::length),
                            ir::Encoding::Linear, 1, -5, 20, 12, "gliderTestPing"});
    }
    for (size_t i = m_.sensors.size(); i > 1; --i) {
      std::swap(m_.sensors[i - 1], m_.sensors[random_.below(i)]);
    }
  }

  void behaviours() {
    m_.behaviours = {{"record",
                      "gliderProfileRecord",
                      ir::BehaviourKind::Profile,
                      {{"a", quantity(dimension::number)},
                       {"b", quantity(dimension::length)},
                       {"c", quantity(dimension::time)},
                       {"d", quantity(dimension::temperature)}},
                      {{random_.below(m_.sensors.size())}}},
                     {"record",
                      "gliderRouteRecord",
                      ir::BehaviourKind::Route,
                      {{"a", quantity(dimension::number)}, {"b", kLatitude}, {"c", kLongitude}},
                      {}},
                     {"written", "", ir::BehaviourKind::Profile, {}, {}},
                     {"written", "", ir::BehaviourKind::Route, {}, {}}};
  }

  void functions() {
    if (random_.chance(0.5)) {
      return;
    }
    const Type number = quantity(dimension::number), length = quantity(dimension::length);
    const Type truth{TypeKind::Bool, {}};
    m_.functions = {
        {"level", "gliderTestLevel", {}, length, -5, 20},
        {"mixed", "gliderTestMixed", {{"a", number}, {"b", length}, {"c", truth}}, number},
        {"met",
         "gliderTestMet",
         {{"a", number},
          {"b", number},
          {"c", truth},
          {"d", length},
          {"e", kLatitude},
          {"f", kLongitude},
          {"g", number},
          {"h", quantity(dimension::time)}},
         truth}};
  }

  void variables() {
    addVariables(ir::VariableKind::Parameter, {}, random_.below(4));
    addVariables(ir::VariableKind::Mission, {}, random_.below(4));
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      addVariables(ir::VariableKind::Argument, {i}, i == 0 ? 0 : random_.below(3));
      for (auto kind :
           {ir::VariableKind::State, ir::VariableKind::Profile, ir::VariableKind::Route}) {
        addVariables(kind, {i}, random_.below(3));
      }
    }
  }

  void addVariables(ir::VariableKind kind, ir::StateId owner, uint32_t count) {
    constexpr Type kTypes[] = {{TypeKind::Bool, {}},
                               quantity(dimension::length),
                               quantity(dimension::number),
                               quantity(dimension::time),
                               quantity(dimension::angle),
                               kLatitude,
                               quantity(dimension::temperature)};
    for (; count > 0; --count) {
      ir::Variable v;
      v.name = fmt::format("v{}", m_.variables.size());
      v.type = random_.pick(kTypes);
      v.kind = kind;
      v.owner = owner;
      if (v.type.kind != TypeKind::Bool &&
          (kind == ir::VariableKind::Parameter || random_.chance(0.6))) {
        v.lowest = random_.uniform(-60, 60);
        v.highest = v.lowest + random_.uniform(0, 60);
      }
      if (kind == ir::VariableKind::Argument) {
        m_.states[owner.index].parameters.push_back({static_cast<uint32_t>(m_.variables.size())});
      }
      m_.variables.push_back(v);
    }
  }

  void initialValuesFrom(uint32_t first) {
    for (uint32_t i = first; i < m_.variables.size(); ++i) {
      ir::Variable& v = m_.variables[i];
      const bool owned = v.owner.valid();
      const uint32_t readable = first > 0 ? first : i;  // later ones do not read one another
      expressions_.stand(
          {owned ? ir::ListKind::State : ir::ListKind::Always, v.owner, readable, true});
      if (v.kind == ir::VariableKind::Parameter) {
        v.initial = v.type.kind == TypeKind::Bool
                        ? expressions_.truth(random_.chance(0.5))
                        : expressions_.plain(v.type, random_.uniform(v.lowest, v.highest));
        condition({i});
      } else if (v.kind != ir::VariableKind::Argument) {
        v.initial = expressions_.valueFor(v, random_.between(0, 2));
      }
    }
  }

  /// That holds for the default.
  void condition(ir::VariableId id) {
    const ir::Variable& v = m_[id];
    if (v.type.kind == TypeKind::Bool || random_.chance(0.5)) {
      return;
    }
    const double lowest = random_.uniform(v.lowest, m_[v.initial].number);
    const ir::ExprId value = expressions_.variable(id);
    m_.conditions.push_back(expressions_.atLeast(value, expressions_.plain(v.type, lowest)));
  }

  void stand(ir::ListKind list, ir::StateId state) {
    expressions_.stand({list, state, UINT32_MAX, false});
  }

  ir::Activity activity(ir::StateId state, ir::ListKind list) {
    const bool profile = list == ir::ListKind::Profile;
    stand(list, state);
    ir::Activity activity;
    if (random_.chance(0.5)) {
      activity.behaviour = {profile ? 0U : 1U};
      for (const ir::Parameter& p : m_[activity.behaviour].parameters) {
        activity.arguments.push_back(expressions_.number(p.type, random_.between(0, 3)));
      }
      return activity;
    }
    activity.behaviour = {profile ? 2U : 3U};
    if (random_.chance(0.6)) {
      activity.entry = blocks_.block(2);
    }
    for (uint32_t i = 0; i < m_.variables.size(); ++i) {
      const ir::Variable& v = m_.variables[i];
      const auto kind = profile ? ir::VariableKind::Profile : ir::VariableKind::Route;
      if (v.owner == state && v.kind == kind && v.type.kind == TypeKind::Bool) {
        activity.done = {i};
      }
    }
    for (uint32_t k = random_.below(4); k > 0; --k) {
      ir::Case c;
      c.guard = expressions_.guard(random_.between(0, 2));
      c.action = action();
      c.transition =
          activity.done.valid() && random_.chance(0.4) ? Transition::Done : Transition::Stay;
      activity.cases.push_back(c);
    }
    return activity;
  }

  /// Codes of instruments, of which some are none.
  void sampling() {
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      stand(ir::ListKind::State, {i});
      for (uint32_t place = 0; place < kHookMostInstruments; ++place) {
        if (random_.chance(0.4)) {
          const auto code = static_cast<double>(random_.below(kHookSamplingCodes));
          const ir::ExprId number = random_.chance(0.5)
                                        ? expressions_.plain(quantity(dimension::number), code)
                                        : expressions_.number(quantity(dimension::number), 2);
          m_.states[i].sampling.push_back(
              {fmt::format("i{}", place), random_.chance(0.5) ? "off" : "", place, number, {}});
        }
      }
    }
  }

  ir::BlockId action() { return random_.chance(0.5) ? blocks_.block(2) : ir::BlockId(); }

  /// Free of errors by construction: calls lead to states written later (in the order before
  /// shuffling) only, gotos to the states before `gone_to_` only, and only the others return.
  void states() {
    const auto count = static_cast<uint32_t>(m_.states.size());
    gone_to_ = random_.between(1, count);
    for (uint32_t i = 0; i < count; ++i) {
      names_.push_back({i});
    }
    for (uint32_t i = count; i > 2; --i) {
      std::swap(names_[i - 1], names_[random_.between(1, i - 1)]);
    }
    for (uint32_t i = 0; i < count; ++i) {
      state(i);
    }
    for (uint32_t i = 1; i < count; ++i) {  // every state is led to
      const uint32_t from = random_.below(i);
      stand(ir::ListKind::State, names_[from]);
      add(from, often(), i < gone_to_ ? Transition::Goto : Transition::Call, i);
    }
  }

  void state(uint32_t i) {
    const ir::StateId id = names_[i];
    ir::State& s = m_.states[id.index];
    s.name = fmt::format("s{}", id.index);
    s.route = activity(id, ir::ListKind::Route);
    s.profile = activity(id, ir::ListKind::Profile);
    stand(ir::ListKind::State, id);
    for (uint32_t k = random_.below(4); k > 0; --k) {
      constexpr double kPeriods[] = {0, 4, 30.5};
      s.log.push_back({fmt::format("log{}", k), expressions_.logged(), random_.pick(kPeriods)});
    }
    s.entry = action();
    if (random_.chance(0.1)) {
      expressions_.unread();
    }
    for (uint32_t k = random_.below(5); k > 0; --k) {
      randomCase(i);
    }
    if (i >= gone_to_ && random_.chance(0.9)) {
      add(i, often(), Transition::Return, 0);
    }
    if (i < gone_to_ && random_.chance(0.7)) {
      const ir::ExprId guard = often();
      add(i, guard, Transition::Goto, random_.below(gone_to_));
    }
    if (random_.chance(0.15)) {
      longList(i);
    }
  }

  /// Behind the others, which it would hide.
  void longList(uint32_t i) {
    for (uint32_t k = random_.between(8, 40); k > 0; --k) {
      const ir::ExprId guard = expressions_.thresholds();
      m_.states[names_[i].index].cases.push_back(made(guard, Transition::Stay, {}));
    }
  }

  void randomCase(uint32_t i) {
    const auto count = static_cast<uint32_t>(m_.states.size());
    const ir::ExprId guard = expressions_.guard(random_.between(0, 3));
    const double kind = random_.unit();
    if (kind < 0.08) {
      add(i, late(guard), Transition::Exit, 0);
    } else if (kind < 0.2) {
      add(i, guard, Transition::Stay, 0);
    } else if (kind < 0.6 && i + 1 < count) {
      add(i, guard, Transition::Call, random_.between(i + 1, count - 1));
    } else if (kind < 0.8 && i >= gone_to_) {
      add(i, guard, Transition::Return, 0);
    } else {
      add(i, guard, Transition::Goto, random_.below(gone_to_));
    }
  }

  ir::ExprId late(ir::ExprId guard) {
    const double time = random_.uniform(600, 4000);
    return expressions_.both(expressions_.since(ir::Op::MissionTime, time), guard);
  }

  /// A guard that comes true before long.
  ir::ExprId often() {
    if (random_.chance(0.4)) {
      return expressions_.guard(1);
    }
    const ir::Op clock = random_.chance(0.5) ? ir::Op::StateTime : ir::Op::ResumeTime;
    return expressions_.since(clock, random_.uniform(0, 60));
  }

  ir::Case made(ir::ExprId guard, Transition transition, ir::StateId target) {
    ir::Case c;
    c.guard = guard;
    c.action = random_.chance(0.4) ? blocks_.block(1) : ir::BlockId();
    c.transition = transition;
    if (transition == Transition::Goto || transition == Transition::Call) {
      c.target = target;
      for (ir::VariableId id : m_[target].parameters) {
        c.arguments.push_back(expressions_.valueFor(m_[id], random_.between(0, 2)));
      }
    }
    return c;
  }

  void add(uint32_t from, ir::ExprId guard, Transition transition, uint32_t to) {
    const ir::Case c = made(guard, transition, names_[to]);
    std::vector<ir::Case>& cases = m_.states[names_[from].index].cases;
    cases.insert(cases.begin() + random_.below(cases.size() + 1), c);
  }

  /// Cases anywhere to anywhere, except those that would be errors.
  void always() {
    constexpr Transition kKinds[] = {Transition::Call, Transition::Call, Transition::Goto,
                                     Transition::Stay, Transition::Exit};
    stand(ir::ListKind::Always, {});
    if (random_.chance(0.2)) {
      expressions_.unread();
    }
    for (uint32_t k = random_.below(5); k > 0; --k) {
      const Transition kind = random_.pick(kKinds);
      ir::ExprId guard = random_.chance(0.5) ? expressions_.guard(1) : often();
      guard = kind == Transition::Exit ? late(guard) : guard;
      const ir::StateId target{random_.below(m_.states.size())};
      if (kind == Transition::Call || kind == Transition::Goto) {
        m_.always.push_back({guard, {}, kind, target, {}, {}});
        const bool sound = mayAdd(target);
        m_.always.pop_back();
        if (!sound) {
          continue;
        }
      }
      m_.always.push_back(made(guard, kind, target));
    }
  }

  /// Sets variables of its own, since nothing else may read what it sets.
  void everyTick() {
    const auto own = static_cast<uint32_t>(m_.variables.size());
    addVariables(ir::VariableKind::Mission, {}, random_.between(1, 4));
    initialValuesFrom(own);
    expressions_.stand({ir::ListKind::Always, {}, UINT32_MAX, true, own});
    const size_t first = m_.blocks.size();
    m_.every_tick = blocks_.block(2);
    for (ir::Block& block : std::span(m_.blocks).subspan(first)) {
      std::erase_if(block.statements, [](const ir::Statement& statement) {
        return statement.kind == ir::StatementKind::Command;
      });
    }
  }

  /// Whether the mission is free of errors with its last case of `always`, arguments aside.
  bool mayAdd(ir::StateId target) {
    for (ir::VariableId id : m_[target].parameters) {
      const ir::Variable& v = m_[id];
      m_.always.back().arguments.push_back(expressions_.valueFor(v, 0));
    }
    support::DiagnosticEngine diagnostics;
    ir::verify(m_, diagnostics);
    return !diagnostics.hasErrors();
  }

  ir::Mission m_;
  uint64_t seed_;
  Random random_;
  ExpressionMaker expressions_;
  BlockMaker blocks_;
  std::vector<ir::StateId>
      names_;  ///< of each state in the order of making, its number in the mission
  uint32_t gone_to_ = 1;
};

}  // namespace

ir::Mission randomMission(uint64_t seed) {
  return MissionMaker(seed).run(false);
}

ir::Mission flownMission(uint64_t seed) {
  return MissionMaker(seed).run(true);
}

ir::Externals randomExternals() {
  const auto state = std::make_shared<ExternalState>();
  const auto which = [](const std::string& symbol) {
    return symbol == "gliderTestLevel" ? 1U : symbol == "gliderTestMixed" ? 2U : 3U;
  };
  ir::Externals externals;
  externals.call = [=](const ir::Function& function, std::span<const double> arguments) {
    externalAsked(state.get(), which(function.symbol), 0);
    for (const double argument : arguments) {
      externalAsked(state.get(), which(function.symbol), argument);
    }
    return externalAnswer(state.get());
  };
  externals.poll = [=](const ir::Sensor&, double mission_time) {
    externalAsked(state.get(), 4, mission_time);
    return externalAnswer(state.get());
  };
  return externals;
}

std::vector<double> randomParameters(const ir::Mission& mission, uint64_t seed) {
  Random random(seed);
  for (int tries = 0; tries < 20; ++tries) {
    std::vector<double> values = ir::defaultParameters(mission);
    for (uint32_t i = 0; i < values.size(); ++i) {
      const ir::Variable& v = mission.variables[i];
      values[i] =
          v.type.kind == TypeKind::Bool ? random.below(2) : random.uniform(v.lowest, v.highest);
    }
    if (!ir::failedCondition(mission, values)) {
      return values;
    }
  }
  return ir::defaultParameters(mission);
}

}  // namespace glider::random_missions
