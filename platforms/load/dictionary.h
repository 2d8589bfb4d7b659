// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/dictionary.h"
#include "platforms/load/platform.h"
#include "support/result.h"

#include <vector>

namespace glider::platforms {

/// Whether `name` is a role of hooks/protocol/roles.def.
bool isRole(std::string_view name);

/// GL5001 if missions for the platform cannot fly: it lacks a sensor that hooks need
/// (hooks/protocol/roles.def).
support::Result<void> checkRoles(const Platform& platform);

/// A platform's sensors in the form of the hook protocol. Hooks keep a pointer to get(), so this
/// object cannot be moved.
class Dictionary {
 public:
  explicit Dictionary(const Platform& platform);
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  [[nodiscard]] const GliderDictionary& get() const { return dictionary_; }

 private:
  std::vector<GliderSensorFormat> formats_;
  std::vector<uint32_t> roles_;
  GliderDictionary dictionary_;
};

}  // namespace glider::platforms
