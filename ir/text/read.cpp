// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/read.h"

#include "ir/core/validate.h"
#include "ir/text/cursor.h"
#include "ir/text/expression_reader.h"
#include "ir/text/names.h"

#include <utility>

namespace glider::ir {
namespace {

using support::DiagnosticId;
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
    targets();
    if (!in_.failed()) {
      for (const Defect& defect : validate(m_)) {
        in_.fail(DiagnosticId::irInvalid, defect.range, defect.message);
      }
    }
    return in_.failed() ? std::nullopt : std::optional(std::move(m_));
  }

 private:
  struct Target {
    StateId state;
    size_t case_index;
    Token name;
  };

  void header() {
    in_.expect("glider_ir");
    const Token version = in_.take();
    if (version.text != "1") {
      in_.fail(DiagnosticId::irVersion, version.range, describe(version));
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
    } else if (in_.accept("let")) {
      expressions_.let();
    } else if (in_.accept("state")) {
      state();
    } else {
      in_.failExpecting("`sensor`, `behaviour`, `let` or `state`");
    }
  }

  void sensor() {
    const Token name = in_.nameToken("the sensor's name");
    sensors_.define(name, m_.sensors.size());
    Sensor s;
    s.name = name.text;
    in_.expect(':');
    s.type = in_.type();
    in_.expect("vehicle");
    s.vehicle_name = in_.name("the vehicle's name of the sensor");
    in_.expect("id");
    s.id = static_cast<uint16_t>(in_.integer(0, UINT16_MAX));
    in_.expect("encoding");
    s.encoding = in_.accept("degrees_minutes") ? Encoding::DegreesMinutes : Encoding::Linear;
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
    list([&] {
      Parameter p;
      p.name = in_.name("a parameter's name");
      in_.expect(':');
      p.type = in_.type();
      b.parameters.push_back(std::move(p));
    });
    in_.expect("reads");
    list([&] { b.reads.push_back(sensorName()); });
    m_.behaviours.push_back(std::move(b));
  }

  /// `(`, what `element` reads any number of times with commas between, `)`.
  template <typename Element>
  void list(Element element) {
    in_.expect('(');
    if (in_.accept(')')) {
      return;
    }
    do {
      element();
    } while (in_.accept(','));
    in_.expect(')');
  }

  void state() {
    const Token name = in_.nameToken("the state's name");
    const StateId id{static_cast<uint32_t>(m_.states.size())};
    states_.define(name, id.index);
    m_.states.push_back({});
    State& s = m_.states.back();
    s.name = name.text;
    s.range = name.range;
    while (true) {
      const SourceRange begin = in_.peek().range;
      if (in_.accept("route")) {
        activity(s.route, routes_, "route", begin);
      } else if (in_.accept("profile")) {
        activity(s.profile, profiles_, "profile", begin);
      } else if (in_.accept("log")) {
        log(s);
      } else if (in_.accept("case")) {
        stateCase(id, s, begin);
      } else if (in_.accept("let")) {
        expressions_.let();
      } else {
        return;
      }
    }
  }

  void activity(Activity& a, text::Names& names, std::string_view what, SourceRange begin) {
    const Token name = in_.nameToken("the behaviour's name");
    if (a.behaviour.valid()) {
      in_.fail(DiagnosticId::irDefinedTwice, begin, what, name.text);
    }
    a.behaviour = {names.find(name)};
    list([&] { a.arguments.push_back(expressions_.expression()); });
    a.range = in_.since(begin);
  }

  void log(State& s) {
    LogItem item;
    item.name = in_.name("the name of a log item");
    in_.expect("every");
    item.period_s = in_.number(false);
    item.value = expressions_.expression();
    s.log.push_back(std::move(item));
  }

  void stateCase(StateId id, State& s, SourceRange begin) {
    Case c;
    c.guard = expressions_.expression();
    if (in_.accept("goto")) {
      c.transition = Transition::Goto;
    } else if (in_.accept("call")) {
      c.transition = Transition::Call;
    } else if (in_.accept("return")) {
      c.transition = Transition::Return;
    } else if (in_.accept("exit")) {
      c.transition = Transition::Exit;
    } else if (!in_.accept("stay")) {
      in_.failExpecting("`goto`, `call`, `return`, `exit` or `stay`");
    }
    if (c.transition == Transition::Goto || c.transition == Transition::Call) {
      targets_.push_back({id, s.cases.size(), in_.nameToken("the name of a state")});
    }
    c.range = in_.since(begin);
    s.cases.push_back(c);
  }

  /// States may be named before they are defined, so targets are found at the end.
  void targets() {
    for (const Target& t : targets_) {
      if (!in_.failed()) {
        m_.states[t.state.index].cases[t.case_index].target = {states_.find(t.name)};
      }
    }
  }

  text::Cursor in_;
  Mission m_;
  text::Names sensors_{in_, "sensor"};
  text::Names profiles_{in_, "profile"};
  text::Names routes_{in_, "route"};
  text::Names states_{in_, "state"};
  text::ExpressionReader expressions_{in_, m_, sensors_};
  std::vector<Target> targets_;
};

}  // namespace

std::optional<Mission> read(const support::SourceManager& sources, uint32_t file,
                            support::DiagnosticEngine& diagnostics) {
  return Reader(sources.text(file), file, diagnostics).run();
}

}  // namespace glider::ir
