// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/plan/problems.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::tests {
namespace {

using Values = std::vector<double>;

bool all(const Values&) {
  return true;
}

Values none(const Values&) {
  return {};
}

std::string state(const std::string& name, const std::string& profile, const std::string& cases) {
  return "state " + name + "\nbegin\n  flightroute heading(90 deg)\n  flightprofile " + profile +
         "\n  sensors missiontime, statetime, depth, temp, charge, battery\n  events\n" + cases +
         "end\n";
}

/// As long as the batteries allow, then as deep as possible.
Problem afternoon() {
  return {
      "afternoon",
      {{"bottom", "length", "m", 20, 100, 40}, {"hours", "time", "h", 2, 14, 2}},
      "prefer greatest hours then greatest bottom",
      "pack 100 Ah at 14.4 V\nrequire always energyused <= 110 Wh\n" +
          state("fly", "yo(5 m, bottom, 26 deg, 26 deg)", "    case missiontime > hours exit\n"),
      all,
      [](const Values& v) { return Values{-v[1], -v[0]}; }};
}

/// Nothing but the energy: of the dives and of the climbs.
Problem angles() {
  return {"angles", {{"dive", "angle", "deg", 15, 35, 5}, {"climb", "angle", "deg", 15, 35, 5}},
          "",       state("fly", "yo(5 m, 45 m, dive, climb)", "    case missiontime > 8 h exit\n"),
          all,      none};
}

/// As seldom at the surface as a promise allows.
Problem surfacing() {
  return {"surfacing",
          {{"period", "time", "min", 120, 240, 30}},
          "prefer greatest period",
          "require surfaces every 4 h\n" +
              state("fly", "yo(5 m, 45 m)", "    case statetime > period call report\n") +
              state("report", "surfaced", "    case statetime > 20 min return\n"),
          all,
          [](const Values& v) { return Values{-v[0]}; }};
}

/// Two legs whose times add up.
Problem legs() {
  return {"legs",
          {{"out", "time", "h", 1, 8, 1}, {"back", "time", "h", 1, 8, 1, "back > 1.2 * out"}},
          "prefer greatest out then least back then endurance",
          "require exit within 10 h\n" +
              state("leave", "yo(5 m, 40 m)", "    case statetime > out goto home\n") +
              state("home", "yo(5 m, 20 m)", "    case statetime > back exit\n"),
          [](const Values& v) { return v[1] > 1.2 * v[0]; },
          [](const Values& v) { return Values{-v[0], v[1]}; }};
}

/// A band of water whose middle and thickness are open.
Problem band() {
  return {"band",
          {{"middle", "length", "m", 20, 60, 10},
           {"thick", "length", "m", 10, 60, 10, "middle - thick / 2 >= 5 m"}},
          "prefer greatest (thick * middle) then least middle",
          "require after missiontime > 1 h: never depth >= 80 m\n" +
              state("fly", "yo(middle - thick / 2, middle + thick / 2)",
                    "    case missiontime > 6 h exit\n"),
          [](const Values& v) { return v[0] - v[1] / 2 >= 5; },
          [](const Values& v) { return Values{-v[0] * v[1], v[0]}; }};
}

/// There and back, but not too often.
Problem rounds() {
  return {"rounds",
          {{"out", "time", "min", 20, 80, 60}, {"up_there", "time", "min", 5, 20, 15}},
          "prefer least out then least up_there",
          "require visit up at most 5 times\n" +
              state("fly", "yo(5 m, 40 m)",
                    "    case missiontime > 5 h exit\n    case statetime > out goto up\n") +
              state("up", "yo(4 m, 10 m)", "    case statetime > up_there goto fly\n"),
          all,
          [](const Values& v) { return Values{v[0], v[1]}; }};
}

/// How low the batteries may be, and how soon the mission may turn: a promise about the voltage.
Problem reserve() {
  return {"reserve",
          {{"least_V", "voltage", "V", 10.4, 12.4, 1}, {"wait", "time", "min", 0, 4, 4}},
          "prefer least least_V then greatest wait",
          "require after missiontime > 0 s: whenever battery < 11.2 V then home within 5 min or "
          "exit\n" +
              state("fly", "yo(5 m, 40 m)",
                    "    case statetime > wait && battery < least_V goto home\n"
                    "    case missiontime > 12 h exit\n") +
              state("home", "yo(5 m, 15 m)", "    case missiontime > 24 h exit\n"),
          all,
          [](const Values& v) { return Values{v[0], -v[1]}; }};
}

/// A mission without an end, so the power counts: how long to talk, how deep to go.
Problem endless() {
  return {
      "endless",
      {{"talk", "time", "min", 5, 25, 10}, {"bottom", "length", "m", 20, 80, 30}},
      "prefer endurance",
      state("fly", "yo(5 m, bottom, 26 deg, 26 deg)", "    case statetime > 2 h call report\n") +
          state("report", "surfaced", "    case statetime > talk return\n"),
      all,
      none};
}

/// How often to visit before going home.
Problem visits() {
  return {
      "visits",
      {{"times", "number", "", 1, 4, 1}, {"each", "time", "min", 40, 120, 40}},
      "prefer greatest times then greatest each",
      "require exit within 4 h\nvar done_times: number = 0 in 0 .. 10\n" +
          state("look", "yo(5 m, 40 m)",
                "    case statetime > each && done_times + 1 >= times exit\n"
                "    case statetime > each do set done_times = min(done_times + 1, 10) end goto "
                "look\n"),
      all,
      [](const Values& v) { return Values{-v[0], -v[1]}; }};
}

/// A steep dive is short, a shallow one goes far.
Problem slope() {
  return {"slope",
          {{"slant", "angle", "deg", 15, 35, 2.5}, {"bottom", "length", "m", 30, 90, 30}},
          "prefer least (bottom / sqrt(1 - (slant / 1 rad) * (slant / 1 rad))) then endurance",
          "pack 100 Ah at 14.4 V\nrequire always energyused <= 75 Wh\n" +
              state("fly", "yo(5 m, bottom, slant, slant)", "    case missiontime > 5 h exit\n"),
          all,
          [](const Values& v) {
            const double slant = v[0] * std::acos(-1.0) / 180;
            return Values{v[1] / std::sqrt(1 - slant * slant)};
          }};
}

/// UNDERSEA's problem: three sensors of different rates, reliabilities and joules for a
/// measurement, and the speed. Every 10 m need at least 20 good measurements for at most 120 J;
/// least of all is preferred what the measurements and the time take together.
constexpr double kRate[] = {5, 4, 4}, kGood[] = {0.97, 0.83, 0.88}, kJoules[] = {3, 2.4, 2.1};

double perTen(const Values& v, const double (&of)[3], bool good) {
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    sum += v[i] * kRate[i] * 10 / v[3] * of[i] * (good ? kGood[i] : 1);
  }
  return sum;
}

