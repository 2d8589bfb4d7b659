// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"

#include <string>

namespace glider::frontend {

/// One line about what is declared at `where`: the comment after it on its line, otherwise the
/// comment on the lines immediately above it, otherwise the declaration itself.
std::string describe(const support::SourceManager& sources, const support::SourceRange& where);

}  // namespace glider::frontend
