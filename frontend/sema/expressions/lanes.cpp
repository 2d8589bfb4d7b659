// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Great circles are straight lines in the gnomonic projection, so hull and lanes are computed on
// such a map around the middle of the corners. The map never shows a distance shorter than it is,
// and within kFarthestCorner never more than 0.2 % longer: lanes may be closer together than they
// should be, but never farther apart. Sines and similar functions are the language's own, so that
// every computer compiles the same path.

#include "frontend/sema/expressions/lanes.h"

#include "ir/eval/arithmetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace glider::frontend {
namespace {

using ir::Op;

constexpr double kEarthRadius = 6371008.8;  ///< mean, m (IUGG)
constexpr double kDegree = std::numbers::pi / 180;
/// A hull narrower than this is a line, m: waypoints are rounded to a centimetre.
constexpr double kNarrowest = 1;
constexpr double kRounding = 1e-6;  ///< m

struct Vector {
  double x = 0, y = 0, z = 0;
};

Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator*(double factor, const Vector& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Vector& a) {
  return std::sqrt(dot(a, a));
}

Vector vectorOf(const Place& place) {
  const double north = place.latitude * kDegree;
  const double east = place.longitude * kDegree;
  const auto of = [](Op op, double angle) { return ir::function(op, std::array{angle}); };
  const double out = of(Op::Cos, north);
  return {out * of(Op::Cos, east), out * of(Op::Sin, east), of(Op::Sin, north)};
}

/// Rounded to 1e-7 degrees, a centimetre. A pole has longitude 0.
Place placeOf(const Vector& v) {
  const auto degrees = [](double y, double x) {
    const double angle = y == 0 && x == 0 ? 0 : ir::function(Op::Atan2, std::array{y, x});
    return std::round(angle / kDegree * 1e7) / 1e7 + 0.0;  // no -0
  };
  return {degrees(v.z, std::sqrt(v.x * v.x + v.y * v.y)), degrees(v.y, v.x)};
}

/// On the map, m.
struct Point {
  double x = 0, y = 0;
  auto operator<=>(const Point&) const = default;
};

Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
/// Positive if `c` lies to the left of the way from `a` to `b`.
double turn(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a;
  const Point v = c - a;
  return u.x * v.y - u.y * v.x;
}

/// The map around a middle.
class Map {
 public:
  explicit Map(const Vector& middle) : middle_((1 / length(middle)) * middle) {
    const Vector axis = std::fabs(middle_.z) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0};
    const Vector x = cross(axis, middle_);
    x_ = (1 / length(x)) * x;
    y_ = cross(middle_, x_);
  }

  /// The cosine of the angle between a place and the middle.
  [[nodiscard]] double cosine(const Vector& place) const { return dot(place, middle_); }
  [[nodiscard]] Point point(const Vector& place) const {
    const double scale = kEarthRadius / cosine(place);
    return {scale * dot(place, x_), scale * dot(place, y_)};
  }
  [[nodiscard]] Place place(const Point& p) const {
    return placeOf(middle_ + (p.x / kEarthRadius) * x_ + (p.y / kEarthRadius) * y_);
  }

 private:
  Vector middle_, x_, y_;
};

/// Andrew's monotone chain: the corners of the convex hull, counter-clockwise, none on a line
/// between two others.
std::vector<Point> hullOf(std::vector<Point> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Point> hull;
  const auto add = [&](const Point& p, size_t from) {
    while (hull.size() >= from + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point& p : points) {
    add(p, 0);
  }
  const size_t lower = hull.size() - 1;
  for (size_t i = points.size() - 1; i-- > 0;) {
    add(points[i], lower);
  }
  hull.pop_back();  // the first again
  return hull;
}

/// The hull in the lanes' coordinates: `u` along them, `v` across.
struct Frame {
  Point along;
  double low = 0;  ///< least v of the hull
  double width = 0;

  [[nodiscard]] Point across() const { return {-along.y, along.x}; }
  /// (u, v)
  [[nodiscard]] Point seen(const Point& p) const { return {dot(p, along), dot(p, across())}; }
  [[nodiscard]] Point back(const Point& uv) const {
    return {uv.x * along.x + uv.y * across().x, uv.x * along.y + uv.y * across().y};
  }
};

/// The frame in which the hull is narrowest across: one of its edges is then parallel to the lanes.
Frame narrowest(const std::vector<Point>& hull) {
  Frame best;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Point edge = hull[(i + 1) % hull.size()] - hull[i];
    const double size = std::sqrt(dot(edge, edge));
    Frame frame{{edge.x / size, edge.y / size}};
    double high = frame.seen(hull[0]).y;
    frame.low = high;
    for (const Point& p : hull) {
      const double v = frame.seen(p).y;
      frame.low = std::min(frame.low, v);
      high = std::max(high, v);
    }
    frame.width = high - frame.low;
    if (i == 0 || frame.width < best.width) {
      best = frame;
    }
  }
  return best;
}

struct Lane {
  double v = 0;
  double from = 0, to = 0;  ///< u of its ends
};

