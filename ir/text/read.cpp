// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/read.h"

#include "ir/core/ops.h"
#include "ir/core/validate.h"
#include "ir/text/cursor.h"
#include "ir/text/print.h"

#include <fmt/format.h>

#include <unordered_map>
#include <utility>

namespace glider::ir {
namespace {

using support::DiagnosticId;
using support::SourceRange;
using text::Token;
using text::TokenKind;

constexpr uint32_t kDeepestNesting = 200;

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
  using Names = std::unordered_map<std::string, uint32_t>;
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
      let();
    } else if (in_.accept("state")) {
      state();
    } else {
      in_.failExpecting("`sensor`, `behaviour`, `let` or `state`");
    }
  }

  void define(Names& names, std::string_view what, const Token& name, size_t index) {
    if (!names.emplace(name.text, static_cast<uint32_t>(index)).second) {
      in_.fail(DiagnosticId::irDefinedTwice, name.range, what, name.text);
    }
  }

  /// The number of the `what` called `name`; UINT32_MAX after reporting that there is none.
  uint32_t find(const Names& names, std::string_view what, const Token& name) {
    auto found = names.find(name.text);
    if (found != names.end()) {
      return found->second;
    }
    in_.fail(DiagnosticId::irUnknownName, name.range, what, name.text);
    return UINT32_MAX;
  }

  /// Takes a name together with its place.
  Token nameToken(std::string_view what) {
    Token token = in_.peek();
    token.text = in_.name(what);
    return token;
  }

  void sensor() {
    const Token name = nameToken("the sensor's name");
    define(sensors_, "sensor", name, m_.sensors.size());
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

  SensorId sensorName() { return {find(sensors_, "sensor", nameToken("the name of a sensor"))}; }

  void behaviour() {
    Behaviour b;
    const bool profile = in_.accept("profile");
    if (!profile) {
      in_.expect("route");
    }
    b.kind = profile ? BehaviourKind::Profile : BehaviourKind::Route;
    const Token name = nameToken("the behaviour's name");
    define(profile ? profiles_ : routes_, "behaviour", name, m_.behaviours.size());
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

  void let() {
    const Token name = in_.peek();
    if (name.kind != TokenKind::Name) {
      in_.failExpecting("a name like `%1`");
    }
    in_.take();
    in_.expect('=');
    const ExprId value = expression(0);
    define(lets_, "expression", name, value.index);
  }

  ExprId add(Expr e, SourceRange begin) {
    e.range = in_.since(begin);
    if (in_.failed()) {
      return {};
    }
    const std::optional<Type> type = resultType(m_, e);
    if (!type) {
      std::string operands;
      for (uint32_t i = 0; i < opInfo(e.op).operands; ++i) {
        operands += (i == 0 ? "" : " and ") + typeText(m_[e.operands.at(i)].type);
      }
      in_.fail(DiagnosticId::irOperands, e.range, opInfo(e.op).text, operands);
      return {};
    }
    e.type = *type;
    m_.exprs.push_back(e);
    return {static_cast<uint32_t>(m_.exprs.size() - 1)};
  }

  ExprId expression(uint32_t depth) {
    const Token token = in_.peek();
    if (token.kind == TokenKind::Number) {
      return constant(token.range);
    }
    if (token.kind == TokenKind::Name) {
      in_.take();
      return {find(lets_, "expression", token)};
    }
    if (in_.accept('(')) {
      return operation(token.range, depth + 1);
    }
    const OpInfo* op = token.kind == TokenKind::Word ? findOp(token.text) : nullptr;
    if (op == nullptr || op->operands > 0 || named(op->op) || op->op == Op::Constant) {
      in_.failExpecting("an expression");
      return {};
    }
    in_.take();
    Expr e;
    e.op = op->op;
    return add(e, token.range);
  }

  static bool named(Op op) { return op == Op::Sensor || op == Op::Age; }

  ExprId constant(SourceRange begin) {
    Expr e;
    e.number = in_.number(false);
    if (in_.accept(':')) {
      e.type = in_.type();
    }
    return add(e, begin);
  }

  ExprId operation(SourceRange begin, uint32_t depth) {
    if (depth > kDeepestNesting) {
      in_.fail(DiagnosticId::irTooDeep, begin, kDeepestNesting);
      return {};
    }
    const OpInfo* op = in_.peek().kind == TokenKind::Word ? findOp(in_.peek().text) : nullptr;
    if (op == nullptr || (op->operands == 0 && !named(op->op))) {
      in_.failExpecting("an operation");
      return {};
    }
    in_.take();
    Expr e;
    e.op = op->op;
    if (named(op->op)) {
      e.sensor = sensorName();
    }
    for (uint32_t i = 0; i < op->operands; ++i) {
      e.operands.at(i) = expression(depth);
    }
    in_.expect(')');
    return add(e, begin);
  }

  void state() {
    const Token name = nameToken("the state's name");
    const StateId id{static_cast<uint32_t>(m_.states.size())};
    define(states_, "state", name, id.index);
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
        let();
      } else {
        return;
      }
    }
  }

  void activity(Activity& a, const Names& names, std::string_view what, SourceRange begin) {
    const Token name = nameToken("the behaviour's name");
    if (a.behaviour.valid()) {
      in_.fail(DiagnosticId::irDefinedTwice, begin, what, name.text);
    }
    a.behaviour = {find(names, what, name)};
    list([&] { a.arguments.push_back(expression(0)); });
    a.range = in_.since(begin);
  }

  void log(State& s) {
    LogItem item;
    item.name = in_.name("the name of a log item");
    in_.expect("every");
    item.period_s = in_.number(false);
    item.value = expression(0);
    s.log.push_back(std::move(item));
  }

  void stateCase(StateId id, State& s, SourceRange begin) {
    Case c;
    c.guard = expression(0);
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
      targets_.push_back({id, s.cases.size(), nameToken("the name of a state")});
    }
    c.range = in_.since(begin);
    s.cases.push_back(c);
  }

  /// States may be named before they are defined, so targets are found at the end.
  void targets() {
    for (const Target& t : targets_) {
      if (!in_.failed()) {
        m_.states[t.state.index].cases[t.case_index].target = {find(states_, "state", t.name)};
      }
    }
  }

  text::Cursor in_;
  Mission m_;
  Names sensors_, profiles_, routes_, states_, lets_;
  std::vector<Target> targets_;
};

}  // namespace

std::optional<Mission> read(const support::SourceManager& sources, uint32_t file,
                            support::DiagnosticEngine& diagnostics) {
  return Reader(sources.text(file), file, diagnostics).run();
}

}  // namespace glider::ir
