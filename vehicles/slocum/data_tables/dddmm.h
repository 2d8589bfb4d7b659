// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::slocum {

/// The degrees of a position in the vehicle's form, dddmm.mmmm; NaN for what has no such form.
double degreesOf(double dddmm);

}  // namespace glider::slocum
