// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>

namespace glider::report {

/// A path as a URI (RFC 3986): an absolute one with the scheme `file`, a relative one as a
/// reference that cannot be read as having a scheme.
std::string toUri(const std::string& path);

}  // namespace glider::report
