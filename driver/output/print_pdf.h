// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <filesystem>
#include <string>

namespace glider::driver {

/// Writes the web page `html` to the file `output` as a PDF, printed by Chromium; complete or not
/// at all. GL9377 if there is no Chromium or it prints nothing, GL9002.
support::Result<void> printPdf(const std::string& html, const std::filesystem::path& output);

}  // namespace glider::driver
