// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/verify/promela.h"

#include "ir/verify/structure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>

namespace glider::ir {
namespace {

constexpr std::string_view kPrelude = R"(
#ifndef EMPTY_RETURN
#define EMPTY_RETURN(mission, state) assert(false)
#endif
#ifndef CALLED_TWICE
#define CALLED_TWICE(mission, state, target) assert(false)
#endif
#ifndef REACHED
#define REACHED(mission, state) skip
#endif
#ifndef CALLED
#define CALLED(mission) skip
#endif

inline push() {
  stack[depth] = state; limits[depth] = limit; waits[state] = true; depth++
}

inline pop() {
  depth--; state = stack[depth]; limit = limits[depth];
  waits[state] = false; stack[depth] = 0; limits[depth] = 0
}

inline forget() {
  do
  :: depth > 0 -> depth--; waits[stack[depth]] = false; stack[depth] = 0; limits[depth] = 0
  :: else -> break
  od
}
)";

std::string_view integerFor(size_t greatest) {
  return greatest < 256 ? "byte" : greatest < 32768 ? "short" : "int";
}

class Process {
 public:
  Process(const Mission& mission, std::string_view name)
      : m_(mission), name_(name), truths_(constantTruths(mission)) {
    look(m_.always);
    for (const State& state : m_.states) {
      look(state.cases);
    }
  }

  std::string run(bool active) {
    add("{}proctype {}()\n{{", active ? "active " : "", name_);
    variables();
    add("\n  goto {};\n", label(0));
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      state(i);
    }
    always();
    returns();
    again();
    add("\nexited:\n  skip\n}}\n");
    return std::move(text_);
  }

 private:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  void look(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      calls_ |= c.transition == Transition::Call;
      returns_ |= c.transition == Transition::Return;
    }
  }

  void variables() {
    const size_t states = m_.states.size(), cases = m_.always.size();
    add("\n  {} state = 0;", integerFor(states));
    add("\n  {} limit = {}; /* cases of `always` below it may fire */", integerFor(cases), cases);
    if (calls_) {
      add("\n  {} stack[{}]; /* the states that wait for a return, outermost first */",
          integerFor(states), states);
      add("\n  {} limits[{}]; /* theirs */\n  bool waits[{}];\n  {} depth = 0;", integerFor(cases),
          states, states, integerFor(states));
    }
  }

  /// A name that Promela accepts, made unique by the number.
  [[nodiscard]] std::string label(uint32_t state) const {
    std::string text = fmt::format("s{}_{}", state, m_.states[state].name);
    std::ranges::replace_if(text, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return text;
  }

  void state(uint32_t number) {
    add("\n{}:\n  state = {}; REACHED({}, {});\n  if\n", label(number), number, name_, number);
    for (const Case& c : m_.states[number].cases) {
      const Truth guard = truths_[c.guard.index];
      if (guard != Truth::False) {
        ownCase(number, c);
      }
      if (guard == Truth::True) {
        break;  // it hides the rest
      }
    }
    add("  :: goto {}\n  fi;\n", m_.always.empty() ? label(number) : "always");
  }

  void ownCase(uint32_t from, const Case& c) {
    const std::string to = c.target.valid() ? label(c.target.index) : "";
    switch (c.transition) {
      case Transition::Goto:
        add("  :: d_step {{ {}; limit = {} }}; goto {}\n", calls_ ? "forget()" : "skip",
            m_.always.size(), to);
        return;
      case Transition::Call:
        ownCall(from, c.target.index);
        return;
      case Transition::Return:
        add("  :: goto returns\n");
        return;
      case Transition::Exit:
        add("  :: goto exited\n");
        return;
      case Transition::Stay:
      case Transition::Done:
        return;
    }
  }

  void ownCall(uint32_t from, uint32_t to) {
    // No `else`: in Promela it would apply to all cases together.
    const bool itself = from == to;
    const std::string twice = itself ? "true" : fmt::format("waits[{}]", to);
    add("  :: {} -> CALLED_TWICE({}, {}, {}); goto exited\n", twice, name_, from, to);
    if (!itself) {
      add("  :: !{} -> d_step {{ push() }}; CALLED({}); goto {}\n", twice, name_, label(to));
    }
  }

  /// No case of the state fires.
  void always() {
    if (m_.always.empty()) {
      return;
    }
    add("\nalways:\n  if\n");
    for (size_t i = 0; i < m_.always.size(); ++i) {
      const Case& c = m_.always[i];
      const Truth guard = truths_[c.guard.index];
      if (guard != Truth::False) {
        alwaysCase(i, c);
      }
      if (guard == Truth::True && !c.target.valid()) {
        break;
      }
    }
    add("  :: goto again\n  fi;\n");
  }

  void alwaysCase(size_t i, const Case& c) {
    if (c.transition == Transition::Exit) {
      add("  :: limit > {} -> goto exited\n", i);
    }
    if (!c.target.valid()) {
      return;
    }
    add("  :: limit > {0} && state != {1}", i, c.target.index);
    if (calls_) {
      add(" && !waits[{}]", c.target.index);
    }
    const bool call = c.transition == Transition::Call;
    add(" -> d_step {{ {}; limit = {} }}; {}goto {}\n",
        call     ? "push()"
        : calls_ ? "forget()"
                 : "skip",
        i, call ? fmt::format("CALLED({}); ", name_) : "", label(c.target.index));
  }

  void returns() {
    if (!returns_) {
      return;
    }
    add("\nreturns:\n");
    if (calls_) {
      add("  if\n  :: depth > 0 -> d_step {{ pop() }}; goto again\n  :: else -> skip\n  fi;\n");
    }
    add("  EMPTY_RETURN({}, state);\n  goto exited;\n", name_);
  }

  /// The state that `state` represents continues.
  void again() {
    if (m_.always.empty() && !(returns_ && calls_)) {
      return;
    }
    add("\nagain:\n  if\n");
    for (uint32_t i = 0; i < m_.states.size(); ++i) {
      add("  :: state == {} -> goto {}\n", i, label(i));
    }
    add("  fi;\n");
  }

  const Mission& m_;
  const std::string_view name_;
  const std::vector<Truth> truths_;
  bool calls_ = false;
  bool returns_ = false;
  std::string text_;
};

}  // namespace

std::string_view promelaPrelude() {
  return kPrelude;
}

std::string promelaProcess(const Mission& mission, std::string_view process, bool active) {
  return Process(mission, process).run(active);
}

std::string promela(const Mission& mission) {
  return fmt::format("/* The structure of mission {} for SPIN: spin -run -m1000000 FILE */\n{}\n{}",
                     mission.name, promelaPrelude(), promelaProcess(mission, "mission", true));
}

}  // namespace glider::ir
