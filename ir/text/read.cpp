// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/read.h"

#include "hooks/protocol/sampling.h"
#include "ir/core/mission_writer.h"
#include "ir/core/validate.h"
#include "ir/text/code_reader.h"
#include "ir/text/cursor.h"
#include "ir/text/names.h"
#include "ir/text/table_reader.h"
#include "support/diagnostics/ids/ir_text.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace glider::ir {
namespace {

using support::SourceRange;
using text::Token;
using text::TokenKind;

class Reader {
 public:
  Reader(std::string_view text, uint32_t file, support::DiagnosticEngine& diagnostics)
      : in_(text, file, diagnostics) {}

  std::optional<Mission> run() {
    header();
    while (!in_.failed() && in_.peek().kind != TokenKind::End) {
      item();
    }
    code_.findTargets(states_);
    if (!in_.failed()) {
      for (const Defect& defect : validate(m_)) {
        in_.fail(support::diagnostics::irInvalid, defect.range, defect.message);
      }
    }
    return in_.failed() ? std::nullopt : std::optional(std::move(m_));
  }

 private:
  void header() {
    in_.expect("glider_ir");
    const Token version = in_.take();
    if (version.text != "1") {
      in_.fail(support::diagnostics::irVersion, version.range, describe(version));
    }
    in_.expect("mission");
    m_.name = in_.name("the mission's name");
    in_.expect("platform");
    m_.platform = in_.name("the platform's name");
  }

  void item() {
    if (in_.accept("sensor")) {
      sensor();
    } else if (in_.accept("behaviour")) {
      behaviour();
    } else if (in_.accept("variable")) {
      variable();
    } else if (in_.accept("function")) {
      function();
    } else if (in_.accept("use")) {
      m_.uses.push_back({{functions_.find(in_.nameToken("the name of a function"))}, {}});
    } else if (in_.accept("table")) {
      table();
    } else if (in_.peek().isWord("share")) {
      share();
    } else if (in_.accept("utc")) {
      m_.utc = sensorName();
    } else if (in_.accept("vehicle")) {
      m_.vehicles.push_back(in_.name("the name of a vehicle"));
    } else if (in_.accept("always")) {
      always();
    } else if (in_.accept("state")) {
      state();
    } else if (in_.accept("every")) {
      in_.expect("tick");
      code_.entry(m_.every_tick);
    } else if (in_.accept("monitor")) {
      monitor();
    } else if (in_.peek().isWord("require")) {
      requirement();
    } else if (in_.peek().isWord("assume")) {
      assumption();
    } else if (in_.accept("resume")) {
      resumption();
    } else if (in_.accept("nap")) {
      m_.nap_s = in_.number(false);
    } else if (in_.accept("compass")) {
      compass();
    } else if (in_.accept("pack")) {
      pack();
    } else if (!code_.definition()) {
      in_.failExpecting(
          "`sensor`, `behaviour`, `variable`, `table`, `function`, `use`, `share`, `utc`, "
          "`vehicle`, `let`, `always`, `state`, `every`, `require`, `assume`, `resume`, "
          "`nap`, `compass` or `pack`");
    }
  }

  void compass() {
    Compass read;
    if (in_.accept("variation")) {
      read.variation = sensorName();
    }
    if (in_.accept("declination")) {
      read.declination = in_.number(false);
    }
    m_.compass = read;
  }

  void pack() {
    Pack read;
    read.capacity_C = in_.number(false);
    in_.expect("at");
    read.voltage_V = in_.number(false);
    in_.expect("reserve");
    read.reserve = in_.number(false);
    m_.pack = read;
  }

  void share() {
    const SourceRange begin = in_.expect("share");
    Share s;
    s.name = in_.name("the name of the share");
    in_.expect("of");
    if (in_.accept("sensor")) {
      s.sensor = sensorName();
    } else {
      in_.expect("variable");
      s.variable = code_.variableName();
    }
    while (in_.accept("received")) {
      const SensorId sensor = sensorName();
      if (in_.accept("from")) {
        s.named.push_back({static_cast<uint32_t>(in_.integer(0, UINT32_MAX)), sensor});
      } else {
        s.peer = sensor;
      }
    }
    in_.expect("lowest");
    s.lowest = in_.number(false);
    in_.expect("step");
    s.step = in_.number(false);
    in_.expect("values");
    s.values = static_cast<uint32_t>(in_.integer(0, UINT32_MAX));
    in_.expect("every");
    s.period_s = in_.number(false);
    s.range = in_.since(begin);
    m_.shares.push_back(std::move(s));
  }

