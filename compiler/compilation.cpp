// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"

#include "compiler/library.h"
#include "compiler/share.h"
#include "compiler/steep_pitch.h"
#include "compiler/vehicles_own.h"
#include "frontend/frontend.h"
#include "frontend/import/imports.h"
#include "ir/opt/prepare_for_flight.h"
#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "ir/worlds/naps.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace glider::compiler {
namespace {

using support::Result;

/// Reads `path` into the sources; the number of the file.
Result<uint32_t> addSource(support::SourceManager& sources, const std::filesystem::path& path) {
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  return sources.add(path.string(), std::move(*text));
}

/// Where the mission names its platform; an empty range if it leaves that to the default.
support::SourceRange platformRange(const ast::File& file) {
  for (const ast::Item& item : file.items) {
    if (const auto* line = std::get_if<ast::PlatformLine>(&item)) {
      return line->name.where;
    }
  }
  return {};
}

/// The platform that the mission names, or the default; empty: there is none of that name.
Result<std::optional<platforms::Platform>> choosePlatform(const ast::File& mission,
                                                          support::DiagnosticEngine& diagnostics) {
  const std::string name = frontend::platformName(mission);
  const std::filesystem::path file = platformFile(name);
  const support::SourceRange range = platformRange(mission);
  std::error_code ignored;
  if (range.valid() && !std::filesystem::exists(file, ignored)) {
    diagnostics.report(support::diagnostics::unknownPlatform, range, name);
    return std::nullopt;
  }
  auto platform = platforms::loadPlatform(file);
  if (!platform) {
    return std::unexpected(platform.error());
  }
  return std::move(*platform);
}

/// Adds the standard library to `parsed`; false if it does not parse. The files are part of
/// glidercc, but an error in one is shown like any other.
Result<bool> addLibrary(Parsed& parsed, support::SourceManager& sources,
                        support::DiagnosticEngine& diagnostics) {
  for (const LibraryFile& part : libraryFor(parsed.platform)) {
    const auto file = addSource(sources, part.path);
    if (!file) {
      return std::unexpected(file.error());
    }
    auto library = frontend::parse(sources, *file, diagnostics);
    if (!library) {
      return false;
    }
    addPart(part, std::move(*library), parsed);
  }
  return true;
}

/// Empty if its structure could not be recognised, or a file that it needs is missing.
Result<std::shared_ptr<const Parsed>> parse(uint32_t file, support::SourceManager& sources,
                                            support::DiagnosticEngine& diagnostics) {
  auto mission = frontend::parse(sources, file, diagnostics);
  if (!mission) {
    return nullptr;
  }
  auto platform = choosePlatform(*mission, diagnostics);
  if (!platform || !*platform) {
    return platform ? Result<std::shared_ptr<const Parsed>>(nullptr)
                    : std::unexpected(platform.error());
  }
  auto parsed = std::make_shared<Parsed>();
  parsed->mission = std::move(*mission);
  parsed->platform = std::move(**platform);
  if (const auto added = addLibrary(*parsed, sources, diagnostics); !added || !*added) {
    return added ? Result<std::shared_ptr<const Parsed>>(nullptr) : std::unexpected(added.error());
  }
  auto imports = frontend::loadImports(parsed->mission, sources, diagnostics);
  if (!imports) {
    return nullptr;
  }
  std::ranges::move(*imports, std::back_inserter(parsed->libraries));
  parsed->faulty = diagnostics.hasErrors();
  return parsed;
}

/// Makes what follows from `compilation.parsed`; nothing is lowered if its text has errors.
void lower(Compilation& compilation) {
  const Parsed& parsed = *compilation.parsed;
  frontend::AnalysisInputs inputs{
      parsed.platform, {}, *compilation.sources, parsed.standard_library.size()};
  for (const ast::File& library : parsed.libraries) {
    inputs.library.push_back(&library);
  }
  frontend::BesideMission beside;
  auto mission = frontend::analyse(parsed.mission, inputs, compilation.diagnostics, &beside);
  compilation.open = std::move(beside.open);
  if (!mission) {
    return;
  }
  platforms::Platform platform = parsed.platform;
  allowForSteepPitch(*mission, platform.envelope);
  ir::allowForNaps(*mission, platform.world);
  compilation.lowered = std::make_shared<const Lowered>(
      Lowered{compilation.sources, std::make_shared<const ir::Mission>(std::move(*mission)),
              std::move(beside.in_c), std::move(platform), parsed.standard_library});
}

/// A mission in the IR's text form; empty if it has errors.
Result<std::shared_ptr<const Lowered>> readIr(uint32_t file,
                                              std::shared_ptr<const support::SourceManager> sources,
                                              support::DiagnosticEngine& diagnostics) {
  auto mission = ir::read(*sources, file, diagnostics);
  if (!mission) {
    return nullptr;
  }
  auto platform = platforms::loadPlatform(platformFile(mission->platform));
  if (!platform) {
    return std::unexpected(platform.error());
  }
  allowForSteepPitch(*mission, platform->envelope);
  ir::allowForNaps(*mission, platform->world);
  ir::CInterface in_c = ir::usedInC(*mission);
  return std::make_shared<const Lowered>(
      Lowered{std::move(sources),
              std::make_shared<const ir::Mission>(std::move(*mission)),
              std::move(in_c),
              std::move(*platform),
              {}});
}

/// Everything up to the IR.
Result<void> lowerText(const std::filesystem::path& path, uint32_t file, Compilation& compilation) {
  if (path.extension() == ".ir") {
    auto read = readIr(file, compilation.sources, compilation.diagnostics);
    if (!read) {
      return std::unexpected(read.error());
    }
    compilation.lowered = std::move(*read);
    return {};
  }
  auto parsed = parse(file, *compilation.sources, compilation.diagnostics);
  if (!parsed) {
    return std::unexpected(parsed.error());
  }
  compilation.parsed = std::move(*parsed);
  if (compilation.parsed) {
    lower(compilation);
  }
  return {};
}

/// Checks the structure of what was lowered, if it has no errors.
void verify(Compilation& compilation) {
  if (!compilation.lowered || compilation.diagnostics.hasErrors()) {
    return;
  }
  ir::MissionFacts facts = ir::verify(compilation.lowered->mission, compilation.diagnostics);
  if (!compilation.diagnostics.hasErrors()) {
    const Lowered& lowered = *compilation.lowered;
    compilation.checked = std::make_shared<const Checked>(
        Checked{compilation.lowered, std::move(facts), {lowered.mission, lowered.platform}});
  }
}

/// Writes the value of `choice`, or that none is written.
void write(std::span<const ChosenValue> values, ast::Choice& choice) {
  const auto found = std::ranges::find(values, choice.constant.name.text, &ChosenValue::name);
  choice.chosen = found != values.end();
  if (!choice.chosen) {
    choice.constant.value = choice.range.lowest;
    return;
  }
  const support::SourceRange where = choice.constant.value.where;
  ast::Expr value{ast::Literal{fmt::format("{}", std::fabs(found->number)), found->unit, where},
                  where};
  choice.constant.value = found->number < 0
                              ? ast::Expr{ast::Unary{ast::UnaryOp::Negate, std::move(value)}, where}
                              : std::move(value);
}

}  // namespace

