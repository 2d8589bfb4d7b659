/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* Only changes are sent: one subscribed sensor, Reporter on the science computer and Client on the SBC, a Tick a round. Frames
   are lost, doubled and late, and either side starts again. README.md says what is left out. */

#ifndef FAULTS
#define FAULTS 4          /* of all kinds, in one flight */
#endif
#define VALUES 2
#define REMEMBERED 4      /* Ticks whose answer may still come: Reporter::kRemembered is 8 */
#define ROOM 4            /* frames under way on each line; more is not looked at */
#define NUMBERS 8         /* frames are numbered modulo 256; a Done is never so late */
#define LOST 3            /* cycles: Hookprog::kLostSecs */
#define NEVER 99
#define CALM 6            /* rounds after the last fault in which each report must have arrived */

mtype = { Beacon, Welcome, Tick, Hello, Subscribe, Done };
mtype = { Nothing, Unchanged, Value }; /* Told of hooks/protocol/tick.h */

typedef Frame {
  mtype type;
  bit copy;               /* equals the one before it, which is for FrameDecoder to see */
  byte number;            /* sequence; of Done the one that it answers */
  byte link;
  bit served;             /* Tick: its subscription is the client's */
  mtype told;
  byte value;
  byte truth              /* what was reported, VALUES for nothing (ghost) */
}
hidden Frame in, out;
chan to_sbc = [ROOM] of { Frame };
chan from_sbc = [ROOM] of { Frame };
bit to_sbc_held, from_sbc_held;
byte faults = FAULTS;
bit calm, over;
byte rounds;              /* of calm */
#define DOUBLE_PASSED_OVER(frame) (frame.copy == 1)

/* Reporter and its Hookprog. */
byte link, number;
bit served, held;
byte bits;                /* of the newest value sent */
bit brought_in[REMEMBERED];
byte sequences[REMEMBERED];
byte remembered;
byte waiting_rounds = NEVER; /* since a Tick without any Done */

/* Client. */
byte sbc_link;
bit link_used, holds, all_known;
byte held_value;
bit got;                  /* a reading came in this round (ghost) */

inline clear(frame) {
  frame.type = 0; frame.copy = 0; frame.number = 0; frame.link = 0; frame.served = 0; frame.told = 0; frame.value = 0;
  frame.truth = 0
}

inline put(line) {
  if
  :: len(line) + 2 > ROOM -> over = 1
  :: else ->
     if
     :: line ! out
     :: faults > 0 -> faults--
     :: faults > 0 -> faults--; line ! out; out.copy = 1; line ! out
     fi
  fi;
  clear(out)
}

inline forget() {
  held = 0; bits = 0; remembered = 0;
  byte i;
  for (i : 0 .. REMEMBERED - 1) { brought_in[i] = 0; sequences[i] = 0 }
  i = 0
}

inline confirm(ago) { held = (brought_in[ago] == 1 -> 1 : held) }

inline handle_done() {
  waiting_rounds = NEVER;
  if
  :: remembered > 0 && sequences[0] == in.number -> confirm(0)
  :: else ->
     if
     :: remembered > 1 && sequences[1] == in.number -> confirm(1)
     :: else ->
        if
        :: remembered > 2 && sequences[2] == in.number -> confirm(2)
        :: else ->
           if
           :: remembered > 3 && sequences[3] == in.number -> confirm(3)
           :: else -> skip
           fi
        fi
     fi
  fi
}

inline serve_sbc() {
  do
  :: len(from_sbc) > 0 && from_sbc_held == 0 ->
     from_sbc ? in;
     if
     :: DOUBLE_PASSED_OVER(in) -> skip
     :: !DOUBLE_PASSED_OVER(in) && in.type == Hello ->
        link = in.link; served = 0; waiting_rounds = NEVER; forget();
        number = (number + 1) % NUMBERS;
        out.type = Welcome; out.link = link; out.number = number;
        put(to_sbc)
     :: !DOUBLE_PASSED_OVER(in) && in.type == Subscribe && link != 0 -> served = 1; forget()
     :: !DOUBLE_PASSED_OVER(in) && in.type == Done && link != 0 -> handle_done()
     :: !DOUBLE_PASSED_OVER(in) && in.type != Hello && link == 0 -> skip
     fi
  :: !(len(from_sbc) > 0 && from_sbc_held == 0) -> break
  od
}

