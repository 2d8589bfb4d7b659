// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What a fuzzer feeds: bytes to the lexer, parser and analysis, with the promises that must hold
// for any bytes.

#include "frontend/format/format.h"
#include "frontend/frontend.h"
#include "frontend/symbols.h"
#include "platforms/load/load_platform.h"
#include "support/check.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <cstddef>
#include <cstdint>

namespace {

using namespace glider;

const platforms::Platform& slocum() {
  static const platforms::Platform platform = [] {
    auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    CHECK(loaded.has_value(), "the platform file does not load");
    return *loaded;
  }();
  return platform;
}

const ast::File& library(support::SourceManager& sources) {
  static const std::string text =
      *support::readFile(GLIDER_SOURCE_DIR "/missions/library/standard.mission");
  static const ast::File file = [] {
    support::SourceManager first;
    support::DiagnosticEngine diagnostics;
    return *frontend::parse(first, first.add("standard.mission", text), diagnostics);
  }();
  sources.add("standard.mission", text);  // number 0, as when it was parsed
  return file;
}

/// A sound text can be laid out, which changes neither its AST nor, done again, anything.
void checkFormat(const support::SourceManager& sources, uint32_t file, const ast::File& parsed) {
  support::DiagnosticEngine quiet;
  const auto once = frontend::format(sources, file, quiet);
  CHECK(once.has_value(), "a sound text cannot be formatted");
  support::SourceManager again;
  const uint32_t formatted = again.add("formatted", *once);
  CHECK(frontend::parse(again, formatted, quiet) == parsed, "formatting changes the mission");
  CHECK(frontend::format(again, formatted, quiet) == once, "formatting again changes the text");
}

/// Names are in the text and do not overlap, and what can be looked up is what is in the table.
void checkSymbols(const support::SourceManager& sources, uint32_t file, const ast::File& standard) {
  const ast::File intact = frontend::parseIntact(sources, file);
  const auto table = frontend::symbolsOf(intact, {slocum(), {&standard}, sources});
  const auto check = [&](const frontend::Symbol& symbol, const support::SourceRange& range) {
    const std::string_view text = sources.text(range);
    CHECK(text == symbol.name || text == symbol.vehicle_name, "a name stands elsewhere");
    CHECK(table.at(range.file, range.begin) == &symbol, "a name is not found where it stands");
  };
  for (const frontend::Symbol& symbol : table.symbols()) {
    CHECK(!symbol.name.empty(), "a symbol has no name");
    if (symbol.where.valid()) {
      check(symbol, symbol.where);
    }
    for (const support::SourceRange& use : symbol.uses) {
      check(symbol, use);
    }
  }
  const auto middle = static_cast<uint32_t>(sources.text(file).size() / 2);
  CHECK(table.visibleAt(file, middle).size() <= table.symbols().size(),
        "more names than there are");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const ast::File& standard = library(sources);
  const uint32_t file =
      sources.add("fuzz.mission", std::string(reinterpret_cast<const char*>(data), size));
  const auto parsed = frontend::parse(sources, file, diagnostics);
  CHECK(parsed || diagnostics.hasErrors(), "nothing came of a text, and nothing was said about it");
  if (parsed) {
    const bool sound = !diagnostics.hasErrors();
    const auto mission = frontend::analyse(*parsed, {slocum(), {&standard}, sources}, diagnostics);
    CHECK(mission.has_value() != diagnostics.hasErrors(),
          "a mission in spite of an error, or no mission and no error");
    if (sound) {
      support::SourceManager again;
      support::DiagnosticEngine quiet;
      const auto reread = frontend::parse(again, again.add("printed", ast::print(*parsed)), quiet);
      CHECK(reread && !quiet.hasErrors() && *reread == *parsed,
            "what was printed reads back otherwise");
      checkFormat(sources, file, *parsed);
    }
  }
  checkSymbols(sources, file, standard);
  support::render(diagnostics, sources, false);
  for (const support::Diagnostic& d : diagnostics.sorted()) {
    CHECK(d.range.begin <= d.range.end && d.range.end <= sources.text(d.range.file).size(),
          "a place outside the file");
  }
  return 0;
}
