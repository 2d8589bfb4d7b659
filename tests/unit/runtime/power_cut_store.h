// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

/// A file of checkpoints under test: it keeps what was written to it and when it was synced, and
/// makes of that every file that a power cut could have left.
namespace glider::runtime::testing {

using Bytes = std::vector<uint8_t>;

/// A file of which most was never written: that reads 0.
class SparseFile {
 public:
  static constexpr uint32_t kBlock = 4096;

  void write(uint32_t offset, const uint8_t* bytes, size_t count) {
    size_ = std::max<size_t>(size_, offset + count);
    eachPart(offset, count, [&](uint32_t number, uint32_t from, size_t done, size_t part) {
      Bytes& block = blocks_.try_emplace(number, kBlock, uint8_t{0}).first->second;
      std::copy_n(bytes + done, part, block.begin() + from);
    });
  }
  size_t read(uint32_t offset, uint8_t* bytes, size_t count) const {
    const size_t taken = offset >= size_ ? 0 : std::min<size_t>(count, size_ - offset);
    eachPart(offset, taken, [&](uint32_t number, uint32_t from, size_t done, size_t part) {
      const auto block = blocks_.find(number);
      if (block == blocks_.end()) {
        std::fill_n(bytes + done, part, uint8_t{0});
      } else {
        std::copy_n(block->second.begin() + from, part, bytes + done);
      }
    });
    return taken;
  }
  [[nodiscard]] size_t size() const { return size_; }
  void clear() {
    blocks_.clear();
    size_ = 0;
  }
  void truncate(size_t size) { size_ = std::min(size, size_); }
  /// Calls `visit` with each byte that was written, and where it stands.
  template <typename Visit>
  void eachByte(Visit visit) {
    for (auto& [number, block] : blocks_) {
      for (uint32_t i = 0; i < kBlock; ++i) {
        visit(number * kBlock + i, block[i]);
      }
    }
  }

 private:
  /// Calls `visit` for each block of so many bytes: its number, where in it they begin, how many
  /// there were before and are.
  template <typename Visit>
  static void eachPart(uint32_t offset, size_t count, Visit visit) {
    for (size_t done = 0; done < count;) {
      const auto place = offset + static_cast<uint32_t>(done);
      const uint32_t from = place % kBlock;
      const size_t part = std::min<size_t>(count - done, kBlock - from);
      visit(place / kBlock, from, done, part);
      done += part;
    }
  }

  std::map<uint32_t, Bytes> blocks_;
  size_t size_ = 0;
};

struct RecordedWrite {
  uint32_t offset = 0;
  Bytes bytes;          ///< empty: a sync
  size_t answered = 0;  ///< what `mark` said when it was made
};

class RecordingStore {
 public:
  SparseFile content;
  std::vector<RecordedWrite> log;
  bool fails = false;  ///< as a card with an I/O error
  std::function<size_t()> mark = [] { return size_t{0}; };

  GliderStore store() { return {this, read, write, sync}; }

 private:
  static int32_t read(void* self, uint32_t offset, uint8_t* bytes, uint32_t count) {
    return static_cast<int32_t>(
        static_cast<RecordingStore*>(self)->content.read(offset, bytes, count));
  }
  static int32_t write(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count) {
    auto& store = *static_cast<RecordingStore*>(self);
    if (store.fails) {
      return -1;
    }
    store.content.write(offset, bytes, count);
    store.log.push_back({offset, Bytes(bytes, bytes + count), store.mark()});
    return static_cast<int32_t>(count);
  }
  static int32_t sync(void* self) {
    auto& store = *static_cast<RecordingStore*>(self);
    store.log.push_back({0, {}, store.mark()});
    return store.fails ? -1 : 0;
  }
};

inline SparseFile fileAfter(const std::vector<RecordedWrite>& log, size_t made) {
  SparseFile file;
  for (size_t i = 0; i < made; ++i) {
    file.write(log[i].offset, log[i].bytes.data(), log[i].bytes.size());
  }
  return file;
}

/// A block of a card that is erased and written as one.
struct EraseBlock {
  uint32_t bytes;
  uint32_t phase;  ///< of the file's first byte in its block
  [[nodiscard]] uint32_t of(uint32_t offset) const { return (offset + phase) / bytes; }
};

/// What the card leaves of a block when its power goes while it is rewritten.
enum class Leaves { Zeros, Ones, Noise };

inline SparseFile withoutBlock(SparseFile file, const EraseBlock& blocks, uint32_t number,
                               Leaves leaves) {
  uint32_t noise = 1;
  file.eachByte([&](uint32_t place, uint8_t& byte) {
    noise = noise * 1664525U + 1013904223U;
    if (blocks.of(place) == number) {
      byte = leaves == Leaves::Zeros  ? uint8_t{0}
             : leaves == Leaves::Ones ? uint8_t{255}
                                      : static_cast<uint8_t>(noise >> 24U);
    }
  });
  return file;
}

/// Calls `visit` with each file that a power cut after the first `made` entries of `log` may leave:
/// what was synced is there; of the writes since, any may be missing, and any may be torn anywhere
/// at a sector's border, in any order in which the card took them.
inline void eachFileAfterCut(const std::vector<RecordedWrite>& log, size_t made,
                             const std::function<void(const SparseFile&)>& visit) {
  constexpr size_t kSector = 512;
  size_t synced = made;
  while (synced > 0 && !log[synced - 1].bytes.empty()) {
    --synced;
  }
  const SparseFile safe = fileAfter(log, synced);
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
    SparseFile file = safe;
    for (size_t i = 0; i < choices.size(); ++i) {
      const RecordedWrite& write = log[synced + i];
      const Piece piece = choices[i][chosen[i]];
      if (piece.to > piece.from) {
        file.write(write.offset + static_cast<uint32_t>(piece.from),
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
