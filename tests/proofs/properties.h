// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"

#include <ostream>
#include <string>
#include <vector>

namespace glider::tests {

/// A line of properties.txt: what is to be decided of an example mission.
struct Property {
  std::string mission, verdict, requirement;
  /// For the test's name.
  friend void PrintTo(const Property& property, std::ostream* out) { *out << property.requirement; }
};

/// All of them, in the order of the file.
std::vector<Property> properties();

/// The platform of all missions.
const platforms::Platform& slocum();

}  // namespace glider::tests
