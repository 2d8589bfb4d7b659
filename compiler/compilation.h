// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/input.h"
#include "frontend/ast/ast.h"
#include "frontend/frontend.h"
#include "ir/core/mission.h"
#include "ir/opt/optimise.h"
#include "ir/worlds/worlds.h"
#include "platforms/load/platform.h"
#include "support/diagnostics/engine.h"
#include "support/result.h"
#include "support/source_manager.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The stages of a mission from its text to what flies. Each product is made from the one before;
/// it is complete when it exists and does not change. Later products keep the earlier ones alive.
namespace glider::compiler {

/// A mission's text as its syntax tree, and what its names can mean.
struct Parsed {
  ast::File mission;
  std::vector<uint32_t> standard_library;  ///< numbers of its files
  std::vector<ast::File> libraries;        ///< the standard ones first, then the imported ones
  platforms::Platform platform;            ///< the one that the mission names
  bool faulty = false;  ///< the text had errors, which were corrected here so that it could be read
};

/// A mission in which every name and type is known; its structure may still have errors.
struct Lowered {
  std::shared_ptr<const support::SourceManager> sources;  ///< of all ranges in it
  std::shared_ptr<const ir::Mission> shared;              ///< a copy of this has the same mission
  ir::CInterface in_c;                                    ///< what it declares in C
  platforms::Platform platform;
  std::vector<uint32_t> standard_library;  ///< numbers of its files; none for the IR's text form
  const ir::Mission& mission = *shared;

  [[nodiscard]] bool inStandardLibrary(uint32_t file) const {
    return std::ranges::find(standard_library, file) != standard_library.end();
  }
};

/// A mission without errors.
struct Checked {
  std::shared_ptr<const Lowered> lowered;
  ir::MissionFacts facts;
  ir::Worlds worlds;  ///< of mission() and platform()

  [[nodiscard]] const ir::Mission& mission() const { return lowered->mission; }
  [[nodiscard]] const platforms::Platform& platform() const { return lowered->platform; }
  [[nodiscard]] const support::SourceManager& sources() const { return *lowered->sources; }
};

/// A mission as it is built and flown: without its requirements, and with its own numbering of
/// states and temporals.
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

/// The result of compiling a text: the products that could be made, and the diagnostics that say
/// why the others could not. Later stages report to the same `diagnostics`.
struct Compilation {
  std::shared_ptr<support::SourceManager> sources = std::make_shared<support::SourceManager>();
  support::DiagnosticEngine diagnostics;
  std::shared_ptr<const Parsed> parsed;  ///< also null for the IR's text form
  /// What its lines `choose` and `prefer` say, also if other lines have errors.
  frontend::LeftOpen open;
  std::shared_ptr<const Lowered> lowered;  ///< null: its text has errors
  std::shared_ptr<const Checked> checked;  ///< null: it has errors
};

/// What stands for standard input where a mission file is named.
inline constexpr const char* kStandardInput = "-";
/// `path` as messages name it: "standard input" for kStandardInput.
std::string shownName(const std::string& path);

/// Reads, parses, analyses and verifies the file at `path`, or standard input for kStandardInput; a
/// file ending in `.ir` is read as the IR's text form. The mission's errors are in
/// Compilation::diagnostics; only a file that cannot be read, one of the vehicle's own (GL9368) and
/// bad platform data are a Failure.
support::Result<Compilation> compileMission(const std::filesystem::path& path);

/// The same for `text`, used instead of the file at `path`; it is file 0 of the sources.
support::Result<Compilation> compileText(const std::filesystem::path& path, std::string text);

/// A value for a line `choose`: `65 m`.
struct ChosenValue {
  std::string name;
  double number = 0;
  std::string unit;  ///< empty: none
};
/// As the mission's text has it.
std::string textOf(const ChosenValue& value);

/// The same mission as if these values were written in its lines `choose`, and none in its others.
/// It must have been made from a text without errors (Parsed::faulty); its ranges are those of that
/// text.
Compilation withChosen(const Compilation& compilation, std::span<const ChosenValue> values);

/// The same mission on a vehicle that differs in what `change` makes of its platform.
std::shared_ptr<const Checked> onVehicle(const Checked& checked,
                                         const std::function<void(platforms::Platform&)>& change);

/// The mission as `glidercc build` compiles it; `after` is that of ir::optimise.
Optimised optimise(std::shared_ptr<const Checked> checked,
                   const std::function<void(const ir::OptPass&, const ir::Mission&)>& after = {});
/// The same at -O0: no pass has run.
Optimised withoutPasses(std::shared_ptr<const Checked> checked);

/// The path of the file of the platform called `name`.
std::filesystem::path platformFile(const std::string& name);

/// The states' names, by number.
std::vector<std::string> stateNames(const ir::Mission& mission);

}  // namespace glider::compiler
