// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/golden/stages.h"

#include "compiler/library.h"
#include "frontend/constructs.h"
#include "frontend/frontend.h"
#include "frontend/import/imports.h"
#include "ir/core/validate.h"
#include "ir/prove/prove.h"
#include "ir/text/print.h"
#include "ir/verify/verify.h"
#include "platforms/load/load_platform.h"
#include "support/check.h"
#include "support/diagnostics/fixes.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace glider::golden {
namespace {

const platforms::Platform& platformNamed(const std::string& name) {
  static std::map<std::string, platforms::Platform> loaded;
  if (!loaded.contains(name)) {
    auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/" + name + ".toml");
    CHECK(platform.has_value(), "the file of a platform does not load");
    loaded.emplace(name, std::move(*platform));
  }
  return loaded.at(name);
}

/// The vehicle that an input is for: the LAUV with a line `platform lauv`, else the Slocum; a line
/// `//@without SENSOR` takes a sensor from it.
platforms::Platform platformFor(const std::string& input) {
  const bool lauv = input.find("\nplatform lauv\n") != std::string::npos;
  platforms::Platform platform = platformNamed(lauv ? "lauv" : "slocum");
  constexpr std::string_view kWithout = "\n//@without ";
  if (const size_t at = input.find(kWithout); at != std::string::npos) {
    const size_t from = at + kWithout.size();
    const std::string name = input.substr(from, input.find('\n', from) - from);
    const size_t erased = std::erase_if(
        platform.sensors, [&](const platforms::PlatformSensor& s) { return s.name == name; });
    CHECK(erased == 1, "//@without names no sensor of the platform");
    for (uint16_t id = 0; platforms::PlatformSensor & sensor : platform.sensors) {
      sensor.id = id++;
    }
  }
  return platform;
}

class Compilation {
 public:
  Compilation(const std::string& name, const std::string& input)
      : platform_(platformFor(input)), file_(sources_.add(name, input)) {}

  void parse() {
    ast_ = frontend::parse(sources_, file_, diagnostics_);
    if (ast_ && !diagnostics_.hasErrors()) {
      product_ = "--- ast\n" + ast::print(*ast_);
    }
  }

  void analyse() {
    parseLibrary();
    const auto imports = ast_ ? frontend::loadImports(*ast_, sources_, diagnostics_) : std::nullopt;
    if (imports) {
      frontend::AnalysisInputs inputs{platform_, {}, sources_};
      for (const ast::File& part : library_.libraries) {
        inputs.library.push_back(&part);
      }
      for (const ast::File& import : *imports) {
        inputs.library.push_back(&import);
      }
      mission_ = frontend::analyse(*ast_, inputs, diagnostics_);
    }
    showIr();
  }

  void verify() {
    product_.clear();
    if (mission_) {
      facts_ = ir::verify(*mission_, diagnostics_);
    }
  }

  void prove() {
    if (mission_ && !diagnostics_.hasErrors()) {
      ir::prove::Options options;
      options.library = library_.standard_library;
      options.report = true;
      options.board = platforms::BoardPower{3.42, 0.1, "as ts7800", {}};
      show(ir::prove::prove(*mission_, facts_, platform_, options, diagnostics_));
    }
  }

  [[nodiscard]] Outcome outcome() const {
    const bool warned = diagnostics_.errorCount() + diagnostics_.warningCount() > 0;
    return {support::render(diagnostics_, sources_, false) + product_, warned,
            diagnostics_.hasErrors(), diagnostics_.sorted()};
  }

 private:
  void parseLibrary() {
    for (const compiler::LibraryFile& part : compiler::libraryFor(platform_)) {
      const std::string name = part.path.filename().string();
      auto text = support::readFile(GLIDER_SOURCE_DIR "/missions/library/" + name);
      CHECK(text.has_value(), "the standard library cannot be read");
      auto parsed = frontend::parse(sources_, sources_.add(name, *text), diagnostics_);
      CHECK(parsed.has_value(), "the standard library does not parse");
      compiler::addPart(part, std::move(*parsed), library_);
    }
  }

  void show(const ir::prove::Findings& findings) {
    for (const auto& line : findings.lines) {
      product_ += "--- " + line.text + "\n";
    }
    for (const auto& verdict : findings.requirements) {
      const support::SourceRange range = mission_->requirements[verdict.requirement].range;
      product_ += "--- " + std::string(ir::prove::word(verdict.verdict)) + ": " +
                  std::string(sources_.text(range)) + "\n";
      const std::string premises = ir::prove::premisesOf(verdict, *mission_);
      product_ += premises.empty() ? "" : "---   " + premises + "\n";
    }
  }

  void showIr() {
    product_.clear();
    if (mission_) {
      for (const ir::Defect& defect : ir::validate(*mission_)) {
        product_ += "--- invalid: " + defect.message + "\n";
      }
      product_ += "--- ir\n" + ir::print(*mission_);
    }
  }

  platforms::Platform platform_;
  support::SourceManager sources_;
  uint32_t file_;
  support::DiagnosticEngine diagnostics_;
  std::optional<ast::File> ast_;
  compiler::Parsed library_;  ///< only its standard library
  std::optional<ir::Mission> mission_;
  ir::MissionFacts facts_;
  std::string product_;
};

/// The lines that the fixed text has in place of others, with their numbers.
std::string changedLines(const std::string& before, const std::string& after) {
  size_t begin = 0;  // where the first line begins that differs
  for (size_t i = 0; i < before.size() && i < after.size() && before[i] == after[i]; ++i) {
    begin = before[i] == '\n' ? i + 1 : begin;
  }
  size_t same = 0;  // bytes of whole lines at the end that do not differ
  for (size_t i = 1; begin + i < before.size() && begin + i < after.size() &&
                     before[before.size() - i] == after[after.size() - i];
       ++i) {
    same = before[before.size() - i] == '\n' ? i - 1 : same;
  }
  std::istringstream lines(after.substr(begin, after.size() - same - begin));
  auto number = std::count(after.begin(), after.begin() + static_cast<ptrdiff_t>(begin), '\n');
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    text += fmt::format("--- {:5} | {}\n", ++number, line);
  }
  return text;
}

/// What `check` says of a mission, and what `fix` makes of it.
Outcome judgeError(const std::string& name, const std::string& input) {
  Outcome outcome = run("prove", name, input);
  const auto check = [&](const std::string& text) {
    return support::Result<std::vector<support::Diagnostic>>(run("verify", name, text).diagnostics);
  };
  const auto fixing = support::fixAll(input, 0, {check, frontend::constructsOf});
  CHECK(fixing.has_value(), "the text of a golden can always be read");
  if (const size_t proofs = outcome.text.find("--- "); proofs != std::string::npos) {
    outcome.text.erase(proofs);
  }
  outcome.text += fixing->text == input ? "--- fix changes nothing\n"
                                        : "--- fix writes\n" + changedLines(input, fixing->text);
  return outcome;
}

}  // namespace

Outcome run(const std::string& stage, const std::string& name, const std::string& input) {
  if (stage == "errors") {
    return judgeError(name, input);
  }
  Compilation compilation(name, input);
  compilation.parse();
  if (stage != "parse") {
    compilation.analyse();
  }
  if (stage == "verify" || stage == "prove") {
    compilation.verify();
  }
  if (stage == "prove") {
    compilation.prove();
  }
  return compilation.outcome();
}

}  // namespace glider::golden
