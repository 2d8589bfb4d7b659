// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/common_options.h"

#include "driver/terminal.h"
#include "driver/usage/values.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace glider::driver {
namespace {

const std::map<std::string, Colours> kColours = {
    {"auto", Colours::Auto}, {"always", Colours::Always}, {"never", Colours::Never}};

}  // namespace

void addCommonOptions(CLI::App& command) {
  const bool draws = command.get_option_no_throw("--colour-by") != nullptr;
  command
      .add_option_function<std::string>(
          "--color", [](const std::string& when) { setColours(kColours.at(when)); },
          "Colour of messages: auto (on a terminal, unless NO_COLOR is set), always or never "
          "[auto]")
      ->check(oneOf({"auto", "always", "never"},
                    draws ? "the colour of the track is `--colour-by`" : ""))
      ->option_text("WHEN");
  command.add_flag_callback(
      "-q,--quiet", [] { setQuiet(); },
      "Print no progress and no reports of success, only errors, warnings "
      "and what was asked for");
}

}  // namespace glider::driver
