// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_range.h"

#include <vector>

namespace glider::frontend {

/// A place on Earth in degrees, north and east positive.
struct Place {
  double latitude = 0;
  double longitude = 0;
};

/// A list of places, known when the mission is compiled.
using Path = std::vector<Place>;

/// A path that is given for a parameter.
struct PathArgument {
  Path path;
  support::SourceRange where;
};

}  // namespace glider::frontend
