// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/random_missions/random_mission.h"

#include "tests/random_missions/random_expressions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace glider::random_missions {
namespace {

using ir::Transition;
using ir::Type;
using ir::TypeKind;
namespace dimension = support::dimension;

constexpr uint32_t kMostStates = 12;
constexpr double kHuge = std::numeric_limits<double>::max();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Type quantity(support::Dimension of) {
  return {TypeKind::Quantity, of};
}
constexpr Type kLatitude{TypeKind::Latitude, {}};
constexpr Type kLongitude{TypeKind::Longitude, {}};

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
  explicit MissionMaker(uint64_t seed) : random_(seed), expressions_(m_, random_) {
    m_.name = fmt::format("random{}", seed);
    m_.platform = "slocum";
  }

  ir::Mission run() {
    sensors();
    behaviours();
    states();
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
                      {}}};
  }

  ir::Activity activity(uint32_t behaviour) {
    ir::Activity activity{{behaviour}, {}, {}};
    for (const ir::Parameter& p : m_.behaviours[behaviour].parameters) {
      activity.arguments.push_back(expressions_.number(p.type, random_.between(0, 3)));
    }
    return activity;
  }

  /// Free of errors by construction: calls lead to states written later (in the order before
  /// shuffling) only, gotos to the states before `gone_to_` only, and only the others return.
  void states() {
    const uint32_t count = random_.between(1, kMostStates);
    gone_to_ = random_.between(1, count);
    m_.states.resize(count);
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
      add(from, often(), i < gone_to_ ? Transition::Goto : Transition::Call, i);
    }
  }

  void state(uint32_t i) {
    ir::State& s = m_.states[names_[i].index];
    s.name = fmt::format("s{}", names_[i].index);
    s.route = activity(1);
    s.profile = activity(0);
    for (uint32_t k = random_.below(4); k > 0; --k) {
      constexpr double kPeriods[] = {0, 4, 30.5};
      const Type type = random_.pick(m_.sensors).type;
      const ir::ExprId value = expressions_.number(type, random_.between(0, 2));
      s.log.push_back({fmt::format("log{}", k), value, random_.pick(kPeriods)});
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
  }

  void randomCase(uint32_t i) {
    const auto count = static_cast<uint32_t>(m_.states.size());
    const ir::ExprId guard = expressions_.guard(random_.between(0, 3));
    const double kind = random_.unit();
    if (kind < 0.08) {
      const double late = random_.uniform(600, 4000);
      add(i, expressions_.both(expressions_.since(ir::Op::MissionTime, late), guard),
          Transition::Exit, 0);
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

  /// A guard that comes true before long.
  ir::ExprId often() {
    if (random_.chance(0.4)) {
      return expressions_.guard(1);
    }
    const ir::Op clock = random_.chance(0.5) ? ir::Op::StateTime : ir::Op::ResumeTime;
    return expressions_.since(clock, random_.uniform(0, 60));
  }

  void add(uint32_t from, ir::ExprId guard, Transition transition, uint32_t to) {
    const bool targeted = transition == Transition::Goto || transition == Transition::Call;
    std::vector<ir::Case>& cases = m_.states[names_[from].index].cases;
    cases.insert(cases.begin() + random_.below(cases.size() + 1),
                 {guard, transition, targeted ? names_[to] : ir::StateId{}, {}});
  }

  ir::Mission m_;
  Random random_;
  ExpressionMaker expressions_;
  std::vector<ir::StateId>
      names_;  ///< of each state in the order of making, its number in the mission
  uint32_t gone_to_ = 1;
};

}  // namespace

ir::Mission randomMission(uint64_t seed) {
  return MissionMaker(seed).run();
}

}  // namespace glider::random_missions
