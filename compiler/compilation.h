// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "frontend/ast/ast.h"
#include "ir/core/c_symbols.h"
#include "ir/core/mission.h"
#include "ir/opt/optimise.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// A mission on its way from text to what flies. Each product is made from the one before, is
/// whole when it is there, and does not change; the later ones hold on to the earlier.
namespace glider::compiler {

/// A mission's text as its syntax tree, and what its names can mean.
struct Parsed {
  ast::File mission;
  uint32_t standard_library = 0;     ///< number of its file
  std::vector<ast::File> libraries;  ///< the standard one first, then the imported ones
  platforms::Platform platform;      ///< the one that the mission names
};

/// A mission whose every name and type is known; its structure may still have errors.
struct Lowered {
  std::shared_ptr<const support::SourceManager> sources;  ///< of all ranges in it
  ir::Mission mission;
  ir::CInterface in_c;  ///< what it declares in C
  platforms::Platform platform;
  std::optional<uint32_t> standard_library;  ///< number of its file; of the IR's text form: none
};

/// A mission without errors.
struct Checked {
  std::shared_ptr<const Lowered> lowered;
  ir::MissionFacts facts;

  [[nodiscard]] const ir::Mission& mission() const { return lowered->mission; }
  [[nodiscard]] const platforms::Platform& platform() const { return lowered->platform; }
  [[nodiscard]] const support::SourceManager& sources() const { return *lowered->sources; }
};

/// A mission as it is built and flown: without its requirements, and with states and temporals that
/// have numbers of their own.
struct Optimised {
  std::shared_ptr<const Checked> checked;  ///< what it was made from
  ir::Mission mission;

  [[nodiscard]] codegen::Input input() const {
    return {mission, platform(), checked->facts.stack_depth, &checked->mission(),
            &checked->lowered->in_c};
  }
  [[nodiscard]] const platforms::Platform& platform() const { return checked->platform(); }
  [[nodiscard]] const support::SourceManager& sources() const { return checked->sources(); }
};

/// What compiling a text came to: the products as far as there are any, and the diagnostics that
/// say why there are no more. Later stages report to the same `diagnostics`.
struct Compilation {
  std::shared_ptr<support::SourceManager> sources = std::make_shared<support::SourceManager>();
  support::DiagnosticEngine diagnostics;
  std::shared_ptr<const Parsed> parsed;    ///< null of the IR's text form, too
  std::shared_ptr<const Lowered> lowered;  ///< null: its text has errors
  std::shared_ptr<const Checked> checked;  ///< null: it has errors
};

/// Reads `path`, parses, analyses and verifies it; a file ending in `.ir` is read as the IR's text
/// form. The mission's errors stand in Compilation::diagnostics; only a file that cannot be read
/// and bad platform data are a Failure.
support::Result<Compilation> compileMission(const std::filesystem::path& path);

/// The same for a `text` that stands in for the file at `path`; it is file 0 of the sources.
support::Result<Compilation> compileText(const std::filesystem::path& path, std::string text);

/// The mission as `glidercc build` compiles it; `after` as of ir::optimise.
Optimised optimise(std::shared_ptr<const Checked> checked,
                   const std::function<void(const ir::OptPass&, const ir::Mission&)>& after = {});
/// The same at -O0: no pass has run.
Optimised withoutPasses(std::shared_ptr<const Checked> checked);

/// Where the platform called `name` lies.
std::filesystem::path platformFile(const std::string& name);

/// The states' names, by number.
std::vector<std::string> stateNames(const ir::Mission& mission);

}  // namespace glider::compiler
