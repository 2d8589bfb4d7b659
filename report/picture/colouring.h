// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/flight_view.h"
#include "report/picture/picture.h"
#include "report/picture/polyline.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace glider::report::picture {

/// A part of the track in one colour, by rows; it shares its last row with the next.
struct Piece {
  size_t begin = 0, end = 0;
  std::string colour;
};

/// The meaning of the track's colours.
class Colouring {
 public:
  static constexpr size_t kSteps = 12;

  Colouring(const support::Trace& trace, const PictureStyle& style);

  /// The quantity; none if the colours are those of states.
  [[nodiscard]] const std::optional<TrackQuantity>& quantity() const { return quantity_; }
  /// The values that the scale covers; least < greatest.
  [[nodiscard]] Extent extent() const { return extent_; }
  /// Whether at least one row in a hundred has no value, and is therefore grey.
  [[nodiscard]] bool hasUnknown() const { return has_unknown_; }
  /// The whole track, divided where the colour changes.
  [[nodiscard]] std::vector<Piece> pieces() const;

 private:
  [[nodiscard]] int stepOf(double value, int before) const;
  [[nodiscard]] std::vector<std::string> colours() const;

  const support::Trace& trace_;
  std::optional<TrackQuantity> quantity_;
  std::vector<double> values_;
  Extent extent_{0, 1};
  bool has_unknown_ = false;
};

}  // namespace glider::report::picture
