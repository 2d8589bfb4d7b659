// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/obligations.h"

#include "ir/certify/step.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace glider::ir::certify {
namespace {

bool isOf(const Mission& mission, const Configuration& at) {
  const auto exists = [&](StateId state) { return state.index < mission.states.size(); };
  return exists(at.state) &&
         std::ranges::all_of(at.stack, [&](const Waiting& w) { return exists(w.state); });
}

bool hasSuchProofs(const Requirement& r) {
  switch (r.kind) {
    case RequirementKind::Always:
      return r.geofences.empty();
    case RequirementKind::ExitWithin:
    case RequirementKind::NeverAfter:
    case RequirementKind::SurfacesEvery:
    case RequirementKind::StackAtMost:
      return true;
    case RequirementKind::Reach:
      break;
  }
  return false;
}

/// A script that no certificate passes.
Script refusal(const std::string& words) {
  return {"(set-logic ALL)\n(assert true)\n(check-sat)\n", {words}};
}

/// The invariants of a certificate, and the scripts that check them.
class Certificate {
 public:
  Certificate(const Setting& setting, std::span<const Invariant> invariants)
      : setting_(setting), invariants_(invariants) {
    for (size_t i = 0; i < invariants.size(); ++i) {
      numbers_.try_emplace(invariants[i].at, i);
    }
  }

  /// The obligations of a step from invariant number `from`; the start's have none.
  [[nodiscard]] Script script(const Step& step, std::optional<size_t> from) const {
    std::set<size_t> used;
    std::string body = step.text;
    Script script;
    if (from) {
      used.insert(*from);
      body += fmt::format("(assert {})\n", applied(*from, symbols(invariants_[*from].at)));
    }
    const std::string in = from ? wordsOf(setting_.mission, invariants_[*from].at) : "the start";
    std::string checks;
    for (const auto& [words, wrong] : all(step, in, used)) {
      if (wrong != "false") {
        checks += fmt::format("(push 1)\n(assert {})\n(check-sat)\n(pop 1)\n", wrong);
        script.obligations.push_back(words);
      }
    }
    script.text = "(set-logic ALL)\n" + definitions(used) + body + checks;
    return script;
  }

  [[nodiscard]] bool isTerm(const Invariant& invariant) const {
    return isOneTerm(invariant.formula, symbols(invariant.at));
  }

 private:
  struct Obligation {
    std::string words;
    Term wrong;  ///< what must be unsatisfiable
  };

  std::vector<Obligation> all(const Step& step, const std::string& in,
                              std::set<size_t>& used) const {
    std::vector<Term> violated;
    std::vector<Term> ill_formed;
    std::vector<Obligation> obligations;
    for (const Ending& e : step.endings) {
      violated.push_back(conjunction({e.condition, e.violates}));
      ill_formed.push_back(conjunction({e.condition, negation(e.well_formed)}));
      if (e.to || e.impossible) {
        obligations.push_back(leadsOn(e, in, used));
      }
    }
    obligations.push_back(
        {fmt::format("{}: the requirement is not violated", in), disjunction(violated)});
    obligations.push_back(
        {fmt::format("{}: variables stay in their declared ranges", in), step.leaves_range});
    obligations.push_back(
        {fmt::format(
             "{}: clocks stay in order, and the vehicle between the surface and its deepest", in),
         disjunction(ill_formed)});
    return obligations;
  }

  Obligation leadsOn(const Ending& e, const std::string& in, std::set<size_t>& used) const {
    const auto found = e.to ? numbers_.find(*e.to) : numbers_.end();
    if (found == numbers_.end()) {
      return {fmt::format("{}: {} is impossible", in, e.words), e.condition};
    }
    used.insert(found->second);
    return {fmt::format("{}: {} leads to {} and its invariant", in, e.words,
                        wordsOf(setting_.mission, *e.to)),
            conjunction({e.condition, negation(applied(found->second, e.values))})};
  }

  [[nodiscard]] std::vector<Term> symbols(const Configuration& at) const {
    std::vector<Term> all;
    for (const Name& name : namesIn(setting_.mission, setting_.requirement, at)) {
      all.push_back(name.text);
    }
    return all;
  }

  [[nodiscard]] static Term applied(size_t number, const std::vector<Term>& values) {
    return operation(fmt::format("{}invariant{}", kOwnNames, number), values);
  }

  /// Before anything else, so that an invariant can refer to nothing but its own names.
  [[nodiscard]] std::string definitions(const std::set<size_t>& used) const {
    std::string text;
    for (const size_t number : used) {
      const Invariant& invariant = invariants_[number];
      std::string names;
      for (const Name& name : namesIn(setting_.mission, setting_.requirement, invariant.at)) {
        names += fmt::format("({} {})", name.text, name.truth ? "Bool" : "Real");
      }
      text += fmt::format("(define-fun {}invariant{} ({}) Bool {})\n", kOwnNames, number, names,
                          isTerm(invariant) ? invariant.formula : "false");
    }
    return text;
  }

  const Setting& setting_;
  std::span<const Invariant> invariants_;
  std::map<Configuration, size_t> numbers_;
};

}  // namespace

std::vector<Script> obligationsOf(const Mission& mission, const platforms::Platform& platform,
                                  const Requirement& requirement,
                                  std::span<const Invariant> invariants, double longest_gap_s) {
  if (!hasSuchProofs(requirement)) {
    return {refusal("a requirement of this kind is not proved by an invariant")};
  }
  const Facts facts = factsOf(mission);
  const Setting setting{mission, platform, requirement, facts};
  const Certificate certificate(setting, invariants);
  std::vector<Script> scripts{certificate.script(startOf(setting), std::nullopt)};
  for (size_t i = 0; i < invariants.size(); ++i) {
    const Configuration& at = invariants[i].at;
    if (!isOf(mission, at)) {
      scripts.push_back(refusal("the mission has such a configuration"));
    } else if (!certificate.isTerm(invariants[i])) {
      scripts.push_back(
          refusal(fmt::format("the invariant of {} is one term of SMT-LIB", wordsOf(mission, at))));
    } else {
      scripts.push_back(certificate.script(stepOf(setting, at, longest_gap_s), i));
    }
  }
  return scripts;
}

std::vector<Script> obligationsUnder(const WidestWorld& widest, uint32_t requirement,
                                     std::span<const uint32_t> assumptions,
                                     std::span<const Invariant> invariants) {
  const auto [mission, platform] = assuming(widest, assumptions);
  return obligationsOf(mission, platform, mission.requirements.at(requirement), invariants,
                       longestGap(mission, platform));
}

double longestGap(const Mission& mission, const platforms::Platform& platform) {
  return std::max(platform.world.tick_gap_s, mission.resume_within_s);
}

}  // namespace glider::ir::certify
