// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_ABI_GLIDER_ABI_H
#define GLIDER_RUNTIME_ABI_GLIDER_ABI_H

/* The plain C contract between generated missions, behaviours written in C or C++, and the runtime.
 */

#include "hooks/protocol/dictionary.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GLIDER_ABI_VERSION 12u
/* Gives a function declared in C the symbol that a mission looks for; ir/core/c_symbols.h says how
   the symbol encodes the function's types. */
#define GLIDER_SYMBOL(name) __asm__(name)
#define GLIDER_NO_CASE UINT32_MAX
/* What the vehicle's modem receives of others is numbered from here on, and the SBC's own sensors
 * from there on. */
#define GLIDER_FIRST_HEARD_SENSOR 0xFE00u
#define GLIDER_FIRST_OWN_SENSOR 0xFF00u
#define GLIDER_NO_LIST UINT32_MAX
#define GLIDER_NO_LIMIT UINT32_MAX
#define GLIDER_MOST_PARAMETERS 64u
/* 2000-01-01, in seconds since 1970: a parameter of type time whose default is this or later is a
 * time of the calendar. No duration of a mission is 30 years. */
#define GLIDER_FIRST_DATE 946684800.0
#define GLIDER_MOST_NOTES 16u
#define GLIDER_MOST_WAKES 32u
#define GLIDER_GUARD_STRIDE 16u
#define GLIDER_MOST_NOTE_VALUES 64u
/* What a behaviour may keep from tick to tick in each state that uses it. */
#define GLIDER_BEHAVIOUR_MEMORY_BYTES 8192u

typedef enum GliderTransition {
#define TRANSITION(name, number, word) kGlider##name = number,
#include "hooks/protocol/notices.def"
} GliderTransition;

/* The lists of cases that a tick tries. */
typedef enum GliderList {
#define CASE_LIST(name, number, word) kGliderList##name = number,
#include "hooks/protocol/notices.def"
} GliderList;

typedef enum GliderNoteKind {
#define NOTE_KIND(name, number, meaning) kGliderNote##name = number,
#include "hooks/protocol/notices.def"
} GliderNoteKind;

typedef enum GliderEncoding {
  kGliderLinear,
  kGliderDegreesMinutes,
  kGliderMagnetic /* linear; a heading, magnetic on the vehicle, true after
                     GliderConvertHeadings */
} GliderEncoding;

/* What a state may log, and what a table of guards reads. */
typedef enum GliderSource {
  kGliderSensor,
  kGliderMissionTime,
  kGliderStateTime,
  kGliderResumeTime
} GliderSource;

/* Why a behaviour runs: its state was entered by goto or call, resumed by return, or stays current.
 */
typedef enum GliderPhase { kGliderEnter, kGliderResume, kGliderTick } GliderPhase;

typedef enum GliderVertical {
  kGliderNoVertical,
  kGliderDescend,  /* to depth at pitch (negative), pump in; does not level off */
  kGliderAscend,   /* to depth at pitch (positive), pump out; does not level off */
  kGliderHover,    /* at depth */
  kGliderSurface,  /* climb to the surface and stay */
  kGliderActuators /* pump and pitch battery at fixed positions, which take the places of depth and
                      pitch */
} GliderVertical;

typedef enum GliderLateral {
  kGliderDrift,    /* no heading commanded: fin centred */
  kGliderHeading,  /* heading */
  kGliderWaypoint, /* latitude, longitude */
  kGliderFin       /* the fin at a fixed angle, which takes the place of the heading */
} GliderLateral;

typedef struct GliderContext GliderContext;
typedef struct GliderMission GliderMission;
typedef struct GliderUpdate GliderUpdate;
typedef struct GliderNap GliderNap;

typedef union GliderBehaviourMemory {
  uint8_t bytes[GLIDER_BEHAVIOUR_MEMORY_BYTES];
  double align;
} GliderBehaviourMemory;

/* What the generated code of a mission does; ir/README.md says when. A state's functions are called
   while it is current. One that would do nothing is NULL: guards then answer GLIDER_NO_CASE.

   Begin: gives the mission's variables (not the parameters, which are already set) their
   initial values and starts the temporals of `always`.
   Advance: advances the temporals of `always`, or of the state.
   Guards: the number of the first case, from number `from` on, of `always` or of the state whose
   guard is true, or GLIDER_NO_CASE.
   Act: runs the `do` block of that case, then gives the arguments of its transition to the
   parameters of its target.
   Enter: phase enter or resume of the state; the context's fields are set already: variables,
   temporals, entries, C functions.
   Fly: tries the state's profile or route: fires a case and runs its `do` block, or calls the C
   function with phase tick; returns the case that fired or GLIDER_NO_CASE.
   Condition: the number of the first `where` that the parameters do not satisfy (unknown included),
   or GLIDER_NO_CASE. */
typedef void(GliderBegin)(GliderContext* context);
typedef void(GliderAdvance)(GliderContext* context);
typedef uint32_t(GliderGuards)(GliderContext* context, uint32_t from);
typedef void(GliderAct)(GliderContext* context, uint32_t fired);
typedef void(GliderEnter)(GliderContext* context, uint32_t phase);
typedef uint32_t(GliderFly)(GliderContext* context);
typedef uint32_t(GliderCondition)(const GliderContext* context);
/* A sensor on the SBC, read once per tick: a new reading in SI units; NaN if there is none since
   the last call. `mission_time` is s since the mission got control. */