  void resumption() {
    if (in_.accept("never")) {
      in_.expect("after");
      in_.expect("restart");
      m_.new_after_restart = true;
    } else {
      in_.expect("within");
      m_.resume_within_s = in_.number(false);
    }
  }

  void requirement() {
    const SourceRange begin = in_.expect("require");
    const size_t number = m_.requirements.size();
    Requirement r;
    m_.requirements.push_back(r);
    if (in_.accept("always")) {
      r.kind = RequirementKind::Always;
      r.condition = code_.expression();
      r.monitor = std::exchange(monitor_, {});
      geofences(r);
    } else if (in_.accept("exit")) {
      r.kind = RequirementKind::ExitWithin;
      in_.expect("within");
      r.seconds = in_.number(false);
    } else if (in_.accept("stack")) {
      r.kind = RequirementKind::StackAtMost;
      r.depth = static_cast<uint32_t>(in_.integer(0, UINT32_MAX));
    } else if (in_.accept("reach")) {
      r.kind = RequirementKind::Reach;
      code_.stateName([this, number](StateId id) { m_.requirements[number].state = id; });
    } else if (in_.accept("never")) {
      r.kind = RequirementKind::NeverAfter;
      code_.stateName([this, number](StateId id) { m_.requirements[number].state = id; });
      in_.expect("after");
      code_.stateName([this, number](StateId id) { m_.requirements[number].after = id; });
    } else {
      r.kind = RequirementKind::SurfacesEvery;
      in_.expect("surfaces");
      in_.expect("every");
      r.seconds = in_.number(false);
    }
    r.range = in_.since(begin);
    m_.requirements[number] = r;
  }

  void assumption() {
    const SourceRange begin = in_.expect("assume");
    Assumption a;
    a.words = in_.name("the words of the assumption");
    if (in_.accept("start")) {
      a.kind = in_.accept("depth") ? AssumptionKind::StartDepth : AssumptionKind::StartInside;
      a.kind == AssumptionKind::StartDepth ? void(a.limit = in_.number(false))
                                           : void(a.area = geofence());
    } else if (in_.accept("current")) {
      a.kind = AssumptionKind::Current;
      a.limit = in_.number(false);
    } else if (in_.accept("outage")) {
      a.kind = AssumptionKind::Outage;
      a.limit = in_.number(false);
    } else if (in_.accept("range")) {
      a.kind = AssumptionKind::Range;
      a.sensor = sensorName();
      a.lowest = in_.number(false);
      a.highest = in_.number(false);
    } else {
      in_.expect("always");
    }
    a.range = in_.since(begin);
    a.watch.range = a.range;
    if (a.isWatched()) {
      a.watch.condition = code_.expression();
      a.watch.monitor = std::exchange(monitor_, {});
    }
    m_.assumptions.push_back(std::move(a));
  }

  /// What precedes a `require always` or an `assume`: its monitor.
  void monitor() {
    if (in_.accept("of")) {
      in_.expect("every");
      in_.expect("tick");
      monitor_.every_tick = true;
    }
    in_.expect("horizon");
    monitor_.horizon_s = in_.number(false);
    const size_t requirement = m_.requirements.size();
    while (in_.accept("observe")) {
      observation(requirement);
    }
    in_.expect("step");
    code_.entry(monitor_.step);
    while (true) {
      if (code_.definition()) {
        continue;
      }
      if (!in_.accept("violation")) {
        break;
      }
      Violation read;
      read.words = in_.name("the words of a violation");
      if (in_.accept("since")) {
        read.since = code_.variableName();
        read.cause = in_.name("what a violation is due to");
      }
      read.condition = code_.expression();
      monitor_.violations.push_back(std::move(read));
    }
    if (!in_.peek().isWord("require") && !in_.peek().isWord("assume")) {
      in_.failExpecting("`violation`, `require` or `assume`");
    }
  }

  void observation(size_t requirement) {
    Observation o;
    o.variable = code_.variableName();
    if (in_.accept("ended")) {
      monitor_.observations.push_back(o);
      return;
    }
    o.kind = in_.accept("entered") ? ObservationKind::Entered : ObservationKind::Inside;
    if (o.kind == ObservationKind::Inside) {
      in_.expect("inside");
    }
    const size_t number = monitor_.observations.size();
    code_.stateName([this, requirement, number](StateId id) {
      if (requirement < m_.requirements.size() &&
          number < m_.requirements[requirement].monitor.observations.size()) {
        m_.requirements[requirement].monitor.observations[number].state = id;
      }
    });
    monitor_.observations.push_back(o);
  }

