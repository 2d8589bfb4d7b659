// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#ifndef GLIDER_RUNTIME_C_GLIDER_H
#define GLIDER_RUNTIME_C_GLIDER_H

/* Missions in plain C, the way Fig. 3 of the paper writes them: make a list of events, run until
   some of them fire, react with commands, continue.

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
#define MISSION_TIME 0x10000u /* s since the mission got control; needs no subscription */

/* How an event compares its sensor with its limit. An unknown reading fires no event. */
typedef enum gliderOp { LEQ, LESS, GEQ, GREATER, CUSTOM } gliderOp;

typedef struct gliderEvent {
  gliderOp op;
  uint32_t sensor;
  const double* limit;           /* read on every tick */
  int (*test)(const void* data); /* for CUSTOM: nonzero fires the event */
  const void* data;
} gliderEvent;

/* An event is identified by its address, so that == distinguishes events. */
typedef const gliderEvent* event;
#define EVENT(op, sensor, limit) (&(const gliderEvent){op, sensor, limit, NULL, NULL})
#define CUSTOM_EVENT(test, data) (&(const gliderEvent){CUSTOM, MISSION_TIME, NULL, test, data})

typedef struct gliderEventList* eventList;

/* A new empty list; NULL when there are 16 already. */
eventList newEventList(void);
/* Adds an event and subscribes its sensor. The event is copied, its limit and data are not: they
   must live as long as the list. Two events that must be distinguishable must both still exist: in
   a function that returns, name them `static`. Returns 0, or -1: the list holds 16, or gliderRun
   has been called and the sensor is not among those subscribed before. */
int addEvent(eventList list, event added);
/* Subscribes a sensor that no event compares. Returns 0 or -1, as addEvent. */
int useSensor(uint32_t sensor);

/* What the program needs to continue after a power cut: with --checkpoint FILE these bytes are
   kept with every answer that changes them (no pointers: they are not valid in a restarted
   program). At most 16 pieces of 2,048 bytes in all, in the same order each time; NULL and 0:
   nothing. Commands, setDepths, setPitches, readings and what is known of a thermocline are kept
   anyway. Returns 0, or -1: too many, or gliderOpen has been called. */
int keepState(void* state, size_t bytes);
/* The longest outage after which the mission continues, s: 300 unless set. After a longer one the
   mission does not take control of the vehicle again, and gliderRun returns NULL. */
void resumeWithin(double seconds);
/* The mission does not continue either if the vehicle has restarted its own mission during the
   outage. */
void newAfterRestart(void);
/* The angle of magnetic north from true north, rad, east positive (off New Jersey -0.21). Headings
   are true here, those of the vehicle magnetic: this value is used until the vehicle has reported
   its own m_gps_mag_var. Unless set it is 0, and a note in the logs reports that. Returns 0, or -1:
   more than half a turn. */
int setDeclination(double east);
/* True after the mission has continued from a checkpoint. */
int gliderResumed(void);

/* Opens the link that the command line names (--port PATH, --baud N, --stdio, --log FILE,
   --checkpoint FILE). Returns 0, or an exit status after a message with the reason. --help and
   --version print their text and end the program with status 0. */
int gliderOpen(int argc, char** argv, const char* mission_name);
/* Answers the vehicle's current tick with the commands in force, then runs until a tick on which
   events of `list` are true. Returns them, valid until the next call, or NULL when the mission is
   over: control was released, or the link is lost.

   In a program that continues after a power cut the first call returns an empty list: the data of
   keepState and the commands in force are restored, and what the program commanded before that is
   discarded. The next call tests its list on that same tick. */
eventList gliderRun(eventList list);
/* The event after `previous` (NULL: the first) of those that fired; NULL after the last. */
event nextEvent(eventList fired, event previous);

/* Exit status for main: 0 if control was released, 2 if the link was lost, 3 if an internal check
   failed. */
int gliderExitStatus(void);
/* Ends the mission: the next gliderRun releases control of the vehicle and returns NULL. */
void releaseControl(void);

/* A note with `count` values (NULL and 0: none) for the logs of the SBC and the vehicle, like the
   mission language's `log`; at most 60 characters. Dropped before the first tick. */
void gliderLog(const char* text, const double* values, int count);

/* This tick's reading in SI units; NaN if it is unknown. */
double gliderSensor(uint32_t sensor);

/* The range of dive and climb: these depths, at these pitches (magnitudes). 3 m, 30 m and 0.454
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
/* The fin at a fixed angle, positive to turn to starboard. A program that calls this is refused by
 * a vehicle that does not obey it. */
void holdFin(double angle);
/* The buoyancy pump, cc, positive to lift, and the pitch battery, inches, positive to lower the
 * nose: in place of a depth, together; the one that is not set since the last command about depth
 * is in the middle, at 0. Nothing then keeps a depth: end the descent yourself. A program that
 * calls one of them is refused by a vehicle that does not obey it. */
void setPump(double cc);
void setPitchBattery(double inches);
void drift(void);

/* Thermocline: a difference of `dtemp` within `ddepth` metres. */
typedef struct gliderThermo {
  double dtemp;
  double ddepth;
} gliderThermo;
/* For CUSTOM_EVENT with a gliderThermo: true when the current dive or climb has met one. */
int thermoMet(const void* thermo);
/* Sets *min and *max to depths around the thermocline that the current dive or climb has met,
   within the depths of setDepths. Returns 1; if there is none, returns 0 and changes nothing. */
int trackThermo(double* min, double* max, double dtemp, double ddepth);

#ifdef __cplusplus
}
#endif

#endif
