// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/reprove.h"

#include "ir/certify/obligations.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <z3++.h>

namespace glider::ir::prove {
namespace {

bool holds(const certify::Script& script, unsigned effort) {
  z3::context context;
  const std::string text = fmt::format("(set-option :rlimit {})\n{}", effort, script.text);
  std::istringstream answers(Z3_eval_smtlib2_string(context, text.c_str()));
  size_t met = 0;
  for (std::string line; std::getline(answers, line); ++met) {
    if (line != "unsat") {
      return false;
    }
  }
  return met == script.obligations.size();
}

}  // namespace

bool reproves(const Mission& mission, const platforms::Platform& platform, uint32_t requirement,
              const EarlierProof& proof, unsigned effort) {
  const std::vector<certify::Script> scripts = certify::obligationsUnder(
      mission, platform, requirement, proof.assumptions, proof.invariants);
  try {
    return std::ranges::all_of(
        scripts, [&](const certify::Script& script) { return holds(script, effort); });
  } catch (const z3::exception&) {
    return false;
  }
}

}  // namespace glider::ir::prove
