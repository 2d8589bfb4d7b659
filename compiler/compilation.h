// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"
#include "ir/core/mission.h"
#include "ir/prove/prove.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::compiler {

/// One mission on its way through the stages; what a stage could not make is empty, and the
/// diagnostics say why.
struct Compilation {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  std::optional<ast::File> ast;
  std::optional<platforms::Platform> platform;
  std::optional<uint32_t> library;  ///< the standard library's file
  std::optional<ir::Mission> mission;
  ir::CInterface in_c;     ///< what it declares in C; meaningful when ok()
  ir::MissionFacts facts;  ///< meaningful when ok()

  [[nodiscard]] bool ok() const { return mission.has_value() && !diagnostics.hasErrors(); }
};

/// Reads `path`, parses, analyses and verifies it; a file ending in `.ir` is read as the IR's text
/// form. The mission's mistakes stand in Compilation::diagnostics; only the world's failures (file,
/// platform data) are a Failure.
support::Result<std::unique_ptr<Compilation>> compileMission(const std::filesystem::path& path);

/// The same for a `text` that stands in for the file at `path`; it is file 0 of the sources.
support::Result<std::unique_ptr<Compilation>> compileText(const std::filesystem::path& path,
                                                          std::string text);

/// Where the platform called `name` lies.
std::filesystem::path platformFile(const std::string& name);

/// The states' names, by number.
std::vector<std::string> stateNames(const ir::Mission& mission);

/// Proves what can be proved of a mission that is ok(): GL31xx, and lines for the report. Only the
/// world's failures are a Failure.
support::Result<ir::prove::Findings> proveMission(Compilation& compilation,
                                                  ir::prove::Options options = {});
/// Of a mission that is ok(): the cases of which GL3101 or GL3103 says that they never fire, and of
/// each whether it is earlier ones that hide it.
support::Result<std::map<ir::CasePlace, bool>> casesThatNeverFire(Compilation& compilation);

}  // namespace glider::compiler
