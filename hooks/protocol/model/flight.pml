/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The flight controller: its sensor array, and Hookbeh::cycle. */

mtype hb_state = Ready, hb_answer = None;
mtype hb_settled_answer = None;
byte hb_session, hb_lost, hb_silence;
NUMBER hb_settled, hb_answered;
bit hb_settled_known;
mtype array_control;
byte array_session, array_command;
NUMBER array_sequence;
bit array_beat;           /* the heartbeat is newer than the one before */
byte in_force;            /* the instruction that is obeyed (ghost) */
byte newest_obeyed;       /* since hookbeh started (ghost) */
byte newest_lost;         /* session, since hookbeh started (ghost) */
bit written;              /* an instruction has come since hookbeh started (ghost) */

inline receive_at_flight() {
  do
  :: ARRIVED(to_flight, TO_FLIGHT) ->
     get(to_flight, TO_FLIGHT);
     if
     :: DOUBLE_PASSED_OVER(in) -> skip
     :: !DOUBLE_PASSED_OVER(in) && in.flag == 1 -> array_beat = 1 - in.old
     :: else ->
        written = 1;
        array_session = in.session; array_control = in.control; array_command = in.command; array_sequence = in.sequence
     fi
  :: !ARRIVED(to_flight, TO_FLIGHT) -> break
  od
}

inline watch_heartbeat() {
  if
  :: array_beat == 1 || hb_state != Active -> hb_silence = 0
  :: else -> hb_silence++
  fi;
  array_beat = 0;
  if
  :: hb_state == Active && hb_silence >= SILENCE -> 
     newest_lost = hb_session;
     hb_state = Silent; hb_lost = hb_session; hb_session = 0; in_force = 0
  :: else -> skip
  fi
}

inline obey() {
  assert(written == 1);                  /* not what lies in the array from before */
  assert(array_session == hb_session);   /* of no other session */
  assert(array_command > newest_obeyed); /* none twice, none out of turn */
  assert(told_end == 0 || array_command < told_end); /* nor any of a mission after it has released control */
  newest_obeyed = array_command;
  in_force = array_command
}

inline take() {
  if
  :: array_session <= hb_lost -> hb_answer = WrongSession
  :: else ->
     assert(hb_state != Complete);         /* a release is final */
     assert(array_session > newest_lost);  /* after silence only a newer session takes control */
     hb_answer = Accepted; hb_state = Active; hb_session = array_session; hb_silence = 0; since_progress = 0;
     obey()
  fi
}

inline decide() {
  if
  :: hb_state == Complete -> hb_answer = NotReady
  :: (hb_state == Ready || hb_state == Silent) && array_control == Take -> take()
  :: (hb_state == Ready || hb_state == Silent) && array_control != Take -> hb_answer = WrongSession
  :: hb_state == Active && array_session != hb_session -> hb_answer = WrongSession
  :: hb_state == Active && array_session == hb_session && array_control == Release ->
     hb_state = Complete; hb_session = 0; in_force = 0; hb_answer = Accepted
  :: hb_state == Active && array_session == hb_session && array_control != Release -> hb_answer = Accepted; obey()
  fi
}

inline read_instruction() {
  if
  :: hb_settled_known == 0 -> hb_settled_known = 1; hb_settled = array_sequence; hb_answered = array_sequence
  :: hb_settled_known == 1 && array_sequence != 0 && array_sequence == hb_settled ->
     hb_answered = hb_settled; hb_answer = hb_settled_answer
  :: hb_settled_known == 1 && array_sequence > hb_settled ->
     hb_answered = array_sequence; hb_settled = array_sequence;
     decide();
     hb_settled_answer = hb_answer
  :: hb_settled_known == 1 && array_sequence != 0 && array_sequence < hb_settled ->
     hb_answered = array_sequence; hb_answer = OldSequence
  :: else -> skip
  fi
}

inline flight_cycle() {
  receive_at_flight();
  watch_heartbeat();
  read_instruction();
  out.type = Sensors; out.state = hb_state; out.session = hb_session; out.sequence = hb_answered; out.answer = hb_answer;
#ifdef REPLAY
  out.time = rounds + 1;
#endif
  put(from_flight, FROM_FLIGHT)
}

/* Its mission starts again; the sensor array keeps what lies in it. */
inline restart_flight() {
  hb_state = Ready; hb_answer = None; hb_settled_answer = None; hb_session = 0; hb_lost = 0; hb_settled = 0; hb_answered = 0; hb_settled_known = 0;
  hb_silence = 0; in_force = 0; newest_obeyed = 0; newest_lost = 0; written = 0;
  printf("restart flight\n")
}
