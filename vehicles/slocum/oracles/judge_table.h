// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::slocum::oracles {

/// The rows of the table in scenarios/README.md on what each check allows, as Markdown.
std::string judgeTable();

}  // namespace glider::slocum::oracles
