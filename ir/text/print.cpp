// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/print.h"

#include "ir/core/ops.h"
#include "ir/core/validate.h"
#include "ir/text/layout.h"
#include "support/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace glider::ir {
namespace {

/// A name as it is if it looks like one, else in quotes with everything but printable ASCII
/// escaped.
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

class Printer {
 public:
  explicit Printer(const Mission& mission) : m_(mission), layout_(text::layOut(mission)) {}

  std::string run() {
    add("glider_ir 1\nmission {} platform {}\n", nameText(m_.name), nameText(m_.platform));
    std::ranges::for_each(m_.sensors, [&](const Sensor& s) { sensor(s); });
    std::ranges::for_each(m_.behaviours, [&](const Behaviour& b) { behaviour(b); });
    std::ranges::for_each(m_.states, [&](const State& s) { state(s); });
    defineUpTo(static_cast<uint32_t>(m_.exprs.size()), "");
    return std::move(out_);
  }

 private:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }

  void sensor(const Sensor& s) {
    const bool linear = s.encoding == Encoding::Linear;
    add("\nsensor {}: {} vehicle {} id {} encoding {} to_si {} lowest {} highest {} stale_after {}",
        nameText(s.name), typeText(s.type), nameText(s.vehicle_name), s.id,
        linear ? "linear" : "degrees_minutes", s.to_si, s.lowest, s.highest, s.stale_after_s);
  }

  void behaviour(const Behaviour& b) {
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

  void state(const State& s) {
    add("\n\nstate {}", nameText(s.name));
    activity("route", s.route);
    activity("profile", s.profile);
    for (const LogItem& item : s.log) {
      prepare({&item.value, 1});
      add("\n  log {} every {} ", nameText(item.name), item.period_s);
      use(item.value);
    }
    for (const Case& c : s.cases) {
      prepare({&c.guard, 1});
      add("\n  case ");
      use(c.guard);
      transition(c);
    }
  }

  void activity(std::string_view what, const Activity& a) {
    prepare(a.arguments);
    add("\n  {} {} (", what, nameText(m_[a.behaviour].name));
    for (size_t i = 0; i < a.arguments.size(); ++i) {
      add("{}", i == 0 ? "" : ", ");
      use(a.arguments[i]);
    }
    add(")");
  }

  void transition(const Case& c) {
    constexpr std::string_view kWords[] = {"goto", "call", "return", "exit", "stay"};
    add(" {}", kWords[static_cast<size_t>(c.transition)]);
    if (c.target.valid()) {
      add(" {}", nameText(m_[c.target].name));
    }
  }

  /// Defines by `let` what must have a name before the expressions `ids` can be written in a row.
  void prepare(std::span<const ExprId> ids) {
    auto pending = [&](ExprId id) { return id.index >= next_; };
    auto start = std::ranges::find_if(ids, pending);
    if (start == ids.end()) {
      return;
    }
    const uint32_t first = layout_.first[start->index];
    uint32_t number = first;
    for (ExprId id : ids) {
      if (layout_.uses[id.index] == 1 && layout_.first[id.index] == number) {
        number = id.index + 1;
      } else if (id.index >= number) {
        defineUpTo(std::ranges::max(ids).index + 1, "  ");
        return;
      }
    }
    defineUpTo(first, "  ");
  }

  /// Names every expression below number `end` that has not been written yet.
  void defineUpTo(uint32_t end, std::string_view indent) {
    while (next_ < end) {
      uint32_t root = next_;
      while (layout_.inside[root]) {
        ++root;
      }
      add("\n{}let %{} = ", indent, root);
      use({root});
    }
  }

  void use(ExprId id) {
    if (id.index < next_) {
      add("%{}", id.index);
    } else {
      tree(id.index);
      next_ = id.index + 1;
    }
  }

  /// Recursion as deep as the layout lets trees be.
  void tree(uint32_t i) {
    const Expr& e = m_.exprs[i];
    const OpInfo& op = opInfo(e.op);
    if (e.op == Op::Constant) {
      constexpr Type kPlain;
      add("{}{}", e.number, e.type == kPlain ? "" : ":" + typeText(e.type));
      return;
    }
    if (op.operands == 0 && !e.sensor.valid()) {
      add("{}", op.text);
      return;
    }
    add("({}", op.text);
    if (e.sensor.valid()) {
      add(" {}", nameText(m_[e.sensor].name));
    }
    for (uint32_t k = 0; k < op.operands; ++k) {
      const uint32_t operand = e.operands.at(k).index;
      add(" ");
      if (layout_.inside[operand]) {
        tree(operand);
      } else {
        add("%{}", operand);
      }
    }
    add(")");
  }

  const Mission& m_;
  text::Layout layout_;
  std::string out_;
  uint32_t next_ = 0;
};

}  // namespace

std::string typeText(Type type) {
  switch (type.kind) {
    case TypeKind::Bool:
      return "bool";
    case TypeKind::Latitude:
      return "latitude";
    case TypeKind::Longitude:
      return "longitude";
    case TypeKind::Quantity:
      break;
  }
  if (type.dimension.dimensionless()) {
    return "number";
  }
  const std::string name = support::describe(type.dimension);
  return support::findDimension(name) == type.dimension
             ? name
             : fmt::format("dim({})", fmt::join(type.dimension.exponents, ","));
}

std::string print(const Mission& mission) {
  CHECK(validate(mission).empty(), "a mission that does not hold together");
  return Printer(mission).run() + "\n";
}

}  // namespace glider::ir