  void geofences(Requirement& r) {
    while (true) {
      if (in_.peek().isWord("inside") || in_.peek().isWord("outside")) {
        r.geofences.push_back(geofence());
      } else if (in_.peek().isWord("closer") || in_.peek().isWord("farther")) {
        r.geofences.push_back(disc());
      } else {
        return;
      }
    }
  }

  Geofence disc() {
    Geofence disc;
    disc.keep_in = in_.accept("closer");
    if (!disc.keep_in) {
      in_.expect("farther");
    }
    disc.radius_m = in_.number(false);
    corners(disc);
    return disc;
  }

  Geofence geofence() {
    Geofence fence;
    fence.keep_in = in_.accept("inside");
    if (!fence.keep_in) {
      in_.expect("outside");
    }
    corners(fence);
    return fence;
  }

  void corners(Geofence& fence) {
    in_.expect('(');
    do {
      Position corner;
      corner.latitude = in_.number(false);
      in_.expect(',');
      corner.longitude = in_.number(false);
      fence.corners.push_back(corner);
    } while (in_.accept(','));
    in_.expect(')');
  }

  void sensor() {
    const Token name = in_.nameToken("the sensor's name");
    sensors_.define(name, m_.sensors.size());
    Sensor s;
    s.name = name.text;
    in_.expect(':');
    s.type = in_.type();
    if (in_.accept("symbol")) {
      s.symbol = in_.name("the sensor's symbol");
    } else if (!in_.accept("received")) {
      in_.expect("vehicle");
      s.vehicle_name = in_.name("the vehicle's name of the sensor");
    }
    in_.expect("id");
    s.id = static_cast<uint16_t>(in_.integer(0, UINT16_MAX));
    in_.expect("encoding");
    s.encoding = in_.accept("degrees_minutes") ? Encoding::DegreesMinutes
                 : in_.accept("magnetic")      ? Encoding::Magnetic
                                               : Encoding::Linear;
    if (s.encoding == Encoding::Linear) {
      in_.expect("linear");
    }
    in_.expect("to_si");
    s.to_si = in_.number(false);
    in_.expect("lowest");
    s.lowest = in_.number(true);
    in_.expect("highest");
    s.highest = in_.number(true);
    in_.expect("stale_after");
    s.stale_after_s = in_.number(true);
    m_.sensors.push_back(std::move(s));
  }

  SensorId sensorName() { return {sensors_.find(in_.nameToken("the name of a sensor"))}; }

  void behaviour() {
    Behaviour b;
    const bool profile = in_.accept("profile");
    if (!profile) {
      in_.expect("route");
    }
    b.kind = profile ? BehaviourKind::Profile : BehaviourKind::Route;
    const Token name = in_.nameToken("the behaviour's name");
    (profile ? profiles_ : routes_).define(name, m_.behaviours.size());
    b.name = name.text;
    in_.expect("symbol");
    b.symbol = in_.name("the behaviour's symbol");
    code_.list([&] { b.parameters.push_back(parameter()); });
    in_.expect("reads");
    code_.list([&] { b.reads.push_back(sensorName()); });
    m_.behaviours.push_back(std::move(b));
  }

  void variable() {
    constexpr std::string_view kKinds[] = {"parameter", "mission", "argument", "state",
                                           "profile",   "route",   "monitor",  "momentary"};
    const Token name = in_.nameToken("the variable's name");
    const size_t number = m_.variables.size();
    variables_.define(name, number);
    Variable v;
    v.name = name.text;
    v.range = name.range;
    in_.expect(':');
    v.type = in_.typeOrBool();
    const auto* kind =
        std::ranges::find_if(kKinds, [&](std::string_view word) { return in_.accept(word); });
    if (kind == std::end(kKinds)) {
      in_.failExpecting(
          "`parameter`, `mission`, `argument`, `state`, `profile`, `route`, `monitor` or "
          "`momentary`");
      return;
    }
    v.kind = static_cast<VariableKind>(kind - std::begin(kKinds));
    if (in_.accept("of")) {
      code_.stateName([this, number](StateId id) { m_.variables[number].owner = id; });
    }
    if (in_.accept("lowest")) {
      v.lowest = in_.number(true);
      in_.expect("highest");
      v.highest = in_.number(true);
    }
    if (in_.accept("unit")) {
      v.unit = in_.name("the unit of the parameter");
    }
    MissionWriter(m_).add(std::move(v));
  }

  Parameter parameter() {
    Parameter p;
    p.name = in_.name("a parameter's name");
    in_.expect(':');
    p.type = in_.typeOrBool();
    return p;
  }

