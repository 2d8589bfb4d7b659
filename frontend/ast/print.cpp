// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/ast/print.h"

#include "frontend/ast/print_parts.h"

#include <fmt/format.h>

namespace glider::ast {
namespace {

std::string printUse(const Use& use) {
  return use.name.text + (use.parenthesised ? printArguments(use.arguments) : "");
}

std::string printRange(const std::optional<Range>& range) {
  return range ? fmt::format(" in {} .. {}", print(range->lowest), print(range->highest)) : "";
}

std::string printFormals(const std::vector<Formal>& formals) {
  std::string out;
  for (const Formal& formal : formals) {
    out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", formal.name.text, formal.type.text);
    out += formal.usual ? " = " + print(*formal.usual) : "";
    out += printRange(formal.range);
  }
  return "(" + out + ")";
}

std::string printFormals(const std::optional<std::vector<Formal>>& formals) {
  return formals ? printFormals(*formals) : "";
}

std::string_view word(BehaviourKind kind) {
  return kind == BehaviourKind::Profile ? "flightprofile" : "flightroute";
}

std::string_view word(Transition transition) {
  constexpr std::string_view kWords[] = {"goto", "call", "return", "exit", "stay", "done"};
  return kWords[static_cast<size_t>(transition)];
}

/// The size or the index of an array.
std::string inBrackets(const std::optional<Expr>& expr) {
  return expr ? "[" + print(*expr) + "]" : "";
}

class FilePrinter {
 public:
  void item(const Item& node) {
    std::visit([this](const auto& n) { write(n); }, node);
  }
  std::string take() { return std::move(out_); }

 private:
  void line(std::string_view text) {
    out_.append(2 * indent_, ' ');
    out_ += text;
    out_ += '\n';
  }
  void gap() { out_ += out_.empty() ? "" : "\n"; }

  void write(const MissionLine& n) { line("mission " + n.name.text); }
  void write(const PlatformLine& n) { line("platform " + n.name.text); }
  void write(const Import& n) { line("import " + n.path + (n.as ? " as " + n.as->text : "")); }
  void write(const Const& n) {
    const std::string type = n.type ? ": " + n.type->text : "";
    line(fmt::format("const {}{} = {}", n.name.text, type, print(n.value)));
  }
  void write(const Param& n) {
    const std::string where = n.condition ? " where " + print(*n.condition) : "";
    line(fmt::format("param {}{}: {} = {}{}{}", n.name.text, inBrackets(n.size), n.type.text,
                     print(n.value), printRange(n.range), where));
  }
  void write(const Var& n) {
    line(fmt::format("var {}{}: {} = {}{}", n.name.text, inBrackets(n.size), n.type.text,
                     print(n.value), printRange(n.range)));
  }
  void write(const Always& n) {
    gap();
    line("always");
    cases(n.cases);
  }
  void write(const State& n) {
    gap();
    line("state " + n.name.text + printFormals(n.formals));
    members(n.members);
  }
  void write(const Behaviour& n) {
    gap();
    line(fmt::format("{} {}{}", word(n.kind), n.name.text, printFormals(n.formals)));
    members(n.members);
  }
  void write(const ExternFunction& n) {
    line(fmt::format("extern function {}{}: {}{}", n.name.text, printFormals(n.formals),
                     n.result.text, printRange(n.range)));
  }
  void write(const ExternBehaviour& n) {
    std::string reads;
    for (const Name& sensor : n.reads) {
      reads += (reads.empty() ? " reads " : ", ") + sensor.text;
    }
    line(
        fmt::format("extern {} {}{}{}", word(n.kind), n.name.text, printFormals(n.formals), reads));
  }
  void write(const ExternSensor& n) {
    const std::string stale = n.stale_after ? " stale after " + print(*n.stale_after) : "";
    line(fmt::format("extern sensor {}: {}{}{}", n.name.text, n.type.text, printRange(n.range),
                     stale));
  }
  void write(const PlaceDeclaration& n) {
    line("place " + n.name.text + " = " + print(n.condition));
  }
  void write(const Requirement& n) {
    const std::string scope = n.scope ? printed(*n.scope) : "";
    const std::string end = n.or_exit ? " or exit" : "";
    std::visit([&](const auto& p) { line("require " + scope + promise(p) + end); }, n.node);
  }

