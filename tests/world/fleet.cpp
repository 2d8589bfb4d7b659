// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/world/fleet.h"

#include "platforms/load/load_platform.h"
#include "support/diagnostics/engine.h"
#include "support/files.h"
#include "tests/world/random_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace glider::tests {
namespace {

const std::filesystem::path kSource = GLIDER_SOURCE_DIR;

}  // namespace

uint64_t wanted(const char* name, uint64_t standard) {
  const char* text = std::getenv(name);
  return text == nullptr ? standard : std::stoull(text);
}

const platforms::Platform& slocum() {
  static const auto platform = platforms::loadPlatform(kSource / "platforms/slocum.toml");
  return *platform;
}

std::vector<FlyingMission> missions(uint64_t random, uint64_t seed) {
  setenv("GLIDERCC_SHARE", GLIDER_BINARY_DIR "/share/glidercc", 1);
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"missions", "missions/gallery"}) {
    for (const auto& entry : std::filesystem::directory_iterator(kSource / folder)) {
      if (entry.path().extension() == ".mission") {
        files.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(files);
  std::vector<FlyingMission> all;
  for (const auto& file : files) {
    all.push_back(*loadMission(file.string(), *support::readFile(file)));
  }
  for (uint64_t i = 0; i < random; ++i) {
    all.push_back(*loadMission(fmt::format("random {}", seed + i), randomMissionText(seed + i)));
  }
  return all;
}

std::vector<simulator::Scenario> scenarios() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "scenarios")) {
    if (entry.path().extension() == ".toml" && entry.path().stem() != "layered") {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  std::vector<simulator::Scenario> all;
  for (const auto& file : files) {
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    all.push_back(*simulator::loadScenario(file, slocum(), sources, diagnostics));
  }
  return all;
}

}  // namespace glider::tests
