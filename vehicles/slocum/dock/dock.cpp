// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/dock.h"

#include "vehicles/slocum/dock/findings.h"
#include "vehicles/slocum/dock/parts.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace glider::slocum {
namespace {

using vehicles::DockEnd;
using vehicles::DockPart;

/// Listens. A vehicle reports by itself; a program on the SBC only answers, so it is silent.
DockPart findPart(DockRun& run, std::vector<std::string>& heard) {
  bool vehicle = false;
  const double listen_s = run.setup().times.listen_s;
  run.host().progress(fmt::format("listening for {:.0f} s", listen_s));
  run.hearWhile(
      run.now() + listen_s, [&] { return !vehicle; },
      [&](const std::string& body) {
        heard.push_back(body);
        vehicle = vehicle || isOfVehicle(nameOf(body));
      });
  return vehicle ? DockPart::Sbc : DockPart::Vehicle;
}

}  // namespace

vehicles::DockResult checkAtDock(const DockSetup& setup, const vehicles::DockHost& host) {
  vehicles::DockResult result;
  DockRun run(setup, host);
  const auto errors = host.errors();
  result.checks = {listFinding(setup), baudFinding(setup, host.baud)};
  const bool told = setup.part != DockPart::Auto;
  std::vector<std::string> heard;
  const DockPart part = told ? setup.part : findPart(run, heard);
  if (part == DockPart::Sbc) {
    playSbc(run, heard, result);
  } else {
    playVehicle(run, told, result);
  }
  result.end = run.end();
  const auto errors_now = host.errors();
  if (errors && errors_now) {
    result.checks.push_back(deviceFinding(*errors, *errors_now));
  }
  if (result.end == DockEnd::LineGone) {
    result.checks.push_back(goneFinding(run.now()));
  }
  result.seconds = run.now();
  return result;
}

}  // namespace glider::slocum
