// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/campaign_boards.h"

#include "codegen/scratch_folder.h"
#include "compiler/boards.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <sstream>
#include <unistd.h>

namespace glider::campaign {

using codegen::ScratchFolder;
using simulator::SbcPort;
using simulator::StartSbc;
using support::Result;

namespace {

/// True if `program` is found by PATH.
bool isHere(const std::string& program) {
  if (program.find('/') != std::string::npos) {
    return ::access(program.c_str(), X_OK) == 0;
  }
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

/// A mission's binary for a board, built once however many threads need it.
class Binary {
 public:
  Binary(std::shared_ptr<const compiler::Optimised> mission, flights::LaunchChoice launch,
         std::vector<std::string> user_code, std::string board)
      : mission_(std::move(mission)),
        launch_(std::move(launch)),
        user_code_(std::move(user_code)),
        board_(std::move(board)) {}

  /// Starts it with what it keeps in `folder`.
  Result<StartSbc> startIn(const std::filesystem::path& folder) {
    // The code generator does not support several threads.
    static std::mutex building;
    const std::scoped_lock lock(building);
    if (command_.empty()) {
      auto made = ScratchFolder::make();
      if (!made) {
        return std::unexpected(made.error());
      }
      folder_.emplace(std::move(*made));
      auto end = flights::usualEnd(mission_->platform());
      if (!end) {
        return std::unexpected(end.error());
      }
      port_ = *end;
      auto built = flights::buildOnBoard(*mission_, launch_, user_code_, board_,
                                         folder_->path() / mission_->mission.name, port_);
      if (!built) {
        return std::unexpected(built.error());
      }
      command_ = std::move(*built);
    }
    constexpr double kHangSecs = 120;  // the machine is busy, and a verdict must not depend on it
    return flights::startOnBoard(board_, command_, launch_, folder, mission_->mission.name,
                                 kHangSecs, port_);
  }

 private:
  std::shared_ptr<const compiler::Optimised> mission_;
  flights::LaunchChoice launch_;
  std::optional<flights::PortEnd> port_;
  std::vector<std::string> user_code_;
  std::string board_;
  std::optional<ScratchFolder> folder_;
  std::vector<std::string> command_;
};

/// Returns what starts the SBC of one flight, again each time that its power returns.
StartSbc oneFlight(const std::shared_ptr<Binary>& binary) {
  struct Card {
    std::optional<ScratchFolder> folder;
    StartSbc start;
  };
  return [binary, card = std::make_shared<Card>()]() -> Result<std::unique_ptr<SbcPort>> {
    if (!card->start) {
      auto folder = ScratchFolder::make();
      if (!folder) {
        return std::unexpected(folder.error());
      }
      card->folder.emplace(std::move(*folder));
      auto start = binary->startIn(card->folder->path());
      if (!start) {
        return std::unexpected(start.error());
      }
      card->start = std::move(*start);
    }
    return card->start();
  };
}

}  // namespace

std::vector<std::string> boardsHere(std::vector<std::string>& missing) {
  std::vector<std::string> boards;
  for (const std::string& name : compiler::targetNames()) {
    const auto board = compiler::loadTarget(name);
    if (!board || board->emulator.empty()) {
      continue;  // the host: its flights fly in this process
    }
    if (isHere(board->emulator.front())) {
      boards.push_back(name);
    } else {
      missing.push_back(
          fmt::format("`{}`, which runs the binaries of {}", board->emulator.front(), name));
    }
  }
  return boards;
}

flights::NewFlight flightsOnBoard(std::shared_ptr<const compiler::Optimised> mission,
                                  const flights::LaunchChoice& launch,
                                  const std::vector<std::string>& user_code,
                                  const std::string& board) {
  return [binary = std::make_shared<Binary>(std::move(mission), launch, user_code, board)] {
    return oneFlight(binary);
  };
}

}  // namespace glider::campaign
