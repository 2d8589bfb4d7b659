// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/match_states.h"

#include "analysis/difference/canonical_text.h"

#include <algorithm>
#include <map>
#include <optional>

namespace glider::analysis {
namespace {

using ir::StateId;

/// Instead of the name of a state that only one version has.
constexpr const char* kUnmatched = "?";

std::map<std::string, StateId> byName(const ir::Mission& mission) {
  std::map<std::string, StateId> states;
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    states[mission.states[i].name] = {i};
  }
  return states;
}

/// The states with these texts; none for a text that several have.
using ByText = std::map<std::string, std::optional<StateId>>;

ByText byText(const ir::Mission& mission, const std::vector<std::string>& names) {
  ByText states;
  CanonicalText text(mission, names);
  for (uint32_t i = 0; i < names.size(); ++i) {
    if (names[i] == kUnmatched) {
      const auto [at, first] = states.try_emplace(text.state({i}), StateId{i});
      at->second = first ? at->second : std::nullopt;
    }
  }
  return states;
}

/// Pairs the states of two versions: by name, then those that differ in nothing but their names.
/// Each pair may make the targets of other states equal, so the second step repeats until nothing
/// changes.
class StateMatcher {
 public:
  StateMatcher(const ir::Mission& before, const ir::Mission& after) : old_(before), new_(after) {
    found_.old_names.assign(before.states.size(), kUnmatched);
    found_.new_names.assign(after.states.size(), kUnmatched);
  }

  MatchedStates run() {
    const std::map<std::string, StateId> old_states = byName(old_);
    for (uint32_t i = 0; i < new_.states.size(); ++i) {
      if (const auto same = old_states.find(new_.states[i].name); same != old_states.end()) {
        match(same->second, {i});
      }
    }
    while (matchRenamed()) {
    }
    std::ranges::sort(found_.pairs, {}, [](const auto& pair) { return pair.second; });
    nameRest(old_, found_.old_names, found_.removed);
    nameRest(new_, found_.new_names, found_.added);
    return std::move(found_);
  }

 private:
  void match(StateId before, StateId after) {
    found_.pairs.emplace_back(before, after);
    found_.old_names[before.index] = found_.new_names[after.index] = old_[before].name;
  }

  /// A state that is matched may tell others apart that lead to it.
  bool matchRenamed() {
    const ByText old_states = byText(old_, found_.old_names);
    bool any = false;
    for (const auto& [text, state] : byText(new_, found_.new_names)) {
      const auto same = old_states.find(text);
      if (state && same != old_states.end() && same->second) {
        match(*same->second, *state);
        found_.renamed.emplace_back(*same->second, *state);
        any = true;
      }
    }
    return any;
  }

  static void nameRest(const ir::Mission& mission, std::vector<std::string>& names,
                       std::vector<StateId>& rest) {
    for (uint32_t i = 0; i < names.size(); ++i) {
      if (names[i] == kUnmatched) {
        names[i] = mission.states[i].name;
        rest.push_back({i});
      }
    }
  }

  const ir::Mission& old_;
  const ir::Mission& new_;
  MatchedStates found_;
};

}  // namespace

MatchedStates matchStates(const ir::Mission& before, const ir::Mission& after) {
  return StateMatcher(before, after).run();
}

}  // namespace glider::analysis
