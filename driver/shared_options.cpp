// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/shared_options.h"

#include "driver/usage/quantity.h"
#include "driver/usage/values.h"
#include "ir/prove/prove.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace glider::driver {
namespace {

std::string checkSeed(const std::string& text) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = error == std::errc() && end == text.data() + text.size();
  return good ? "" : fmt::format("`{}` is not a whole number from 0 to 2^64-1", text);
}

}  // namespace

void addLaunchOptions(CLI::App& command, flights::LaunchChoice& choice) {
  command
      .add_option("--set", choice.settings,
                  "Set a parameter of the mission, as in --set bottom=20m; may be repeated")
      ->option_text("NAME=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command
      .add_option("--parameters", choice.file,
                  "Read parameters from a file with lines `NAME = VALUE`; --set takes precedence")
      ->option_text("FILE");
}

void addProofOptions(CLI::App& command, unsigned& effort, std::optional<double>& timeout_s) {
  constexpr double kShortestTimeout_s = 0.001, kLongestTimeout_s = 1e6;
  command
      .add_option("--effort", effort,
                  "Multiply the resource limits of proofs by N: 1 million steps of Z3 a question, "
                  "40 million all requirements of a mission [1]")
      ->check(CLI::Range(1U, ir::prove::kMostRaised))
      ->option_text("N");
  addDurationOption(command, "--timeout", timeout_s, kShortestTimeout_s, kLongestTimeout_s,
                    "Begin no question of a proof later than this after the first, as in 5s or "
                    "2min; what is left is undecided [no limit]");
}

void addLinkOption(CLI::App& command, std::vector<std::string>& files) {
  command
      .add_option("--link", files,
                  "Link an object file, archive or LLVM bitcode that defines the mission's "
                  "`extern` declarations; may be repeated")
      ->option_text("FILE")
      ->take_all()
      ->allow_extra_args(false);
}

std::vector<std::string> trackColours() {
  std::vector<std::string> names = {"state"};
  for (const report::TrackQuantity& quantity : report::pictureQuantities()) {
    if (std::ranges::find(names, quantity.name) == names.end()) {
      names.emplace_back(quantity.name);
    }
  }
  return names;
}

CLI::Option* addPictureOptions(CLI::App& command, std::string& file, report::PictureStyle& style) {
  auto* picture = command.add_option("--picture", file,
                                     "Also draw the flight as an SVG, for a paper or a logbook");
  picture->option_text("FILE.svg");
  addColourOption(command, style, picture,
                  "Quantity that colours the track [chlorophyll if measured, else temp]");
  return picture;
}

void addColourOption(CLI::App& command, report::PictureStyle& style, CLI::Option* picture,
                     const std::string& description) {
  command.add_option("--colour-by", style.colour, description)
      ->check(oneOf(trackColours()))
      ->option_text("QUANTITY")
      ->needs(picture);
  command.add_option("--colour", style.colour)
      ->check(oneOf(trackColours(), "the colour of messages is `--color`"))
      ->needs(picture)
      ->group("");
}

void acceptNoCache(CLI::App& command) {
  command.add_flag("--no-cache")->group("");
}

CLI::Validator seedValidator() {
  return CLI::Validator(checkSeed, "", "seed");
}

}  // namespace glider::driver
