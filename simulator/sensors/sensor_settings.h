// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <concepts>
#include <iterator>
#include <string_view>
#include <type_traits>

namespace glider::simulator {

class ScenarioTables;

/// A key that a scenario file may have in [table].
struct ScenarioKey {
  std::string_view table, key;
};

/// What a scenario specifies about one sensor: plain data with its defaults, the keys that it reads
/// in [sensors] and [ocean] (a table of its own, [sensors.name], is one such key), and read(),
/// which reads them.
template <typename S>
concept SensorSettingsOf =
    std::is_aggregate_v<S> && std::copyable<S> && requires(S settings, ScenarioTables& tables) {
      { *std::begin(S::kKeys) } -> std::convertible_to<ScenarioKey>;
      { settings.read(tables) } -> std::same_as<void>;
    };

}  // namespace glider::simulator
