/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The science computer: Hookprog::run. */

byte link, newest_session;
byte waiting_rounds = NEVER;         /* since a Tick without any Done */
byte progress = NEVER;               /* mission time that the session in control has told */
byte progress_session;
bit subscribed;
mtype reported_state = Absent, reported_answer = None;
byte reported_session, reported_cycle;
NUMBER reported_sequence;
bit reported_old;
bit cycle_is_new;
byte told_cycle, earlier;            /* REPLAY only: of CycleWatch */
bit was_earlier;
byte told_time;                      /* newest mission time of this link */

inline handle_hello() {
  link = in.link; subscribed = 0; told_time = 0; waiting_rounds = NEVER;
  out.type = Welcome; out.link = link; out.session = newest_session;
  put(to_sbc, TO_SBC)
}

inline handle_write() {
  newest_session = (in.session > newest_session -> in.session : newest_session);
  if
  :: reported_state == Absent -> skip
  :: else ->
     out.type = Sensors; out.session = in.session; out.control = in.control; out.sequence = in.sequence;
     out.command = in.command;
     put(to_flight, TO_FLIGHT)
  fi
}

inline handle_done() {
  waiting_rounds = NEVER; told_time = in.time;
  bit counts = (in.session != 0 && (reported_session == 0 || in.session == reported_session));
  if
  :: counts == 1 && progress_session != in.session -> progress_session = in.session; progress = NEVER
  :: else -> skip
  fi;
  bit goes_on_there = (counts == 1 && NEWS(in.time, in.old));
  progress = (goes_on_there == 1 -> in.time : progress);
  if
  :: reported_state != Absent && (counts == 1 -> goes_on_there : reported_session == 0) ->
     out.type = Sensors; out.flag = 1;
     put(to_flight, TO_FLIGHT)
  :: else -> skip
  fi;
  counts = 0; goes_on_there = 0
}

inline serve_sbc() {
  do
  :: ARRIVED(from_sbc, FROM_SBC) ->
     get(from_sbc, FROM_SBC);
     if
     :: DOUBLE_PASSED_OVER(in) -> skip
     :: !DOUBLE_PASSED_OVER(in) && in.type == Hello -> handle_hello()
     :: !DOUBLE_PASSED_OVER(in) && in.type != Hello && link == 0 -> skip
     :: !DOUBLE_PASSED_OVER(in) && in.type == Subscribe && link != 0 -> subscribed = 1
     :: !DOUBLE_PASSED_OVER(in) && in.type == Write && link != 0 -> handle_write()
     :: !DOUBLE_PASSED_OVER(in) && in.type == Done && link != 0 && STALE(in) -> skip
     :: !DOUBLE_PASSED_OVER(in) && in.type == Done && link != 0 && !STALE(in) -> handle_done()
     fi
  :: !ARRIVED(from_sbc, FROM_SBC) -> break
  od
}

inline take_flight() {
  do
  :: ARRIVED(from_flight, FROM_FLIGHT) ->
     get(from_flight, FROM_FLIGHT);
     if
     :: DOUBLE_PASSED_OVER(in) -> skip
     :: else ->
        reported_state = in.state; reported_session = in.session; reported_sequence = in.sequence;
        reported_answer = in.answer; reported_old = in.old;
#ifdef REPLAY
        cycle_is_new = (in.time != reported_cycle -> 1 : cycle_is_new); reported_cycle = in.time
#else
        cycle_is_new = 1
#endif
     fi
  :: !ARRIVED(from_flight, FROM_FLIGHT) -> break
  od
}

inline skip_cycle() {
  cycle_is_new = 0; was_earlier = 1; earlier = reported_cycle
}

inline send_cycle() {
  cycle_is_new = 0; was_earlier = 0; earlier = 0; told_cycle = reported_cycle;
  if
  :: link == 0 -> out.type = Beacon; out.state = reported_state
  :: else ->
     out.type = Tick; out.link = link; out.state = reported_state; out.session = reported_session;
     out.sequence = reported_sequence; out.answer = reported_answer; out.flag = subscribed;
     out.time = reported_cycle;
     waiting_rounds = (waiting_rounds == NEVER -> 0 : waiting_rounds)
  fi;
  put(to_sbc, TO_SBC)
}

inline science_run() {
  serve_sbc();
  take_flight();
  if
  :: cycle_is_new == 1 && NEXT_CYCLE -> send_cycle()
  :: cycle_is_new == 1 && !(NEXT_CYCLE) -> skip_cycle()
  :: else -> skip
  fi;
  if
  :: link != 0 && waiting_rounds != NEVER && waiting_rounds >= LOST -> link = 0; waiting_rounds = NEVER
  :: else -> skip
  fi
}

/* A round is LOST's cycle of 4 s. */
inline count_rounds() {
  waiting_rounds = (waiting_rounds == NEVER -> NEVER : waiting_rounds + 1)
}

/* Its links and what it has received are forgotten. */
inline restart_science() {
  link = 0; newest_session = 0; waiting_rounds = NEVER; progress = NEVER; progress_session = 0; subscribed = 0; cycle_is_new = 0;
  told_time = 0; told_cycle = 0; was_earlier = 0; earlier = 0; reported_cycle = 0; reported_old = 0;
  recorded_is_last = (recorded_line == FROM_SBC + 1 || recorded_line == FROM_FLIGHT + 1 -> 0 : recorded_is_last);
  reported_state = Absent; reported_answer = None; reported_session = 0; reported_sequence = 0;
  printf("restart science\n")
}
