// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/certificates/write.h"

#include "analysis/check/check.h"
#include "analysis/trace_of_run.h"
#include "compiler/certificate_file.h"
#include "support/files.h"

#include <string>
#include <system_error>
#include <utility>

namespace glider::driver {
namespace {

compiler::Certificate certificateWithRun(const compiler::Checked& checked,
                                         const ir::prove::RequirementVerdict& verdict,
                                         std::string subject) {
  compiler::Certificate certificate = compiler::certificateOf(checked, verdict, std::move(subject));
  if (verdict.evidence->method == ir::prove::Method::Run) {
    certificate.run = analysis::traceOfRun(checked, verdict);
  }
  return certificate;
}

}  // namespace

support::Result<size_t> writeCertificates(const analysis::CheckedFile& checked,
                                          const std::filesystem::path& folder) {
  const compiler::Checked& mission = *checked.compilation->checked;
  auto subject = compiler::subjectOf(mission);
  if (!subject) {
    return std::unexpected(subject.error());
  }
  std::error_code trouble;
  std::filesystem::create_directories(folder, trouble);  // reported when a file is written
  size_t count = 0;
  for (const ir::prove::RequirementVerdict& verdict : checked.proved.requirements) {
    const auto path = compiler::certificatePath(folder, verdict.requirement);
    if (!verdict.evidence) {
      std::filesystem::remove(path, trouble);
      continue;
    }
    const compiler::Certificate certificate = certificateWithRun(mission, verdict, *subject);
    if (auto written = support::writeFileAtomically(
            path, compiler::certificateToJson(certificate, mission.mission()));
        !written) {
      return std::unexpected(written.error());
    }
    ++count;
  }
  return count;
}

}  // namespace glider::driver
