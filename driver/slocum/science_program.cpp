// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/slocum/science_program.h"

#include "platforms/load/dictionary.h"
#include "simulator/slocum/own_mission.h"
#include "simulator/slocum/science/science_program.h"
#include "support/diagnostics/ids/ports.h"

#include <sstream>
#include <vector>

namespace glider::driver {

support::Result<void> useScienceProgram(const std::string& command,
                                        const platforms::Platform& platform,
                                        simulator::Scenario& scenario) {
  std::vector<std::string> words;
  std::istringstream all(command);
  for (std::string word; all >> word;) {
    words.push_back(word);
  }
  if (words.empty()) {
    return support::fail(support::diagnostics::scienceProgramFails, command, "no program is named");
  }
  if (platform.family != "slocum" || simulator::slocumMissionOf(scenario).extctl) {
    return support::fail(support::diagnostics::scienceProgramFails, command,
                         "this vehicle has no hookprog");
  }
  const platforms::Dictionary dictionary(platform);
  if (auto tried = simulator::ScienceProgram::tryOut(words, dictionary.get()); !tried) {
    return tried;
  }
  simulator::slocumMissionOf(scenario).science_program = std::move(words);
  return {};
}

}  // namespace glider::driver
