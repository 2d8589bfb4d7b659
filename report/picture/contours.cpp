// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/contours.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>

namespace glider::report::picture {
namespace {

using support::TraceField;

/// An edge of the grid: from a point to the next in time, or to the next in depth.
struct Edge {
  size_t time, depth;
  bool along_time;
  auto operator<=>(const Edge&) const = default;
};

class Grid {
 public:
  Grid(const TraceField& field, double level) : field_(field), level_(level) {}

  /// The edge that the line crosses; none if both ends are on one side.
  [[nodiscard]] std::optional<Edge> crossed(const Edge& edge) const {
    const bool a = above(edge.time, edge.depth);
    const bool b =
        edge.along_time ? above(edge.time + 1, edge.depth) : above(edge.time, edge.depth + 1);
    return a == b ? std::nullopt : std::optional(edge);
  }
  [[nodiscard]] Dot place(const Edge& edge) const {
    const size_t t = edge.time + (edge.along_time ? 1U : 0U);
    const size_t d = edge.depth + (edge.along_time ? 0U : 1U);
    const double a = value(edge.time, edge.depth), b = value(t, d), part = (level_ - a) / (b - a);
    const auto between = [&](double from, double to) { return from + (to - from) * part; };
    return {between(field_.times_s[edge.time], field_.times_s[t]),
            between(field_.depths_m[edge.depth], field_.depths_m[d])};
  }
  [[nodiscard]] bool known(size_t time, size_t depth) const {
    return !std::isnan(value(time, depth) + value(time + 1, depth) + value(time, depth + 1) +
                       value(time + 1, depth + 1));
  }

 private:
  [[nodiscard]] double value(size_t time, size_t depth) const {
    return field_.values[time * field_.depths_m.size() + depth];
  }
  [[nodiscard]] bool above(size_t time, size_t depth) const { return value(time, depth) >= level_; }

  const TraceField& field_;
  double level_;
};

/// The stretches of a line by their ends.
class Stretches {
 public:
  void add(const Edge& a, const Edge& b) {
    ends_.emplace(a, b);
    ends_.emplace(b, a);
  }
  /// Takes a whole line, from a loose end if there is one; empty if nothing is left.
  std::vector<Edge> take() {
    if (ends_.empty()) {
      return {};
    }
    auto start = ends_.begin();
    for (auto it = ends_.begin(); it != ends_.end(); it = ends_.upper_bound(it->first)) {
      if (ends_.count(it->first) == 1) {
        start = it;
        break;
      }
    }
    std::vector<Edge> line = {start->first};
    for (auto it = start; it != ends_.end(); it = ends_.find(line.back())) {
      const Edge from = it->first, to = it->second;
      ends_.erase(it);
      forget(to, from);
      line.push_back(to);
    }
    return line;
  }

 private:
  void forget(const Edge& from, const Edge& to) {
    for (auto [it, end] = ends_.equal_range(from); it != end; ++it) {
      if (it->second == to) {
        ends_.erase(it);
        return;
      }
    }
  }

  std::multimap<Edge, Edge> ends_;
};

/// The stretches within one cell: two crossed edges make one stretch, four (a saddle) make two.
void addCell(const Grid& grid, size_t time, size_t depth, Stretches& stretches) {
  std::vector<Edge> crossed;
  for (const Edge& edge : {Edge{time, depth, true}, Edge{time + 1, depth, false},
                           Edge{time, depth + 1, true}, Edge{time, depth, false}}) {
    if (const auto found = grid.crossed(edge)) {
      crossed.push_back(*found);
    }
  }
  for (size_t i = 0; i + 1 < crossed.size(); i += 2) {
    stretches.add(crossed[i], crossed[i + 1]);
  }
}

}  // namespace

std::vector<Line> contours(const TraceField& field, double level) {
  std::vector<Line> lines;
  if (field.values.size() != field.times_s.size() * field.depths_m.size()) {
    return lines;
  }
  const Grid grid(field, level);
  Stretches stretches;
  for (size_t t = 0; t + 1 < field.times_s.size(); ++t) {
    for (size_t d = 0; d + 1 < field.depths_m.size(); ++d) {
      if (grid.known(t, d)) {
        addCell(grid, t, d, stretches);
      }
    }
  }
  for (auto edges = stretches.take(); !edges.empty(); edges = stretches.take()) {
    Line line;
    for (const Edge& edge : edges) {
      line.push_back(grid.place(edge));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace glider::report::picture
