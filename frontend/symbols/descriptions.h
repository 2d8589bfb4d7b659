// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <string>

namespace glider::frontend {

/// One line on what is declared at `where`: the comment behind it on its line, or else the comment
/// on the lines right above it, or else the declaration itself.
std::string describe(const support::SourceManager& sources, const support::SourceRange& where);

}  // namespace glider::frontend
