// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/coverage.h"

#include "ir/opt/compact.h"
#include "ir/verify/verify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <set>

namespace glider::analysis {
namespace {

constexpr size_t kMostCases = 60;
/// Of the usual effort, for each mission without a part.
constexpr unsigned kShare = 4;

std::vector<ir::Case>& casesOf(ir::Mission& mission, const ir::CasePlace& place) {
  return place.state.valid() ? mission.states[place.state.index].cases : mission.always;
}

std::vector<ir::CasePlace> allCases(const ir::Mission& mission) {
  std::vector<ir::CasePlace> places;
  for (uint32_t i = 0; i < mission.always.size() && !mission.always[i].implied; ++i) {
    places.push_back({{}, i});
  }
  for (uint32_t s = 0; s < mission.states.size(); ++s) {
    for (uint32_t i = 0; i < mission.states[s].cases.size(); ++i) {
      places.push_back({{s}, i});
    }
  }
  return places;
}

/// Whether a requirement names the state: without the state it would say nothing.
bool named(const ir::Mission& mission, ir::StateId state) {
  return std::ranges::any_of(mission.requirements, [&](const ir::Requirement& r) {
    return r.state == state || r.after == state ||
           std::ranges::any_of(r.monitor.observations,
                               [&](const ir::Observation& o) { return o.state == state; });
  });
}

/// Proves the mission again without each case, one at a time, with a part of the effort: a proof
/// that is not found again counts as one that needs the case. So nothing is called superfluous that
/// a proof needs.
class DependenceSearch {
 public:
  DependenceSearch(const compiler::Checked& checked,
                   const std::vector<ir::prove::RequirementVerdict>& proved,
                   const ir::prove::Options& asked)
      : checked_(checked), m_(checked.mission()) {
    how_.effort = asked.effort;
    how_.run_effort = asked.run_effort / kShare;
    how_.total_effort = asked.total_effort / kShare;
    how_.until = asked.until;
    how_.premises = false;
    for (const ir::prove::RequirementVerdict& verdict : proved) {
      if (verdict.verdict == ir::prove::Verdict::Proved) {
        proved_.push_back(verdict.requirement);
      }
    }
  }

  std::optional<Coverage> run() {
    const std::vector<ir::CasePlace> all = allCases(m_);
    if (proved_.empty() || all.size() > kMostCases) {
      return std::nullopt;
    }
    Coverage coverage;
    coverage.cases = all.size();
    for (const ir::CasePlace& place : all) {
      if (holdsWithout({place})) {
        coverage.idle_cases.push_back(place);
      }
    }
    for (uint32_t s = 1; s < m_.states.size(); ++s) {
      std::vector<ir::CasePlace> leading;
      std::ranges::copy_if(all, std::back_inserter(leading), [&](const ir::CasePlace& place) {
        return caseAt(place).target == ir::StateId{s};
      });
      if (!leading.empty() && !named(m_, {s}) && holdsWithout(leading)) {
        coverage.idle_states.push_back({s});
      }
    }
    return coverage;
  }

 private:
  [[nodiscard]] const ir::Case& caseAt(const ir::CasePlace& place) const {
    return (place.state.valid() ? m_[place.state].cases : m_.always).at(place.number);
  }

  /// Whether all is still proved without these cases; the later of a list come later.
  [[nodiscard]] bool holdsWithout(const std::vector<ir::CasePlace>& cases) const {
    ir::Mission without = m_;
    std::for_each(cases.rbegin(), cases.rend(), [&](const ir::CasePlace& place) {
      std::vector<ir::Case>& list = casesOf(without, place);
      list.erase(list.begin() + place.number);
    });
    ir::opt::compact(without);
    support::DiagnosticEngine unheard;
    const ir::MissionFacts facts = ir::verify(without, unheard);
    if (unheard.hasErrors()) {
      return false;
    }
    const ir::prove::Findings found =
        ir::prove::prove(without, facts, checked_.platform(), how_, unheard);
    return std::ranges::all_of(proved_, [&](uint32_t requirement) {
      return found.requirements.at(requirement).verdict == ir::prove::Verdict::Proved;
    });
  }

  const compiler::Checked& checked_;
  const ir::Mission& m_;
  ir::prove::Options how_;
  std::vector<uint32_t> proved_;
};

}  // namespace

std::optional<Coverage> coverageOf(const compiler::Checked& checked,
                                   const std::vector<ir::prove::RequirementVerdict>& proved,
                                   const ir::prove::Options& asked) {
  return DependenceSearch(checked, proved, asked).run();
}

std::string coverageLine(const Coverage& coverage, const compiler::Checked& checked) {
  const ir::Mission& mission = checked.mission();
  std::set<uint32_t> lines;
  for (const ir::CasePlace& place : coverage.idle_cases) {
    const ir::Case& c =
        (place.state.valid() ? mission[place.state].cases : mission.always).at(place.number);
    lines.insert(checked.sources().place(c.range.file, c.range.begin).line);
  }
  std::vector<std::string> parts;
  if (!lines.empty()) {
    parts.push_back(fmt::format("{} of {} cases (line{} {})", coverage.idle_cases.size(),
                                coverage.cases, lines.size() == 1 ? "" : "s",
                                fmt::join(lines, ", ")));
  }
  if (!coverage.idle_states.empty()) {
    std::vector<std::string> names;
    for (const ir::StateId state : coverage.idle_states) {
      names.push_back("`" + mission[state].name + "`");
    }
    parts.push_back(
        fmt::format("state{} {}", names.size() == 1 ? "" : "s", fmt::join(names, ", ")));
  }
  return parts.empty() ? ""
                       : fmt::format("each proof would hold without any one of these: {}",
                                     fmt::join(parts, "; "));
}

}  // namespace glider::analysis
