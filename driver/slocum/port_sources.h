// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "support/result.h"

#include <string>
#include <utility>
#include <vector>

namespace glider::driver {

/// The files from which a mission was compiled, as they lie in a port's folder.
struct PortSources {
  std::string mission;  ///< the mission file, relative to the folder
  std::vector<std::pair<std::string, std::string>> files;  ///< names relative to it, and contents
};

/// Of `mission`, compiled from `mission_file`: alone it is `alone`; with what it imports, all lie
/// below `source/` as they do on disk, so that each finds the others. Fails if one cannot be read
/// again, or is on another disk.
support::Result<PortSources> portSources(const compiler::Optimised& mission,
                                         const std::string& mission_file, const std::string& alone);

}  // namespace glider::driver
