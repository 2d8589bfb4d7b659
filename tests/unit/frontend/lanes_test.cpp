// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Lanes against geometry on the sphere that knows nothing of maps and hulls: every place that is a
// mixture of the corners, weighted as one likes, lies in their hull.

#include "frontend/sema/expressions/lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace glider::frontend {
namespace {

constexpr double kRadius = 6371008.8;
constexpr double kRadians = std::numbers::pi / 180;
constexpr double kCentimetres = 0.03;  ///< way-points are rounded

using Vec = std::array<double, 3>;

Vec at(const Place& p) {
  const double north = p.latitude * kRadians;
  const double east = p.longitude * kRadians;
  return {std::cos(north) * std::cos(east), std::cos(north) * std::sin(east), std::sin(north)};
}
double dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& a) {
  const double size = std::sqrt(dot(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}
double metres(const Vec& a, const Vec& b) {
  const Vec c = cross(a, b);
  return kRadius * std::atan2(std::sqrt(dot(c, c)), dot(a, b));
}

/// A great circle's arc between two places.
class Arc {
 public:
  Arc(const Vec& a, const Vec& b) : a_(a), b_(b), normal_(cross(a, b)) {
    point_ = dot(normal_, normal_) < 1e-24;
    normal_ = point_ ? normal_ : unit(normal_);
  }
  /// From a place to the arc, m.
  [[nodiscard]] double from(const Vec& p) const {
    const bool between =
        !point_ && dot(cross(normal_, a_), p) >= 0 && dot(cross(b_, normal_), p) >= 0;
    return between ? kRadius * std::fabs(std::asin(dot(normal_, p)))
                   : std::min(metres(p, a_), metres(p, b_));
  }

 private:
  Vec a_, b_, normal_;
  bool point_;
};

class Track {
 public:
  explicit Track(const Path& path) {
    for (size_t i = 0; i < path.size(); ++i) {
      arcs_.emplace_back(at(path[i == 0 ? 0 : i - 1]), at(path[i]));
    }
  }
  [[nodiscard]] double from(const Vec& p) const {
    double least = arcs_.front().from(p);
    for (const Arc& arc : arcs_) {
      least = std::min(least, arc.from(p));
    }
    return least;
  }

 private:
  std::vector<Arc> arcs_;
};

/// The greatest distance of a place of the hull from the path: over a fine grid of mixtures of
/// three corners, and the corners' edges with them.
double farthest(const Path& corners, const Path& path, int fine) {
  const Track track(path);
  double most = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = i; j < corners.size(); ++j) {
      for (size_t k = j; k < corners.size(); ++k) {
        const Vec a = at(corners[i]), b = at(corners[j]), c = at(corners[k]);
        for (int x = 0; x <= fine; ++x) {
          for (int y = 0; x + y <= fine; ++y) {
            const int z = fine - x - y;
            Vec mixture;
            for (size_t d = 0; d < 3; ++d) {
              mixture[d] = a[d] * x + b[d] * y + c[d] * z;
            }
            most = std::max(most, track.from(unit(mixture)));
          }
        }
      }
    }
  }
  return most;
}

/// The least width of the corners on a plane, by trying every direction there is.
double leastWidth(const Path& corners) {
  const Vec up = unit(at(corners.front()));
  const Vec side = unit(cross({0.3, -0.5, 0.7}, up));
  const Vec other = cross(up, side);
  std::vector<std::pair<double, double>> points;
  for (const Place& corner : corners) {
    points.emplace_back(kRadius * dot(at(corner), side), kRadius * dot(at(corner), other));
  }
  constexpr int kDirections = 10000;
  double least = 1e18;
  for (int i = 0; i < kDirections; ++i) {
    const double x = std::cos(i * std::numbers::pi / kDirections);
    const double y = std::sin(i * std::numbers::pi / kDirections);
    double low = 1e18, high = -1e18;
    for (const auto& [u, v] : points) {
      low = std::min(low, x * u + y * v);
      high = std::max(high, x * u + y * v);
    }
    least = std::min(least, high - low);
  }
  return least;
}

Path laid(const Path& corners, double spacing) {
  const auto path = layLanes(corners, spacing);
  EXPECT_TRUE(path.has_value());
  return path.value_or(Path{corners.front()});
}

LaneProblem refused(const Path& corners, double spacing) {
  const auto path = layLanes(corners, spacing);
  EXPECT_FALSE(path.has_value());
  return path ? LaneProblem() : path.error();
}

/// Corners about a middle anywhere on Earth.
class RandomHulls {
 public:
  explicit RandomHulls(uint32_t seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  Path next() {
    const Vec middle = unit({uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)});
    return around(middle, std::exp(uniform(std::log(300.0), std::log(2e5))));
  }
  Path around(const Vec& middle, double size) {
    const Vec x = unit(cross({0.6, 0.64, 0.48}, middle));
    const Vec y = cross(middle, x);
    const double narrow = uniform(0.1, 1);
    Path corners;
    for (auto count = 3 + random_() % 6; count > 0; --count) {
      const double u = size * uniform(-1, 1) / kRadius;
      const double v = narrow * size * uniform(-1, 1) / kRadius;
      Vec p;
      for (size_t d = 0; d < 3; ++d) {
        p[d] = middle[d] + u * x[d] + v * y[d];
      }
      p = unit(p);
      corners.push_back({std::asin(p[2]) / kRadians, std::atan2(p[1], p[0]) / kRadians});
    }
    return corners;
  }

