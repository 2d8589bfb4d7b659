// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/certificate_file.h"

#include "codegen/digest.h"
#include "compiler/proving.h"
#include "support/diagnostics/ids/command.h"
#include "support/one_line.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace glider::compiler {
namespace {

using ir::certify::Configuration;
using nlohmann::json;
using support::Result;

constexpr int kVersion = 1;
constexpr std::array kMethods = {ir::prove::Method::Invariant,      ir::prove::Method::Bound,
                                 ir::prove::Method::Configurations, ir::prove::Method::Run,
                                 ir::prove::Method::Energy,         ir::prove::Method::Geometry};

/// null: every case of `always` may fire.
json limitToJson(uint32_t limit) {
  return limit == ir::certify::kNoLimit ? json() : json(limit);
}

json invariantToJson(const ir::certify::Invariant& invariant, const ir::Mission& mission) {
  json stack = json::array();
  for (const auto& waiting : invariant.at.stack) {
    stack.push_back(
        {{"state", mission[waiting.state].name}, {"limit", limitToJson(waiting.limit)}});
  }
  return {{"state", mission[invariant.at.state].name},
          {"stack", stack},
          {"limit", limitToJson(invariant.at.limit)},
          {"justReturned", invariant.at.just_returned},
          {"formula", invariant.formula}};
}

/// Throws json::exception, or std::string with what is wrong.
class Reader {
 public:
  Reader(const ir::Mission& mission, const std::string& subject) : m_(mission), subject_(subject) {}

  Certificate read(const json& in, const std::string& name) {
    if (in.at("glidercc certificate").get<int>() != kVersion) {
      throw std::string("it is of another version of glidercc");
    }
    Certificate certificate{in.at("requirement").get<std::string>(),
                            in.at("subject").get<std::string>(),
                            methodOf(in.at("method").get<std::string>()),
                            {},
                            {},
                            std::nullopt};
    if (certificate.subject != subject_) {
      return certificate;
    }
    certificate.assumptions = assumptions(in.value("assumptions", json::array()));
    std::set<Configuration> seen;
    for (const json& one : in.at("invariants")) {
      certificate.invariants.push_back(invariant(one));
      if (!seen.insert(certificate.invariants.back().at).second) {
        throw std::string("it lists a configuration twice");
      }
    }
    if (certificate.method == ir::prove::Method::Run) {
      auto run = support::traceFromJson(in.at("run").dump(), name);
      if (!run) {
        throw run.error().message;
      }
      certificate.run = std::move(*run);
    }
    return certificate;
  }

 private:
  static ir::prove::Method methodOf(const std::string& text) {
    const auto found = std::ranges::find_if(
        kMethods, [&](ir::prove::Method method) { return text == ir::prove::word(method); });
    if (found == kMethods.end()) {
      throw fmt::format("there is no method `{}`", text);
    }
    return *found;
  }

  [[nodiscard]] ir::StateId state(const json& in) const {
    const auto name = in.get<std::string>();
    const auto found = std::ranges::find(m_.states, name, &ir::State::name);
    if (found == m_.states.end()) {
      throw fmt::format("the mission has no state `{}`", name);
    }
    return {static_cast<uint32_t>(found - m_.states.begin())};
  }

  [[nodiscard]] std::vector<uint32_t> assumptions(const json& in) const {
    std::vector<uint32_t> numbers;
    for (const json& one : in) {
      const auto words = one.get<std::string>();
      const auto found = std::ranges::find(m_.assumptions, words, &ir::Assumption::words);
      if (found == m_.assumptions.end()) {
        throw fmt::format("the mission does not assume `{}`", words);
      }
      numbers.push_back(static_cast<uint32_t>(found - m_.assumptions.begin()));
    }
    return numbers;
  }

  static uint32_t limit(const json& in) {
    return in.is_null() ? ir::certify::kNoLimit : in.get<uint32_t>();
  }

  [[nodiscard]] ir::certify::Invariant invariant(const json& in) const {
    ir::certify::Invariant one;
    one.at.state = state(in.at("state"));
    for (const json& waiting : in.at("stack")) {
      one.at.stack.push_back({state(waiting.at("state")), limit(waiting.at("limit"))});
    }
    one.at.limit = limit(in.at("limit"));
    one.at.just_returned = in.at("justReturned").get<bool>();
    one.formula = in.at("formula").get<std::string>();
    return one;
  }

  const ir::Mission& m_;
  const std::string& subject_;
};

}  // namespace

Result<std::string> subjectOf(const Checked& checked) {
  const auto subject = proofSubject(checked);
  return subject ? Result<std::string>(codegen::digestOf(*subject))
                 : std::unexpected(subject.error());
}

std::filesystem::path certificatePath(const std::filesystem::path& folder, uint32_t requirement) {
  return folder / fmt::format("requirement-{}.json", requirement + 1);
}

Certificate certificateOf(const Checked& checked, const ir::prove::RequirementVerdict& verdict,
                          std::string subject) {
  const auto range = checked.mission().requirements[verdict.requirement].range;
  return {support::onOneLine(checked.sources().text(range)),
          std::move(subject),
          verdict.evidence->method,
          verdict.assumptions,
          verdict.evidence->invariants,
          std::nullopt};
}

std::string certificateToJson(const Certificate& certificate, const ir::Mission& mission) {
  json invariants = json::array();
  for (const auto& invariant : certificate.invariants) {
    invariants.push_back(invariantToJson(invariant, mission));
  }
  json assumptions = json::array();
  for (const uint32_t number : certificate.assumptions) {
    assumptions.push_back(mission.assumptions.at(number).words);
  }
  json out = {{"glidercc certificate", kVersion}, {"requirement", certificate.requirement},
              {"subject", certificate.subject},   {"method", ir::prove::word(certificate.method)},
              {"assumptions", assumptions},       {"invariants", invariants}};
  if (certificate.run) {
    out["run"] = json::parse(support::traceToJson(*certificate.run));
  }
  return out.dump(1) + "\n";
}

Result<Certificate> certificateFromJson(const std::string& text, const std::string& name,
                                        const Checked& checked) {
  const auto subject = subjectOf(checked);
  if (!subject) {
    return std::unexpected(subject.error());
  }
  const auto wrong = [&](const std::string& what) {
    return support::fail(support::diagnostics::noCertificate, name, what);
  };
  const json in = json::parse(text, nullptr, false);
  if (in.is_discarded()) {
    return wrong("it is not JSON");
  }
  try {
    return Reader(checked.mission(), *subject).read(in, name);
  } catch (const json::exception&) {
    return wrong("a field is missing or has another type");
  } catch (const std::string& what) {
    return wrong(what);
  }
}

}  // namespace glider::compiler
