// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/parts.h"

#include "codegen/llvm/program/work.h"

#include <algorithm>
#include <functional>

namespace glider::codegen {
namespace {

// A part costs about as much as a small state, for any content.
constexpr size_t kFewestStates = 2;  ///< of a mission in parts
constexpr size_t kManyStates = 64;

size_t countOf(size_t states) {
  if (states < kFewestStates) {
    return 1;
  }
  return states < kManyStates ? 2 : 8;
}

/// A unit that is never split between parts.
struct Piece {
  uint32_t state = 0;
  bool profile = false;  ///< the ticks of its profile, or everything else of the state
  size_t work = 0;
};

std::vector<Piece> piecesOf(const ir::Mission& mission) {
  std::vector<Piece> pieces;
  for (uint32_t i = 0; i < mission.states.size(); ++i) {
    pieces.push_back({i, true, workOfProfileTick(mission, i)});
    pieces.push_back({i, false, workOfState(mission, i)});
  }
  std::ranges::stable_sort(pieces, std::greater{}, &Piece::work);
  return pieces;
}

}  // namespace

std::vector<MissionPart> partsOf(const ir::Mission& mission) {
  std::vector<MissionPart> parts(countOf(mission.states.size()), {false, {}, {}});
  parts.front().head = true;
  std::vector<size_t> work(parts.size());
  for (const Piece& piece : piecesOf(mission)) {
    const auto least = static_cast<size_t>(std::ranges::min_element(work) - work.begin());
    (piece.profile ? parts[least].profiles : parts[least].states).push_back(piece.state);
    work[least] += piece.work;
  }
  return parts;
}

}  // namespace glider::codegen
