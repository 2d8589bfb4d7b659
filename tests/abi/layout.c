// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/* What C makes of every ABI struct, as numbers in the section "layout.STRUCT" of an object file:
   size, alignment, then the offset of each field. */

#include "runtime/abi/glider_abi.h"

#include <stddef.h>

#define STRUCT(name)                                                                    \
  void layoutOf##name(void);                                                            \
  void layoutOf##name(void) {                                                           \
    typedef name Struct;                                                                \
    __attribute__((used, section("layout." #name))) static const uint32_t numbers[] = { \
      sizeof(Struct), _Alignof(Struct),
#define FIELD(type, name) offsetof(Struct, name),
#define STRUCT_END(name) \
  }                      \
  ;                      \
  }
#include "hooks/protocol/dictionary.def"
#include "runtime/abi/abi_structs.def"
