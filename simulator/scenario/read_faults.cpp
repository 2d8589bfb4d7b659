// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/scenario/read_faults.h"

#include <cmath>

namespace glider::simulator {
namespace {

constexpr double kLongest = 1e7;  // s

/// from_s (which must be there) and to_s.
Span readSpan(Fields& f) {
  Span span;
  span.from_s = f.required("from_s", 0, kLongest);
  f.number("to_s", span.to_s, 0, kLongest);
  if (!f.reader().failure() && !(span.from_s < span.to_s)) {
    f.reader().refuse("to_s", "must be after `from_s`");
  }
  return span;
}

/// The directions that `line` names.
std::vector<LineWay> readWays(Fields& f) {
  const std::string line = f.reader().text("line");
  const std::pair<const char*, std::vector<LineWay>> names[] = {
      {"sbc", {LineWay::ToSbc, LineWay::FromSbc}},
      {"to_sbc", {LineWay::ToSbc}},
      {"from_sbc", {LineWay::FromSbc}},
      {"flight_science", {LineWay::ToFlight, LineWay::FromFlight}},
      {"to_flight", {LineWay::ToFlight}},
      {"from_flight", {LineWay::FromFlight}}};
  for (const auto& [name, ways] : names) {
    if (line == name) {
      return ways;
    }
  }
  f.reader().refuse(
      "line",
      "must be \"sbc\", \"to_sbc\", \"from_sbc\", \"flight_science\", \"to_flight\" or "
      "\"from_flight\"");
  return {};
}

void readLine(Fields& f, Faults& faults) {
  f.reader().only({"line", "from_s", "to_s", "cut", "loss", "flips", "bursts", "burst_bytes",
                   "delay_s", "doubled", "replayed", "heard_at_baud"});
  const std::vector<LineWay> ways = readWays(f);
  LineFault fault;
  fault.when = readSpan(f);
  fault.cut = f.reader().flagOr("cut", false);
  f.number("loss", fault.loss, 0, 1);
  f.number("flips", fault.flips, 0, 1);
  f.number("bursts", fault.bursts, 0, 1);
  f.number("burst_bytes", fault.burst_bytes, 1, 1e6);
  f.number("delay_s", fault.delay_s, 0, 3600);
  f.number("doubled", fault.doubled, 0, 1);
  f.number("replayed", fault.replayed, 0, 1);
  f.number("heard_at_baud", fault.heard_at_baud, 300, 921600);
  const bool nothing = !fault.cut && fault.loss == 0 && fault.flips == 0 && fault.bursts == 0 &&
                       fault.delay_s == 0 && fault.doubled == 0 && fault.replayed == 0 &&
                       fault.heard_at_baud == 0;
  if (nothing) {
    f.reader().refuse("line", "has no fault set");
  }
  for (const LineWay way : ways) {
    fault.way = way;
    faults.lines.push_back(fault);
  }
}

/// How a sensor can be wrong: the field that specifies it, with its bounds.
struct Wrong {
  const char* field;
  SensorFault::Kind kind;
  double lowest, highest;
};
constexpr double kMostWrong = 1e6;
constexpr Wrong kWrongByNumber[] = {
    {"drift_per_s", SensorFault::Kind::Drift, -kMostWrong, kMostWrong},
    {"scale", SensorFault::Kind::Scale, -kMostWrong, kMostWrong},
    {"offset", SensorFault::Kind::Offset, -kMostWrong, kMostWrong},
    {"jumps", SensorFault::Kind::Jumps, 0, kMostWrong},
    {"sways", SensorFault::Kind::Sways, 0, kMostWrong}};

void readSensor(Fields& f, Faults& faults) {
  f.reader().only({"sensor", "from_s", "to_s", "frozen", "missing", "value", "drift_per_s", "scale",
                   "offset", "jumps", "jumps_share", "sways", "period_s", "missing_share",
                   "value_share"});
  SensorFault fault;
  fault.name = f.reader().text("sensor");
  fault.when = readSpan(f);
  const bool frozen = f.reader().flagOr("frozen", false);
  const bool missing = f.reader().flagOr("missing", false);
  int kinds = frozen + missing + f.has("value");
  fault.kind = frozen    ? SensorFault::Kind::Frozen
               : missing ? SensorFault::Kind::Missing
                         : SensorFault::Kind::Value;
  fault.value = f.has("value") ? f.anyNumber("value") : 0;
  for (const Wrong& wrong : kWrongByNumber) {
    if (f.has(wrong.field)) {
      ++kinds;
      fault.kind = wrong.kind;
      fault.value = f.required(wrong.field, wrong.lowest, wrong.highest);
    }
  }
  if (kinds != 1) {
    f.reader().refuse("sensor",
                      "needs one of `frozen = true`, `missing = true`, `value`, `drift_per_s`, "
                      "`scale`, `offset`, `jumps` and `sways`");
  }
  f.number("period_s", fault.period_s, 1, kLongest);
  if (f.has("period_s") && !f.has("sways")) {
    f.reader().refuse("period_s", "needs `sways` as well");
  }
  f.number("jumps_share", fault.share, 0, 1);
  if (f.has("jumps_share") && !f.has("jumps")) {
    f.reader().refuse("jumps_share", "needs `jumps` as well");
  }
  f.number("missing_share", fault.share, 0, 1);
  if (f.has("missing_share") && !missing) {
    f.reader().refuse("missing_share", "needs `missing = true` as well");
  }
  f.number("value_share", fault.share, 0, 1);
  if (f.has("value_share") && !f.has("value")) {
    f.reader().refuse("value_share", "needs `value` as well");
  }
  faults.sensors.push_back(fault);
}

void readClock(Fields& f, Faults& faults) {
  f.reader().only({"at_s", "by_s"});
  ClockJump jump;
  jump.at_s = f.required("at_s", 0, kLongest);
  jump.by_s = f.required("by_s", -kLongest, kLongest);
  faults.clock.push_back(jump);
}

/// at_s (which must be there) and takes_s.
Span readRestart(Fields& f) {
  Span span;
  span.from_s = f.required("at_s", 0, kLongest);
  double takes_s = 60;
  f.number("takes_s", takes_s, 1, kLongest);
  span.to_s = span.from_s + takes_s;
  return span;
}

void readScience(Fields& f, Faults& faults) {
  f.reader().only({"at_s", "takes_s"});
  faults.science.push_back(readRestart(f));
}

void readFlight(Fields& f, Faults& faults) {
  f.reader().only({"at_s", "takes_s", "keeps_array"});
  FlightRestart restart;
  restart.when = readRestart(f);
  restart.keeps_array = f.reader().flagOr("keeps_array", false);
  faults.flight.push_back(restart);
}

void readCard(Fields& f, Faults& faults) {
  f.reader().only({"at_s", "flips", "cut", "zeroed"});
  CardFault fault;
  fault.at_s = f.required("at_s", 0, kLongest);
  if (f.has("flips") + f.has("cut") + f.has("zeroed") != 1) {
    f.reader().refuse("at_s", "needs one of `flips`, `cut` and `zeroed` as well");
  }
  constexpr double kMostFlips = 1e6;
  f.number("flips", fault.amount, 1, kMostFlips);
  f.number("cut", fault.amount, 0, 1);
  f.number("zeroed", fault.amount, 0, 1);
  fault.kind = f.has("flips") ? CardFault::Kind::Flips
               : f.has("cut") ? CardFault::Kind::Cut
                              : CardFault::Kind::Zeroed;
  faults.card.push_back(fault);
}

void readLeftover(Fields& f, Faults& faults) {
  f.reader().only({"session", "sequence", "depth_m"});
  constexpr double kMostSession = 16777215, kMostSequence = 65535, kDeepest = 10000;
  Leftover leftover;
  leftover.session = static_cast<uint32_t>(f.required("session", 1, kMostSession));
  leftover.sequence = static_cast<uint16_t>(f.required("sequence", 1, kMostSequence));
  f.number("depth_m", leftover.depth_m, 0, kDeepest);
  faults.leftover.push_back(leftover);
}

}  // namespace

void readFaults(ScenarioTables& tables, Scenario& scenario) {
  Faults& faults = scenario.faults;
  tables.table("faults", [](Fields& f) {
    f.reader().only({"line", "sensor", "power", "port", "stuck", "modem", "science", "console",
                     "clock", "abort", "card", "flight", "leftover"});
  });
  const auto spans = [&](const char* part, std::vector<Span>& list) {
    tables.each("faults", part, [&](Fields& f) {
      f.reader().only({"from_s", "to_s"});
      list.push_back(readSpan(f));
    });
  };
  tables.each("faults", "line", [&](Fields& f) { readLine(f, faults); });
  tables.each("faults", "sensor", [&](Fields& f) { readSensor(f, faults); });
  tables.each("faults", "science", [&](Fields& f) { readScience(f, faults); });
  tables.each("faults", "clock", [&](Fields& f) { readClock(f, faults); });
  tables.each("faults", "card", [&](Fields& f) { readCard(f, faults); });
  tables.each("faults", "flight", [&](Fields& f) { readFlight(f, faults); });
  tables.each("faults", "leftover", [&](Fields& f) { readLeftover(f, faults); });
  tables.each("faults", "abort", [&](Fields& f) {
    f.reader().only({"at_s"});
    faults.aborts.push_back(f.required("at_s", 0, kLongest));
  });
  spans("power", faults.power);
  spans("port", faults.port);
  spans("stuck", faults.stuck);
  spans("modem", faults.modem);
  spans("console", faults.console);
}

}  // namespace glider::simulator
