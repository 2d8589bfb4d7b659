// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/spelling.h"
#include "platforms/load/platform.h"

#include <string>

namespace glider::frontend {

/// "`ctd`, `fluorometer` and `optode`"
std::string instrumentsOf(const platforms::Platform& platform);

/// What was meant by `word`, which is not the name of an instrument or sensor of `platform`: `all`,
/// or a part of the vehicle's name for what one measures, as in `flbbcd`. `how` is what is written
/// behind it.
Suggestion insteadOfInstrument(const std::string& word, const std::string& how,
                               const platforms::Platform& platform);

}  // namespace glider::frontend
