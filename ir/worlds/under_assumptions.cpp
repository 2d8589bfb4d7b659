// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/under_assumptions.h"

#include "platforms/load/surface_reading.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>

namespace glider::ir {
namespace {

/// By how much dead reckoning may be wrong, m/s: `drift_m_s` of the platform is a current and this.
constexpr double kReckoningError = 0.1;

const Type kTruth{TypeKind::Bool, {}};

/// Lets requirements rest on the assumptions that are watched.
class Watches {
 public:
  explicit Watches(Mission& mission) : m_(mission) {}

  void run() {
    for (const Assumption& assumption : m_.assumptions) {
      if (assumption.kind == AssumptionKind::Always) {
        watched_.push_back(assumption.watch);
      }
    }
    if (watched_.empty()) {
      return;
    }
    broken_ = flag("assumption broken");
    for (Requirement& requirement : m_.requirements) {
      if (restsOnWatches(requirement)) {
        weaken(requirement);
      }
    }
  }

 private:
  /// The watches run before the requirement's own monitor, which they do not change.
  void weaken(Requirement& requirement) {
    if (requirement.kind == RequirementKind::ExitWithin) {
      endedBy(requirement);
    }
    Block step;
    for (const Requirement& watch : watched_) {
      if (watch.monitor.step.valid()) {
        append(step, copy(watch.monitor.step));
      }
      Statement set;
      set.variable = broken_;
      set.value = push(Op::True, kTruth, {});
      const ExprId broken = push(Op::Not, kTruth, {watch.condition});
      step.statements.push_back(when(broken, add({{set}})));
      requirement.monitor.every_tick |= watch.monitor.every_tick;
      requirement.monitor.horizon_s =
          std::max(requirement.monitor.horizon_s, watch.monitor.horizon_s);
    }
    if (requirement.monitor.step.valid()) {
      step.statements.push_back(when(push(Op::True, kTruth, {}), requirement.monitor.step));
    }
    requirement.monitor.step = add(std::move(step));
    const ExprId kept = push(Op::Not, kTruth, {read(broken_)});
    for (Violation& violation : requirement.monitor.violations) {
      violation.condition = push(Op::And, kTruth, {kept, violation.condition});
    }
    requirement.condition = push(Op::Or, kTruth, {read(broken_), requirement.condition});
  }

  void endedBy(Requirement& requirement) {
    const Type time{TypeKind::Quantity, support::dimension::time};
    const ExprId now = push(Op::MissionTime, time, {});
    const ExprId limit = push(Op::Constant, time, {});
    m_.exprs[limit.index].number = requirement.seconds;
    requirement.kind = RequirementKind::Always;
    requirement.condition = push(Op::LessEqual, kTruth, {now, limit});
    requirement.monitor.horizon_s = requirement.seconds;
  }

  // --- parts ---

  VariableId flag(const std::string& name) {
    Variable variable;
    variable.name = name;
    variable.type = kTruth;
    variable.kind = VariableKind::Monitor;
    variable.initial = push(Op::False, kTruth, {});
    m_.variables.push_back(std::move(variable));
    return {static_cast<uint32_t>(m_.variables.size() - 1)};
  }

  ExprId read(VariableId variable) {
    const ExprId id = push(Op::Variable, m_[variable].type, {});
    m_.exprs[id.index].variable = variable;
    return id;
  }

  ExprId push(Op op, const Type& type, std::initializer_list<ExprId> operands) {
    Expr expr;
    expr.op = op;
    expr.type = type;
    std::ranges::copy(operands, expr.operands.begin());
    m_.exprs.push_back(expr);
    return {static_cast<uint32_t>(m_.exprs.size() - 1)};
  }

  static Statement when(ExprId condition, BlockId then) {
    Statement statement;
    statement.kind = StatementKind::If;
    statement.value = condition;
    statement.then = then;
    return statement;
  }

  BlockId add(Block block) {
    m_.blocks.push_back(std::move(block));
    return {static_cast<uint32_t>(m_.blocks.size() - 1)};
  }