Problem undersea() {
  constexpr double kOne[] = {1, 1, 1};
  return {"undersea",
          {{"first", "number", "", 0, 1, 1},
           {"second", "number", "", 0, 1, 1},
           {"third", "number", "", 0, 1, 1},
           {"fast", "number", "", 0.25, 5, 0.25, "good >= 20 && joules <= 120"}},
          "prefer least (joules + 8 / fast)",
          "const good = (first * 5 * 0.97 + second * 4 * 0.83 + third * 4 * 0.88) * 10 / fast\n"
          "const joules = (first * 5 * 3 + second * 4 * 2.4 + third * 4 * 2.1) * 10 / fast\n" +
              state("fly", "yo(5 m, 30 m)", "    case missiontime > 1 h exit\n"),
          [=](const Values& v) {
            return perTen(v, kOne, true) >= 20 && perTen(v, kJoules, false) <= 120;
          },
          [](const Values& v) { return Values{perTen(v, kJoules, false) + 8 / v[3]}; }};
}

}  // namespace

std::vector<Problem> planProblems() {
  return {afternoon(), angles(),  surfacing(), legs(),  band(),    rounds(),
          reserve(),   endless(), visits(),    slope(), undersea()};
}

std::string valueText(const OpenValue& open, double value) {
  return fmt::format("{:.10g}{}{}", value, open.unit.empty() ? "" : " ", open.unit);
}

std::string openText(const Problem& problem) {
  std::string text = "mission " + problem.name + "\n";
  for (const OpenValue& one : problem.open) {
    text += fmt::format("choose {}: {} in {} .. {} by {}{}\n", one.name, one.type,
                        valueText(one, one.lowest), valueText(one, one.highest),
                        valueText(one, one.step), one.where.empty() ? "" : " where " + one.where);
  }
  return text + problem.prefer + "\n" + problem.rest;
}

}  // namespace glider::tests
