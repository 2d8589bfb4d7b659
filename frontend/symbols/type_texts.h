// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"
#include "platforms/load/platform.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

/// Types as a pilot writes them; empty if there is none.
namespace glider::frontend {

/// `written` itself if it is a type.
std::string knownType(std::string_view written);
/// The unit that a bare number of type `written` has.
std::string unitOf(std::string_view written);
std::string typeOf(const platforms::PlatformSensor& sensor);

/// The types of constants by the file and offset of their names: those whose definitions are right.
using ConstantTypes = std::map<std::pair<uint32_t, uint32_t>, std::string>;
ConstantTypes constantTypes(const ast::File& mission, const AnalysisInputs& inputs);

}  // namespace glider::frontend
