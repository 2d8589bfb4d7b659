// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/worlds/under_assumptions.h"

#include "ir/core/mission_writer.h"
#include "platforms/load/surface_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace glider::ir {
namespace {

/// By how much dead reckoning may be wrong, m/s: `drift_m_s` of the platform is a current and this.
constexpr double kReckoningError = 0.1;

/// Lets requirements rest on the assumptions that are watched.
class Watches {
 public:
  explicit Watches(Mission& mission) : m_(mission), write_(mission) {}

  void run() {
    for (const Assumption& assumption : m_.assumptions) {
      if (assumption.kind == AssumptionKind::Always) {
        watched_.push_back(assumption.watch);
      }
    }
    if (watched_.empty()) {
      return;
    }
    broken_ = write_.flag("assumption broken", VariableKind::Monitor);
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
      const Statement set = write_.assignment(broken_, write_.truth(true));
      const ExprId broken = write_.negation(watch.condition);
      step.statements.push_back(write_.branch(broken, write_.add(Block{{set}})));
      requirement.monitor.every_tick |= watch.monitor.every_tick;
      requirement.monitor.horizon_s =
          std::max(requirement.monitor.horizon_s, watch.monitor.horizon_s);
    }
    if (requirement.monitor.step.valid()) {
      step.statements.push_back(write_.branch(write_.truth(true), requirement.monitor.step));
    }
    requirement.monitor.step = write_.add(std::move(step));
    const ExprId kept = write_.negation(write_.read(broken_));
    for (Violation& violation : requirement.monitor.violations) {
      violation.condition = write_.both(kept, violation.condition);
    }
    requirement.condition = write_.either(write_.read(broken_), requirement.condition);
  }

  void endedBy(Requirement& requirement) {
    const ExprId now = write_.now();
    const ExprId limit = write_.number(requirement.seconds, quantity(support::dimension::time));
    requirement.kind = RequirementKind::Always;
    requirement.condition = write_.operation(Op::LessEqual, boolean(), {now, limit});
    requirement.monitor.horizon_s = requirement.seconds;
  }

  /// A block belongs to one place.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the monitor's statements nest
  Block copy(BlockId id) {
    Block block = m_[id];
    for (Statement& statement : block.statements) {
      if (statement.then.valid()) {
        statement.then = write_.add(copy(statement.then));
      }
      if (statement.otherwise.valid()) {
        statement.otherwise = write_.add(copy(statement.otherwise));
      }
    }
    return block;
  }

  static void append(Block& block, Block more) {
    std::ranges::move(more.statements, std::back_inserter(block.statements));
  }

  Mission& m_;
  MissionWriter write_;
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