  void write(const Assumption& n) {
    std::visit([&](const auto& p) { line("assume " + premise(p)); }, n.node);
  }
  static std::string premise(const StartPremise& p) { return "start " + print(p.condition); }
  static std::string premise(const OutagePremise& p) {
    return p.limit ? "outage <= " + print(*p.limit) : "no outage";
  }
  static std::string premise(const CurrentPremise& p) { return "current <= " + print(p.limit); }
  static std::string premise(const KnownPremise& p) {
    return (p.sensor ? "known " + p.sensor->text : "fix") + " every " + print(p.every);
  }
  static std::string premise(const ChangesPremise& p) {
    return p.sensor.text + " changes <= " + print(p.limit);
  }
  static std::string premise(const RangePremise& p) { return p.sensor.text + printRange(p.range); }
  static std::string premise(const ConditionPremise& p) {
    return print(p.condition) + (p.inside ? " " + print(*p.inside) : "");
  }

  void write(const Nap& n) { line("nap at most " + print(n.longest)); }
  void write(const Resumption& n) {
    line("resume within " + print(n.within) +
         (n.never_after_restart ? ", never after restart" : ""));
  }
  void write(const Declination& n) { line("declination " + print(n.angle)); }

  void write(const Share& n) {
    const std::string value =
        n.variable ? fmt::format(": {} = {}{}", n.variable->type.text, print(n.variable->value),
                                 printRange(n.variable->range))
                   : printRange(n.range);
    const std::string precision = n.precision ? " precision " + print(*n.precision) : "";
    const std::string stale = n.stale_after ? " stale after " + print(*n.stale_after) : "";
    line(fmt::format("share {}{}{} every {}{}", n.name.text, value, precision, print(n.every),
                     stale));
  }

  void write(const Choice& n) {
    const std::string value = n.chosen ? " = " + print(n.constant.value) : "";
    const std::string step = n.step ? " by " + print(*n.step) : "";
    const std::string where = n.condition ? " where " + print(*n.condition) : "";
    line(fmt::format("choose {}: {}{}{}{}{}", n.constant.name.text, n.constant.type->text, value,
                     printRange(n.range), step, where));
  }
  void write(const Preference& n) {
    std::string text;
    for (const Objective& one : n.objectives) {
      text += (text.empty() ? "prefer " : " then ") + printed(one);
    }
    line(text);
  }
  static std::string printed(const Objective& n) {
    switch (n.aim) {
      case Aim::Least:
        return "least " + print(*n.value);
      case Aim::Greatest:
        return "greatest " + print(*n.value);
      case Aim::Endurance:
        break;
    }
    return "endurance";
  }
  void write(const Pack& n) {
    const std::string reserve = n.reserve ? " reserve " + print(*n.reserve) : "";
    line("pack " + print(n.capacity) + " at " + print(n.voltage) + reserve);
  }
  void write(const Vehicles& n) {
    std::string names;
    for (const Name& name : n.names) {
      names += (names.empty() ? "" : ", ") + name.text;
    }
    line("vehicles " + names);
  }

  static std::string promise(const AlwaysPromise& p) { return "always " + print(p.condition); }
  static std::string promise(const ExitPromise& p) { return "exit within " + print(p.within); }
  static std::string promise(const StackPromise& p) { return "stack <= " + print(p.depth); }
  static std::string promise(const ReachPromise& p) { return "reach " + p.state.text; }
  static std::string promise(const VisitPromise& p) {
    return "visit " + route(p.places, p.manner) + " within " + print(p.within);
  }
  static std::string promise(const PatrolPromise& p) {
    return "patrol " + route(p.places, p.manner) + " every " + print(p.every);
  }
  static std::string route(const std::vector<Expr>& places, Manner manner) {
    constexpr std::string_view kManners[] = {"", "", " in order", " in strict order", " fairly"};
    std::string text;
    for (const Expr& place : places) {
      const std::string_view between = manner == Manner::Sequence ? " then " : ", ";
      text += (text.empty() ? "" : std::string(between)) + print(place);
    }
    return text + std::string(kManners[static_cast<size_t>(manner)]);
  }
  static std::string promise(const CountPromise& p) {
    constexpr std::string_view kBounds[] = {"at most", "at least", "exactly"};
    return fmt::format("visit {} {} {} times{}", print(p.place),
                       kBounds[static_cast<size_t>(p.bound)], print(p.times),
                       p.within ? " within " + print(*p.within) : "");
  }
  static std::string promise(const NeverPromise& p) {
    const std::string_view when = p.when == NeverWhen::Before ? " before " : " after ";
    return "never " + print(p.place) + (p.event ? std::string(when) + print(*p.event) : "");
  }
  static std::string promise(const ReactionPromise& p) {
    constexpr std::string_view kTriggers[] = {"whenever", "when", "whenever and only when"};
    constexpr std::string_view kTimings[] = {"", " within ", " for ", " next tick"};
    return fmt::format("{} {} then {}{}{}", kTriggers[static_cast<size_t>(p.trigger)],
                       print(p.cause), print(p.response), kTimings[static_cast<size_t>(p.timing)],
                       p.time ? print(*p.time) : "");
  }
  static std::string promise(const HoldPromise& p) {
    return fmt::format("hold {} until {} within {}", print(p.place), print(p.until),
                       print(p.within));
  }
  static std::string printed(const PromiseScope& scope) {
    constexpr std::string_view kWords[] = {"in", "outside", "before", "after", "from"};
    return fmt::format("{} {}{}: ", kWords[static_cast<size_t>(scope.kind)], print(scope.place),
                       scope.to ? " to " + print(*scope.to) : "");
  }
  static std::string promise(const SurfacesPromise& p) {
    return "surfaces every " + print(p.every);
  }

