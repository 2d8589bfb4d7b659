// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/dock_run.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace glider::slocum {

using vehicles::DockEnd;

bool DockRun::hearUntil(double until_s, const std::function<void(const std::string&)>& take) {
  return hearWhile(until_s, [] { return true; }, take);
}

bool DockRun::hearWhile(double until_s, const std::function<bool()>& wanted,
                        const std::function<void(const std::string&)>& take) {
  constexpr double kPause = 0.002;
  while (now() < until_s && wanted()) {
    for (const std::string& body : line_.hear()) {
      take(body);
    }
    if (end() != DockEnd::Complete) {
      return false;
    }
    host_.sleep(kPause);
  }
  return true;
}

DockEnd DockRun::end() const {
  return line_.gone() ? DockEnd::LineGone : host_.stop() ? DockEnd::Interrupted : DockEnd::Complete;
}

std::string nameOf(const std::string& body) {
  return body.substr(0, std::min(body.find(','), body.size()));
}

bool isOfVehicle(const std::string& name) {
  constexpr std::array<std::string_view, 8> kNames = {"HI",   "BY", "SD",  "FI",
                                                      "NEXT", "TT", "DIR", "ER"};
  return std::ranges::find(kNames, name) != kNames.end();
}

bool isOfSbc(const std::string& name) {
  constexpr std::array<std::string_view, 7> kNames = {"SW", "MD", "TXT", "FR", "FW", "LS", "GO"};
  return std::ranges::find(kNames, name) != kNames.end();
}

}  // namespace glider::slocum
