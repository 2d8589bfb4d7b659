// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_GLIDER_ABI_H
#define GLIDER_RUNTIME_ABI_GLIDER_ABI_H

/* The plain C contract between generated missions, behaviours written in C or C++, and the runtime.
 */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GLIDER_ABI_VERSION 1u
#define GLIDER_NO_CASE UINT32_MAX
/* What a behaviour may keep from tick to tick in each state that uses it. */
#define GLIDER_BEHAVIOUR_MEMORY_BYTES 1024u

typedef enum GliderTransition {
  kGliderGoto,
  kGliderCall,
  kGliderReturn,
  kGliderExit,
  kGliderStay
} GliderTransition;

typedef enum GliderEncoding { kGliderLinear, kGliderDegreesMinutes } GliderEncoding;

/* Why a behaviour runs: its state was entered by goto or call, resumed by return, or stays current.
 */
typedef enum GliderPhase { kGliderEnter, kGliderResume, kGliderTick } GliderPhase;

typedef enum GliderVertical {
  kGliderNoVertical,
  kGliderDescend, /* to depth at pitch (negative), pump in; does not level off */
  kGliderAscend,  /* to depth at pitch (positive), pump out; does not level off */
  kGliderHover,   /* at depth */
  kGliderSurface  /* climb to the surface and stay */
} GliderVertical;

typedef enum GliderLateral {
  kGliderDrift,   /* no heading wanted: fin centred */
  kGliderHeading, /* heading */
  kGliderWaypoint /* latitude, longitude */
} GliderLateral;

typedef struct GliderContext GliderContext;
typedef struct GliderMission GliderMission;

typedef union GliderBehaviourMemory {
  uint8_t bytes[GLIDER_BEHAVIOUR_MEMORY_BYTES];
  double align;
} GliderBehaviourMemory;

/* The number of the current state's first case whose guard is true, or GLIDER_NO_CASE. */
typedef uint32_t(GliderGuards)(const GliderContext* context);
/* Runs the current state's profile, then its route, with their arguments evaluated now. */
typedef void(GliderFly)(GliderContext* context, uint32_t phase);
/* The value of log item `item` of the current state, SI units; NaN: unknown. */
typedef double(GliderLogValue)(const GliderContext* context, uint32_t item);

#define GLIDER_ABI_U32 uint32_t
#define GLIDER_ABI_F64 double
#define GLIDER_ABI_PTR(pointee) pointee*
#define STRUCT(name) typedef struct name {
#define FIELD(type, name) GLIDER_ABI_##type name;
#define STRUCT_END(name) \
  }                      \
  name;
#include "runtime/abi/abi_structs.def"
#undef STRUCT
#undef FIELD
#undef STRUCT_END

/* What generated code defines: the mission, and in an executable for a board also the memory of its
   one context, gliderMission.context_bytes long and aligned for a double. */
extern const GliderMission gliderMission;
extern uint8_t gliderContextMemory[];

/* The smallest and largest finite magnitude rule of ir/README.md, used wherever the runtime
 * computes a reading. */
double gliderSettle(double value);

#ifdef __cplusplus
}
#endif

#endif
