/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The SBC: Client, and a mission that takes control, steers, and releases control at any time. */

bit sbc_on = 1, sbc_stuck;
byte sbc_link, next_session = 1, sbc_session;
NUMBER sequence, settled, last_settled; /* the second: the newest that hookbeh was seen to look at */
bit tick_seen;            /* in this link */
byte newest_cycle;        /* REPLAY only */
bit link_used, waiting, due, taken;
byte unanswered;
mtype pending_control;
byte pending_session, pending_command;
mtype tick_state = Absent, tick_answer = None;
byte tick_session;
NUMBER tick_answered;
bit resubscribe, finished;
bit claims = 1;           /* its session is for it to keep alive */
/* GliderRuntime and Checkpoint: what outlives a power cut, and the result of it */
bit kept, kept_finished;
byte kept_session;
NUMBER kept_sequence;
bit found;                /* there is a checkpoint, and nothing is decided about it */
bit goes_on, leaves;      /* it was decided in this tick */
byte mission_time;        /* ticks that the mission has seen; counts round */
byte commands;            /* given so far, which is the newest one's number (ghost) */
byte since_progress;      /* rounds since a Done left that claims control and is news to hookprog of a mission that goes on (ghost) */
NUMBER told_sequence;       /* of the newest instruction that has left this mission, started again or not (ghost) */
byte told_end;            /* the same: the instruction with which it has released control, 0 for none (ghost) */
byte disagreed;           /* rounds in which hookbeh has obeyed another instruction than the newest, and nothing else went wrong (ghost) */

inline say(kind) {
  out.type = kind; out.link = sbc_link;
  put(from_sbc, FROM_SBC)
}

inline ask_for_link() {
  if
  :: sbc_link == 0 -> sbc_link = next_session
  :: sbc_link != 0 && link_used == 1 -> sbc_link++
  :: else -> skip
  fi;
  link_used = 0; tick_seen = 0;
  say(Hello);
  say(Subscribe)
}

inline learn_session(number) {
  if
  :: number != 0 && next_session <= number -> next_session = number + 1
  :: else -> skip
  fi
}

inline answer_done() {
  out.type = Done; out.session = (claims == 1 && unanswered < UNANSWERED -> sbc_session : 0); 
  out.time = (found == 1 || leaves == 1 -> 0 : mission_time);
  if
  :: out.session != 0 && (NEWS(mission_time, 0) || out.session != progress_session) -> since_progress = 0
  :: else -> skip
  fi;
  put(from_sbc, FROM_SBC)
}

inline renumber() {
  NUMBER theirs;
  theirs = (settled != 0 -> settled : tick_answered);
  sequence = (theirs > sequence -> theirs + 1 : sequence + 1);
  theirs = 0
}

#define OBEYED (sbc_session != 0 && tick_session == sbc_session && tick_state == Active)

inline look_for_answer() {
  if
  :: tick_answered == sequence && tick_answer == None -> renumber()
  :: tick_answered == sequence && tick_answer == OldSequence -> sequence = sequence + JUMP; renumber()
  :: tick_answered == sequence && tick_answer != None && tick_answer != OldSequence -> waiting = 0
  :: else -> skip
  fi;
  due = waiting
}

inline follow_instruction() {
  bit unwritten = due;
  if
  :: OBEYED -> taken = 1
  :: else -> skip
  fi;
  settled = (tick_answer != OldSequence -> tick_answered : settled);
  if
  :: waiting == 1 -> look_for_answer()
  :: else -> skip
  fi;
  if
  :: waiting == 0 || unwritten == 1 || settled != last_settled -> unanswered = 0
  :: else -> unanswered = (unanswered < UNANSWERED -> unanswered + 1 : UNANSWERED)
  fi;
  last_settled = settled
}

