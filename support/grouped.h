// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <string>

namespace glider::support {

/// 1234567 as "1,234,567".
std::string grouped(uint64_t number);

/// "9.86", "1,250": to three digits, from 100 on whole; no less than `amount`, which is not
/// negative.
std::string atMost(double amount);
/// The same, no more than `amount`.
std::string atLeast(double amount);

}  // namespace glider::support
