// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glider::report::picture {

/// Colour number `step` of `steps` (>= 2) colours from low to high. Their lightness always
/// increases, so that the scale can also be read in grey and by colour-blind readers.
std::string scaleColour(size_t step, size_t steps);

/// The colour of state number `id` (Okabe and Ito 2008, distinguishable for colour-blind readers);
/// states after the seventh reuse the colours.
std::string_view stateColour(double id);

/// The colour of the layered control, and of unknown values.
inline constexpr std::string_view kGrey = "#98a2ac";

/// Black or white, whichever is easier to read on `colour` (#rrggbb; relative luminance, WCAG 2).
std::string_view inkOn(std::string_view colour);

}  // namespace glider::report::picture