inline instruct(what) {
  printf("mission %e\n", what);
  commands++;
  pending_control = what;
  if
  :: what == Take -> sbc_session = next_session; next_session++; taken = 0
  :: what == Steer && taken == 0 -> pending_control = Take
  :: else -> skip
  fi;
  pending_session = sbc_session; pending_command = commands;
  renumber();
  waiting = 1; due = 1; claims = 1
}

#define TAKING (waiting == 1 && pending_control == Take)

inline rest() { printf("mission rests\n") }

#ifdef COMPOSED
#include "composed.pml"
#else
inline mission() {
  if
  :: leaves == 1 || found == 1 || sbc_stuck == 1 || commands == COMMANDS -> rest()
  :: leaves == 0 && goes_on == 1 && sbc_stuck == 0 && commands < COMMANDS ->
     /* The command in force, in the session that hookbeh obeys or a new one; or the release once more. */
     if
     :: OBEYED && finished == 0 -> instruct(Steer)
     :: OBEYED && finished == 1 -> instruct(Release)
     :: !OBEYED -> instruct(Take)
     fi
  :: leaves == 0 && goes_on == 0 && found == 0 && sbc_stuck == 0 && commands < COMMANDS && finished == 1 -> rest()
  :: else ->
     if
     :: !OBEYED && !TAKING && (tick_state == Ready || tick_state == Silent) -> instruct(Take)
     :: !OBEYED && !TAKING && tick_state == Active -> rest()
     :: !OBEYED && !TAKING && (tick_state == Active || tick_state == Complete) && calm == 0 -> instruct(Take) /* in vain */
     :: !OBEYED && !TAKING && (tick_state == Absent || tick_state == Complete) -> rest()
     :: OBEYED || TAKING -> rest()
     :: (OBEYED || TAKING) && calm == 0 -> instruct(Steer)
     :: OBEYED && calm == 0 -> instruct(Release); finished = 1
     fi
  fi
}
#endif

inline write_instruction() {
  due = 0;
  told_sequence = sequence;
  told_end = (pending_control == Release && told_end == 0 -> pending_command : told_end);
  out.type = Write; out.session = pending_session; out.control = pending_control; out.sequence = sequence;
  out.command = pending_command;
  put(from_sbc, FROM_SBC)
}

/* As soon as hookbeh says what became of the flight in which the checkpoint was made. */
inline consider_checkpoint() {
  if
  :: found == 0 || sbc_stuck == 1 || tick_state == Absent || tick_state == Complete -> skip
  :: found == 1 && sbc_stuck == 0 && tick_state == Ready -> /* another flight: it had ended, or long ago */
     found = 0; sbc_session = 0; mission_time = 0; told_sequence = 0; told_end = 0; forget_mission();
     printf("decides start\n")
  :: found == 1 && sbc_stuck == 0 && tick_state == Ready && kept_finished == 0 -> /* or the vehicle's mission has begun again */
     found = 0; goes_on = 1; finished = 0;
     printf("decides on\n")
  :: found == 1 && sbc_stuck == 0 && tick_state == Ready && kept_finished == 0 -> /* or that was too long ago, or may not be */
     found = 0; sbc_session = 0; leaves = 1;
     printf("decides leaves\n")
  :: found == 1 && sbc_stuck == 0 && (tick_state == Active || tick_state == Silent) ->
     found = 0;
     if
     :: kept_finished == 0 || OBEYED -> goes_on = 1; finished = kept_finished; printf("decides on\n")
     :: sbc_session = 0; leaves = 1; printf("decides leaves\n") /* too late, or there is nothing to release */
     fi
  fi
}

/* Checkpoint::keep, before the answer. */
inline keep_checkpoint() {
  if
  :: found == 0 && leaves == 0 && sbc_session != 0 && (kept == 0 || sequence != kept_sequence) ->
     kept = 1; kept_session = sbc_session; kept_sequence = sequence; kept_finished = finished
  :: else -> skip
  fi
}

inline write_answer() {
  if
  :: resubscribe == 1 -> say(Subscribe)
  :: else -> skip
  fi;
  if
  :: waiting == 1 && due == 1 -> write_instruction()
  :: else -> skip
  fi
}

