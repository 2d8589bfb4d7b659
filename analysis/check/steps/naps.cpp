// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"
#include "ir/naps/wake.h"
#include "support/listed.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

namespace glider::analysis::check {
namespace {

/// What wakes the SBC in a state.
struct Causes {
  std::set<std::string> sensors;
  bool time = false;
};

// NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
void collect(const ir::Mission& mission, const ir::Wake& wake, Causes& causes) {
  causes.time |= wake.kind == ir::WakeKind::Until;
  if (wake.sensor.valid()) {
    causes.sensors.insert(fmt::format("`{}`", mission[wake.sensor].name));
  }
  for (const ir::Wake& part : wake.parts) {
    collect(mission, part, causes);
  }
}

/// What keeps it awake, as the mission writes it.
std::string reasonOf(const Run& run, support::SourceRange range) {
  const support::SourceManager& sources = run.checked().sources();
  if (!range.valid()) {
    return "";
  }
  constexpr size_t kLongest = 60;
  std::string text = support::onOneLine(sources.text(range));
  text = text.size() > kLongest ? text.substr(0, kLongest) + " …" : text;
  return fmt::format(": what follows from `{}` ({}:{}) cannot be foreseen", text,
                     sources.name(range.file), sources.place(range.file, range.begin).line);
}

std::string lineOf(const Run& run, ir::StateId id) {
  const ir::Mission& mission = run.mission();
  const ir::Wake wake = ir::wakeOf(mission, id);
  if (const ir::Wake* awake = ir::whatKeepsAwake(mission, wake)) {
    return fmt::format("in `{}` the SBC stays awake{}", mission[id].name,
                       reasonOf(run, awake->range));
  }
  Causes causes;
  collect(mission, wake, causes);
  std::vector<std::string> wakers(causes.sensors.begin(), causes.sensors.end());
  if (causes.time) {
    wakers.emplace_back("time");
  }
  return fmt::format("in `{}` the SBC may sleep{}{}", mission[id].name,
                     wakers.empty() ? "" : " until woken by ", support::listed(wakers));
}

}  // namespace

/// In which states the SBC may sleep, of a mission that says that it may.
support::Result<void> naps(Run& run) {
  if (run.mission().nap_s) {
    for (uint32_t i = 0; i < run.mission().states.size(); ++i) {
      run.remark(lineOf(run, ir::StateId{i}));
    }
  }
  return {};
}

}  // namespace glider::analysis::check
