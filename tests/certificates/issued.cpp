// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/certificates/issued.h"

#include "analysis/trace_of_run.h"
#include "compiler/proving.h"
#include "support/files.h"
#include "support/program.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace glider::tests {

std::string Issued::file(uint32_t requirement) const {
  const compiler::Checked& checked = *mission->checked;
  const ir::prove::RequirementVerdict& verdict = findings.requirements.at(requirement);
  if (!verdict.evidence) {
    return "";
  }
  compiler::Certificate certificate{"",
                                    *compiler::subjectOf(checked),
                                    verdict.evidence->method,
                                    verdict.assumptions,
                                    verdict.evidence->invariants,
                                    std::nullopt};
  if (verdict.run) {
    certificate.run = analysis::traceOfRun(checked, verdict);
  }
  return compiler::certificateToJson(certificate, checked.mission());
}

analysis::Rechecked Issued::rechecked(uint32_t requirement, const std::string& file) const {
  const auto certificate =
      compiler::certificateFromJson(file, "certificate.json", *mission->checked);
  if (!certificate) {
    ADD_FAILURE() << certificate.error().message;
    return {};
  }
  const auto found = analysis::recheck(*certificate, *mission, requirement);
  if (!found) {
    ADD_FAILURE() << found.error().message;
    return {};
  }
  return *found;
}

Issued issue(const std::string& text, ir::prove::Options options) {
  const auto path =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".mission");
  std::filesystem::create_directories(path.parent_path());
  EXPECT_TRUE(support::writeFileAtomically(path, text));
  auto compiled = compiler::compileMission(path);
  Issued issued;
  if (!compiled || !compiled->checked) {
    ADD_FAILURE() << "the mission has errors";
    return issued;
  }
  options.evidence = true;
  issued.findings = compiler::prove(*compiled->checked, options, compiled->diagnostics);
  issued.mission = std::make_shared<compiler::Optimised>(compiler::optimise(compiled->checked));
  return issued;
}

bool solverIsInstalled() {
  return support::runProgram({analysis::kSolver, "--version"}, "").has_value();
}

}  // namespace glider::tests
