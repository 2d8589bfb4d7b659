// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/diagnostics/diagnostic.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <vector>

namespace glider::report {

/// Writes `trace` to `path` as one web page that needs nothing else: no network, no other file. A
/// flight of more than kPageRows rows is thinned (report/downsample.h); its figures are still those
/// of all rows. Columns the page knows are listed in report/README.md, each may be absent. What
/// went wrong, `reported`, stands in red at its top. The file appears whole or not at all; GL9201
/// when it cannot be written.
support::Result<void> writeReport(const support::Trace& trace, const std::filesystem::path& path,
                                  const std::vector<support::Diagnostic>& reported = {});

}  // namespace glider::report
