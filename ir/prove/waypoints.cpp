// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// What a glider sails in its longest missions; one that is farther from all others is a slip.
constexpr double kFarOff = 3e6;  // m

struct Waypoint {
  double latitude = 0, longitude = 0;  ///< degrees
  support::SourceRange range;          ///< of the route that steers there
};

/// Metres along a sphere of the Earth's mean radius (R. W. Sinnott, Virtues of the haversine,
/// 1984).
double distance(const Waypoint& a, const Waypoint& b) {
  constexpr double kEarth = 6371008.8;
  constexpr double kDegree = std::numbers::pi / 180;
  const double south = std::sin((b.latitude - a.latitude) * kDegree / 2);
  const double east = std::sin((b.longitude - a.longitude) * kDegree / 2);
  const double h =
      south * south + std::cos(a.latitude * kDegree) * std::cos(b.latitude * kDegree) * east * east;
  return 2 * kEarth * std::asin(std::sqrt(std::clamp(h, 0.0, 1.0)));
}

class WaypointCheck {
 public:
  explicit WaypointCheck(Proof& proof) : proof_(proof), m_(proof.ground.mission) {}

  void run() {
    for (const State& state : m_.states) {
      range_ = state.route.range;
      gather(state.route.entry);
      for (const Case& c : state.route.cases) {
        gather(c.action);
      }
    }
    for (const Waypoint& one : waypoints_) {
      places_.emplace(one.latitude, one.longitude);
    }
    for (const Waypoint& one : waypoints_) {
      check(one);
    }
  }

 private:
  void gather(BlockId id) {
    if (!id.valid()) {
      return;
    }
    for (const Statement& statement : m_[id].statements) {
      if (statement.kind == StatementKind::If) {
        gather(statement.then);
        gather(statement.otherwise);
      } else if (statement.kind == StatementKind::Command &&
                 statement.command == Command::SteerTo) {
        add(m_[statement.values.at(0)], m_[statement.values.at(1)]);
      }
    }
  }

  /// Constants, and the places of a path.
  void add(const Expr& latitude, const Expr& longitude) {
    if (latitude.op == Op::Constant && longitude.op == Op::Constant) {
      waypoints_.push_back({latitude.number, longitude.number, range_});
    } else if (latitude.op == Op::Element && longitude.op == Op::Element) {
      const auto& north = m_[latitude.table].values;
      const auto& east = m_[longitude.table].values;
      for (size_t i = 0; i < std::min(north.size(), east.size()); ++i) {
        waypoints_.push_back({north[i], east[i], range_});
      }
    }
  }

  void check(const Waypoint& one) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [latitude, longitude] : places_) {
      const bool same = latitude == one.latitude && longitude == one.longitude;
      nearest = same ? nearest : std::min(nearest, distance(one, {latitude, longitude, {}}));
      if (nearest <= kFarOff) {
        return;
      }
    }
    const bool told = std::ranges::find(told_, one.range.begin) != told_.end();
    if (std::isfinite(nearest) && nearest > kFarOff && !told) {
      told_.push_back(one.range.begin);
      proof_.diagnostics.report(support::DiagnosticId::waypointFarOff, one.range,
                                fmt::format("{:.0f}", nearest / 1000));
    }
  }

  Proof& proof_;
  const Mission& m_;
  support::SourceRange range_;
  std::vector<Waypoint> waypoints_;
  std::set<std::pair<double, double>> places_;  ///< of all, each once
  std::vector<uint32_t> told_;
};

}  // namespace

void passes::waypoints(Proof& proof) {
  WaypointCheck(proof).run();
}

}  // namespace glider::ir::prove
