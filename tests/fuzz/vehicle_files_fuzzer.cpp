// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// libFuzzer feeds bytes to the readers of the vehicle's own files, .mi and .ma, with the promises
// that must hold for any bytes.

#include "support/check.h"
#include "support/diagnostics/render.h"
#include "vehicles/slocum/mission_files/extctl_file.h"
#include "vehicles/slocum/mission_files/read.h"

#include <cstddef>
#include <cstdint>

namespace {

using namespace glider;

template <typename Read>
void feed(const char* name, const std::string& bytes, const Read& read) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add(name, bytes);
  const bool whole = read(sources, file, diagnostics);
  CHECK(whole == !diagnostics.hasErrors(), "a file is read exactly when nothing is wrong with it");
  (void)support::render(diagnostics, sources, false);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  feed("fuzz.mi", bytes, [](const auto& sources, uint32_t file, auto& diagnostics) {
    return slocum::readMission(sources, file, diagnostics).has_value();
  });
  feed("fuzz.ma", bytes, [](const auto& sources, uint32_t file, auto& diagnostics) {
    return slocum::readArguments(sources, file, diagnostics).has_value();
  });
  if (const auto list = slocum::readExtctlFile("fuzz.ini", bytes)) {
    const auto again = slocum::readExtctlFile("again.ini", slocum::printExtctlFile(*list, ""));
    CHECK(again && again->sensors().size() == list->sensors().size(), "what is printed is read");
  }
  return 0;
}
