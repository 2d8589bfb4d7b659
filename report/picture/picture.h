// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glider::report {

/// What can colour the track of a picture.
struct TrackQuantity {
  std::string_view name;    ///< as in the language
  std::string_view column;  ///< of the trace
  std::string_view title;   ///< of the colour bar, with its unit
};

/// Every quantity that can colour a track.
std::span<const TrackQuantity> pictureQuantities();

/// How a flight is drawn.
struct PictureStyle {
  /// One of pictureQuantities(), or "state". Without it chlorophyll where the flight has measured
  /// it, else the temperature, else the state.
  std::optional<std::string> colour;
};

/// The flight as one SVG, for a paper or a logbook: depth against time, downwards, its track
/// coloured by a quantity or by state; who decides in a band above; the water's isotherms, the
/// marked one, the seabed and the ordered range where the trace has them; the track from above
/// beside it when the flight did not just go straight on. Lines are thinned to a third of a pixel.
/// Where the quantity is unknown the track is grey. The same trace gives the same bytes.
std::string drawPicture(const support::Trace& trace, const PictureStyle& style = {});

}  // namespace glider::report