  /// A block belongs to one place.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's statements nest
  Block copy(BlockId id) {
    Block block = m_[id];
    for (Statement& statement : block.statements) {
      if (statement.then.valid()) {
        statement.then = add(copy(statement.then));
      }
      if (statement.otherwise.valid()) {
        statement.otherwise = add(copy(statement.otherwise));
      }
    }
    return block;
  }

  static void append(Block& block, Block more) {
    std::ranges::move(more.statements, std::back_inserter(block.statements));
  }

  Mission& m_;
  std::vector<Requirement> watched_;
  VariableId broken_;
};

/// From where a division and a product in doubles lead back is at most this many doubles away.
constexpr int kMostSteps = 4;

/// The greatest number (towards `up`: +infinity) of the vehicle's unit whose reading is not beyond
/// `limit`, or the least for -infinity. A reading is the rounded product, which grows with the
/// number: so exactly the numbers beyond this one have a reading beyond the limit.
double lastWithin(double limit, double to_si, double up) {
  const auto beyond = [&](double raw) {
    return up > 0 ? raw * to_si > limit : raw * to_si < limit;
  };
  double raw = limit / to_si;
  for (int i = 0; i < kMostSteps && beyond(raw); ++i) {
    raw = std::nextafter(raw, -up);
  }
  for (int i = 0; i < kMostSteps && !beyond(std::nextafter(raw, up)); ++i) {
    raw = std::nextafter(raw, up);
  }
  return raw;
}

/// The readings in an assumed range, neither more nor fewer: a requirement may have the same limit.
void narrow(Sensor& sensor, double lowest, double highest) {
  constexpr double kUp = std::numeric_limits<double>::infinity();
  sensor.lowest = std::max(sensor.lowest, lastWithin(lowest, sensor.to_si, -kUp));
  sensor.highest = std::min(sensor.highest, lastWithin(highest, sensor.to_si, kUp));
}

}  // namespace

bool restsOnWatches(const Requirement& requirement) {
  return (requirement.kind == RequirementKind::Always && requirement.geofences.empty()) ||
         requirement.kind == RequirementKind::ExitWithin;
}

Mission underAssumptions(Mission mission) {
  for (const Assumption& assumption : mission.assumptions) {
    if (assumption.kind == AssumptionKind::Range) {
      narrow(mission.sensors.at(assumption.sensor.index), assumption.lowest, assumption.highest);
    } else if (assumption.kind == AssumptionKind::Outage) {
      mission.resume_within_s = std::min(mission.resume_within_s, assumption.limit);
    }
  }
  Watches(mission).run();
  return mission;
}

platforms::Platform underAssumptions(platforms::Platform platform, const Mission& mission) {
  for (const Assumption& assumption : mission.assumptions) {
    if (assumption.kind == AssumptionKind::StartDepth) {
      // At a smaller reading than that the program cannot wait for the surface.
      const double least = platforms::kSurfaceReadingM + platform.world.depth_error_m;
      platform.world.start_depth_m = std::max(assumption.limit, least);
    } else if (assumption.kind == AssumptionKind::Current) {
      const double waves = platform.world.surface_drift_m_s - platform.envelope.drift_m_s;
      platform.envelope.drift_m_s = assumption.limit + kReckoningError;
      platform.world.surface_drift_m_s = platform.envelope.drift_m_s + waves;
    }
  }
  return platform;
}

platforms::Platform notNarrowed(const platforms::Platform& platform, const Mission& mission) {
  platforms::Platform widest = underAssumptions(platform, mission);
  const auto widen = [](double& value, double usual) { value = std::max(value, usual); };
  widen(widest.world.start_depth_m, platform.world.start_depth_m);
  widen(widest.envelope.drift_m_s, platform.envelope.drift_m_s);
  widen(widest.world.surface_drift_m_s, platform.world.surface_drift_m_s);
  return widest;
}

}  // namespace glider::ir
