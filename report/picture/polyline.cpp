// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/polyline.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace glider::report::picture {
namespace {

/// The distance from `p` to the line segment from `a` to `b`.
double distance(const Dot& p, const Dot& a, const Dot& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along =
      square == 0 ? 0 : std::fmax(0, std::fmin(1, ((p.x - a.x) * dx + (p.y - a.y) * dy) / square));
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Tenths of a pixel as whole numbers, which add up without rounding errors.
long tenths(double px) {
  return std::lround(px * 10);
}

/// The number in SVG's shortest form; a sign also separates it from the one before.
std::string shortest(long tenths, bool first) {
  const long whole = std::labs(tenths) / 10, rest = std::labs(tenths) % 10;
  std::string digits = rest == 0
                           ? fmt::format("{}", whole)
                           : fmt::format("{}.{}", whole == 0 ? "" : fmt::to_string(whole), rest);
  return (tenths < 0 ? "-" : first ? "" : " ") + digits;
}

}  // namespace

Line simplified(const Line& line, double tolerance) {
  if (line.size() < 3) {
    return line;
  }
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<size_t, size_t>> open = {{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    size_t furthest = begin;
    double far = tolerance;
    for (size_t i = begin + 1; i < end; ++i) {
      const double here = distance(line[i], line[begin], line[end]);
      if (here > far) {
        far = here;
        furthest = i;
      }
    }
    if (furthest != begin) {
      keep[furthest] = true;
      open.emplace_back(begin, furthest);
      open.emplace_back(furthest, end);
    }
  }
  Line out;
  for (size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) {
      out.push_back(line[i]);
    }
  }
  return out;
}

std::string pathData(const Line& line) {
  if (line.size() < 2) {
    return {};
  }
  long x = tenths(line[0].x), y = tenths(line[0].y);
  std::string out = "M" + shortest(x, true) + shortest(y, false);
  bool first = true;
  for (size_t i = 1; i < line.size(); ++i) {
    const long dx = tenths(line[i].x) - x, dy = tenths(line[i].y) - y;
    if (dx == 0 && dy == 0) {
      continue;
    }
    out += (first ? "l" : "") + shortest(dx, first) + shortest(dy, false);
    first = false;
    x += dx;
    y += dy;
  }
  return out;
}

}  // namespace glider::report::picture