/// The part of laying out lanes that uses the hull.
class LaneMaker {
 public:
  LaneMaker(const std::vector<Point>& hull, const Frame& frame, double reach) : reach_(reach) {
    for (const Point& p : hull) {
      hull_.push_back(frame.seen(p));
    }
  }

  /// The lane at `v` for everything within `half` of it: from edge to edge, and farther until every
  /// point there is within `reach` of it.
  [[nodiscard]] Lane lane(double v, double half) const {
    std::optional<Lane> lane;
    for (const double edge : {v - half, v, v + half}) {
      for (const double u : edges(edge)) {
        extend(lane, v, {u, edge});
      }
    }
    for (const Point& corner : hull_) {
      if (std::fabs(corner.y - v) <= half + kRounding) {
        extend(lane, v, corner);
      }
    }
    return *lane;
  }

 private:
  /// Where the hull's edges meet the line at `v`. Because of rounding, the outermost line may miss
  /// the hull.
  [[nodiscard]] std::vector<double> edges(double v) const {
    std::vector<double> found;
    for (size_t i = 0; i < hull_.size(); ++i) {
      const Point& a = hull_[i];
      const Point& b = hull_[(i + 1) % hull_.size()];
      if ((a.y <= v && v <= b.y) || (b.y <= v && v <= a.y)) {
        const double share = a.y == b.y ? 0 : (v - a.y) / (b.y - a.y);
        found.push_back(a.x + share * (b.x - a.x));
      }
    }
    return found;
  }

  /// A lane at `v` long enough for the point `p` of the hull's edge.
  void extend(std::optional<Lane>& lane, double v, const Point& p) const {
    const double off = p.y - v;
    const double slack = std::sqrt(std::max(0.0, reach_ * reach_ - off * off));
    // On the lane's own line the edge itself is reached.
    const double from = off == 0 ? p.x : p.x + slack;
    const double to = off == 0 ? p.x : p.x - slack;
    if (!lane) {
      lane = {v, from, to};
    }
    lane->from = std::min(lane->from, from);
    lane->to = std::max(lane->to, to);
  }

  std::vector<Point> hull_;
  double reach_;
};

/// Back and forth, from the end that is nearest to `start`.
std::vector<Point> strung(const std::vector<Lane>& lanes, const Point& start) {
  std::vector<Point> best;
  for (const bool last_first : {false, true}) {
    for (const bool backwards : {false, true}) {
      std::vector<Point> points;
      for (size_t i = 0; i < lanes.size(); ++i) {
        const Lane& lane = lanes[last_first ? lanes.size() - 1 - i : i];
        Point from{lane.from, lane.v};
        Point to{lane.to, lane.v};
        if (backwards != (i % 2 == 1)) {
          std::swap(from, to);
        }
        points.push_back(from);
        if (to != from) {
          points.push_back(to);
        }
      }
      const auto off = [&](const Point& p) { return dot(p - start, p - start); };
      if (best.empty() || off(points.front()) < off(best.front())) {
        best = std::move(points);
      }
    }
  }
  return best;
}

}  // namespace

std::expected<Path, LaneProblem> layLanes(const Path& corners, double spacing) {
  std::vector<Vector> places;
  Vector sum;
  for (const Place& corner : corners) {
    places.push_back(vectorOf(corner));
    sum = sum + places.back();
  }
  if (length(sum) < 1e-9) {
    return std::unexpected(
        LaneProblem{LaneProblem::Kind::TooFar, kEarthRadius * std::numbers::pi / 2});
  }
  const Map map(sum);
  std::vector<Point> points;
  for (const Vector& place : places) {
    const double off = kEarthRadius * std::acos(std::clamp(map.cosine(place), -1.0, 1.0));
    if (off > kFarthestCorner) {
      return std::unexpected(LaneProblem{LaneProblem::Kind::TooFar, off});
    }
    points.push_back(map.point(place));
  }
  const std::vector<Point> hull = hullOf(points);
  const Frame frame = hull.size() < 3 ? Frame() : narrowest(hull);
  if (frame.width < kNarrowest) {
    return std::unexpected(LaneProblem{LaneProblem::Kind::Line});
  }
  // A width that is a multiple of the spacing except for a rounding error needs no additional lane.
  const double count = std::max(1.0, std::ceil(frame.width / spacing - 1e-4));
  if (count > static_cast<double>(kMostLanes)) {
    return std::unexpected(LaneProblem{LaneProblem::Kind::TooMany,
                                       std::ceil(frame.width / static_cast<double>(kMostLanes))});
  }
  const double half = frame.width / count / 2;
  const LaneMaker maker(hull, frame, std::max(spacing / 2, half));
  std::vector<Lane> lanes;
  for (double i = 0; i < count; ++i) {
    lanes.push_back(maker.lane(frame.low + (2 * i + 1) * half, half));
  }
  Path path;
  for (const Point& p : strung(lanes, frame.seen(points.front()))) {
    path.push_back(map.place(frame.back(p)));
  }
  return path;
}

}  // namespace glider::frontend
