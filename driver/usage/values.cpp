// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/usage/values.h"

#include "compiler/boards.h"
#include "flights/scenario_choice.h"
#include "frontend/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace glider::driver {
namespace {

/// What stands between the braces that oneOf puts into the type name of its option.
std::vector<std::string> choicesOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const size_t begin = type.find('{');
  const size_t end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) {
    return {};
  }
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

/// The choice that `word` most likely means: one that it begins with, as `temperature` with `temp`,
/// or that begins with it, or else that is spelled nearly like it; empty if there is none.
std::string_view nearest(const std::string& word, const std::vector<std::string>& choices) {
  constexpr size_t kLetters = 3;
  for (const std::string& choice : choices) {
    const bool long_enough = std::min(word.size(), choice.size()) >= kLetters;
    if (long_enough && (word.starts_with(choice) || choice.starts_with(word))) {
      return choice;
    }
  }
  return frontend::closest(word, std::vector<std::string_view>(choices.begin(), choices.end()));
}

const std::vector<std::string> kMissionSuffixes = {".mission", ".ir"};

}  // namespace

CLI::Validator oneOf(std::vector<std::string> choices, std::string otherwise) {
  const std::string list = fmt::format("{{{}}}", fmt::join(choices, ","));
  return {[choices = std::move(choices),
           otherwise = std::move(otherwise)](const std::string& text) -> std::string {
            if (std::ranges::find(choices, text) != choices.end()) {
              return "";
            }
            const std::string_view near = nearest(text, choices);
            const std::string more =
                near.empty() ? otherwise : fmt::format("did you mean `{}`?", near);
            return fmt::format("`{}` is not one of {}{}{}", text, fmt::join(choices, ", "),
                               more.empty() ? "" : "; ", more);
          },
          list, "choice"};
}

std::string valueWord(const CLI::Option& option) {
  const std::string& shown = option.get_option_text();
  const std::string type = option.get_type_name();
  const std::string& word = !shown.empty()           ? shown
                            : option.nonpositional() ? type
                                                     : option.get_name(true, false);
  return word.substr(0, word.find_first_of(" :="));
}

ValueKind kindOf(const CLI::Option& option) {
  ValueKind kind;
  kind.choices = choicesOf(option);
  if (!kind.choices.empty()) {
    return kind;
  }
  const std::string word = valueWord(option);
  const size_t dot = word.find('.');
  if (word == "SCENARIO") {
    kind.choices = flights::scenarioNames();
    kind.suffixes = {".toml"};
    kind.file = true;
  } else if (word == "TARGET") {
    kind.choices = compiler::targetNames();
  } else if (word == "FOLDER") {
    kind.folder = true;
  } else if (word == "MISSION" || word == "OLD" || word == "NEW") {
    kind.suffixes = kMissionSuffixes;
    kind.file = true;
  } else if (dot != std::string::npos) {
    kind.suffixes = {word.substr(dot)};
    kind.file = true;
  } else if (word == "FILE" || word == "FILES" || word == "LOG" || word == "PROGRAM" ||
             word == "DEVICE" || word == "OUT") {
    kind.file = true;
  }
  return kind;
}

std::string unnamedChoices(const CLI::Option& option) {
  const std::vector<std::string> choices = kindOf(option).choices;
  const std::string& description = option.get_description();
  const bool named = std::ranges::all_of(choices, [&](const std::string& choice) {
    return description.find(choice) != std::string::npos;
  });
  return named ? "" : fmt::to_string(fmt::join(choices, ", "));
}

}  // namespace glider::driver
