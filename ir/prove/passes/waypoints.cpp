// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/context/commands.h"
#include "ir/prove/geometry/nearest.h"
#include "ir/prove/geometry/sphere.h"
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

/// The distance of a glider's longest missions; a waypoint that is farther from all others is
/// probably a typing error.
constexpr double kFarOff = 3e6;  // m

struct Waypoint {
  Position place;
  support::SourceRange range;  ///< of the route that steers there, or of the command of a case
};

class WaypointCheck {
 public:
  explicit WaypointCheck(Proof& proof) : proof_(proof), m_(proof.proof_context.mission) {}

  void run() {
    for (const Statement* command : commandsOfAlways(m_)) {
      add(*command, command->range);
    }
    for (const State& state : m_.states) {
      const std::vector<const Statement*> of_route = commandsOf(m_, state.route);
      for (const Statement* command : commandsOf(m_, state)) {
        const bool routes = std::ranges::find(of_route, command) != of_route.end();
        add(*command, routes ? state.route.range : command->range);
      }
    }
    checkPlaces();
    checkCoordinates(TypeKind::Latitude);
    checkCoordinates(TypeKind::Longitude);
  }

 private:
  void add(const Statement& statement, const support::SourceRange& route) {
    if (const auto fixed = fixedTarget(m_, statement)) {
      waypoints_.push_back({*fixed, route});
    }
    for (const Position& place : pathTargets(m_, statement)) {
      waypoints_.push_back({place, route});
    }
  }

  void checkPlaces() {
    std::vector<Position> places;
    for (const Waypoint& one : waypoints_) {
      places.push_back(one.place);
    }
    const PlaceIndex index(places);
    for (const Waypoint& one : waypoints_) {
      tellIfFarOff(one.range, index.nearestOther(one.place));
    }
  }

  /// Checks latitudes, or longitudes, of places that are not directly steered to: corners of areas,
  /// centres, arguments of states.
  void checkCoordinates(TypeKind kind) {
    const std::vector<Coordinate> all = coordinates(kind);
    std::vector<double> degrees;
    for (const Coordinate& one : all) {
      degrees.push_back(one.degrees);
    }
    const std::vector<double> nearest = nearestOnCircle(degrees);
    for (size_t i = 0; i < all.size(); ++i) {
      tellIfFarOff(all[i].range, nearest[i] * all[i].metres);
    }
  }

  struct Coordinate {
    double degrees;
    double metres;  ///< the length of one of its degrees
    support::SourceRange range;
  };

  [[nodiscard]] std::vector<Coordinate> coordinates(TypeKind kind) const {
    std::set<uint32_t> units;  // constants that differences are divided by are not places
    for (const Expr& e : m_.exprs) {
      if (e.op == Op::Divide) {
        units.insert(e.operands[1].index);
      }
    }
    const double narrow =
        kind == TypeKind::Longitude ? std::cos(middleLatitude() * std::numbers::pi / 180) : 1;
    std::vector<Coordinate> found;
    for (uint32_t i = 0; i < m_.exprs.size(); ++i) {
      const Expr& e = m_.exprs[i];
      if (e.op == Op::Constant && e.type.kind == kind && !units.contains(i)) {
        found.push_back({e.number, kMetresPerDegree * narrow, e.range});
      }
    }
    return found;
  }

  /// The median, which a single typing error does not move.
  [[nodiscard]] double middleLatitude() const {
    std::vector<double> all;
    for (const Expr& e : m_.exprs) {
      if (e.op == Op::Constant && e.type.kind == TypeKind::Latitude) {
        all.push_back(e.number);
      }
    }
    std::ranges::sort(all);
    return all.empty() ? 0 : all[all.size() / 2];
  }

  void tellIfFarOff(const support::SourceRange& range, double nearest) {
    if (std::isfinite(nearest) && nearest > kFarOff && told_.insert(range.begin).second) {
      proof_.diagnostics.report(support::DiagnosticId::waypointFarOff, range,
                                fmt::format("{:.0f}", nearest / 1000));
    }
  }

  Proof& proof_;
  const Mission& m_;
  std::vector<Waypoint> waypoints_;
  std::set<uint32_t> told_;
};

}  // namespace

void passes::waypoints(Proof& proof) {
  WaypointCheck(proof).run();
}

}  // namespace glider::ir::prove