std::filesystem::path platformFile(const std::string& name) {
  return shareDirectory() / "platforms" / (name + ".toml");
}

std::string shownName(const std::string& path) {
  return path == kStandardInput ? "standard input" : path;
}

Result<Compilation> compileMission(const std::filesystem::path& path) {
  if (path == kStandardInput) {
    auto text = support::readFile("/dev/stdin");
    return text ? compileText(shownName(path), std::move(*text))
                : Result<Compilation>(std::unexpected(text.error()));
  }
  if (auto kind = requireKind(path, MissionKind::Language); !kind) {
    return std::unexpected(kind.error());
  }
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  return compileText(path, std::move(*text));
}

Result<Compilation> compileText(const std::filesystem::path& path, std::string text) {
  Compilation compilation;
  const uint32_t file = compilation.sources->add(path.string(), std::move(text));
  if (auto lowered = lowerText(path, file, compilation); !lowered) {
    return std::unexpected(lowered.error());
  }
  verify(compilation);
  return compilation;
}

std::string textOf(const ChosenValue& value) {
  return fmt::format("{}{}{}", value.number, value.unit.empty() ? "" : " ", value.unit);
}

Compilation withChosen(const Compilation& compilation, std::span<const ChosenValue> values) {
  auto parsed = std::make_shared<Parsed>(*compilation.parsed);
  for (ast::Item& item : parsed->mission.items) {
    if (auto* choice = std::get_if<ast::Choice>(&item)) {
      write(values, *choice);
    }
  }
  Compilation made;
  made.sources = compilation.sources;
  made.parsed = std::move(parsed);
  lower(made);
  verify(made);
  return made;
}

std::shared_ptr<const Checked> onVehicle(const Checked& checked,
                                         const std::function<void(platforms::Platform&)>& change) {
  auto lowered = std::make_shared<Lowered>(*checked.lowered);
  change(lowered->platform);
  return std::make_shared<const Checked>(
      Checked{lowered, checked.facts, {lowered->mission, lowered->platform}});
}

Optimised optimise(std::shared_ptr<const Checked> checked,
                   const std::function<void(const ir::OptPass&, const ir::Mission&)>& after) {
  ir::Mission mission = ir::optimise(checked->mission(), after);
  return {std::move(checked), std::move(mission)};
}

Optimised withoutPasses(std::shared_ptr<const Checked> checked) {
  ir::Mission mission = checked->mission();
  ir::prepareForFlight(mission);
  return {std::move(checked), std::move(mission)};
}

std::vector<std::string> stateNames(const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const ir::State& state : mission.states) {
    names.push_back(state.name);
  }
  return names;
}

}  // namespace glider::compiler
