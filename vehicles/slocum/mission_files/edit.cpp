// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/edit.h"

#include "vehicles/slocum/mission_files/line_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace glider::slocum {
namespace {

template <typename Number>
std::optional<Number> whole(std::string_view text) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value)
                                                                  : std::nullopt;
}

}  // namespace

std::optional<Edit> readEdit(std::string_view text) {
  const size_t equals = text.find('=');
  const size_t dot = text.find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot > equals) {
    return std::nullopt;
  }
  Edit edit;
  std::string_view behaviour = text.substr(0, dot);
  if (const size_t hash = behaviour.find('#'); hash != std::string_view::npos) {
    const auto number = whole<int>(behaviour.substr(hash + 1));
    if (!number || *number < 1) {
      return std::nullopt;
    }
    edit.number = *number;
    behaviour = behaviour.substr(0, hash);
  }
  edit.behaviour = lowerCase(behaviour);
  edit.setting = lowerCase(text.substr(dot + 1, equals - dot - 1));
  edit.value = std::string(text.substr(equals + 1));
  const auto value = whole<double>(edit.value);
  const bool good =
      value && std::isfinite(*value) && !edit.behaviour.empty() && !edit.setting.empty();
  return good ? std::optional(edit) : std::nullopt;
}

const Setting* findSetting(const MissionFile& mission, const Edit& edit) {
  if (edit.behaviour == "sensor") {
    const auto found = std::ranges::find(mission.sensors, edit.setting, &Setting::name);
    return found == mission.sensors.end() ? nullptr : &*found;
  }
  int number = 0;
  for (const BehaviourBlock& block : mission.behaviours) {
    if (block.name == edit.behaviour && ++number == edit.number) {
      return block.find(edit.setting);
    }
  }
  return nullptr;
}

std::string withValue(std::string_view text, support::SourceRange range, std::string_view value) {
  std::string out(text.substr(0, range.begin));
  out += value;
  out += text.substr(range.end);
  return out;
}

}  // namespace glider::slocum
