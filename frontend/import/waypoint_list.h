// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "support/diagnostics/engine.h"
#include "support/source_manager.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace glider::frontend {

/// Whether a file is a list of waypoints by its name: `goto_l10.ma`, in small letters or capitals.
bool isWaypointList(const std::filesystem::path& file);

/// The waypoints of file `number`, as a file that declares them as the constant path `name`. They
/// are the lines between `<start:waypoints>` and `<end:waypoints>`, each a longitude and a latitude
/// in ddmm.mmmm, south and west negative; `#` begins a comment. Empty if a line is something else
/// (GL2182) or there is none (GL2183); what they mean is checked as in a mission. GL2177 if the
/// file has an `initial_wpt` that is not 0.
std::optional<ast::File> readWaypointList(const support::SourceManager& sources, uint32_t number,
                                          const ast::Name& name,
                                          support::DiagnosticEngine& diagnostics);

}  // namespace glider::frontend
