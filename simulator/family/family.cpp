// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/family/family.h"

#include <algorithm>

namespace glider::simulator {
namespace {

constexpr const Family* kFamilies[] = {
#define FAMILY(name) &families::name,
#include "vehicles/vehicles.def"
#undef FAMILY
};

}  // namespace

const Family* familyOf(const platforms::Platform& platform) {
  const auto* const found = std::ranges::find(kFamilies, platform.family,
                                              [](const Family* family) { return family->name; });
  return found == std::end(kFamilies) ? nullptr : *found;
}

std::string knownFamilies() {
  std::string all;
  for (const Family* family : kFamilies) {
    all += (all.empty() ? "only `" : ", `") + std::string(family->name) + "`";
  }
  return all;
}

}  // namespace glider::simulator
