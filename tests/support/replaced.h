// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::tests {

/// `text` with each `from` in it replaced by `to`. The test fails if `from` is not in it: it would
/// try the text that it means to change.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace glider::tests
