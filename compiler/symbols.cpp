// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/symbols.h"

#include "compiler/library.h"
#include "compiler/share.h"
#include "frontend/import/imports.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

#include <filesystem>
#include <iterator>
#include <utility>

namespace glider::compiler {
namespace {

using support::Result;

constexpr uint32_t kMission = 0;

/// The platform that the mission names; one without sensors if there is none of that name.
Result<platforms::Platform> platformOf(const ast::File& mission) {
  const std::filesystem::path file = platformFile(frontend::platformName(mission));
  std::error_code ignored;
  return std::filesystem::exists(file, ignored)
             ? platforms::loadPlatform(file)
             : Result<platforms::Platform>(platforms::Platform{});
}

/// The parts of a mission with errors that can be read.
Result<Parsed> readIntact(support::SourceManager& sources) {
  Parsed parsed;
  parsed.mission = frontend::parseIntact(sources, kMission);
  auto platform = platformOf(parsed.mission);
  if (!platform) {
    return std::unexpected(platform.error());
  }
  parsed.platform = std::move(*platform);
  for (const LibraryFile& part : libraryFor(parsed.platform)) {
    auto text = support::readFile(part.path);
    if (!text) {
      return std::unexpected(text.error());
    }
    const uint32_t file = sources.add(part.path.string(), std::move(*text));
    addPart(part, frontend::parseIntact(sources, file), parsed);
  }
  std::ranges::move(frontend::loadIntactImports(parsed.mission, sources),
                    std::back_inserter(parsed.libraries));
  return parsed;
}

Symbols namesOf(const Parsed& parsed, std::shared_ptr<const support::SourceManager> sources) {
  frontend::AnalysisInputs inputs{parsed.platform, {}, *sources, parsed.standard_library.size()};
  for (const ast::File& library : parsed.libraries) {
    inputs.library.push_back(&library);
  }
  frontend::SymbolTable table = frontend::symbolsOf(parsed.mission, inputs);
  return {std::move(sources), std::move(table)};
}

}  // namespace

Result<Symbols> symbolsOf(const Compilation& compilation) {
  const std::string& path = compilation.sources->name(kMission);
  if (std::filesystem::path(path).extension() == ".ir") {
    return support::fail(support::diagnostics::noSyntaxTree, path);
  }
  if (compilation.parsed) {
    return namesOf(*compilation.parsed, compilation.sources);
  }
  // The text is read again into a copy: the sources of the compilation do not change.
  auto sources = std::make_shared<support::SourceManager>(*compilation.sources);
  const auto parsed = readIntact(*sources);
  return parsed ? Result<Symbols>(namesOf(*parsed, sources)) : std::unexpected(parsed.error());
}

}  // namespace glider::compiler
