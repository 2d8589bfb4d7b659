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

/// Ends each dive by commands to climb of which each replaces the one of the tick before, so that a
/// vehicle that obeyed only what is left alone for three ticks would go on diving.
constexpr const char* kRestless = R"(mission restless

flightprofile up(top: length)
begin
  entry do ascend(top, 26 deg) end
end

flightprofile down(bottom: length)
begin
  entry do descend(bottom, 26 deg) end
end

always
  case missiontime >= 2 h exit

state diving
begin
  flightprofile down(55 m)
  sensors missiontime, depth, statetime
  events
    case depth > 20 m goto one
    case statetime > 20 min goto one
end

state one
begin
  flightprofile up(4 m)
  sensors missiontime, depth, statetime
  events
    case depth < 5 m goto diving
    case statetime > 0 s goto other
end

state other
begin
  flightprofile up(3 m)
  sensors missiontime, depth, statetime
  events
    case depth < 5 m goto diving
    case statetime > 0 s goto one
end
)";

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
  all.push_back(*loadMission("restless", kRestless));
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
