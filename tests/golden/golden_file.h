// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glider::golden {

/// One golden: a mission, and below it, in `//|` comments, what the stage says about it
/// (README.md).
class GoldenFile {
 public:
  explicit GoldenFile(std::filesystem::path path);

  /// The mission; a line `//@repeat N: text` stands for N times `text`, on one line.
  [[nodiscard]] std::string input() const;
  [[nodiscard]] const std::string& expected() const { return expected_; }
  /// Rewrites the file with `actual` as what is expected.
  void update(const std::string& actual) const;

 private:
  std::filesystem::path path_;
  std::string input_;
  std::string expected_;
};

/// Every golden under `folder`, sorted.
std::vector<std::filesystem::path> goldensIn(const std::filesystem::path& folder);

}  // namespace glider::golden
