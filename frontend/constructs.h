// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/fixes.h"

#include <string_view>

namespace glider::frontend {

/// The constructs of a mission's text, found by its keywords alone, so that errors do not hide
/// them: what `glidercc fix` needs in order to change nothing outside an error.
support::Constructs constructsOf(std::string_view text);

}  // namespace glider::frontend
