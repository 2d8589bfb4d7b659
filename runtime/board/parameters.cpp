// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/parameters.h"

#include "runtime/board/files.h"
#include "runtime/board/kernel.h"

namespace glider::runtime {
namespace {

constexpr uint32_t kMostFileBytes = 16384;

bool setFromFile(const char* path, Launch& launch) {
  static char bytes[kMostFileBytes];
  uint32_t size = 0;
  if (const char* problem = readFile(path, bytes, kMostFileBytes, size)) {
    tell("error: cannot read the parameters `", path, "`: ", problem);
    return false;
  }
  if (!launch.setAll(path, {bytes, bytes + size})) {
    tell("error: ", launch.problem());
    return false;
  }
  return true;
}

}  // namespace

bool setParameters(const Options& options, Launch& launch) {
  if (options.parameters != nullptr && !setFromFile(options.parameters, launch)) {
    return false;
  }
  for (uint32_t i = 0; i < options.setting_count; ++i) {
    const char* setting = options.settings[i];
    if (!launch.set({setting, setting + lengthOf(setting)})) {
      tell("error: ", launch.problem());
      return false;
    }
  }
  if (!launch.check()) {
    tell("error: ", launch.problem());
    return false;
  }
  return true;
}

}  // namespace glider::runtime