/* Reporter::begin and report: `truth` is the report, VALUES for none. */
inline tell(truth) {
  brought_in[3] = brought_in[2]; brought_in[2] = brought_in[1]; brought_in[1] = brought_in[0]; brought_in[0] = 0;
  out.told = Nothing;
  if
  :: truth == VALUES -> skip
  :: truth != VALUES && held == 1 && bits == truth ->
     if
     :: out.told = Unchanged
     :: out.told = Value; out.value = truth; brought_in[0] = 1; held = 0 /* refreshed now and then */
     fi
  :: else ->
     out.told = Value; out.value = truth;
     if
     :: bits != truth -> brought_in[1] = 0; brought_in[2] = 0; brought_in[3] = 0
     :: else -> skip
     fi;
     brought_in[0] = 1; bits = truth; held = 0
  fi
}

inline sent() {
  sequences[3] = sequences[2]; sequences[2] = sequences[1]; sequences[1] = sequences[0]; sequences[0] = number;
  remembered = (remembered < REMEMBERED -> remembered + 1 : REMEMBERED)
}

inline send_cycle(truth) {
  number = (number + 1) % NUMBERS;
  if
  :: link == 0 -> out.type = Beacon
  :: else ->
     out.type = Tick; out.link = link; out.served = served; out.truth = truth;
     if
     :: served == 1 -> tell(truth)
     :: else -> skip
     fi;
     sent();
     waiting_rounds = (waiting_rounds == NEVER -> 0 : waiting_rounds)
  fi;
  out.number = number;
  put(to_sbc)
}

inline say(kind) { out.type = kind; out.link = sbc_link; put(from_sbc) }

inline subscribe() { holds = 0; held_value = 0; say(Subscribe) }

inline ask_for_link() {
  if
  :: sbc_link == 0 ->
     if
     :: sbc_link = 1 /* it may happen to begin with the number that was in use */
     :: sbc_link = 2
     fi
  :: sbc_link != 0 && link_used == 1 -> sbc_link = 3 - sbc_link
  :: else -> skip
  fi;
  link_used = 0;
  say(Hello);
  subscribe()
}

inline take_reading() {
  if
  :: in.told == Nothing -> skip
  :: in.told == Value -> holds = 1; held_value = in.value
  :: in.told == Unchanged -> all_known = holds
  fi;
  if
  :: in.told != Nothing && holds == 1 ->
     assert(held_value == in.truth); /* what the mission reads is what the vehicle reported in that cycle */
     got = 1
  :: else -> skip
  fi
}

inline handle_tick() {
  link_used = 1; all_known = in.served;
  if
  :: in.served == 1 -> take_reading()
  :: else -> skip
  fi;
  if
  :: all_known == 1 -> skip
  :: else -> subscribe()
  fi;
  all_known = 0
}

inline sbc_run() {
  do
  :: len(to_sbc) > 0 && to_sbc_held == 0 ->
     to_sbc ? in;
     if
     :: DOUBLE_PASSED_OVER(in) -> skip
     :: else ->
        if
        :: in.type == Beacon -> ask_for_link()
        :: in.type == Welcome -> link_used = (in.link == sbc_link -> 1 : link_used)
        :: in.type == Tick && (sbc_link == 0 || in.link != sbc_link) -> ask_for_link()
        :: in.type == Tick && sbc_link != 0 && in.link == sbc_link -> handle_tick()
        fi;
        out.type = Done; out.number = in.number;
        put(from_sbc)
     fi
  :: !(len(to_sbc) > 0 && to_sbc_held == 0) -> break
  od
}

inline restart_sbc() { sbc_link = 0; link_used = 0; holds = 0; held_value = 0 }
inline restart_science() { link = 0; served = 0; number = 0; waiting_rounds = NEVER; forget() }

inline count_rounds() {
  waiting_rounds = (waiting_rounds == NEVER -> NEVER : waiting_rounds + 1);
  if
  :: link != 0 && waiting_rounds != NEVER && waiting_rounds >= LOST -> link = 0; waiting_rounds = NEVER
  :: else -> skip
  fi
}

inline world() {
  to_sbc_held = 0; from_sbc_held = 0;
  if
  :: skip
  :: calm == 0 -> calm = 1; faults = 0
  :: faults > 0 ->
     faults--;
     if
     :: to_sbc_held = 1
     :: from_sbc_held = 1
     :: restart_sbc()
     :: restart_science()
     fi
  fi
}

init {
  byte truth;
  do
  :: over == 1 -> break
  :: else ->
     atomic {
       select(truth : 0 .. VALUES - calm); /* in the calm it is reported in each cycle */
       got = 0;
       serve_sbc();
       count_rounds();
       send_cycle(truth);
       sbc_run();
       serve_sbc();
       if
       :: calm == 1 && rounds >= CALM ->
          assert(got == 1); /* a loss heals */
          over = 1
       :: else -> rounds = (calm == 1 -> rounds + 1 : 0)
       fi;
       truth = 0;
       world()
     }
  od
}
