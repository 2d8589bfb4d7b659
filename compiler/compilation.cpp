// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"

#include "compiler/share.h"
#include "frontend/import/imports.h"
#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/files.h"

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

/// Where the mission names its platform; nowhere if it leaves that to the default.
support::SourceRange platformRange(const ast::File& file) {
  for (const ast::Item& item : file.items) {
    if (const auto* line = std::get_if<ast::PlatformLine>(&item)) {
      return line->name.where;
    }
  }
  return {};
}

/// The platform that the mission names, or the default.
Result<void> choosePlatform(Compilation& compilation) {
  const std::string name = frontend::platformName(*compilation.ast);
  const std::filesystem::path file = platformFile(name);
  const support::SourceRange range = platformRange(*compilation.ast);
  std::error_code ignored;
  if (range.valid() && !std::filesystem::exists(file, ignored)) {
    compilation.diagnostics.report(support::DiagnosticId::unknownPlatform, range, name);
    return {};
  }
  auto platform = platforms::loadPlatform(file);
  if (!platform) {
    return std::unexpected(platform.error());
  }
  compilation.platform = std::move(*platform);
  return {};
}

/// The library's declarations; our own file, so a mistake in it is shown like any other.
Result<std::optional<ast::File>> loadLibrary(Compilation& compilation) {
  auto file = addSource(compilation.sources, shareDirectory() / "library" / "standard.mission");
  if (!file) {
    return std::unexpected(file.error());
  }
  compilation.library = *file;
  return frontend::parse(compilation.sources, *file, compilation.diagnostics);
}

Result<void> analyse(Compilation& compilation, uint32_t file) {
  compilation.ast = frontend::parse(compilation.sources, file, compilation.diagnostics);
  if (!compilation.ast) {
    return {};
  }
  if (auto chosen = choosePlatform(compilation); !chosen || !compilation.platform) {
    return chosen;
  }
  auto library = loadLibrary(compilation);
  if (!library) {
    return std::unexpected(library.error());
  }
  const auto imports =
      frontend::loadImports(*compilation.ast, compilation.sources, compilation.diagnostics);
  if (!*library || !imports) {
    return {};
  }
  frontend::AnalysisInputs inputs{*compilation.platform, {&**library}, compilation.sources};
  for (const ast::File& import : *imports) {
    inputs.library.push_back(&import);
  }
  compilation.mission =
      frontend::analyse(*compilation.ast, inputs, compilation.diagnostics, &compilation.in_c);
  return {};
}

}  // namespace

std::filesystem::path platformFile(const std::string& name) {
  return shareDirectory() / "platforms" / (name + ".toml");
}

Result<std::unique_ptr<Compilation>> compileMission(const std::filesystem::path& path) {
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  return compileText(path, std::move(*text));
}

Result<std::unique_ptr<Compilation>> compileText(const std::filesystem::path& path,
                                                 std::string text) {
  auto compilation = std::make_unique<Compilation>();
  const uint32_t file = compilation->sources.add(path.string(), std::move(text));
  if (path.extension() == ".ir") {
    compilation->mission = ir::read(compilation->sources, file, compilation->diagnostics);
    compilation->in_c =
        compilation->mission ? ir::usedInC(*compilation->mission) : ir::CInterface();
  } else if (auto analysed = analyse(*compilation, file); !analysed) {
    return std::unexpected(analysed.error());
  }
  if (compilation->ok()) {
    compilation->facts = ir::verify(*compilation->mission, compilation->diagnostics);
  }
  return compilation;
}

std::vector<std::string> stateNames(const ir::Mission& mission) {
  std::vector<std::string> names;
  for (const ir::State& state : mission.states) {
    names.push_back(state.name);
  }
  return names;
}

namespace {

/// That of the mission; one in the IR's text form does not bring it.
Result<void> needPlatform(Compilation& compilation) {
  if (!compilation.platform) {  // a mission in the IR's text form
    auto platform = platforms::loadPlatform(platformFile(compilation.mission->platform));
    if (!platform) {
      return std::unexpected(platform.error());
    }
    compilation.platform = std::move(*platform);
  }
  return {};
}

}  // namespace

Result<std::map<ir::CasePlace, bool>> casesThatNeverFire(Compilation& compilation) {
  if (auto known = needPlatform(compilation); !known) {
    return std::unexpected(known.error());
  }
  ir::prove::Options options;
  options.library = compilation.library;
  return ir::prove::casesThatNeverFire(*compilation.mission, compilation.facts,
                                       *compilation.platform, options);
}

Result<ir::prove::Findings> proveMission(Compilation& compilation, ir::prove::Options options) {
  if (auto known = needPlatform(compilation); !known) {
    return std::unexpected(known.error());
  }
  options.library = compilation.library;
  return ir::prove::prove(*compilation.mission, compilation.facts, *compilation.platform, options,
                          compilation.diagnostics);
}

}  // namespace glider::compiler
