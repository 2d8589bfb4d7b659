// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/broken_assumption.h"

#include "ir/core/inside.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace glider::flights {
namespace {

using ir::AssumptionKind;

constexpr double kEstimateError = 0.1;  // m/s

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
                         flown.row(),
                         fmt::format("the mission begins at {:.4f}, {:.4f}", latitude, longitude)))
                   : std::nullopt;
  }
  return assumption.kind == AssumptionKind::Current ? fastCurrent(assumption.limit, trace, flown)
                                                    : std::nullopt;
}

}  // namespace glider::flights
