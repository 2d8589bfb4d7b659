// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/obligations.h"
#include "ir/certify/step.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace glider::ir::certify {

/// Whether cvc5 is installed.
bool haveCvc5();

/// cvc5's answers to a script, one for each check-sat; "(error …" where it does not understand it.
std::vector<std::string> answersTo(const std::string& script);

/// The obligations that are not shown; empty: the certificate is accepted.
std::vector<std::string> refused(const std::vector<Script>& scripts);

/// The mission of this text in the language, with its requirements.
Mission compiled(const std::string& text);

/// All configurations that its states' and lists' transitions lead to, by the rules alone.
std::vector<Configuration> configurationsOf(const Mission& mission);

/// An invariant for each configuration in which `formula`, given its words, is not empty.
using Formula = std::function<std::string(const std::string& words)>;
std::vector<Invariant> invariantsOf(const Mission& mission, const Formula& formula);

/// The obligations of the first requirement of `mission` that are refused.
std::vector<std::string> judged(const Mission& mission, const Formula& formula);

#define NEEDS_CVC5()                         \
  if (!haveCvc5()) {                         \
    GTEST_SKIP() << "cvc5 is not installed"; \
  }                                          \
  static_assert(true)

}  // namespace glider::ir::certify
