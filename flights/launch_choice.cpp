// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/launch_choice.h"

#include "codegen/codegen.h"
#include "compiler/boards.h"
#include "compiler/user_code.h"
#include "flights/parameter_table.h"
#include "frontend/bare_positions.h"
#include "ir/eval/interpreter.h"
#include "runtime/launch/dates.h"
#include "runtime/launch/launch.h"
#include "runtime/launch/quantity.h"
#include "support/diagnostics/ids/flights.h"
#include "support/files.h"

#include <fmt/format.h>

#include <map>
#include <sstream>
#include <string_view>

namespace glider::flights {

namespace {

/// The text of each parameter's value; the later of two settings applies.
using Given = std::map<std::string, std::string>;

std::string trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\r");
  return begin == std::string::npos
             ? ""
             : text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

void addSetting(const std::string& setting, Given& given) {
  const size_t equals = setting.find('=');
  if (equals != std::string::npos) {
    const std::string name = trimmed(setting.substr(0, equals));
    given[name] = trimmed(setting.substr(equals + 1));
    given.erase(name + ".latitude");  // of a position that is set as a whole
    given.erase(name + ".longitude");
  }
}

void addLines(const std::string& content, Given& given) {
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    addSetting(line.substr(0, line.find('#')), given);
  }
}

/// If a longitude and a latitude were given, without letters, where a latitude and a longitude are
/// expected: why that is refused. Otherwise empty. The language has the same rule.
std::string longitudeFirst(const ParameterTable& table, const double* values, const Given& given) {
  constexpr std::string_view kNorth = ".latitude";
  const auto isBare = [&](const std::string& name) {
    const auto found = given.find(name);
    return found != given.end() && found->second.find_first_of("NSEW") == std::string::npos;
  };
  for (uint32_t i = 0; i + 1 < table.mission().parameter_count; ++i) {
    const std::string north = table[i].name;
    const std::string east = table[i + 1].name;
    const std::string place = north.substr(0, north.rfind('.'));
    if (north == place + std::string(kNorth) && east == place + ".longitude" && isBare(north) &&
        isBare(east) && frontend::isLongitudeFirst(values[i], values[i + 1])) {
      return fmt::format(
          "`{}` looks like a longitude: the latitude comes first; if it is a latitude, give it a "
          "letter: `{} = {}`",
          given.at(north), north, frontend::withLetter(values[i], true));
    }
  }
  return "";
}

/// How to write the parameter that `problem` begins with; empty if it begins with none.
std::string hintFor(const ParameterTable& table, std::string_view problem) {
  std::string hint = "`glidercc params MISSION` lists the parameters";
  if (problem.find("has no parameter") != std::string_view::npos) {
    hint += "; what a line `choose` leaves open is chosen by `glidercc plan`";
  }
  for (uint32_t i = 0; i < table.mission().parameter_count; ++i) {
    const GliderParameterInfo& info = table[i];
    if (problem.find(fmt::format("`{}` cannot be", info.name)) == std::string_view::npos) {
      continue;
    }
    runtime::Units units(info.units);
    if (runtime::isOnEarth(info.units)) {
      hint += info.units[0] == 'N'
                  ? "; write it as `39.175 N`, as `39 10.5 N`, or in ddmm.mmmm, such as `3910.5`"
                  : "; write it as `73.83 W`, as `73 49.8 W`, or in ddmm.mmmm, such as `-7349.8`";
    } else if (runtime::isDate(info)) {
      hint += fmt::format("; write it as `{}=2027-03-01T00:00Z`, in UTC", info.name);
    } else if (units.next() && units.name().is("s")) {
      hint +=
          fmt::format("; a number alone is in seconds: write the unit, as in `{}=8h`", info.name);
    }
  }
  return hint;
}

}  // namespace

support::Result<std::vector<double>> chooseParameters(const ir::Mission& mission,
                                                      const LaunchChoice& choice) {
  const ParameterTable table(mission);
  runtime::Launch launch(table.mission());
  auto piece = [](const std::string& text) {
    return runtime::Piece{text.data(), text.data() + text.size()};
  };
  auto refused = [&] {
    auto failure = support::fail(support::diagnostics::badParameter, launch.problem());
    failure.error().hint = hintFor(table, launch.problem());
    return failure;
  };
  Given given;
  if (!choice.file.empty()) {
    const auto content = support::readFile(choice.file);
    if (!content) {
      return std::unexpected(content.error());
    }
    if (!launch.setAll(choice.file.c_str(), piece(*content))) {
      return refused();
    }
    addLines(*content, given);
  }
  for (const std::string& setting : choice.settings) {
    if (!launch.set(piece(setting))) {
      return refused();
    }
    addSetting(setting, given);
  }
  const std::vector<double> values(launch.values(),
                                   launch.values() + table.mission().parameter_count);
  if (const auto failed = ir::failedCondition(mission, values)) {
    launch.refuseWhere(*failed);
    return refused();
  }
  if (const std::string why = longitudeFirst(table, values.data(), given); !why.empty()) {
    return support::fail(support::diagnostics::badParameter, why);
  }
  return values;
}

support::Result<codegen::LoadedMission> loadHere(const compiler::Optimised& mission,
                                                 const std::vector<std::string>& user_code) {
  const auto host = compiler::loadTarget("host");
  if (!host) {
    return std::unexpected(host.error());
  }
  const auto code = compiler::loadUserCode(user_code, mission.mission, *host);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions options;
  options.debug = false;
  code->addTo(options);
  const auto object = codegen::linkShared(mission.input(), *host, options);
  if (!object) {
    return std::unexpected(object.error());
  }
  return codegen::LoadedMission::load(*object);
}

}  // namespace glider::flights