  void members(const std::vector<Member>& list) {
    line("begin");
    ++indent_;
    for (const Member& member : list) {
      std::visit([this](const auto& n) { writeMember(n); }, member.node);
    }
    --indent_;
    line("end");
  }
  void writeMember(const RouteMember& n) { line("flightroute " + printUse(n.use)); }
  void writeMember(const ProfileMember& n) { line("flightprofile " + printUse(n.use)); }
  void writeMember(const SensorsMember& n) {
    std::string text;
    for (const SensorItem& item : n.items) {
      text += (text.empty() ? "" : ", ") + item.name.text;
      text += item.every ? " every " + print(*item.every) : "";
    }
    line("sensors " + text);
  }
  void writeMember(const SampleMember& n) {
    std::string text;
    for (const SampleItem& item : n.items) {
      text += (text.empty() ? "" : ", ") + item.instrument.text;
      text += item.off ? " off" : "";
      text += item.every ? " every " + print(*item.every) : "";
      text += item.when ? " when " + print(*item.when) : "";
    }
    line("sample " + text);
  }
  void writeMember(const Var& n) { write(n); }
  void writeMember(const EntryMember& n) {
    line("entry do");
    statements(n.block.statements);
    line("end");
  }
  void writeMember(const EventsMember& n) {
    line("events");
    cases(n.cases);
  }

  void cases(const std::vector<Case>& list) {
    ++indent_;
    for (const Case& c : list) {
      const std::string target = c.target ? " " + printUse(*c.target) : "";
      const std::string transition = std::string(word(c.transition)) + target;
      if (c.action) {
        line(fmt::format("case {} do", print(c.guard)));
        statements(c.action->statements);
        line("end " + transition);
      } else {
        line(fmt::format("case {} {}", print(c.guard), transition));
      }
    }
    --indent_;
  }

  void statements(const std::vector<Statement>& list) {
    ++indent_;
    for (const Statement& statement : list) {
      std::visit([this](const auto& n) { writeStatement(n); }, statement.node);
    }
    --indent_;
  }
  void writeStatement(const Set& n) {
    line(fmt::format("set {}{} = {}", n.variable.text, inBrackets(n.index), print(n.value)));
  }
  void writeStatement(const For& n) {
    line(fmt::format("for {} in {} .. {} do", n.index.text, print(n.first), print(n.last)));
    statements(n.body);
    line("end");
  }
  void writeStatement(const If& n) {
    line("if " + print(n.condition) + " then");
    statements(n.then);
    if (n.otherwise) {
      line("else");
      statements(*n.otherwise);
    }
    line("end");
  }
  void writeStatement(const Log& n) {
    std::string text = "log " + n.text;
    for (const Expr& value : n.values) {
      text += ", " + print(value);
    }
    line(text);
  }
  void writeStatement(const Command& n) {
    line(n.call.function.text + printArguments(n.call.arguments));
  }

  std::string out_;
  size_t indent_ = 0;
};

}  // namespace

std::string print(const File& file) {
  FilePrinter printer;
  for (const Item& item : file.items) {
    printer.item(item);
  }
  return printer.take();
}

}  // namespace glider::ast
