// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"
#include "platforms/load/load_platform.h"
#include "support/diagnostics/render.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>

namespace glider::frontend::testing_support {

inline std::string readSource(const std::string& path) {
  auto text = support::readFile(std::string(GLIDER_SOURCE_DIR "/") + path);
  EXPECT_TRUE(text.has_value()) << path;
  return text.value_or("");
}

/// A mission of the source tree without its own requirements, for tests that give it others.
inline std::string readWithoutPromises(const std::string& path) {
  std::istringstream in(readSource(path));
  std::string text;
  for (std::string line; std::getline(in, line);) {
    text += line.starts_with("require ") ? "" : line + "\n";
  }
  return text;
}

/// One run of the frontend over a text, with all that it lives on.
struct FrontendRun {
  explicit FrontendRun(std::string text) : file(sources.add("test.mission", std::move(text))) {}

  std::optional<ast::File> parse() { return frontend::parse(sources, file, diagnostics); }

  std::optional<ir::Mission> compile() {
    auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
    EXPECT_TRUE(platform.has_value());
    const uint32_t library =
        sources.add("standard.mission", readSource("missions/library/standard.mission"));
    const auto standard = frontend::parse(sources, library, diagnostics);
    EXPECT_TRUE(standard.has_value());
    const auto mission = parse();
    return mission ? analyse(*mission, {*platform, {&*standard}, sources}, diagnostics)
                   : std::nullopt;
  }

  [[nodiscard]] std::string said() const { return support::render(diagnostics, sources, false); }
  [[nodiscard]] bool says(support::DiagnosticId id) const {
    for (const support::Diagnostic& d : diagnostics.sorted()) {
      if (d.id == id) {
        return true;
      }
    }
    return false;
  }

  support::SourceManager sources;
  uint32_t file;
  support::DiagnosticEngine diagnostics;
};

}  // namespace glider::frontend::testing_support
