// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::support {

/// `text` as a quoted field of comma-separated values: in quotes, with each quote in it doubled.
std::string csvQuoted(std::string_view text);

}  // namespace glider::support
