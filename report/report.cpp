// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/report.h"

#include "report/page.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

namespace glider::report {

support::Result<void> writeReport(const support::Trace& trace, const std::filesystem::path& path,
                                  const std::vector<support::Diagnostic>& reported) {
  auto written = support::writeFileAtomically(path, renderPage(trace, reported));
  if (!written) {
    return support::fail(support::diagnostics::reportNotWritten, written.error().message);
  }
  return {};
}

}  // namespace glider::report
