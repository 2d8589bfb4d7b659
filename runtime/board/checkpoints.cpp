// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/checkpoints.h"

#include "hooks/protocol/crc.h"
#include "runtime/board/files.h"
#include "runtime/board/kernel.h"
#include "runtime/checkpoint/checkpoint.h"

#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

/// The executable's own ELF header, as placed by the linker.
extern "C" __attribute__((visibility("hidden"))) const ElfW(Ehdr) __ehdr_start;

namespace glider::runtime {
namespace {

/// The file of checkpoints.
struct Slots {
  const char* path;
  uint32_t bytes;
  int descriptor;
};

bool openSlots(Slots& slots) {
  slots.descriptor = open(slots.path, O_RDWR | O_CREAT, 0644);
  return slots.descriptor >= 0;
}

/// Allocates the whole file on the card, once. Later writes then do not change any table of the
/// file system, which all files share; and the slots are as far apart on the card as in the file,
/// unlike in a file with holes.
void makeRoom(const Slots& slots) {
  static uint8_t zeros[Checkpoint::kBlock];
  off_t end = lseek(slots.descriptor, 0, SEEK_END);
  const bool grows = end >= 0 && end < static_cast<off_t>(slots.bytes);
  while (end >= 0 && end < static_cast<off_t>(slots.bytes)) {
    const ssize_t put = write(slots.descriptor, zeros, sizeof zeros);
    end = put > 0 ? end + put : put < 0 && errno == EINTR ? end : -1;
  }
  if (grows) {
    (void)fdatasync(slots.descriptor);
  }
}

int descriptorOf(void* self) {
  return static_cast<const Slots*>(self)->descriptor;
}

/// Returns how many bytes `move`, read or write, processed from `offset` on.
template <typename Move, typename Bytes>
int32_t moveAll(Move move, void* self, uint32_t offset, Bytes* bytes, uint32_t count) {
  uint32_t done = 0;
  if (lseek(descriptorOf(self), static_cast<off_t>(offset), SEEK_SET) < 0) {
    return -1;
  }
  while (done < count) {
    const ssize_t moved = move(descriptorOf(self), bytes + done, count - done);
    if (moved <= 0 && !(moved < 0 && errno == EINTR)) {
      break;
    }
    done += moved > 0 ? static_cast<uint32_t>(moved) : 0U;
  }
  return static_cast<int32_t>(done);
}

int32_t readStore(void* self, uint32_t offset, uint8_t* bytes, uint32_t count) {
  return moveAll(read, self, offset, bytes, count);
}

int32_t writeStore(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count) {
  auto& slots = *static_cast<Slots*>(self);
  if (slots.descriptor < 0) {
    if (!openSlots(slots)) {
      return -1;
    }
    makeRoom(slots);
  }
  return moveAll(write, self, offset, bytes, count);
}

int32_t syncStore(void* self) {
  return fdatasync(descriptorOf(self));
}

/// Copies a piece of the executable as it is in memory, including the gaps between its variables,
/// where a sanitizer would reject reads.
[[gnu::no_sanitize_address]] void copyImage(const uint8_t* from, uint8_t* to, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    *static_cast<volatile uint8_t*>(to + i) = from[i];
  }
}

uint32_t checkOf(const uint8_t* bytes, uint32_t count, uint32_t before) {
  uint8_t piece[256];
  for (uint32_t done = 0; done < count; done += sizeof piece) {
    const uint32_t left = count - done < sizeof piece ? count - done : sizeof piece;
    copyImage(bytes + done, piece, left);
    before = hooks::crc32c(piece, left, before);
  }
  return before;
}

}  // namespace

GliderStore openCheckpoints(const char* path, uint32_t context_bytes) {
  static Slots slots;
  if (path == nullptr) {
    return {};
  }
  slots.path = path;
  slots.bytes = Checkpoint::storeBytes(context_bytes);
  if (!openSlots(slots)) {
    tell("warning: cannot keep checkpoints in `", path,
         "`; the mission flies without until it can");
  }
  return {&slots, readStore, writeStore, syncStore};
}

void holdCheckpoints(const GliderStore& checkpoints) {
  while (lockWhole(descriptorOf(checkpoints.self)) != 0 && errno == EINTR) {
  }
  makeRoom(*static_cast<const Slots*>(checkpoints.self));
}

uint32_t programNumber() {
  const auto* image = reinterpret_cast<const uint8_t*>(&__ehdr_start);
  const auto* segments = reinterpret_cast<const ElfW(Phdr)*>(image + __ehdr_start.e_phoff);
  uint32_t number = 0;
  // The lowest address that the executable was linked for is where its ELF header is now.
  const ElfW(Phdr)* first = nullptr;
  for (uint32_t i = 0; i < __ehdr_start.e_phnum; ++i) {
    const ElfW(Phdr)& segment = segments[i];
    if (segment.p_type != PT_LOAD) {
      continue;
    }
    first = first == nullptr ? &segment : first;
    if ((segment.p_flags & PF_W) == 0) {
      number = checkOf(image + (segment.p_vaddr - first->p_vaddr),
                       static_cast<uint32_t>(segment.p_filesz), number);
    }
  }
  return number;
}

}  // namespace glider::runtime
