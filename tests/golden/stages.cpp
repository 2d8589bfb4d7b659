// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/golden/stages.h"

#include <optional>

#include "frontend/frontend.h"
#include "support/check.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#if __has_include("ir/text/print.h") && __has_include("ir/text/read.h")
#include "ir/text/print.h"
#include "ir/text/read.h"
#define GLIDER_HAS_IR_TEXT 1
#endif
#if __has_include("ir/verify/verify.h")
#include "ir/verify/verify.h"
#define GLIDER_HAS_VERIFY 1
#endif

namespace glider::golden {
namespace {

const platforms::Platform& slocum() {
  static const platforms::Platform platform = [] {
    auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    CHECK(loaded.has_value(), "platforms/slocum.toml does not load");
    return *loaded;
  }();
  return platform;
}

class Compilation {
 public:
  Compilation(const std::string& name, const std::string& input) : file_(sources_.add(name, input)) {}

  void parse() {
    ast_ = frontend::parse(sources_, file_, diagnostics_);
    if (ast_ && !diagnostics_.hasErrors()) {
      product_ = "--- ast\n" + ast::print(*ast_);
    }
  }

  void analyse() {
    auto text = support::readFile(GLIDER_SOURCE_DIR "/missions/library/standard.mission");
    CHECK(text.has_value(), "the standard library cannot be read");
    const uint32_t library = sources_.add("standard.mission", *text);
    const auto standard = frontend::parse(sources_, library, diagnostics_);
    CHECK(standard.has_value(), "the standard library does not parse");
    if (ast_) {
      mission_ = frontend::analyse(*ast_, {slocum(), {&*standard}, sources_}, diagnostics_);
    }
    showIr();
  }

  void readIr() {
#ifdef GLIDER_HAS_IR_TEXT
    mission_ = ir::read(sources_, file_, diagnostics_);
#endif
    showIr();
  }

  void verify() {
    product_.clear();
#ifdef GLIDER_HAS_VERIFY
    if (mission_) {
      ir::verify(*mission_, diagnostics_);
    }
#endif
  }

  [[nodiscard]] Outcome outcome() const {
    const bool warned = diagnostics_.errorCount() + diagnostics_.warningCount() > 0;
    return {support::render(diagnostics_, sources_, false) + product_, warned, diagnostics_.hasErrors()};
  }

 private:
  void showIr() {
    product_.clear();
#ifdef GLIDER_HAS_IR_TEXT
    if (mission_) {
      product_ = "--- ir\n" + ir::print(*mission_);
    }
#endif
  }

  support::SourceManager sources_;
  uint32_t file_;
  support::DiagnosticEngine diagnostics_;
  std::optional<ast::File> ast_;
  std::optional<ir::Mission> mission_;
  std::string product_;
};

}  // namespace

Outcome run(const std::string& stage, const std::string& name, const std::string& input) {
  Compilation compilation(name, input);
  if (name.ends_with(".ir")) {
    compilation.readIr();
  } else {
    compilation.parse();
    if (stage != "parse") {
      compilation.analyse();
    }
  }
  if (stage == "verify") {
    compilation.verify();
  }
  return compilation.outcome();
}

bool hasStage(const std::string& stage) {
#ifndef GLIDER_HAS_VERIFY
  if (stage == "verify") {
    return false;
  }
#endif
#ifndef GLIDER_HAS_IR_TEXT
  if (stage == "ir") {
    return false;
  }
#endif
  return true;
}

}  // namespace glider::golden
