// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::support {

/// `text` on one line, with each run of white space as one space.
std::string onOneLine(std::string_view text);

}  // namespace glider::support
