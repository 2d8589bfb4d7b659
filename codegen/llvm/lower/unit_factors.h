// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>

namespace glider::codegen {

/// The units in which a parameter of `type` may be given at launch, in the form of
/// GliderParameterInfo::units.
std::string unitFactors(const ir::Type& type);

}  // namespace glider::codegen
