// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/fleet/fleet_talk.h"

#include "ir/core/share_messages.h"
#include "platforms/load/modem.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace glider::driver {
namespace {

using support::Result;

bool isSame(const ir::Mission& first, const ir::Share& one, const ir::Mission& second,
            const ir::Share& other) {
  return ir::typeOf(first, one) == ir::typeOf(second, other) && one.name == other.name &&
         one.lowest == other.lowest && one.step == other.step && one.values == other.values &&
         one.period_s == other.period_s;
}

/// The first share that two missions do not have alike; empty: they have the same.
std::string firstDifference(const ir::Mission& one, const ir::Mission& other) {
  const size_t common = std::min(one.shares.size(), other.shares.size());
  for (size_t i = 0; i < common; ++i) {
    if (!isSame(one, one.shares[i], other, other.shares[i])) {
      return one.shares[i].name;
    }
  }
  return one.shares.size() > common     ? one.shares[common].name
         : other.shares.size() > common ? other.shares[common].name
                                        : "";
}

Result<void> refuse(const flights::Fleet& fleet, const std::string& what, const std::string& hint) {
  return support::fail(support::diagnostics::fleetCannotTalk, fleet.file.string(), what, hint);
}

Result<void> checkAlike(const flights::Fleet& fleet, const Talking& first, const Talking& other) {
  const std::string differs = firstDifference(*first.mission, *other.mission);
  if (!differs.empty()) {
    return refuse(fleet,
                  fmt::format("`{}` and `{}` do not share `{}` alike, and do not understand each "
                              "other",
                              first.vehicle->name, other.vehicle->name, differs),
                  "give all missions of a fleet the same `share` lines");
  }
  const double one_s = slotOf(*first.platform), other_s = slotOf(*other.platform);
  if (one_s != other_s) {
    return refuse(fleet,
                  fmt::format("the slots of `{}` are {:g} s long, those of `{}` {:g} s, and would "
                              "overlap",
                              first.vehicle->name, one_s, other.vehicle->name, other_s),
                  "give both platform files the same `[modem]`");
  }
  return {};
}

/// Whether a vehicle has the address by which the line `vehicles` of a mission knows it.
Result<void> checkAddress(const flights::Fleet& fleet, const Talking& vehicle,
                          const std::vector<std::string>& names) {
  const std::string& name = vehicle.vehicle->name;
  const uint32_t address = vehicle.vehicle->address;
  if (address <= names.size() && names[address - 1] == name) {
    return {};
  }
  const auto place = std::ranges::find(names, name);
  return refuse(fleet,
                fmt::format("`{}` has address {}, but the line `vehicles` has {}", name, address,
                            address <= names.size() ? fmt::format("`{}` there", names[address - 1])
                                                    : fmt::format("only {} names", names.size())),
                place != names.end()
                    ? fmt::format("give it `address = {}`, the place of its name in that line",
                                  place - names.begin() + 1)
                    : "give the vehicles of the fleet file the names of that line");
}

/// The names that missions give the vehicles are those of the fleet file.
Result<void> checkNames(const flights::Fleet& fleet, const std::vector<Talking>& vehicles) {
  const Talking* first = nullptr;
  for (const Talking& vehicle : vehicles) {
    if (vehicle.mission->vehicles.empty()) {
      continue;
    }
    first = first == nullptr ? &vehicle : first;
    if (first->mission->vehicles != vehicle.mission->vehicles) {
      return refuse(fleet,
                    fmt::format("`{}` and `{}` do not have the same line `vehicles`",
                                first->vehicle->name, vehicle.vehicle->name),
                    "give all missions of a fleet the same line `vehicles`, or none");
    }
  }
  // One that shares without that line is received by its address too.
  for (const Talking& vehicle : vehicles) {
    if (first == nullptr || vehicle.mission->shares.empty()) {
      continue;
    }
    if (auto right = checkAddress(fleet, vehicle, first->mission->vehicles); !right) {
      return right;
    }
  }
  return {};
}

Result<void> checkTurns(const flights::Fleet& fleet, const Talking& first) {
  const uint32_t slots = flights::slotsOf(fleet);
  if (slots > flights::kMostAddress) {
    return refuse(fleet,
                  fmt::format("it has {} vehicles, but its modems have only {} addresses", slots,
                              flights::kMostAddress),
                  "share nothing in the missions, or divide the fleet");
  }
  const ir::Share& shortest = first.mission->shares.front();
  const double round_s = slots * slotOf(*first.platform);
  if (shortest.period_s < round_s) {
    return refuse(fleet,
                  fmt::format("`{}` is shared every {:g} s, but a round of {} slots takes {:g} s",
                              shortest.name, shortest.period_s, slots, round_s),
                  fmt::format("share it every {:g} s or less often", round_s));
  }
  return {};
}

}  // namespace

double slotOf(const platforms::Platform& platform) {
  return platform.modem ? platforms::slotOf(*platform.modem, platform.envelope.cycle_s) : 0;
}

Result<void> checkTalk(const flights::Fleet& fleet, const std::vector<Talking>& vehicles) {
  const Talking* first = nullptr;
  for (const Talking& vehicle : vehicles) {
    if (vehicle.mission->shares.empty()) {
      continue;
    }
    first = first == nullptr ? &vehicle : first;
    if (auto alike = checkAlike(fleet, *first, vehicle); !alike) {
      return alike;
    }
  }
  if (auto named = checkNames(fleet, vehicles); !named) {
    return named;
  }
  return first != nullptr ? checkTurns(fleet, *first) : Result<void>{};
}

}  // namespace glider::driver
