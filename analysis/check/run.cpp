// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/check/run.h"

#include <utility>

namespace glider::analysis::check {

const compiler::Optimised& Run::optimised() {
  if (!optimised_) {
    optimised_ = compiler::optimise(file.compilation->checked);
  }
  return *optimised_;
}

void Run::remark(std::string line, report::Remark::Subject subject) {
  file.found.remarks.push_back({{}, std::move(line), subject});
}

}  // namespace glider::analysis::check
