// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `waypoints`: positions more than 3000 km from all others (GL3106), and positions that
// fit if latitude and longitude are exchanged (GL3119), with a suggested fix. In: all fixed
// positions of the mission, and where the bundled scenarios start (Options::known_starts). Hints:
// the limits are those of what gliders fly. PlaceIndex keeps it fast for 10,000 waypoints.

#include "ir/eval/arithmetic.h"
#include "ir/prove/context/commands.h"
#include "ir/prove/geometry/nearest.h"
#include "ir/prove/geometry/sphere.h"
#include "ir/prove/passes.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

/// The distance of a glider's longest missions; a waypoint that is farther from all others is
/// probably a typing error.
constexpr double kFarOff = 3e6;  // m

/// A waypoint is taken for one with its coordinates exchanged if it is farther than the first from
/// the others and would otherwise be nearer than the second, or the third to a known start.
constexpr double kFarIfExchanged = 1e6;  // m
constexpr double kNearOthers = 3e5;      // m
constexpr double kNearKnownStart = 1e5;  // m

struct Waypoint {
  Position place;
  support::SourceRange range;  ///< of the route that steers there, or of the command of a case
  const Statement* fixed = nullptr;  ///< the command, if its target is written as constants
};

/// The places that a pilot may have meant who exchanged the two numbers: with the letters as they
/// are, and with the signs of the numbers.
std::vector<Position> exchanged(const Position& place) {
  std::vector<Position> meant;
  if (std::abs(place.longitude) <= 90) {
    meant.push_back({std::copysign(place.longitude, place.latitude),
                     std::copysign(place.latitude, place.longitude)});
    meant.push_back({place.longitude, place.latitude});
  }
  return meant;
}

std::string latitudeText(double degrees) {
  return fmt::format("{:.8g} {}", std::abs(degrees), degrees < 0 ? "S" : "N");
}

std::string longitudeText(double degrees) {
  return fmt::format("{:.8g} {}", std::abs(degrees), degrees < 0 ? "W" : "E");
}

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
    const PlaceIndex others(places());
    checkExchanged(others);
    checkPlaces(others);
    checkCoordinates(TypeKind::Latitude);
    checkCoordinates(TypeKind::Longitude);
  }

 private:
  void add(const Statement& statement, const support::SourceRange& route) {
    if (const auto fixed = fixedTarget(m_, statement)) {
      waypoints_.push_back({*fixed, route, &statement});
    }
    for (const Position& place : pathTargets(m_, statement)) {
      waypoints_.push_back({place, route});
    }
  }

  [[nodiscard]] std::vector<Position> places() const {
    std::vector<Position> all;
    for (const Waypoint& one : waypoints_) {
      all.push_back(one.place);
    }
    return all;
  }

  /// Places that a waypoint is expected near to.
  struct Neighbours {
    const PlaceIndex& places;
    double far_off;  ///< how far the nearest of them is from the waypoint, m
    double near;
    const char* what;
  };

  void checkExchanged(const PlaceIndex& others) {
    const PlaceIndex starts(proof_.options.known_starts);
    for (const Waypoint& one : waypoints_) {
      if (one.fixed == nullptr) {
        continue;
      }
      const double from_others = others.nearestOther(one.place);
      const double from_starts = starts.nearestOther(one.place);
      if (!isFarOff(from_others) && !isFarOff(from_starts)) {
        continue;  // as most are: nothing else need be looked for
      }
      for (const Position& meant : exchanged(one.place)) {
        if (told_.contains(one.range.begin)) {
          break;
        }
        tellIfExchanged(one, meant,
                        {others, from_others, kNearOthers, "the other positions of the mission"});
        tellIfExchanged(one, meant,
                        {starts, from_starts, kNearKnownStart, "where the scenarios start"});
      }
    }
  }

  static bool isFarOff(double nearest) {
    return std::isfinite(nearest) && nearest > kFarIfExchanged;
  }

  /// Whether as many waypoints are at the place as are near the one that may be meant. Where the
  /// others are far away, the waypoints near the place are those at it.
  static bool outnumbered(const Position& place, const Position& meant, const Neighbours& around) {
    return around.places.hasAround(meant, around.near,
                                   std::max<size_t>(1, around.places.timesGiven(place)));
  }

  [[nodiscard]] bool isKnownStart(const Position& place) const {
    return std::ranges::any_of(proof_.options.known_starts, [&](const Position& start) {
      return onEarth(Op::Distance, place, start) < kNearKnownStart;
    });
  }

  void tellIfExchanged(const Waypoint& one, const Position& meant, const Neighbours& around) {
    const double then = isFarOff(around.far_off) ? around.places.nearestOther(meant) : around.near;
    if (then >= around.near || !outnumbered(one.place, meant, around) || isKnownStart(one.place) ||
        !told_.insert(one.range.begin).second) {
      return;
    }
    const std::string north = latitudeText(meant.latitude);
    const std::string east = longitudeText(meant.longitude);
    auto warning =
        proof_.diagnostics.report(support::diagnostics::positionSwapped, one.range,
                                  fmt::format("{:.0f}", around.far_off / 1000), around.what,
                                  fmt::format("{:.0f}", then / 1000), north + " " + east);
    const support::SourceRange& first = m_[one.fixed->values.at(0)].range;
    const support::SourceRange& second = m_[one.fixed->values.at(1)].range;
    told_.insert({first.begin, second.begin});
    if (first.file == one.range.file && second.file == first.file && first.end <= second.begin &&
        one.range.begin <= first.begin && second.end <= one.range.end) {
      warning.fix(first, north).fix(second, east);
    }
  }

  void checkPlaces(const PlaceIndex& others) {
    for (const Waypoint& one : waypoints_) {
      if (tellIfFarOff(one.range, others.nearestOther(one.place)) && one.fixed != nullptr) {
        for (const ExprId half : one.fixed->values) {  // not once more, by itself
          told_.insert(m_[half].range.begin);
        }
      }
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

  /// Whether it is.
  bool tellIfFarOff(const support::SourceRange& range, double nearest) {
    const bool far = std::isfinite(nearest) && nearest > kFarOff;
    if (far && told_.insert(range.begin).second) {
      proof_.diagnostics.report(support::diagnostics::waypointFarOff, range,
                                fmt::format("{:.0f}", nearest / 1000));
    }
    return far;
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
