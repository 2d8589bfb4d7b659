// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>

namespace glider::support {

/// 1234567 as "1,234,567".
std::string grouped(uint64_t number);

/// "9.86", "1,250": to three digits, from 100 on whole and rounded up.
std::string groupedAmount(double amount);

}  // namespace glider::support
