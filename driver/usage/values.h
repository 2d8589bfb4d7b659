// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

// What the value of an option can be. Its check, --help and the completion of shells use it.

namespace glider::driver {

/// For an option whose value is one of `choices`; the error names the nearest, or else says
/// `otherwise`, such as the name of an option that is easily taken for this one.
CLI::Validator oneOf(std::vector<std::string> choices, std::string otherwise = "");

/// What can stand for the value of an option, or for a positional argument.
struct ValueKind {
  std::vector<std::string> choices;   ///< the words, of which some may be file names too
  std::vector<std::string> suffixes;  ///< of the files that are meant; empty: of any
  bool file = false;
  bool folder = false;
};

/// The kind of `option`, by the word that --help shows for its value: MISSION, SCENARIO, TARGET,
/// FOLDER, FILE, FILE.mi; and by its choices.
ValueKind kindOf(const CLI::Option& option);

/// The word that --help shows for the value of `option`, such as FILE.
std::string valueWord(const CLI::Option& option);

/// "text, json": the choices of `option` that its description does not name; empty if it names
/// all.
std::string unnamedChoices(const CLI::Option& option);

}  // namespace glider::driver
