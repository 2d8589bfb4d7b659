// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/golden/golden_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

namespace glider::golden {
namespace {

constexpr std::string_view kMark = "//|";

}  // namespace

GoldenFile::GoldenFile(std::filesystem::path path) : path_(std::move(path)) {
  std::ifstream in(path_, std::ios::binary);
  const std::string all(std::istreambuf_iterator<char>(in), {});
  size_t split = all.starts_with(kMark) ? 0 : all.find("\n" + std::string(kMark));
  split = split == std::string::npos ? all.size() : all.starts_with(kMark) ? 0 : split + 1;
  input_ = all.substr(0, split);
  std::istringstream rest(all.substr(split));
  for (std::string line; std::getline(rest, line);) {
    const size_t skip =
        line.starts_with(std::string(kMark) + " ") ? kMark.size() + 1 : kMark.size();
    expected_ += line.substr(std::min(skip, line.size())) + "\n";
  }
}

std::string GoldenFile::input() const {
  constexpr std::string_view kRepeat = "//@repeat ";
  if (input_.find(kRepeat) == std::string::npos) {
    return input_;
  }
  std::string out;
  std::istringstream lines(input_);
  for (std::string line; std::getline(lines, line); out += '\n') {
    const size_t colon = line.find(": ");
    if (!line.starts_with(kRepeat) || colon == std::string::npos) {
      out += line;
      continue;
    }
    for (unsigned long n = std::stoul(line.substr(kRepeat.size())); n > 0; --n) {
      out += line.substr(colon + 2);
    }
  }
  return out;
}

void GoldenFile::update(const std::string& actual) const {
  std::ofstream out(path_, std::ios::binary);
  out << input_ << (input_.empty() || input_.ends_with('\n') ? "" : "\n");
  std::istringstream lines(actual);
  for (std::string line; std::getline(lines, line);) {
    out << kMark << (line.empty() ? "" : " ") << line << "\n";
  }
}

std::vector<std::filesystem::path> goldensIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found;
  if (std::filesystem::is_directory(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".mission") {
        found.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace glider::golden
