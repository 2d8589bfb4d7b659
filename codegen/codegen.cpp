// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/codegen.h"

#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <algorithm>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

constexpr const Backend* kBackends[] = {
#define BACKEND(name) &name,
#include "codegen/backends.def"
#undef BACKEND
};

/// The function `part` of the first back end that serves the board and has it. GL4002 if none does.
template <typename Function>
Result<Function*> findPart(Function* Backend::* part, const Board& board) {
  for (const Backend* backend : kBackends) {
    if (backend->*part != nullptr && backend->serves(board)) {
      return backend->*part;
    }
  }
  return support::fail(support::diagnostics::unsupportedMachine, board.name, board.triple,
                       board.cpu);
}

}  // namespace

std::vector<const Product*> products() {
  std::vector<const Product*> all;
  for (const Backend* backend : kBackends) {
    for (const Product& product : backend->products) {
      if (std::ranges::none_of(all, [&](const Product* p) { return p->name == product.name; })) {
        all.push_back(&product);
      }
    }
  }
  return all;
}

const Product* findProduct(std::string_view name, const Board& board) {
  for (const Backend* backend : kBackends) {
    const auto found = std::ranges::find(backend->products, name, &Product::name);
    if (found != backend->products.end() && backend->serves(board)) {
      return &*found;
    }
  }
  return nullptr;
}

Result<void> writeProduct(const Product& product, const Input& input, const Board& board,
                          const CodegenOptions& options, const std::filesystem::path& output) {
  if (product.write != nullptr) {
    return product.write(input, board, options, output);
  }
  const auto content = product.make(input, board, options);
  return content ? support::writeFileAtomically(output, *content, support::FileKind::Product)
                 : std::unexpected(content.error());
}

Result<void> linkExecutable(const Input& input, const Board& board, const CodegenOptions& options,
                            const std::filesystem::path& output) {
  const auto link = findPart(&Backend::link_executable, board);
  return link ? (*link)(input, board, options, output) : std::unexpected(link.error());
}

Result<std::string> linkShared(const Input& input, const Board& host,
                               const CodegenOptions& options) {
  const auto link = findPart(&Backend::link_shared, host);
  return link ? (*link)(input, host, options) : std::unexpected(link.error());
}

Result<Budget> measureBudget(const Input& input, const Board& board,
                             const CodegenOptions& options) {
  const auto measure = findPart(&Backend::measure, board);
  return measure ? (*measure)(input, board, options) : std::unexpected(measure.error());
}

}  // namespace glider::codegen
