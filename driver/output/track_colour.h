// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/picture/picture.h"
#include "support/trace/trace.h"

namespace glider::driver {

/// `style`, or the usual one with a note on the terminal if the flight has no reading of the
/// quantity that it names: its track would be grey, beside a scale that says nothing.
report::PictureStyle styleFor(const support::Trace& trace, const report::PictureStyle& style);

}  // namespace glider::driver
