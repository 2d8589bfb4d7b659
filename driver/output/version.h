// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::driver {

/// What --version prints: the version, the commit that was built, LLVM's version, the protocol's,
/// and the hash of the usual vehicle's dictionary, which its hookbeh compares.
std::string versionText();

}  // namespace glider::driver
