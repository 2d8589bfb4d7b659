// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/load_platform.h"

namespace glider::ir {

/// The platform of all missions.
inline const platforms::Platform& slocum() {
  static const auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *loaded;
}

}  // namespace glider::ir