typedef double(GliderPoll)(double mission_time);
/* The function of a GliderCompass. With a frame, before its tick: stores in `variation` (NaN:
   unknown so far) the value among the updates, if any, and converts the magnetic headings among
   them to true ones. A variation that is not valid is replaced by the last one, and before the
   mission runs the last one is added if there is room (kMostSubscriptions of the protocol): what
   the mission reads is what headings are converted by. Returns the number of updates. With
   `updates` NULL, after each tick: converts the heading in force to magnetic. If the vehicle has
   not reported the variation by then, the mission's `declination` line gives it; without that line
   it is 0, and a note reports this. `context` is that of the running mission, or NULL before it
   runs. */
typedef uint32_t(GliderConvertHeadings)(const GliderMission* mission, GliderContext* context,
                                        double* variation, GliderUpdate* updates, uint32_t count);
/* After a tick of the state: adds to `nap` what can make the next ticks do anything else than this
   one did (ir/naps), or that this is not known. */
typedef void(GliderForesee)(GliderContext* context, GliderNap* nap);
/* After each tick, before its answer: adds a sleep to that if there may be one. The runtime's own
   NapMemory and NapTick (runtime/core/nap_tick.h). */
typedef void(GliderNapTick)(void* memory, const void* tick);
/* 1 if the guard of case `number` of a list is true. */
typedef uint32_t(GliderHolds)(const GliderContext* context, uint32_t number);

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

/* The value of log item `item` of the current state, SI units; NaN: unknown. */
double gliderLogValue(const GliderContext* context, uint32_t item);

/* The words of memory that a table keeps: a word for its answer, then for each column its interval
   and the rows that may hold there. */
static inline uint32_t gliderGuardMemory(uint32_t column_count, uint32_t words) {
  return 1u + column_count * (1u + words);
}

/* The answer of GliderGuards, by a table. Keeps the intervals in which the numbers were, and reads
   no row as long as they stay there. */
uint32_t gliderFirstTrue(GliderContext* context, const GliderGuardTable* table, uint32_t from);

/* Commands how often the vehicle's instruments read: a word of hooks/protocol/sampling.h. One that
   is unknown changes nothing and is counted as a refused command. */
void gliderSample(GliderContext* context, double word);

/* What code of the type GliderForesee adds. Awake: what comes next is not known. Until: two numbers
   that approach each other by 1 a second are `seconds` apart (below 0: they have passed; NaN:
   nothing follows from them). Crossed: a sensor of the mission passes a number in SI units (NaN:
   nothing), or, while it is unknown, becomes known. Known, Lost: it becomes known; unknown. */
void gliderNapAwake(GliderNap* nap);
void gliderNapUntil(GliderNap* nap, double seconds);
void gliderNapCrossed(GliderNap* nap, const GliderContext* context, uint32_t sensor, double number);
void gliderNapKnown(GliderNap* nap, const GliderContext* context, uint32_t sensor);
void gliderNapLost(GliderNap* nap, const GliderContext* context, uint32_t sensor);

/* Adds a note of `kind` (GliderNoteKind) with `count` values, for this tick; `text` outlives the
   mission. A note for which there is no room is counted as lost. */
void gliderNote(GliderContext* context, uint32_t kind, const char* text, const double* values,
                uint32_t count);

/* The functions of the language, the same bits on every machine (runtime/numbers); angles in rad,
   positions in degrees; NaN for an unknown argument; results are settled. gliderSin, gliderCos and
   gliderTan take angles up to 2^20 rad; one beyond is unknown. gliderAtan2: in (-pi, pi]; of (0, 0)
   unknown. gliderDistance: metres along a sphere of the Earth's mean radius; gliderBearing: rad
   clockwise from north in [0, 2 pi), from the first position to the second, unknown between
   positions that are one place. Unknown too beyond 90 degrees of latitude or 360 of longitude.
   gliderOffsetLatitude and gliderOffsetLongitude: the place on the great circle that leaves a
   position at a bearing (rad, at most 2^20), a distance along it (metres, below 0 backwards; at
   most half way around the Earth); the longitude in [-180, 180]. */
double gliderSin(double angle);
double gliderCos(double angle);
double gliderTan(double angle);
double gliderAtan2(double y, double x);
double gliderDistance(double latitude, double longitude, double to_latitude, double to_longitude);
double gliderBearing(double latitude, double longitude, double to_latitude, double to_longitude);
/* The remainder of x / y that is at least 0 and below y; unknown if y is not above 0, or if x / y
   is 2^31 or more in magnitude. */
double gliderRemainder(double x, double y);
/* Practical salinity, and density in kg/m3 at that pressure, of sea water: conductivity in S/m,
   temperature in degC (ITS-90), pressure in Pa above that of the air. Unknown where the formulas
   are not defined: a salinity outside 0..45, a temperature outside -4..45, a pressure above 1200
   bar. */
double gliderSalinity(double conductivity, double temperature, double pressure);
double gliderDensity(double conductivity, double temperature, double pressure);
double gliderOffsetLatitude(double latitude, double longitude, double bearing, double distance);
double gliderOffsetLongitude(double latitude, double longitude, double bearing, double distance);

#ifdef __cplusplus
}
#endif

#endif
