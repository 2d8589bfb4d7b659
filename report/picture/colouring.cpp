// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/picture/colouring.h"

#include "report/picture/colours.h"

#include <algorithm>
#include <cmath>

namespace glider::report {
namespace {

constexpr TrackQuantity kQuantities[] = {
    {"chlorophyll", "sci_flbbcd_chlor_units", "chlorophyll (µg/L)"},
    {"chlorophyll", "sci_flntu_chlor_units", "chlorophyll (µg/L)"},
    {"temp", "sci_water_temp", "temperature (°C)"},
    {"oxygen", "sci_oxy4_oxygen", "oxygen (µM)"},
    {"battery", "m_battery", "battery (V)"},
    {"altitude", "m_altitude", "altitude (m)"},
};

}  // namespace

std::span<const TrackQuantity> pictureQuantities() {
  return kQuantities;
}

namespace picture {
namespace {

/// The quantity that `style` names; otherwise the first of chlorophyll and temperature that was
/// measured.
std::optional<TrackQuantity> choose(const support::Trace& trace, const PictureStyle& style) {
  std::optional<TrackQuantity> unknown;
  for (const TrackQuantity& quantity : kQuantities) {
    const bool usual = quantity.name == "chlorophyll" || quantity.name == "temp";
    if (!(style.colour ? *style.colour == quantity.name : usual)) {
      continue;
    }
    if (isKnown(trace, quantity.column)) {
      return quantity;
    }
    unknown = unknown ? unknown : quantity;
  }
  return style.colour ? unknown : std::nullopt;
}

}  // namespace

Colouring::Colouring(const support::Trace& trace, const PictureStyle& style)
    : trace_(trace), quantity_(choose(trace, style)) {
  if (!quantity_) {
    return;
  }
  values_ = valuesOf(trace, quantity_->column);
  constexpr ptrdiff_t kSeen = 100;  // a smaller share of grey is not visible
  const auto unknown = std::ranges::count_if(values_, [](double v) { return !std::isfinite(v); });
  has_unknown_ = unknown * kSeen > std::ssize(values_);
  const Extent known = extentOf(values_);
  if (known.least <= known.greatest) {
    const double least_span = 1e-3 * std::fmax(1, std::fabs(known.least));
    extent_ = {known.least, std::fmax(known.greatest, known.least + least_span)};
  }
}

/// The step of a value; a value that has just crossed a border keeps `before`, so that noise does
/// not break the track into small pieces. -1 for an unknown one.
int Colouring::stepOf(double value, int before) const {
  if (!std::isfinite(value)) {
    return -1;
  }
  constexpr double kSlack = 0.1;  // of a step
  const double x = (value - extent_.least) / (extent_.greatest - extent_.least) * kSteps;
  if (before >= 0 && x > before - kSlack && x < before + 1 + kSlack) {
    return before;
  }
  return std::clamp(static_cast<int>(std::floor(x)), 0, static_cast<int>(kSteps) - 1);
}

std::vector<std::string> Colouring::colours() const {
  std::vector<std::string> colours;
  const auto pilots = pilotsOf(trace_);
  int step = -1;
  for (size_t row = 0; row < trace_.rowCount(); ++row) {
    if (quantity_) {
      step = stepOf(values_[row], step);
    }
    colours.emplace_back(!quantity_  ? pilotColour(pilots[row])
                         : step >= 0 ? scaleColour(static_cast<size_t>(step), kSteps)
                                     : std::string(kGrey));
  }
  return colours;
}

std::vector<Piece> Colouring::pieces() const {
  const auto colour = colours();
  std::vector<Piece> pieces;
  for (size_t row = 0; row < colour.size(); ++row) {
    if (pieces.empty() || pieces.back().colour != colour[row]) {
      pieces.push_back({row, row, colour[row]});
    }
    pieces.back().end = std::min(row + 1, colour.size() - 1);
  }
  return pieces;
}

}  // namespace picture
}  // namespace glider::report