  /// 400 hulls that are not all but a line, one after the other, with their least width, m.
  void eachBroad(const std::function<void(const Path& corners, double width)>& test) {
    for (int i = 0; i < 400; ++i) {
      SCOPED_TRACE(i);
      const Path corners = next();
      const double width = leastWidth(corners);
      if (width >= 10) {
        test(corners, width);
      }
    }
  }

 private:
  std::mt19937 random_;
};

TEST(Lanes, EveryPlaceOfTheHullIsWithinHalfTheSpacing) {
  RandomHulls hulls(1);
  hulls.eachBroad([&](const Path& corners, double width) {
    const double spacing = width * std::exp(hulls.uniform(-3.0, 0.7));
    EXPECT_LE(farthest(corners, laid(corners, spacing), 7), spacing / 2 + kCentimetres);
  });
}

TEST(Lanes, AreAsFewAsCanBe) {
  RandomHulls hulls(2);
  hulls.eachBroad([&](const Path& corners, double width) {
    const double spacing = width / hulls.uniform(0.5, 40);
    // The map stretches by 0.2 % at most, and the plane of this test shrinks as much.
    const size_t most = 2 * static_cast<size_t>(std::ceil(1.005 * width / spacing));
    EXPECT_LE(laid(corners, spacing).size(), most);
  });
}

TEST(Lanes, BeginAtTheEndNearestToTheFirstCorner) {
  RandomHulls hulls(3);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Path corners = hulls.next();
    const double spacing = std::max(20.0, leastWidth(corners) / 6);
    for (size_t turn = 0; turn < corners.size(); ++turn) {
      const auto path = layLanes(corners, spacing);
      if (path && path->size() > 1) {
        const Vec first = at(corners.front());
        EXPECT_LE(metres(first, at(path->front())), 1.001 * metres(first, at(path->back())) + 1);
      }
      std::ranges::rotate(corners, corners.begin() + 1);
    }
  }
}

TEST(Lanes, DoNotDependOnWhatAddsNothingToTheHull) {
  RandomHulls hulls(4);
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE(i);
    const Path corners = hulls.next();
    const double width = leastWidth(corners);
    if (width < 10) {
      continue;
    }
    Path more = corners;
    more.insert(more.end(), corners.begin(), corners.end());
    // Their coverage is checked at the corners alone.
    const Path path = laid(more, width / 5);
    EXPECT_EQ(path.size(), laid(corners, width / 5).size());
    EXPECT_LE(farthest(corners, path, 6), width / 10 + kCentimetres);
  }
}

TEST(Lanes, OfASquareAreWhatOneWouldDraw) {
  const double m = 1 / (kRadius * kRadians);  // degrees of latitude
  const Path square = {{0, 0}, {0, 2000 * m}, {1000 * m, 2000 * m}, {1000 * m, 0}};
  const Path path = laid(square, 500);
  ASSERT_EQ(path.size(), 4U);
  const double expected[][2] = {{250, 0}, {250, 2000}, {750, 2000}, {750, 0}};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(path[i].latitude / m, expected[i][0], 0.05) << i;
    EXPECT_NEAR(path[i].longitude / m, expected[i][1], 0.05) << i;
  }
}

TEST(Lanes, CrossTheDateLineAndThePoles) {
  const Path date_line = {{10, 179.95}, {10, -179.95}, {10.05, -179.95}, {10.05, 179.95}};
  EXPECT_LE(farthest(date_line, laid(date_line, 400), 8), 200 + kCentimetres);
  const Path pole = {{89.9, 0}, {89.95, 90}, {89.9, 180}, {89.92, -90}};
  EXPECT_LE(farthest(pole, laid(pole, 1000), 8), 500 + kCentimetres);
  const Path south = {{-89.9, 0}, {-89.95, 90}, {-89.9, 180}, {-90, 0}};
  EXPECT_LE(farthest(south, laid(south, 1000), 8), 500 + kCentimetres);
}

TEST(Lanes, ThatCannotBeAreRefused) {
  using Kind = LaneProblem::Kind;
  EXPECT_EQ(refused({{39, -73}}, 100).kind, Kind::Line);
  EXPECT_EQ(refused({{39, -73}, {39, -73}}, 100).kind, Kind::Line);
  EXPECT_EQ(refused({{39, -73}, {39.1, -73}}, 100).kind, Kind::Line);
  EXPECT_EQ(refused({{0, 0}, {0, 0.1}, {0, 0.2}, {0, 0.05}}, 100).kind, Kind::Line);
  EXPECT_EQ(refused({{39, -73}, {39.1, -73}, {39.05, -73}}, 100).kind, Kind::Line);
  EXPECT_EQ(refused({{39, -73}, {44, -73}, {41, -70}}, 1e4).kind, Kind::TooFar);
  EXPECT_EQ(refused({{0, 0}, {0, 120}, {0, -120}}, 1e4).kind, Kind::TooFar);
  EXPECT_EQ(refused({{90, 0}, {-90, 0}, {0, 0}, {0, 180}}, 1e4).kind, Kind::TooFar);
  const Path area = {{39, -73}, {39.1, -73}, {39.1, -72.9}};
  for (const double spacing : {20.0, 1e-3, 1e-300}) {
    const LaneProblem problem = refused(area, spacing);
    EXPECT_EQ(problem.kind, Kind::TooMany);
    EXPECT_LE(laid(area, problem.metres).size(), 2 * kMostLanes) << "the spacing it says is enough";
  }
}

}  // namespace
}  // namespace glider::frontend
