// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/overwritten.h"

#include <filesystem>
#include <system_error>

namespace glider::driver {

std::optional<std::string> overwrittenInput(const std::vector<std::string>& inputs,
                                            const std::vector<std::string>& outputs) {
  for (const std::string& input : inputs) {
    for (const std::string& output : outputs) {
      std::error_code error;
      if (!input.empty() && !output.empty() && std::filesystem::equivalent(output, input, error) &&
          !error) {
        return input;
      }
    }
  }
  return std::nullopt;
}

}  // namespace glider::driver
