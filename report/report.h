// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <vector>

namespace glider::report {

/// Writes `trace` to `path` as one self-contained web page: no network, no other file. A flight of
/// more than kPageRows rows is downsampled (report/downsample.h); its figures are still those of
/// all rows. report/README.md lists the columns that the page uses, each of which may be absent.
/// What went wrong, `reported`, is shown in red at its top. The file is written completely or not
/// at all; GL9201 if it cannot be written.
support::Result<void> writeReport(const support::Trace& trace, const std::filesystem::path& path,
                                  const std::vector<support::Diagnostic>& reported = {});

}  // namespace glider::report
