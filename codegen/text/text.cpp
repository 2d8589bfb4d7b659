// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The back end whose products are texts about the mission, the same for every board.

#include "codegen/backend.h"
#include "ir/text/c_header.h"
#include "ir/text/print.h"

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

bool servesAll(const Board&) {
  return true;
}

/// The mission with its requirements if no pass is to run.
Result<std::string> makeIr(const Input& input, const Board&, const CodegenOptions& options) {
  const bool as_written = options.optimisation_level == 0 && input.written != nullptr;
  return ir::print(as_written ? *input.written : input.mission);
}

Result<std::string> makeHeader(const Input& input, const Board&, const CodegenOptions&) {
  return ir::printHeader(input.in_c != nullptr ? *input.in_c : ir::usedInC(input.mission),
                         input.mission.name);
}

constexpr Product kTextProducts[] = {
    {.name = "ir", .suffix = ".ir", .make = makeIr},
    {.name = "header", .suffix = ".h", .note = "C declarations of the mission", .make = makeHeader},
};

}  // namespace

constinit const Backend textBackend{.serves = servesAll, .products = kTextProducts};

}  // namespace glider::codegen
