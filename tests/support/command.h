// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <string>

namespace glider::tests {

/// What a command did.
struct Outcome {
  int status = -1;  ///< exit code; 128 + signal number if a signal ended it
  std::string out;
  std::string err;
};

/// Runs a shell command line with standard input closed; GLIDERCC in its environment names the
/// built command, or another that the test's own environment names (scripts/mutants_code).
Outcome runShell(const std::string& line);

/// A new empty folder, removed with everything in it at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes `text` to `name` in the folder; returns its path.
  [[nodiscard]] std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

/// The whole of a file; empty if it is not there.
std::string slurp(const std::filesystem::path& path);

}  // namespace glider::tests
