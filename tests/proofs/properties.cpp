// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/proofs/properties.h"

#include "platforms/load/load_platform.h"
#include "support/check.h"

#include <fstream>
#include <sstream>

namespace glider::tests {
namespace {

std::string trimmed(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::vector<Property> properties() {
  std::ifstream file(GLIDER_SOURCE_DIR "/tests/proofs/properties.txt");
  std::vector<Property> all;
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    Property one;
    if (line.starts_with('#')) {
      continue;
    }
    std::getline(in, one.mission, '|');
    std::getline(in, one.verdict, '|');
    std::getline(in, one.requirement);
    all.push_back({trimmed(one.mission), trimmed(one.verdict), trimmed(one.requirement)});
  }
  CHECK(all.size() > 50, "properties.txt has lost its lines");
  return all;
}

const platforms::Platform& slocum() {
  static const auto platform = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *platform;
}

}  // namespace glider::tests
