// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/against_json.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glider::report {
namespace {

using nlohmann::ordered_json;
using support::SourceManager;

/// Null for an unknown value.
ordered_json known(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

/// "2019-08-09T15:24:50Z".
std::string isoText(std::string utc) {
  if (const size_t space = utc.find(' '); space != std::string::npos) {
    utc[space] = 'T';
    utc += 'Z';
  }
  return utc;
}

ordered_json momentJson(const LoggedMoment& at) {
  return {{"time_s", known(at.time_s)},
          {"utc", isoText(at.utc)},
          {"hours", known(at.hours)},
          {"depth_m", known(at.depth_m)}};
}

ordered_json valuesJson(const std::vector<LoggedValue>& values) {
  ordered_json all = ordered_json::array();
  for (const LoggedValue& value : values) {
    const bool truth = value.unit == kTruthUnit && std::isfinite(value.value);
    all.push_back({{"name", value.name},
                   {"value", truth ? ordered_json(value.value != 0) : known(value.value)},
                   {"unit", value.unit}});
  }
  return all;
}

void addPlace(ordered_json& to, const SourceManager& sources, support::SourceRange range) {
  if (range.valid()) {
    to["file"] = sources.name(range.file);
    to["line"] = sources.place(range.file, range.begin).line;
  }
}

ordered_json firingJson(const LoggedFiring& firing) {
  ordered_json one = momentJson(firing.at);
  one["values"] = valuesJson(firing.values);
  return one;
}

ordered_json caseJson(const LoggedCase& of, const SourceManager& sources) {
  ordered_json one = {{"list", of.list}};
  if (!of.state.empty()) {
    one["state"] = of.state;
  }
  addPlace(one, sources, of.range);
  one["guard"] = of.guard;
  one["transition"] = of.transition;
  one["known_ticks"] = of.known_ticks;
  one["true_ticks"] = of.true_ticks;
  one["followed_true_ticks"] = of.followed_true_ticks;
  one["firings"] = ordered_json::array();
  for (const LoggedFiring& firing : of.firings) {
    one["firings"].push_back(firingJson(firing));
  }
  one["flickers"] = ordered_json::array();
  for (const Flicker& flicker : of.flickers) {
    one["flickers"].push_back({{"first_firing", flicker.first},
                               {"firings", flicker.count},
                               {"seconds", flicker.seconds}});
  }
  if (of.known_ticks == 0) {
    one["unknown_because"] = of.unknown_because;
  }
  return one;
}

ordered_json sensorJson(const LoggedSensor& of) {
  ordered_json one = {{"name", of.name},          {"vehicle_name", of.vehicle_name},
                      {"updates", of.updates},    {"known_ticks", of.known_ticks},
                      {"least", known(of.least)}, {"greatest", known(of.greatest)},
                      {"unit", of.unit}};
  if (!of.problem.empty()) {
    one["problem"] = of.problem;
  }
  return one;
}

ordered_json stepJson(const FollowedStep& step, const SourceManager& sources) {
  ordered_json one = momentJson(step.at);
  one["kind"] = wordOf(step.kind);
  one["from"] = step.from.empty() ? ordered_json(nullptr) : ordered_json(step.from);
  one["to"] = step.to.empty() ? ordered_json(nullptr) : ordered_json(step.to);
  if (step.range.valid()) {
    one["always"] = step.always;
    addPlace(one, sources, step.range);
    one["guard"] = step.guard;
  }
  one["values"] = valuesJson(step.values);
  if (!step.words.empty()) {
    one["how"] = step.words;
  }
  return one;
}

ordered_json vehicleJson(const AgainstLogs& against, const SourceManager& sources) {
  ordered_json one = {{"vehicle", against.vehicle},
                      {"files", against.files},
                      {"begin", momentJson(against.begin)},
                      {"end", momentJson(against.end)},
                      {"ticks", against.ticks},
                      {"ticks_of", against.science ? "science" : "flight"},
                      {"gaps", against.gaps},
                      {"longest_gap_s", against.longest_gap_s},
                      {"parameters", valuesJson(against.parameters)},
                      {"sensors", ordered_json::array()},
                      {"functions_not_called", against.without_code},
                      {"cases", ordered_json::array()},
                      {"followed", ordered_json::array()}};
  for (const LoggedSensor& sensor : against.sensors) {
    one["sensors"].push_back(sensorJson(sensor));
  }
  for (const LoggedCase& of : against.cases) {
    one["cases"].push_back(caseJson(of, sources));
  }
  for (const FollowedStep& step : against.followed) {
    one["followed"].push_back(stepJson(step, sources));
  }
  return one;
}

}  // namespace

ordered_json againstJson(const std::vector<AgainstLogs>& all, const SourceManager& sources) {
  ordered_json vehicles = ordered_json::array();
  for (const AgainstLogs& against : all) {
    vehicles.push_back(vehicleJson(against, sources));
  }
  return vehicles;
}

}  // namespace glider::report
