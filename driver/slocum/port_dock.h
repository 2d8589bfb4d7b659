// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "driver/slocum/port_folder.h"
#include "vehicles/dock.h"

#include <filesystem>

namespace glider::driver {

/// Checks the line of `host` for what is in a folder: `mission` and `port`, for `seconds`.
vehicles::DockResult checkPortAtDock(const PortFolder& folder, const FolderPort& port,
                                     const compiler::Optimised& mission, vehicles::DockPart part,
                                     double seconds, const vehicles::DockHost& host);

}  // namespace glider::driver
