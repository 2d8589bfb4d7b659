// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "report/findings/against.h"
#include "report/picture/picture.h"

#include <string>

namespace glider::report {

/// A mission along data files as one SVG: depth against time, coloured by a quantity or by state;
/// in a band above it the states in which the mission would have been, and marks at its
/// transitions; below it a line for each guard, with a tick whenever it became true. Without a
/// colour in `style` it is that of a quantity that the mission reads. The same data give the same
/// bytes.
std::string drawAgainst(const AgainstLogs& against, const support::SourceManager& sources,
                        PictureStyle style);

}  // namespace glider::report
