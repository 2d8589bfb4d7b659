/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* Who controls the vehicle: the SBC (client and mission), hookprog and hookbeh over the four directions of the two lines, a
   flight cycle a round. README.md says what is left out and how the model is compared with the code. */

#ifndef FAULTS
#define FAULTS 2          /* of all kinds, in one flight */
#endif
#ifndef COMMANDS
#define COMMANDS 4        /* instructions that the mission may give, Takes included */
#endif
#define SILENCE 6         /* cycles: HookbehArgs::silence_secs */
#define LOST 3            /* cycles: Hookprog::kLostSecs */
#define UNANSWERED 6      /* ticks: Client::kMostUnansweredTicks */
#define QUIET 24          /* rounds after the last fault in which all must come right; the flight is over then */
#define NEVER 255

/* `spin -DREPLAY` flies at random, for the test that does the same with the code: faults are rare then, and the flight ends
   after ROUNDS. */
#ifdef REPLAY
#define ROUNDS 120
byte rounds;
#endif

/* Mission time that tells of progress. It counts round when all is searched. */
#ifdef REPLAY
#define TIMES 250
#define NEWS(time, old) (progress == NEVER || time > progress)
#define STALE(frame) (frame.time < told_time)
#define OLD_CYCLE(frame) (frame.time <= newest_cycle)
#define NEXT_CYCLE (told_cycle == 0 || reported_cycle > told_cycle || \
                    (was_earlier == 1 && reported_cycle > earlier && reported_cycle <= earlier + 8))
#define NUMBER int        /* of an instruction */
#define JUMP 16383
#define ROOM 30           /* frames under way on each line; more is not looked at */
#else
#define TIMES 4
#define NEWS(time, old) (progress == NEVER || (old == 0 && time != progress))
#define STALE(frame) (frame.old == 1 && frame.time != told_time)
#define OLD_CYCLE(frame) (frame.old == 1)
#define NEXT_CYCLE (reported_old == 0)
#define NUMBER byte
#define JUMP 32
#define ROOM 10
#endif

/* HookState, HookAnswer, HookControl of hooks/protocol/values.h */
mtype = { Absent, Ready, Active, Silent, Complete };
mtype = { None, Accepted, WrongSession, NotReady, OldSequence };
mtype = { Take, Steer, Release };
/* hooks/protocol/messages.def */
mtype = { Beacon, Welcome, Tick, Hello, Subscribe, Write, Done, Sensors };

typedef Frame {
  mtype type;
  bit copy;               /* equals the one before it, which is for FrameDecoder to see */
  byte link;              /* Welcome, Tick, Hello */
  mtype state;            /* Tick, Sensors to science: x_hook_state */
  mtype answer;           /* the same: x_hook_answer */
  byte session;           /* of Welcome the newest, of Write and Done the SBC's, else x_hook_session */
  bit old;                /* comes again: its cycle, its mission time or its beat was reported before */
  NUMBER sequence;        /* of Write sci_hook_sequence, else x_hook_sequence */
  mtype control;          /* Write: sci_hook_control */
  byte command;           /* Write: which instruction it is (ghost) */
  bit flag;               /* Tick: it serves a subscription; Sensors to flight: a heartbeat */
  byte time               /* Done: mission time; Tick, Sensors to science: the cycle (REPLAY only) */
}
hidden Frame in, out;     /* used within one step only */

chan to_sbc = [ROOM] of { Frame };
chan from_sbc = [ROOM] of { Frame };
chan to_flight = [ROOM] of { Frame };
chan from_flight = [ROOM] of { Frame };
#define TO_SBC 0
#define FROM_SBC 1
#define TO_FLIGHT 2
#define FROM_FLIGHT 3
bit cut[4];               /* nothing gets through */
bit noise;                /* no instruction gets through, which is a long frame; shorter ones do */
byte held[4];             /* the rest comes only in the next round: 1 all of it, 2 all but a frame; 0: all comes */

byte faults = FAULTS;
bit calm;                 /* nothing goes wrong or comes right any more, and the mission keeps the instruction it has */
byte quiet;               /* rounds since then */
byte holds;               /* rounds by which frames may be late in all */
bit over;

/* A frame that is received, and arrives again later. */
chan recorder = [1] of { Frame };
byte recorded_line;       /* and one; 0: none is there */
bit recorded_is_last;     /* no other frame has come on that line since */

#define DOUBLE_PASSED_OVER(frame) (frame.copy == 1)
#define ARRIVED(line, number) (len(line) > 0 && held[number] != 1)

inline clear(frame) {
  frame.type = 0; frame.copy = 0; frame.link = 0; frame.state = 0; frame.answer = 0; frame.session = 0; frame.sequence = 0;
  frame.control = 0; frame.command = 0; frame.flag = 0; frame.time = 0; frame.old = 0
}

/* Takes the next frame of a line. */
inline get(line, number) {
  line ? in;
  held[number] = (held[number] == 2 -> 1 : held[number])
}

inline fault() { faults--; disagreed = 0 }

#define LOST_ANYWAY(number) (cut[number] == 1 || (noise == 1 && out.command != 0))

inline note(number, what) {
  printf("frame %d %e %d %d %d %d\n", number, out.type, out.link, out.session, out.sequence, what)
}
#define PASSES 1
#define DOUBLED 2
#define VANISHES 0

inline pass(line, number) {
  recorded_is_last = (recorded_line == number + 1 -> 0 : recorded_is_last);
  note(number, PASSES); line ! out
}

inline record(line, number) {
  pass(line, number);
  printf("record %d\n", number);
  recorder ! out; recorded_line = number + 1; recorded_is_last = 1
}

