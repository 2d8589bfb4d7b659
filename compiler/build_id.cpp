// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/build_id.h"

#include <cstring>
#include <elf.h>
#include <link.h>

namespace glider::compiler {
namespace {

/// The build id among the notes of one segment; empty if there is none.
std::string idAmong(const char* notes, size_t size) {
  const auto padded = [](size_t bytes) { return (bytes + 3) / 4 * 4; };
  size_t at = 0;
  while (at + sizeof(ElfW(Nhdr)) <= size) {
    ElfW(Nhdr) head;
    std::memcpy(&head, notes + at, sizeof head);
    at += sizeof head;
    const size_t content = at + padded(head.n_namesz);
    const bool whole = content + head.n_descsz <= size;
    if (whole && head.n_type == NT_GNU_BUILD_ID && head.n_namesz == sizeof ELF_NOTE_GNU &&
        std::memcmp(notes + at, ELF_NOTE_GNU, sizeof ELF_NOTE_GNU) == 0) {
      return {notes + content, head.n_descsz};
    }
    at = content + padded(head.n_descsz);
  }
  return "";
}

/// The first object is the program itself.
int lookAt(dl_phdr_info* object, size_t /*size*/, void* found) {
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    auto& id = *static_cast<std::string*>(found);
    if (segment.p_type == PT_NOTE && id.empty()) {
      id = idAmong(reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr),
                   segment.p_memsz);
    }
  }
  return 1;
}

}  // namespace

std::string buildId() {
  std::string id;
  dl_iterate_phdr(lookAt, &id);
  return id;
}

}  // namespace glider::compiler
