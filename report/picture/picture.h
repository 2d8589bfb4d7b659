// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glider::report {

/// A quantity that can colour the track of a picture.
struct TrackQuantity {
  std::string_view name;    ///< as in the language
  std::string_view column;  ///< of the trace
  std::string_view title;   ///< of the colour bar, with its unit
};

/// Every quantity that can colour a track; one that several instruments measure has several rows.
std::span<const TrackQuantity> pictureQuantities();

/// How a flight is drawn.
struct PictureStyle {
  /// One of pictureQuantities(), or "state". If empty, chlorophyll if the flight has measured it,
  /// otherwise the temperature, otherwise the state.
  std::optional<std::string> colour;
};

/// The flight as one SVG, for a paper or a logbook: depth against time, downwards, its track
/// coloured by a quantity or by state; what controls the vehicle in a band above; the water's
/// isotherms, the marked one, the seabed and the commanded range if the trace has them; the track
/// from above beside it unless the flight just went straight on. Lines are simplified to a third of
/// a pixel. The track is grey where the quantity is unknown. The same trace gives the same bytes.
std::string drawPicture(const support::Trace& trace, const PictureStyle& style = {});

}  // namespace glider::report
