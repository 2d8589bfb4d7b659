// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/check/check.h"
#include "support/result.h"

#include <filesystem>

namespace glider::driver {

/// Writes a certificate into `folder` for each requirement that was proved and has evidence
/// (CheckOptions::evidence), and removes those that an earlier check has left there for the others.
/// Returns how many were written.
support::Result<size_t> writeCertificates(const analysis::CheckedFile& checked,
                                          const std::filesystem::path& folder);

}  // namespace glider::driver
