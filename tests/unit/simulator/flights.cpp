// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/simulator/flights.h"

#include "platforms/load/load_platform.h"
#include "simulator/slocum/flight/skeleton.h"
#include "simulator/slocum/own_mission.h"
#include "support/diagnostics/render.h"
#include "vehicles/slocum/mission_files/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace glider::simulator {
namespace {

const std::filesystem::path kSource = GLIDER_SOURCE_DIR;

template <typename T>
T must(support::Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::abort();
  }
  return std::move(*result);
}

}  // namespace

SimulationSetup shippedSetup(const std::string& name) {
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  SimulationSetup setup;
  setup.platform = must(platforms::loadPlatform(kSource / "platforms/slocum.toml"));
  setup.scenario = must(
      loadScenario(kSource / "scenarios" / (name + ".toml"), setup.platform, sources, diagnostics));
  return setup;
}

SimulationSetup setupWith(const std::string& mission) {
  SimulationSetup setup = shippedSetup("layered");
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const uint32_t file = sources.add("test.mi", mission);
  auto read = slocum::readMission(sources, file, diagnostics);
  if (read) {
    checkSkeleton(*read, {file, 0, 0}, diagnostics);
  }
  if (diagnostics.hasErrors()) {
    std::fprintf(stderr, "%s\n", support::render(diagnostics, sources, false).c_str());
    std::abort();
  }
  missionFileOf(setup.scenario) = std::move(*read);
  return setup;
}

support::Trace fly(SimulationSetup setup) {
  return must(simulate(std::move(setup)));
}

const support::TraceEvent* findEvent(const support::Trace& trace, support::EventId id) {
  const auto found = std::ranges::find(trace.events, id, &support::TraceEvent::id);
  return found == trace.events.end() ? nullptr : &*found;
}

const support::TraceEvent* findEvent(const support::Trace& trace, const std::string& text) {
  for (const support::TraceEvent& event : trace.events) {
    if (textOf(event).find(text) != std::string::npos) {
      return &event;
    }
  }
  return nullptr;
}

const support::TraceEvent* findStart(const support::Trace& trace, const std::string& name) {
  for (const support::TraceEvent& event : trace.events) {
    if (event.id == support::EventId::BehaviourStarts &&
        std::get<std::string>(event.values[0]).starts_with(name + "_")) {
      return &event;
    }
  }
  return nullptr;
}

std::string eventText(const support::Trace& trace) {
  std::string out;
  for (const support::TraceEvent& e : trace.events) {
    out += fmt::format("{:8.2f} {:8.2f} {:10} {} | {}\n", e.time_s, e.mission_time_s, kindOf(e),
                       textOf(e), e.why);
  }
  return out;
}

double valueAt(const support::Trace& trace, const char* column, double time_s) {
  double value = 0;
  for (size_t row = 0; row < trace.rowCount() && trace.at(row, 0) <= time_s; ++row) {
    value = trace.at(row, trace.column(column));
  }
  return value;
}

}  // namespace glider::simulator
