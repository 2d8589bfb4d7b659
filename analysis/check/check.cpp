// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/check.h"

#include "analysis/check/run.h"

#include <utility>

namespace glider::analysis {
namespace {

using support::Result;

enum class StepCondition : uint8_t { Always, Report };

struct Step {
  Result<void> (*run)(check::Run&);
  StepCondition when;
};

constexpr Step kSteps[] = {
#define STEP(name, when) {check::name, StepCondition::when},
#include "analysis/check/check_steps.def"
#undef STEP
};

Result<void> runSteps(check::Run& run) {
  for (const Step& step : kSteps) {
    if (step.when == StepCondition::Report && !run.options.report) {
      continue;
    }
    if (auto done = step.run(run); !done) {
      return done;
    }
  }
  return {};
}

void tellFacts(const compiler::Checked& checked, report::CheckedMission& found) {
  const ir::Mission& mission = checked.mission();
  found.mission = mission.name;
  found.states = compiler::stateNames(mission);
  if (checked.facts.stack_depth > 0) {
    for (const ir::StateId id : checked.facts.deepest_path) {
      found.deepest_path.push_back(mission[id].name);
    }
  }
}

}  // namespace

CheckedFile checkMission(const std::string& path, const CheckOptions& options,
                         CheckObserver& observer) {
  observer.at("reading it");
  auto compiled = compiler::compileMission(path);
  if (!compiled) {
    CheckedFile file;
    file.found.path = compiler::shownName(path);
    file.found.failure = compiled.error();
    return file;
  }
  return checkCompilation(compiler::shownName(path), std::move(*compiled), options, observer);
}

CheckedFile checkCompilation(const std::string& name, compiler::Compilation compiled,
                             const CheckOptions& options, CheckObserver& observer) {
  CheckedFile file;
  report::CheckedMission& found = file.found;
  found.path = name;
  file.compilation = std::move(compiled);
  const compiler::Compilation& compilation = *file.compilation;
  found.sources = compilation.sources.get();
  if (compilation.checked) {
    check::Run run(options, observer, file);
    if (auto done = runSteps(run); !done) {
      found.failure = done.error();
    }
  }
  found.diagnostics = compilation.diagnostics.sorted();
  if (compilation.checked && !compilation.diagnostics.hasErrors()) {
    tellFacts(*compilation.checked, found);
  }
  return file;
}

}  // namespace glider::analysis
