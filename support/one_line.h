// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::support {

/// `text` on one line, every stretch of white space one blank.
std::string onOneLine(std::string_view text);

}  // namespace glider::support