  void function() {
    Function f;
    const Token name = in_.nameToken("the function's name");
    functions_.define(name, m_.functions.size());
    f.name = name.text;
    in_.expect("symbol");
    f.symbol = in_.name("the function's symbol");
    code_.list([&] { f.parameters.push_back(parameter()); });
    in_.expect(':');
    f.result = in_.typeOrBool();
    in_.expect("lowest");
    f.lowest = in_.number(true);
    in_.expect("highest");
    f.highest = in_.number(true);
    m_.functions.push_back(std::move(f));
  }

  void table() {
    Table t;
    t.type = in_.type();
    code_.list([&] { t.values.push_back(in_.number(false)); });
    m_.tables.push_back(std::move(t));
  }

  void always() {
    while (!in_.failed()) {
      const SourceRange begin = in_.peek().range;
      if (in_.accept("case")) {
        code_.caseInto([this]() -> std::vector<Case>& { return m_.always; }, begin);
      } else if (in_.accept("table")) {
        m_.always_table = text::readTable(in_, sensors_);
      } else if (!code_.definition()) {
        return;
      }
    }
  }

  void state() {
    const Token name = in_.nameToken("the state's name");
    const size_t number = m_.states.size();
    states_.define(name, number);
    m_.states.push_back({});
    State& s = m_.states.back();
    s.name = name.text;
    s.range = name.range;
    if (in_.peek().isMark('(')) {
      code_.list([&] { s.parameters.push_back(code_.variableName()); });
    }
    while (!in_.failed()) {
      const SourceRange begin = in_.peek().range;
      if (in_.accept("route")) {
        activity(s.route, number, routes_, "route", begin);
      } else if (in_.accept("profile")) {
        activity(s.profile, number, profiles_, "profile", begin);
      } else if (in_.accept("log")) {
        log(s);
      } else if (in_.accept("sample")) {
        sampling(s);
      } else if (in_.accept("entry")) {
        code_.entry(s.entry);
      } else if (in_.accept("case")) {
        code_.caseInto([this, number]() -> std::vector<Case>& { return m_.states[number].cases; },
                       begin);
      } else if (in_.accept("table")) {
        m_.states[number].table = text::readTable(in_, sensors_);
      } else if (!code_.definition()) {
        return;
      }
    }
  }

  /// A use of a behaviour by state `state`: arguments, or a body.
  void activity(Activity& a, size_t state, text::Names& names, std::string_view what,
                SourceRange begin) {
    const Token name = in_.nameToken("the behaviour's name");
    if (a.behaviour.valid()) {
      in_.fail(support::diagnostics::irDefinedTwice, begin, what, name.text);
    }
    a.behaviour = {names.find(name)};
    if (in_.peek().isMark('(')) {
      a.arguments = code_.expressionList();
    } else {
      body(a, [this, state, what]() -> std::vector<Case>& {
        State& s = m_.states[state];
        return (what == "route" ? s.route : s.profile).cases;
      });
    }
    a.range = in_.since(begin);
  }

  template <typename Cases>
  void body(Activity& a, Cases cases) {
    if (in_.accept("done")) {
      a.done = code_.variableName();
    }
    in_.expect("begin");
    while (!in_.failed() && !in_.accept("end")) {
      const SourceRange begin = in_.peek().range;
      if (in_.accept("entry")) {
        code_.entry(a.entry);
      } else if (in_.accept("case")) {
        code_.caseInto(cases, begin);
      } else if (!code_.definition()) {
        in_.failExpecting("`entry`, `case` or `end`");
      }
    }
  }

  void log(State& s) {
    LogItem item;
    item.name = in_.name("the name of a log item");
    in_.expect("every");
    item.period_s = in_.number(false);
    item.value = code_.expression();
    s.log.push_back(std::move(item));
  }

  void sampling(State& s) {
    Sampling one;
    one.instrument = in_.name("the name of an instrument");
    one.words = in_.name("how often it reads");
    one.place = static_cast<uint32_t>(in_.integer(0, kHookMostInstruments - 1));
    one.code = code_.expression();
    if (in_.accept("period")) {
      one.period = code_.expression();
    }
    s.sampling.push_back(std::move(one));
  }

  text::Cursor in_;
  Mission m_;
  text::Names sensors_{in_, "sensor"};
  text::Names profiles_{in_, "profile"};
  text::Names routes_{in_, "route"};
  text::Names states_{in_, "state"};
  Monitor monitor_;  ///< of the next requirement
  text::Names variables_{in_, "variable"};
  text::Names functions_{in_, "function"};
  text::CodeReader code_{in_, m_, sensors_, variables_};
};

}  // namespace

std::optional<Mission> read(const support::SourceManager& sources, uint32_t file,
                            support::DiagnosticEngine& diagnostics) {
  return Reader(sources.text(file), file, diagnostics).run();
}

}  // namespace glider::ir
