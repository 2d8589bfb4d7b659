// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/vehicles_own.h"

#include "support/diagnostics/ids/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>

namespace glider::compiler {
namespace {

/// The ending in small letters: the vehicle's own files often have names in capitals.
std::string endingOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

support::Result<void> refuse(const std::filesystem::path& file, const char* what,
                             const std::string& hint) {
  return support::fail(support::diagnostics::notThisLanguage, file.string(), what, hint);
}

}  // namespace

MissionKind kindOf(const std::filesystem::path& file) {
  const std::string ending = endingOf(file);
  return ending == ".mi"     ? MissionKind::Vehicles
         : ending == ".ma"   ? MissionKind::Arguments
         : ending == ".toml" ? MissionKind::Fleet
                             : MissionKind::Language;
}

support::Result<void> requireKind(const std::filesystem::path& file, MissionKind needed) {
  const MissionKind kind = kindOf(file);
  if (kind == needed) {
    return {};
  }
  switch (kind) {
    case MissionKind::Arguments:
      return refuse(file, "an argument file of the vehicle's own missions, not a mission",
                    "`glidercc mi MISSION.mi` shows its values with the mission that reads it");
    case MissionKind::Vehicles:
      return refuse(file, "a mission of the vehicle's own, not one in the mission language",
                    fmt::format("`glidercc mi {0}` reads it, and `glidercc sim {0}` flies it",
                                file.string()));
    case MissionKind::Fleet:
      return refuse(
          file, "a fleet or another file of settings, not a mission",
          "`glidercc check`, `sim` and `campaign` take a fleet alone; elsewhere, name the "
          "mission of one of its vehicles");
    case MissionKind::Language:
      break;
  }
  return endingOf(file) == ".mission"
             ? refuse(file, "a mission in the mission language, not one of the vehicle's own",
                      fmt::format("`glidercc check {0}` checks it, and `glidercc sim {0}` flies it",
                                  file.string()))
             : support::Result<void>();
}

}  // namespace glider::compiler