inline handle_tick() {
  assert(in.copy == 0); /* no cycle is flown twice */
  link_used = 1; tick_seen = 1; resubscribe = 1 - in.flag;
#ifdef REPLAY
  newest_cycle = in.time;
#endif
  tick_state = in.state; tick_session = in.session; tick_answered = in.sequence; tick_answer = in.answer;
  learn_session(tick_session);
  follow_instruction();
  consider_checkpoint();
  if
  :: sbc_stuck == 1 -> skip
  :: else -> mission_time = (mission_time + 1) % TIMES
  fi;
  mission();
  keep_checkpoint();
  goes_on = 0;
  if
  :: write_answer()
#ifdef REPLAY
  :: write_answer()
  :: write_answer()
  :: write_answer()
  :: write_answer()
  :: write_answer()
#endif
  :: faults > 0 -> fault(); printf("dies\n"); power_cut() /* with the checkpoint written, and no word of the answer */
  fi
}

inline handle() {
  if
  :: in.type == Beacon -> ask_for_link()
  :: in.type == Welcome && in.link == sbc_link ->
     link_used = 1;
     learn_session(in.session);
     if
     :: waiting == 1 -> write_instruction()
     :: else -> skip
     fi
  :: in.type == Welcome && in.link != sbc_link -> skip
  :: in.type == Tick && (sbc_link == 0 || in.link != sbc_link) -> ask_for_link()
  :: in.type == Tick && sbc_link != 0 && in.link == sbc_link && tick_seen == 1 && OLD_CYCLE(in) -> ask_for_link()
  :: in.type == Tick && sbc_link != 0 && in.link == sbc_link && !(tick_seen == 1 && OLD_CYCLE(in)) -> handle_tick()
  fi;
  if
  :: sbc_on == 1 -> answer_done()
  :: else -> skip
  fi;
  if
  :: leaves == 1 -> power_cut() /* the program ends */
  :: else -> skip
  fi
}

inline sbc_run() {
  since_progress = (hb_state == Active -> since_progress + 1 : 0);
  if
  :: hb_state == Active && in_force != commands -> disagreed++
  :: else -> disagreed = 0
  fi;
  do
  :: ARRIVED(to_sbc, TO_SBC) ->
     get(to_sbc, TO_SBC);
     if
     :: sbc_on == 0 || DOUBLE_PASSED_OVER(in) -> skip
     :: else -> handle()
     fi
  :: !ARRIVED(to_sbc, TO_SBC) -> break
  od
}

/* Nothing is left but the checkpoint; mission time goes on with the vehicle's. */
inline power_cut() {
  sbc_on = 0; sbc_stuck = 0;
  sbc_link = 0; next_session = 1; sbc_session = 0; sequence = 0; link_used = 0; waiting = 0; due = 0; taken = 0;
  unanswered = 0; settled = 0; last_settled = 0; tick_seen = 0; newest_cycle = 0; pending_control = 0; pending_session = 0; pending_command = 0;
  tick_state = Absent; tick_answer = None; tick_session = 0; tick_answered = 0; resubscribe = 0; finished = 0;
  claims = 1; found = 0; leaves = 0;
  recorded_is_last = (recorded_line == TO_SBC + 1 -> 0 : recorded_is_last);
  printf("sbc off\n")
}

/* Without a whole checkpoint it knows nothing. */
inline power_back() {
  sbc_on = 1; disagreed = 0;
  if
  :: kept == 1 ->
     printf("sbc on with its checkpoint\n");
     found = 1; claims = 0; sbc_session = kept_session; sequence = kept_sequence;
     assert(sequence >= told_sequence); /* what was sent to the vehicle is never forgotten */
     learn_session(kept_session)
  :: printf("sbc on\n");
     mission_time = 0; kept = 0; kept_session = 0; kept_sequence = 0; kept_finished = 0; told_sequence = 0; told_end = 0; forget_mission()
  fi
}
