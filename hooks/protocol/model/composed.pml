/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* The mission of sbc.pml when it is that of a mission file: the process `mission_states` (glidercc graph --format promela) takes a step
   in each tick that the SBC answers, and tells the state in which it is then. As in the runtime, it goes on while the vehicle does
   not obey it. whole.pml defines what the process says. */

byte at_state = EXITED;      /* of the mission; EXITED: none runs */
byte next_state;
bit begun;                   /* in this flight of the program */
bit flew;                    /* it has begun at all (ghost) */
byte told_state[COMMANDS + 1]; /* the state in which each instruction was given (ghost) */

#define forget_mission() begun = 0

inline instruct_state(what) {
  instruct(what);
  told_state[commands] = at_state
}

/* From the beginning. A process that still runs is of an earlier start. */
inline begin_mission() {
  if
  :: at_state != EXITED -> restart ! 0
  :: else -> skip
  fi;
  begun = 1; flew = 1;
  run mission_states();
  arrived ? at_state
}

inline exit_mission() {
  finished = 1;
  if
  :: OBEYED || TAKING -> instruct_state(Release)
  :: else -> /* there is nothing to release: the program ends, and keeps that */
     if
     :: sbc_session != 0 -> kept = 1; kept_session = sbc_session; kept_sequence = sequence; kept_finished = 1
     :: else -> skip
     fi;
     sbc_session = 0; leaves = 1
  fi
}

inline step_mission() {
  tick ! 0;
  arrived ? next_state;
  if
  :: next_state == at_state -> rest()
  :: next_state != at_state && next_state != EXITED ->
     at_state = next_state;
     if
     :: OBEYED || TAKING -> instruct_state(Steer)
     :: else -> rest()
     fi
  :: next_state == EXITED -> at_state = EXITED; exit_mission()
  fi;
  next_state = 0
}

/* The command in force, in the session that hookbeh obeys or a new one; or the release once more. */
inline go_on() {
  if
  :: OBEYED && finished == 0 -> instruct_state(Steer)
  :: OBEYED && finished == 1 -> instruct_state(Release)
  :: !OBEYED -> instruct_state(Take)
  fi
}

#define MAY_TAKE (!OBEYED && !TAKING && (tick_state == Ready || tick_state == Silent))

inline mission() {
  if
  :: leaves == 1 || found == 1 || sbc_stuck == 1 || commands == COMMANDS -> rest()
  :: leaves == 0 && goes_on == 1 && sbc_stuck == 0 && commands < COMMANDS -> go_on()
  :: leaves == 0 && goes_on == 0 && found == 0 && sbc_stuck == 0 && commands < COMMANDS && finished == 1 -> rest()
  :: else ->
     if
     :: begun == 0 && MAY_TAKE -> begin_mission(); instruct_state(Take)
     :: begun == 0 && !MAY_TAKE -> rest()
     :: begun == 1 && MAY_TAKE -> instruct_state(Take)
     :: begun == 1 && !MAY_TAKE && calm == 0 -> step_mission()
     :: begun == 1 && !MAY_TAKE && calm == 1 -> rest()
     :: begun == 1 && MAY_TAKE && calm == 0 -> step_mission()
     fi
  fi
}

/* What must hold of both together after each round. */
inline judge_composed() {
  /* After `exit` control ends, at most so many rounds after the last fault. */
  assert(!(begun == 1 && finished == 1 && quiet > UNANSWERED + SILENCE + 3 + holds) || hb_state != Active);
  /* What is in force at the end is of the state in which the mission is. */
  assert(!(quiet >= QUIET && FLIES && WHOLE && begun == 1 && finished == 0 && hb_state == Active && commands < COMMANDS) ||
         told_state[in_force] == at_state);
  /* hookbeh obeys nothing before a mission has begun. */
  assert(in_force == 0 || flew == 1)
}
