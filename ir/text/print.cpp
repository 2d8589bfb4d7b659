// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/print.h"

#include "ir/core/ops.h"
#include "ir/core/type_name.h"
#include "ir/core/validate.h"
#include "ir/text/printer.h"
#include "support/check.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace glider::ir {
namespace text {

std::string nameText(std::string_view name) {
  auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  auto part = [&](char c) { return letter(c) || (c >= '0' && c <= '9'); };
  if (!name.empty() && letter(name.front()) && std::ranges::all_of(name, part)) {
    return std::string(name);
  }
  std::string out = "\"";
  for (char c : name) {
    if (c == '"' || c == '\\' || c < 0x20 || c > 0x7e) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string Printer::run() {
  add("glider_ir 1\nmission {} platform {}\n", nameText(m_.name), nameText(m_.platform));
  if (m_.resume_within_s != kResumeWithin_s) {
    line("resume within {}", m_.resume_within_s);
  }
  if (m_.new_after_restart) {
    line("resume never after restart");
  }
  if (m_.nap_s) {
    line("nap {}", *m_.nap_s);
  }
  std::ranges::for_each(m_.sensors, [&](const Sensor& s) { sensor(s); });
  compass();
  if (m_.pack) {
    add("\npack {} at {} reserve {}", m_.pack->capacity_C, m_.pack->voltage_V, m_.pack->reserve);
  }
  std::ranges::for_each(m_.behaviours, [&](const Behaviour& b) { behaviour(b); });
  std::ranges::for_each(m_.variables, [&](const Variable& v) { variable(v); });
  std::ranges::for_each(m_.tables, [&](const Table& t) { table(t); });
  std::ranges::for_each(m_.functions, [&](const Function& f) { function(f); });
  std::ranges::for_each(
      m_.uses, [&](const FunctionUse& use) { add("\nuse {}", nameText(m_[use.function].name)); });
  shares();
  launch();
  if (!m_.always.empty()) {
    add("\n");
    line("always");
    ++indent_;
    cases(m_.always);
    table(m_.always_table);
    --indent_;
  }
  std::ranges::for_each(m_.states, [&](const State& s) { state(s); });
  if (m_.every_tick.valid()) {
    add("\n");
    defineBlocks(m_.every_tick);
    line("every tick ");
    useBlock(m_.every_tick, "do");
  }
  std::ranges::for_each(m_.requirements, [&](const Requirement& r) { requirement(r); });
  std::ranges::for_each(m_.assumptions, [&](const Assumption& a) { assumption(a); });
  while (defineNext(UINT32_MAX)) {
  }
  defineUpTo(static_cast<uint32_t>(m_.exprs.size()));
  return std::move(out_);
}

void Printer::compass() {
  if (!m_.compass) {
    return;
  }
  add("\ncompass");
  if (m_.compass->variation.valid()) {
    add(" variation {}", nameText(m_[m_.compass->variation].name));
  }
  if (m_.compass->declination) {
    add(" declination {}", *m_.compass->declination);
  }
}

void Printer::sensor(const Sensor& s) {
  constexpr std::string_view kEncodings[] = {"linear", "degrees_minutes", "magnetic"};
  const std::string whose = s.isHeard()        ? "received"
                            : s.symbol.empty() ? "vehicle " + nameText(s.vehicle_name)
                                               : "symbol " + nameText(s.symbol);
  add("\nsensor {}: {} {} id {} encoding {} to_si {} lowest {} highest {} stale_after {}",
      nameText(s.name), typeText(s.type), whose, s.id, kEncodings[static_cast<size_t>(s.encoding)],
      s.to_si, s.lowest, s.highest, s.stale_after_s);
}

void Printer::shares() {
  if (m_.utc.valid()) {
    add("\nutc {}", nameText(m_[m_.utc].name));
  }
  for (const std::string& vehicle : m_.vehicles) {
    add("\nvehicle {}", nameText(vehicle));
  }
  for (const Share& s : m_.shares) {
    add("\nshare {} of ", nameText(s.name));
    s.sensor.valid() ? add("sensor {}", nameText(m_[s.sensor].name))
                     : add("variable {}", nameText(m_[s.variable].name));
    if (s.peer.valid()) {
      add(" received {}", nameText(m_[s.peer].name));
    }
    for (const FromVehicle& from : s.named) {
      add(" received {} from {}", nameText(m_[from.sensor].name), from.address);
    }
    add(" lowest {} step {} values {} every {}", s.lowest, s.step, s.values, s.period_s);
  }
}

void Printer::behaviour(const Behaviour& b) {
  add("\nbehaviour {} {} symbol {} (", b.kind == BehaviourKind::Profile ? "profile" : "route",
      nameText(b.name), nameText(b.symbol));
  for (size_t i = 0; i < b.parameters.size(); ++i) {
    const Parameter& p = b.parameters[i];
    add("{}{}: {}", i == 0 ? "" : ", ", nameText(p.name), typeText(p.type));
  }
  add(") reads (");
  for (size_t i = 0; i < b.reads.size(); ++i) {
    add("{}{}", i == 0 ? "" : ", ", nameText(m_[b.reads[i]].name));
  }
  add(")");
}

void Printer::variable(const Variable& v) {
  constexpr std::string_view kKinds[] = {"parameter", "mission", "argument", "state",
                                         "profile",   "route",   "monitor",  "momentary"};
  add("\nvariable {}: {} {}", nameText(v.name), typeText(v.type),
      kKinds[static_cast<size_t>(v.kind)]);
  if (v.owner.valid()) {
    add(" of {}", nameText(m_[v.owner].name));
  }
  if (v.lowest != -Variable::kEndless || v.highest != Variable::kEndless) {
    add(" lowest {} highest {}", v.lowest, v.highest);
  }
  if (!v.unit.empty()) {
    add(" unit {}", nameText(v.unit));
  }
}

void Printer::table(const Table& t) {
  add("\ntable {} ({})", typeText(t.type), fmt::join(t.values, ", "));
}

void Printer::function(const Function& f) {
  add("\nfunction {} symbol {} (", nameText(f.name), nameText(f.symbol));
  for (size_t i = 0; i < f.parameters.size(); ++i) {
    const Parameter& p = f.parameters[i];
    add("{}{}: {}", i == 0 ? "" : ", ", nameText(p.name), typeText(p.type));
  }
  add("): {} lowest {} highest {}", typeText(f.result), f.lowest, f.highest);
}

/// Writes the conditions and values that precede all states, if they come first among the
/// expressions.
void Printer::launch() {
  uint32_t end = 0;
  for (const Variable& v : m_.variables) {
    end = v.owner.valid() ? end : std::max(end, v.initial.index + 1);
  }
  for (ExprId id : m_.conditions) {
    end = std::max(end, id.index + 1);
  }
  while (defineNext(end)) {
  }
}

void Printer::state(const State& s) {
  add("\n");
  line("state {}", nameText(s.name));
  if (!s.parameters.empty()) {
    auto name = [&](VariableId id) { return nameText(m_[id].name); };
    std::vector<std::string> names;
    std::ranges::transform(s.parameters, std::back_inserter(names), name);
    add(" ({})", fmt::join(names, ", "));
  }
  ++indent_;
  initials();
  activity("route", s.route);
  activity("profile", s.profile);
  for (const LogItem& item : s.log) {
    prepare({&item.value, 1});
    line("log {} every {} ", nameText(item.name), item.period_s);
    use(item.value);
  }
  for (const Sampling& one : s.sampling) {
    const std::array<ExprId, 2> both{one.code, one.period};
    prepare({both.data(), one.period.valid() ? 2U : 1U});
    line("sample {} {} {} ", nameText(one.instrument), nameText(one.words), one.place);
    use(one.code);
    if (one.period.valid()) {
      add(" period ");
      use(one.period);
    }
  }
  entry(s.entry);
  cases(s.cases);
  table(s.table);
  --indent_;
}

void Printer::requirement(const Requirement& r) {
  switch (r.kind) {
    case RequirementKind::Always:
      monitor(r.monitor);
      prepare({&r.condition, 1});
      line("require always ");
      use(r.condition);
      std::ranges::for_each(r.geofences, [&](const Geofence& f) { geofence(f); });
      return;
    case RequirementKind::ExitWithin:
      return line("require exit within {}", r.seconds);
    case RequirementKind::StackAtMost:
      return line("require stack {}", r.depth);
    case RequirementKind::Reach:
      return line("require reach {}", nameText(m_[r.state].name));
    case RequirementKind::NeverAfter:
      return line("require never {} after {}", nameText(m_[r.state].name),
                  nameText(m_[r.after].name));
    case RequirementKind::SurfacesEvery:
      return line("require surfaces every {}", r.seconds);
  }
}

void Printer::assumption(const Assumption& a) {
  if (a.isWatched()) {
    monitor(a.watch.monitor);
    prepare({&a.watch.condition, 1});
  }
  line("assume {} ", nameText(a.words));
  switch (a.kind) {
    case AssumptionKind::StartDepth:
      return add("start depth {}", a.limit);
    case AssumptionKind::StartInside:
      add("start");
      return geofence(a.area);
    case AssumptionKind::Current:
      return add("current {}", a.limit);
    case AssumptionKind::Outage:
      add("outage {} ", a.limit);
      break;
    case AssumptionKind::Range:
      add("range {} {} {} ", nameText(m_[a.sensor].name), a.lowest, a.highest);
      break;
    case AssumptionKind::Always:
      add("always ");
      break;
  }
  use(a.watch.condition);
}

void Printer::monitor(const Monitor& monitor) {
  constexpr std::string_view kKinds[] = {"entered", "inside", "ended"};
  if (!monitor.step.valid()) {
    return;
  }
  defineBlocks(monitor.step);
  line("monitor {}horizon {}", monitor.every_tick ? "of every tick " : "", monitor.horizon_s);
  ++indent_;
  for (const Observation& o : monitor.observations) {
    line("observe {} {}", nameText(m_[o.variable].name), kKinds[static_cast<size_t>(o.kind)]);
    if (o.state.valid()) {
      add(" {}", nameText(m_[o.state].name));
    }
  }
  line("step ");
  useBlock(monitor.step, "do");
  for (const Violation& violation : monitor.violations) {
    prepare({&violation.condition, 1});
    line("violation {} ", nameText(violation.words));
    if (violation.since.valid()) {
      add("since {} {} ", nameText(m_[violation.since].name), nameText(violation.cause));
    }
    use(violation.condition);
  }
  --indent_;
}

void Printer::geofence(const Geofence& fence) {
  if (fence.isDisc()) {
    add(" {} {}", fence.keep_in ? "closer" : "farther", fence.radius_m);
  } else {
    add(" {}", fence.keep_in ? "inside" : "outside");
  }
  add(" (");
  for (size_t i = 0; i < fence.corners.size(); ++i) {
    add("{}{}, {}", i == 0 ? "" : ", ", fence.corners[i].latitude, fence.corners[i].longitude);
  }
  add(")");
}

void Printer::table(const GuardTable& table) {
  if (table.empty()) {
    return;
  }
  auto listed = [this](const auto& elements, auto text) {
    std::vector<std::string> texts;
    std::ranges::transform(elements, std::back_inserter(texts), text);
    add("({})", fmt::join(texts, ", "));
  };
  line("table");
  ++indent_;
  for (const GuardColumn& column : table.columns) {
    const std::string_view op = opInfo(column.source).text;
    column.sensor.valid() ? line("column {} {} ", op, nameText(m_[column.sensor].name))
                          : line("column {} ", op);
    listed(column.cuts, [](const Cut& cut) {
      return fmt::format("{} {}", cut.inclusive ? "ge" : "gt", cut.at);
    });
  }
  for (const GuardRow& row : table.rows) {
    line("row {} ", row.number);
    listed(row.within, [](const GuardRow::Range& range) {
      return fmt::format("{} {}", range.first, range.last);
    });
    add("{}", row.exact ? " exact" : "");
  }
  --indent_;
  line("end");
}

/// Writes the initial values that come next among the expressions.
void Printer::initials() {
  while (next_initial_ < m_.variables.size()) {
    const ExprId id = m_.variables[next_initial_].initial;
    if (id.valid() && layout_.first[id.index] != next_) {
      return;
    }
    defineNext(id.valid() ? id.index + 1 : 0);
  }
}

void Printer::activity(std::string_view what, const Activity& a) {
  const Behaviour& b = m_[a.behaviour];
  if (!b.symbol.empty()) {
    prepare(a.arguments);
    line("{} {} ", what, nameText(b.name));
    list(a.arguments);
    return;
  }
  line("{} {} ", what, nameText(b.name));
  if (a.done.valid()) {
    add("done {} ", nameText(m_[a.done].name));
  }
  add("begin");
  ++indent_;
  entry(a.entry);
  cases(a.cases);
  --indent_;
  line("end");
}

}  // namespace text

std::string typeText(Type type) {
  const auto name = typeName(type);
  return name ? *name : fmt::format("dim({})", fmt::join(type.dimension.exponents, ","));
}

std::string print(const Mission& mission) {
  CHECK(validate(mission).empty(), "a mission that does not hold together");
  return text::Printer(mission).run() + "\n";
}

}  // namespace glider::ir
