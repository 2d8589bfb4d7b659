// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <vector>

namespace glider::analysis {

/// A case of a list, as it is compared and as it is shown.
struct ListedCase {
  std::string all;      ///< canonical
  std::string guard;    ///< canonical
  std::string written;  ///< as the pilot wrote it
};

/// Lines that say which cases were changed, added, removed or moved. A changed case is one with the
/// same guard, or the next one at the same place.
std::vector<std::string> compareCases(const std::vector<ListedCase>& before,
                                      const std::vector<ListedCase>& after);

}  // namespace glider::analysis
