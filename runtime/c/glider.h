// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_C_GLIDER_H
#define GLIDER_RUNTIME_C_GLIDER_H

/* Missions in plain C, the way Fig. 3 of the paper writes them: make a list of events, run until
   some of them fire, react with commands, run on.

       double min = 5, max = 20;
       eventList el = newEventList();
       event deep = EVENT(GEQ, M_DEPTH, &max);
       addEvent(el, deep);
       gliderOpen(argc, argv, "mine");
       dive();
       for (eventList fired; (fired = gliderRun(el)) != NULL;) {
         for (event e = NULL; (e = nextEvent(fired, e)) != NULL;) { if (e == deep) climb(); }
       }

   One mission a program; all memory is static. Depths in m, angles in rad, positions in degrees,
   temperatures in degC, times in s. */

/* Which vehicle: vehicle.h. */
#ifndef GLIDER_SENSORS_HEADER
#define GLIDER_SENSORS_HEADER "platforms/slocum_sensors.h"
#endif
#include GLIDER_SENSORS_HEADER

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sensors: any GLIDER_M_… or GLIDER_SCI_… of platforms/slocum_sensors.h, and: */
#define M_DEPTH GLIDER_M_DEPTH
#define M_PITCH GLIDER_M_PITCH
#define M_HEADING GLIDER_M_HEADING
#define M_ALTITUDE GLIDER_M_ALTITUDE
#define M_BATTERY GLIDER_M_BATTERY
#define M_LAT GLIDER_M_LAT
#define M_LON GLIDER_M_LON
#define SCI_WATER_TEMP GLIDER_SCI_WATER_TEMP
#define MISSION_TIME 0x10000u /* s since control was given; needs no subscription */

/* How an event compares its sensor with its limit. An unknown reading fires nothing. */
typedef enum gliderOp { LEQ, LESS, GEQ, GREATER, CUSTOM } gliderOp;

typedef struct gliderEvent {
  gliderOp op;
  uint32_t sensor;
  const double* limit;           /* read on every tick */
  int (*test)(const void* data); /* of CUSTOM: true fires */
  const void* data;
} gliderEvent;

/* An event is named by its address, so that == tells events apart. */
typedef const gliderEvent* event;
#define EVENT(op, sensor, limit) (&(const gliderEvent){op, sensor, limit, NULL, NULL})
#define CUSTOM_EVENT(test, data) (&(const gliderEvent){CUSTOM, MISSION_TIME, NULL, test, data})

typedef struct gliderEventList* eventList;

/* A new empty list; NULL when there are 16 already. */
eventList newEventList(void);
/* Adds an event and subscribes its sensor. The event is copied, its limit and data are not: they
   must live as long as the list. Two events that are to be told apart must both still live: in a
   function that returns, name them `static`. Returns 0, or -1: the list holds 16, or gliderRun has
   been called and the sensor is not among those subscribed before. */
int addEvent(eventList list, event added);
/* Subscribes a sensor that no event compares. Returns 0 or -1, as addEvent. */
int useSensor(uint32_t sensor);

/* What the program must know to go on after a power cut: with --checkpoint FILE these bytes are
   kept with every answer that changes them (no pointers: they point elsewhere in a program that
   starts again). At most 16 pieces of 2,048 bytes in all, in the same order each time; NULL and 0:
   nothing. Commands, setDepths, setPitches, readings and what is known of a thermocline are kept
   anyway. Returns 0, or -1: too many, or gliderOpen has been called. */
int keepState(void* state, size_t bytes);
/* How long an outage may last if the mission is to go on after it, s: 300 unless set. After a
   longer one the vehicle keeps its own control, and gliderRun returns NULL. */
void resumeWithin(double seconds);
/* The mission begins from the start, and does not go on, if the vehicle has begun its own mission
   again during the outage. */
void newAfterRestart(void);
/* The angle of magnetic north from true north, rad, east positive (off New Jersey -0.21). Headings
   are true here, those of the vehicle magnetic: this counts until the vehicle has reported its own
   m_gps_mag_var. Unless set it is 0, and a note in the logs says so. Returns 0, or -1: more than
   half a turn. */
int setDeclination(double east);
/* True once the mission goes on from a checkpoint. */
int gliderResumed(void);

/* Opens the link that the command line names (--port PATH, --baud N, --stdio, --log FILE,
   --checkpoint FILE). Returns 0; or, having said why, an exit status. --help and --version are
   answered and end the program with status 0. */
int gliderOpen(int argc, char** argv, const char* mission_name);
/* Answers the vehicle's tick under way with the commands in force, then runs until a tick on which
   events of `list` are true. Returns them, valid until the next call, or NULL when the mission is
   over: control was given back, or the link is lost.

   In a program that goes on after a power cut the first call returns an empty list: what keepState
   named is now as it was, the commands in force too, and what the program commanded before counts
   no more. The next call tests its list on that same tick. */
eventList gliderRun(eventList list);
/* The event after `previous` (NULL: the first) of those that fired; NULL after the last. */
event nextEvent(eventList fired, event previous);

/* Exit status for main: 0 if control was given back, 2 if the link was lost. */
int gliderExitStatus(void);
/* Ends the mission: the next gliderRun hands the vehicle back to its own control and returns NULL.
 */
void giveBack(void);

/* A word with `count` values (NULL and 0: none) for the log on the SBC and that of the vehicle, as
   the mission language's `log`; 60 characters of it. Dropped before the first tick. */
void gliderLog(const char* text, const double* values, int count);

/* This tick's reading in SI units; NaN if it is unknown. */
double gliderSensor(uint32_t sensor);

/* What dive and climb fly: between these depths at these pitches (magnitudes). 3 m, 30 m and 0.454
 * rad unless set. */
void setDepths(double shallowest, double deepest);
void setPitches(double dive_pitch, double climb_pitch);
void dive(void);
void climb(void);
void diveTo(double depth);
void climbTo(double depth);
void hoverAt(double depth);
void surface(void);
void steer(double heading);
void steerTo(double latitude, double longitude);
void drift(void);

/* Thermocline: a difference of `dtemp` within `ddepth` metres. */
typedef struct gliderThermo {
  double dtemp;
  double ddepth;
} gliderThermo;
/* For CUSTOM_EVENT with a gliderThermo: true when the dive or climb under way has met one. */
int thermoMet(const void* thermo);
/* Puts *min and *max round the thermocline that the dive or climb under way has met, within the
   depths of setDepths. Returns 1; 0, and changes nothing, if there is none. */
int trackThermo(double* min, double* max, double dtemp, double ddepth);

#ifdef __cplusplus
}
#endif

#endif
