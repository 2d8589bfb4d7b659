// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/docs/examples.h"

#include <fstream>

namespace glider::tests {

std::vector<Example> examplesOf(const std::filesystem::path& path) {
  const std::string fence = "```";
  std::vector<Example> examples;
  std::ifstream file(path);
  std::string line;
  bool inside = false;
  std::map<std::string, std::string> files;
  std::string name;  // of the file that is read
  const std::string file_fence = fence + "mi ";
  for (int number = 1; std::getline(file, line); ++number) {
    const bool fragment = line.starts_with(fence + "fragment");
    if (!inside && (fragment || line.starts_with(fence + "mission"))) {
      const size_t space = line.find(' ');
      examples.push_back({path.filename().string(),
                          number,
                          space == std::string::npos ? "" : line.substr(space + 1),
                          fragment ? "mission fragment\n" : "",
                          {}});
      inside = true;
    } else if (!inside && name.empty() && line.starts_with(file_fence)) {
      name = line.substr(file_fence.size());
    } else if (line.starts_with(fence)) {
      inside = false;
      name.clear();
    } else if (inside) {
      examples.back().text += line + "\n";
    } else if (!name.empty()) {
      files[name] += line + "\n";
    }
  }
  for (Example& example : examples) {
    example.files = files;
  }
  return examples;
}

}  // namespace glider::tests
