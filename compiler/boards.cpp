// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/boards.h"

#include "compiler/share.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/target.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace glider::compiler {

std::vector<std::string> targetNames() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry :
       std::filesystem::directory_iterator(shareDirectory() / "boards", ignored)) {
    if (std::filesystem::exists(entry.path() / "board.toml", ignored)) {
      names.push_back(entry.path().filename().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::filesystem::path boardDirectory(const std::string& target) {
  return shareDirectory() / "boards" / target;
}

support::Result<platforms::Board> loadTarget(const std::string& name) {
  const std::vector<std::string> names = targetNames();
  if (std::ranges::find(names, name) == names.end()) {
    auto failure = support::fail(support::diagnostics::unknownTarget, name, fmt::join(names, ", "));
    if (const auto near = frontend::closest(name, {names.begin(), names.end()}); !near.empty()) {
      failure.error().hint = fmt::format("did you mean `{}`?", near);
    }
    return failure;
  }
  return platforms::loadBoard(boardDirectory(name) / "board.toml");
}

support::Result<std::optional<platforms::Board>> usualBoard(const platforms::Platform& platform) {
  if (platform.power.board.empty()) {
    return std::nullopt;
  }
  auto board = loadTarget(platform.power.board);
  return board ? support::Result<std::optional<platforms::Board>>(*std::move(board))
               : std::unexpected(board.error());
}

support::Result<std::optional<platforms::BoardPower>> usualBoardPower(
    const platforms::Platform& platform) {
  auto board = usualBoard(platform);
  if (!board) {
    return std::unexpected(board.error());
  }
  return *board ? (*board)->power : std::nullopt;
}

}  // namespace glider::compiler
