// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/launch_choice.h"

#include "codegen/codegen.h"
#include "driver/boards.h"
#include "driver/link_option.h"
#include "runtime/launch/launch.h"
#include "support/files.h"

#include <CLI/CLI.hpp>

namespace glider::driver {

using support::DiagnosticId;

void addLaunchOptions(CLI::App& command, LaunchChoice& choice) {
  command
      .add_option(
          "--set", choice.settings,
          "Give a parameter of the mission a value, as in --set bottom=20m; may be repeated")
      ->option_text("NAME=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command
      .add_option("--parameters", choice.file,
                  "Take parameters from a file with lines `NAME = VALUE`; --set goes before it")
      ->option_text("FILE");
}

support::Result<std::vector<double>> chooseParameters(const GliderMission& mission,
                                                      const LaunchChoice& choice) {
  runtime::Launch launch(mission);
  auto piece = [](const std::string& text) {
    return runtime::Piece{text.data(), text.data() + text.size()};
  };
  auto refused = [&] { return support::fail(DiagnosticId::badParameter, launch.problem()); };
  if (!choice.file.empty()) {
    const auto content = support::readFile(choice.file);
    if (!content) {
      return std::unexpected(content.error());
    }
    if (!launch.setAll(choice.file.c_str(), piece(*content))) {
      return refused();
    }
  }
  for (const std::string& setting : choice.settings) {
    if (!launch.set(piece(setting))) {
      return refused();
    }
  }
  if (!launch.check()) {
    return refused();
  }
  return std::vector<double>(launch.values(), launch.values() + mission.parameter_count);
}

namespace {

support::Result<codegen::LoadedMission> load(const Compilation& compilation,
                                             const platforms::Board& host,
                                             const support::Result<codegen::UserCode>& user_code) {
  if (!user_code) {
    return std::unexpected(user_code.error());
  }
  codegen::CodegenOptions options;
  options.debug = false;
  user_code->addTo(options);
  const auto object = codegen::linkShared(*compilation.mission, compilation.facts, host, options);
  if (!object) {
    return std::unexpected(object.error());
  }
  return codegen::LoadedMission::load(*object);
}

}  // namespace

support::Result<codegen::LoadedMission> loadHere(const Compilation& compilation,
                                                 const std::vector<std::string>& user_code) {
  const auto host = loadTarget("host");
  if (!host) {
    return std::unexpected(host.error());
  }
  return load(compilation, *host, loadUserCode(user_code, compilation, *host));
}

support::Result<codegen::LoadedMission> loadForParameters(const Compilation& compilation) {
  const auto host = loadTarget("host");
  if (!host) {
    return std::unexpected(host.error());
  }
  return load(compilation, *host, codegen::UserCode::standIn(*compilation.mission, *host));
}

}  // namespace glider::driver
