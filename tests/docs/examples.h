// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glider::tests {

/// A block of a document between ```mission and ```; one of ```fragment gets a first line.
struct Example {
  std::string file;
  int line = 0;
  std::string expected;  ///< "" or an id
  std::string text;
  std::map<std::string, std::string> files;  ///< the blocks ```mi NAME of the document
};

/// The examples of a Markdown file, in order.
std::vector<Example> examplesOf(const std::filesystem::path& path);

}  // namespace glider::tests
