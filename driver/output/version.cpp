// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/version.h"

#include "compiler/vehicles.h"
#include "driver/output/built_from.h"
#include "hooks/protocol/messages.h"
#include "platforms/load/default_platform.h"
#include "platforms/load/dictionary.h"

#include <fmt/format.h>

namespace glider::driver {

std::string versionText() {
  const auto platform = compiler::loadVehicle(std::string(platforms::kDefaultPlatform));
  const std::string dictionary =
      platform ? fmt::format("{:08x}", platforms::Dictionary(*platform).get().hash)
               : std::string("not readable");
  return fmt::format("glidercc {} (commit {})\nLLVM {}\nhook protocol {}\ndictionary of {}: {}",
                     GLIDER_VERSION, kCommit, kLlvmVersion, hooks::kProtocolVersion,
                     platforms::kDefaultPlatform, dictionary);
}

}  // namespace glider::driver