/* Puts `out` on a line, which may lose, double or record it. */
inline put(line, number) {
  if
  :: LOST_ANYWAY(number) -> note(number, VANISHES)
  :: !LOST_ANYWAY(number) && len(line) + 2 > ROOM -> over = 1; printf("full\n")
  :: else ->
     if
     :: pass(line, number)
#ifdef REPLAY
     :: pass(line, number)
     :: pass(line, number)
     :: pass(line, number)
     :: pass(line, number)
     :: pass(line, number)
     :: pass(line, number)
     :: pass(line, number)
#endif
     :: faults > 0 -> fault(); note(number, VANISHES)
     :: faults > 0 ->
        fault(); note(number, DOUBLED); line ! out; out.copy = 1; line ! out;
        recorded_is_last = (recorded_line == number + 1 -> 0 : recorded_is_last)
     :: faults > 0 && recorded_line == 0 -> fault(); record(line, number)
     fi
  fi;
  clear(out)
}

#define FLIES (sbc_on == 1 && sbc_stuck == 0)
#define WHOLE (noise == 0 && cut[TO_SBC] == 0 && cut[FROM_SBC] == 0 && cut[TO_FLIGHT] == 0 && cut[FROM_FLIGHT] == 0)

#ifndef COMPOSED
#define judge_composed() skip
#define forget_mission() skip
#endif

#include "flight.pml"
#include "science.pml"
#include "sbc.pml"

inline begin_cut(number) { cut[number] = 1 }
inline mend(number) { cut[number] = 0; disagreed = 0 }

inline hold(number) {
  if
  :: held[number] = 1
  :: held[number] = 2
  fi;
  printf("hold %d %d\n", number, held[number] - 1)
}

inline again(line) {
  if
  :: len(line) == ROOM -> over = 1; printf("full\n")
  :: else -> line ! in
  fi
}

inline replay() {
  recorder ? in;
  in.old = 1; in.copy = recorded_is_last;
  printf("replay %d\n", recorded_line - 1);
  if
  :: recorded_line == TO_SBC + 1 -> again(to_sbc)
  :: recorded_line == FROM_SBC + 1 -> again(from_sbc)
  :: recorded_line == TO_FLIGHT + 1 -> again(to_flight)
  :: recorded_line == FROM_FLIGHT + 1 -> again(from_flight)
  fi;
  recorded_line = 0; recorded_is_last = 0; disagreed = 0;
  clear(in)
}

/* Things go wrong, or come right, between the rounds. */
inline world() {
  held[TO_SBC] = 0; held[FROM_SBC] = 0; held[TO_FLIGHT] = 0; held[FROM_FLIGHT] = 0;
  do
  :: break
#ifdef REPLAY
  :: break
  :: break
  :: break
  :: break
  :: break
  :: break
  :: break
#else
  :: calm == 0 -> calm = 1; faults = 0; break
#endif
  :: faults > 0 ->
     fault();
     if
     :: holds++;
        if
        :: hold(TO_SBC)
        :: hold(FROM_SBC)
        :: hold(TO_FLIGHT)
        :: hold(FROM_FLIGHT)
        fi
     :: cut[TO_SBC] == 0 -> begin_cut(TO_SBC)
     :: cut[FROM_SBC] == 0 -> begin_cut(FROM_SBC)
     :: cut[TO_FLIGHT] == 0 -> begin_cut(TO_FLIGHT)
     :: cut[FROM_FLIGHT] == 0 -> begin_cut(FROM_FLIGHT)
     :: noise == 0 -> noise = 1
     :: sbc_on == 1 -> power_cut()
     :: sbc_on == 1 && sbc_stuck == 0 -> sbc_stuck = 1; printf("stuck\n")
     :: restart_science()
     :: restart_flight()
     fi
  :: calm == 0 && recorded_line != 0 && noise == 0 && cut[recorded_line - 1] == 0 -> replay()
  :: calm == 0 && cut[TO_SBC] == 1 -> mend(TO_SBC)
  :: calm == 0 && cut[FROM_SBC] == 1 -> mend(FROM_SBC)
  :: calm == 0 && cut[TO_FLIGHT] == 1 -> mend(TO_FLIGHT)
  :: calm == 0 && cut[FROM_FLIGHT] == 1 -> mend(FROM_FLIGHT)
  :: calm == 0 && noise == 1 -> noise = 0; disagreed = 0
  :: calm == 0 && sbc_on == 0 -> power_back()
  od
}

/* What must hold after each round, after any faults. */
inline judge() {
  /* Silence always ends in a release of control. A beat takes two cycles at most, and as much longer as frames were held up. */
  assert(hb_state != Active || since_progress <= SILENCE + 2 + holds);
  /* No instruction is lost while its session stays in control. */
  assert(disagreed <= UNANSWERED + SILENCE + 3 + holds);
  if
  :: quiet >= QUIET ->
     /* A while after the last fault all is as it should be. */
     over = 1;
     assert(FLIES || hb_state != Active);
     assert(!(FLIES && WHOLE) || (link != 0 && link == sbc_link && subscribed == 1));
     assert(!(FLIES && WHOLE && finished == 1) || hb_state != Active);
     assert(!(FLIES && WHOLE && finished == 0 && hb_state != Complete && commands < COMMANDS) ||
            (hb_state == Active && hb_session == sbc_session && in_force == commands))
  :: else -> quiet = (calm == 1 -> quiet + 1 : 0)
  fi
}

init {
  do
  :: over == 1 -> break
  :: else ->
     atomic {
       printf("round\n");
       flight_cycle();
       count_rounds();
       science_run();
       sbc_run();
       science_run();
       printf("state %e %d %d %e\n", hb_state, hb_session, hb_answered, hb_answer);
       judge();
       judge_composed();
#ifdef REPLAY
       rounds++;
       over = (rounds == ROUNDS -> 1 : over);
#endif
       world()
     }
  od
}
