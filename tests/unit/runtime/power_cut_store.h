// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

#include <algorithm>
#include <functional>
#include <vector>

/// A file of checkpoints under test: it keeps what was written to it and when it was synced, and
/// makes of that every file that a power cut could have left.
namespace glider::runtime::testing {

using Bytes = std::vector<uint8_t>;

struct RecordedWrite {
  uint32_t offset = 0;
  Bytes bytes;          ///< empty: a sync
  size_t answered = 0;  ///< what `mark` said when it was made
};

class RecordingStore {
 public:
  Bytes content;
  std::vector<RecordedWrite> log;
  bool fails = false;  ///< as a card with an I/O error
  std::function<size_t()> mark = [] { return size_t{0}; };

  GliderStore store() { return {this, read, write, sync}; }

  static void apply(Bytes& file, uint32_t offset, const uint8_t* bytes, size_t count) {
    file.resize(std::max(file.size(), offset + count));
    std::copy(bytes, bytes + count, file.begin() + offset);
  }

 private:
  static int32_t read(void* self, uint32_t offset, uint8_t* bytes, uint32_t count) {
    const Bytes& file = static_cast<RecordingStore*>(self)->content;
    const size_t from = std::min<size_t>(offset, file.size());
    const size_t taken = std::min<size_t>(count, file.size() - from);
    std::copy_n(file.begin() + static_cast<ptrdiff_t>(from), taken, bytes);
    return static_cast<int32_t>(taken);
  }
  static int32_t write(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count) {
    auto& store = *static_cast<RecordingStore*>(self);
    if (store.fails) {
      return -1;
    }
    apply(store.content, offset, bytes, count);
    store.log.push_back({offset, Bytes(bytes, bytes + count), store.mark()});
    return static_cast<int32_t>(count);
  }
  static int32_t sync(void* self) {
    auto& store = *static_cast<RecordingStore*>(self);
    store.log.push_back({0, {}, store.mark()});
    return store.fails ? -1 : 0;
  }
};

/// Calls `visit` with each file that a power cut after the first `made` entries of `log` may leave:
/// what was synced is there; of the writes since, any may be missing, and any may be torn anywhere
/// at a sector's border, in whatever order the card took them.
inline void eachFileAfterCut(const std::vector<RecordedWrite>& log, size_t made,
                             const std::function<void(const Bytes&)>& visit) {
  constexpr size_t kSector = 512;
  size_t synced = made;
  while (synced > 0 && !log[synced - 1].bytes.empty()) {
    --synced;
  }
  Bytes safe;
  for (size_t i = 0; i < synced; ++i) {
    RecordingStore::apply(safe, log[i].offset, log[i].bytes.data(), log[i].bytes.size());
  }
  // Of each unsynced write: nothing, a head, a tail, or all of it.
  struct Piece {
    size_t from, to;
  };
  std::vector<std::vector<Piece>> choices;
  for (size_t i = synced; i < made; ++i) {
    const size_t size = log[i].bytes.size();
    std::vector<Piece> pieces{{0, 0}, {0, size}, {0, 7}, {size - 7, size}};
    for (size_t cut = kSector - log[i].offset % kSector; cut < size; cut += kSector) {
      pieces.push_back({0, cut});
      pieces.push_back({cut, size});
    }
    choices.push_back(std::move(pieces));
  }
  std::vector<size_t> chosen(choices.size(), 0);
  while (true) {
    Bytes file = safe;
    for (size_t i = 0; i < choices.size(); ++i) {
      const RecordedWrite& write = log[synced + i];
      const Piece piece = choices[i][chosen[i]];
      if (piece.to > piece.from) {
        RecordingStore::apply(file, write.offset + static_cast<uint32_t>(piece.from),
                              write.bytes.data() + piece.from, piece.to - piece.from);
      }
    }
    visit(file);
    size_t i = 0;
    for (; i < chosen.size() && ++chosen[i] == choices[i].size(); ++i) {
      chosen[i] = 0;
    }
    if (i == chosen.size()) {
      return;
    }
  }
}

}  // namespace glider::runtime::testing
