// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/broken_assumption.h"

#include "ir/core/inside.h"
#include "ir/eval/arithmetic.h"
#include "support/units/position_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace glider::flights {
namespace {

using ir::AssumptionKind;

constexpr double kEstimateError = 0.1;  // m/s

/// The metres between two places, as the language counts them.
double metresBetween(const ir::Position& from, const ir::Position& to) {
  return ir::onEarth(ir::Op::Distance, from, to);
}

/// The least distance of a place from the edges of a polygon, m; flat, which is good enough for a
/// message.
double metresToEdge(const ir::Geofence& area, const ir::Position& place) {
  constexpr double kDegrees = std::numbers::pi / 180;
  const double across = std::cos(place.latitude * kDegrees);
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < area.corners.size(); ++i) {
    const ir::Position& a = area.corners[i];
    const ir::Position& b = area.corners[(i + 1) % area.corners.size()];
    const double ab_n = b.latitude - a.latitude, ab_e = (b.longitude - a.longitude) * across;
    const double ap_n = place.latitude - a.latitude,
                 ap_e = (place.longitude - a.longitude) * across;
    const double size = ab_n * ab_n + ab_e * ab_e;
    const double along = size > 0 ? std::clamp((ap_n * ab_n + ap_e * ab_e) / size, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest,
                       metresBetween(place, {a.latitude + along * (b.latitude - a.latitude),
                                             a.longitude + along * (b.longitude - a.longitude)}));
  }
  return nearest;
}

/// How far from an assumed start a place is, for the end of a sentence. A disc was made a regular
/// polygon, which has the same centre.
std::string howFar(const ir::Assumption& assumption, const ir::Position& place) {
  const ir::Geofence& area = assumption.area;
  if (assumption.words.find("distance(") == std::string::npos) {
    return fmt::format(", {} outside of the area", support::lengthText(metresToEdge(area, place)));
  }
  ir::Position centre;
  for (const ir::Position& corner : area.corners) {
    centre.latitude += corner.latitude / static_cast<double>(area.corners.size());
    centre.longitude += corner.longitude / static_cast<double>(area.corners.size());
  }
  return fmt::format(", {} from the place that it names",
                     support::lengthText(metresBetween(place, centre)));
}

/// The rows of a trace from the first tick of a mission on. The trace is by vehicle time and the
/// mission by its own: this converts between them.
class FlownStart {
 public:
  FlownStart(const support::Trace& trace, const HeardTick& start) : trace_(trace), start_(start) {
    while (row_ + 1 < trace.rowCount() && trace.at(row_, 0) < start.vehicle_time) {
      ++row_;
    }
  }

  [[nodiscard]] size_t row() const { return row_; }
  /// NaN if the trace has no such column.
  [[nodiscard]] double at(const char* name, size_t row) const {
    const int column = trace_.column(name);
    return column < 0 || row >= trace_.rowCount() ? std::nan("") : trace_.at(row, column);
  }
  [[nodiscard]] double atStart(const char* name) const { return at(name, row_); }
  [[nodiscard]] FlownViolation broken(size_t row, std::string words) const {
    const double later = trace_.at(row, 0) - start_.vehicle_time;
    const double state = at("state", row);
    const auto number = static_cast<size_t>(state == state ? state : -1.0);
    return {0, start_.mission_time + later, trace_.at(row, 0),
            state == state && number < trace_.state_names.size() ? trace_.state_names[number] : "",
            std::move(words)};
  }

 private:
  const support::Trace& trace_;
  const HeardTick& start_;
  size_t row_ = 0;
};

std::optional<FlownViolation> fastCurrent(double limit, const support::Trace& trace,
                                          const FlownStart& flown) {
  for (size_t row = flown.row(); row < trace.rowCount(); ++row) {
    const double speed = std::hypot(flown.at("m_water_vx", row), flown.at("m_water_vy", row));
    if (speed > limit + kEstimateError) {
      return flown.broken(row, fmt::format("the vehicle estimates a current of {:.2f} m/s", speed));
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<FlownViolation> breakInTrace(const ir::Assumption& assumption,
                                           const support::Trace& trace, const HeardTick& start) {
  const FlownStart flown(trace, start);
  if (flown.row() >= trace.rowCount()) {
    return std::nullopt;
  }
  if (assumption.kind == AssumptionKind::StartDepth) {
    const double depth = flown.atStart("true_depth");
    return depth > assumption.limit
               ? std::optional(flown.broken(flown.row(),
                                            fmt::format("the mission begins {:.1f} m deep", depth)))
               : std::nullopt;
  }
  if (assumption.kind == AssumptionKind::StartInside) {
    const double latitude = flown.atStart("true_lat");
    const double longitude = flown.atStart("true_lon");
    const bool outside =
        latitude == latitude && !ir::isInside(assumption.area, {latitude, longitude});
    return outside ? std::optional(flown.broken(
                         flown.row(), fmt::format("the mission begins at {}{}",
                                                  support::positionText(latitude, longitude),
                                                  howFar(assumption, {latitude, longitude}))))
                   : std::nullopt;
  }
  return assumption.kind == AssumptionKind::Current ? fastCurrent(assumption.limit, trace, flown)
                                                    : std::nullopt;
}

}  // namespace glider::flights
