// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/place_read.h"

#include "ir/core/ops.h"
#include "ir/core/walk.h"

#include <algorithm>
#include <vector>

namespace glider::ir::prove {

PlaceRead placeReadBy(const Sensor& sensor, const platforms::Platform& platform) {
  if (!sensor.symbol.empty() || sensor.encoding != Encoding::DegreesMinutes) {
    return PlaceRead::Nothing;
  }
  const platforms::PlatformSensor* row = platform.find(sensor.vehicle_name);
  if (row == nullptr) {
    return PlaceRead::Nothing;
  }
  return row->alias == "lat"   ? PlaceRead::Latitude
         : row->alias == "lon" ? PlaceRead::Longitude
                               : PlaceRead::Nothing;
}

namespace {

/// Whether the ranges of both sides show that a comparison is never false: `distance(p) >= 0 m`.
bool isFalseNowhere(const ProofContext& proof_context, const Expr& e) {
  if (opInfo(e.op).group != OpGroup::Comparison) {
    return false;
  }
  const Interval& left = proof_context.intervals[e.operands[0].index];
  const Interval& right = proof_context.intervals[e.operands[1].index];
  return (e.op == Op::GreaterEqual && left.lowest >= right.highest) ||
         (e.op == Op::Greater && left.lowest > right.highest) ||
         (e.op == Op::LessEqual && left.highest <= right.lowest) ||
         (e.op == Op::Less && left.highest < right.lowest);
}

/// Which halves of the vehicle's position a requirement's truth is computed from, also by way of
/// variables that were set from them. Conditions under which a mission sets a variable do not
/// count.
class PlaceDependence {
 public:
  explicit PlaceDependence(const ProofContext& proof_context)
      : proof_context_(proof_context), m_(proof_context.mission), seen_(m_.exprs.size()) {}

  bool of(const Requirement& requirement) {
    condition(requirement.condition);
    for (const Violation& violation : requirement.monitor.violations) {
      read(violation.condition);
    }
    forEachStatement(m_, requirement.monitor.step,
                     [&](const Statement& statement) { read(statement.value); });
    for (size_t i = 0; i < variables_.size(); ++i) {
      assignments(variables_[i]);
    }
    return north_ && east_;
  }

 private:
  /// What a condition is computed from, except for parts of `&&` that are false nowhere.
  void condition(ExprId root) {
    std::vector<ExprId> open{root};
    while (!open.empty()) {
      const ExprId id = open.back();
      open.pop_back();
      if (id.valid() && m_[id].op == Op::And) {
        open.insert(open.end(), m_[id].operands.begin(), m_[id].operands.begin() + 2);
      } else if (id.valid() && !isFalseNowhere(proof_context_, m_[id])) {
        read(id);
      }
    }
  }

  /// Adds what an expression reads; whether something is known does not depend on the place.
  void read(ExprId root) {
    std::vector<ExprId> open{root};
    while (!open.empty()) {
      const ExprId id = open.back();
      open.pop_back();
      if (!id.valid() || seen_[id.index]) {
        continue;
      }
      seen_[id.index] = true;
      const Expr& e = m_[id];
      if (e.op == Op::Sensor) {
        const PlaceRead half = placeReadBy(m_[e.sensor], proof_context_.platform);
        north_ = north_ || half == PlaceRead::Latitude;
        east_ = east_ || half == PlaceRead::Longitude;
      } else if (e.op == Op::Temporal) {
        open.push_back(m_[e.temporal].operand);
      } else if (e.op != Op::Known) {
        open.insert(open.end(), e.operands.begin(), e.operands.end());
      }
      if (e.variable.valid() && std::ranges::find(variables_, e.variable) == variables_.end()) {
        variables_.push_back(e.variable);
      }
    }
  }

  /// Reads all that a variable is set to.
  void assignments(VariableId variable) {
    read(m_[variable].initial);
    for (const Block& block : m_.blocks) {
      for (const Statement& statement : block.statements) {
        if (statement.kind == StatementKind::Set && statement.variable == variable) {
          read(statement.value);
        }
      }
    }
    arguments(m_.always, variable);
    for (const State& state : m_.states) {
      arguments(state.cases, variable);
    }
  }

  void arguments(const std::vector<Case>& cases, VariableId variable) {
    for (const Case& c : cases) {
      for (size_t i = 0; i < c.arguments.size(); ++i) {
        if (m_[c.target].parameters[i] == variable) {
          read(c.arguments[i]);
        }
      }
    }
  }

  const ProofContext& proof_context_;
  const Mission& m_;
  std::vector<bool> seen_;             ///< of each expression: it was read
  std::vector<VariableId> variables_;  ///< each that was read, once
  bool north_ = false, east_ = false;
};

bool readsPlaces(const ProofContext& proof_context) {
  const auto any = [&](PlaceRead half) {
    return std::ranges::any_of(proof_context.mission.sensors, [&](const Sensor& sensor) {
      return placeReadBy(sensor, proof_context.platform) == half;
    });
  };
  return any(PlaceRead::Latitude) && any(PlaceRead::Longitude);
}

}  // namespace

bool isAboutPlace(const Requirement& requirement, const ProofContext& proof_context) {
  return requirement.kind == RequirementKind::Always && requirement.geofences.empty() &&
         readsPlaces(proof_context) && PlaceDependence(proof_context).of(requirement);
}

}  // namespace glider::ir::prove
