// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/platform.h"
#include "platforms/load/toml_reader.h"

namespace glider::platforms {

/// Reads [envelope]: with `fastest_m_s` of a vehicle that takes a speed, else of one that glides.
/// Either may have no fin, and a glider no pitch battery. Failures are the reader's.
Envelope readEnvelope(TomlReader& reader);

}  // namespace glider::platforms
