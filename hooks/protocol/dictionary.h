// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_HOOKS_PROTOCOL_DICTIONARY_H
#define GLIDER_HOOKS_PROTOCOL_DICTIONARY_H

/* Which sensors a vehicle has. Plain C: handed by pointer to the hooks when the vehicle's software
   starts, and to the runtime with the mission. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GLIDER_NO_SENSOR UINT32_MAX
/* hookprog keeps the newest value of each in static memory. */
#define GLIDER_MOST_SENSORS 512u

/* What a sensor is for: roles.def. */
typedef enum GliderRole {
#define ROLE(role, sensor, need) kGliderRole##role,
#include "hooks/protocol/roles.def"
#undef ROLE
  kGliderRoleCount
} GliderRole;

#define GLIDER_DICTIONARY_U32 uint32_t
#define GLIDER_DICTIONARY_F64 double
#define GLIDER_DICTIONARY_PTR(pointee) pointee*
#define STRUCT(name) typedef struct name {
#define FIELD(type, name) GLIDER_DICTIONARY_##type name;
#define STRUCT_END(name) \
  }                      \
  name;
#include "hooks/protocol/dictionary.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END

#ifdef __cplusplus
}
#endif

#endif
