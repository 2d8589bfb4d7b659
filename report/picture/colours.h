// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace glider::report::picture {

/// Of `steps` (>= 2) colours from low to high the one of number `step`: rising in lightness
/// throughout, so that it also reads in grey and to the colour-blind.
std::string scaleColour(size_t step, size_t steps);

/// The colour of state number `id` (Okabe and Ito 2008, told apart by the colour-blind); states
/// beyond the seventh begin again.
std::string_view stateColour(double id);

/// The layered control's, and that of values that nobody knows.
inline constexpr std::string_view kGrey = "#98a2ac";

/// Black or white, whichever is read more easily on `colour` (#rrggbb; relative luminance, WCAG 2).
std::string_view inkOn(std::string_view colour);

}  // namespace glider::report::picture
