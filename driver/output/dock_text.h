// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "vehicles/dock.h"

#include <cstdint>
#include <string>

namespace glider::driver {

/// What a check-list is about.
struct DockHeading {
  std::string folder, mission, device;
  uint32_t baud = 0;
};

/// The check-list for people, in lines of at most 100 columns.
std::string dockText(const vehicles::DockResult& result, const DockHeading& heading);
/// The same for programs, into `document`.
void addDock(const vehicles::DockResult& result, const DockHeading& heading, Json& document);

}  // namespace glider::driver
