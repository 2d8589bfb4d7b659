# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0

# Commands for gdb, from version 7 on, while a mission runs: docs/debugging.md. Load it with
#   gdb-multiarch -x glider.gdb …

define state
  printf "state "
  output state
  printf ", %g s after it was entered", missiontime - state_entered
  if state_resumed > state_entered
    printf " and %g s after it was resumed", missiontime - state_resumed
  end
  printf "; missiontime %g s\n", missiontime
  set $glider_caller = (int) stack_depth
  while $glider_caller > 0
    set $glider_caller = $glider_caller - 1
    printf "called by "
    output callers[$glider_caller].state
    printf ", entered at %g s\n", callers[$glider_caller].entered
  end
end
document state
The current state, how long it has been so, and the states that wait for it to return.
end

define case
  if moved_case == 0xffffffff
    printf "no transition in this tick\n"
  else
    if moved_list == 0
      printf "transition by case %u of always\n", moved_case + 1
    else
      printf "transition by case %u of the state that was current\n", moved_case + 1
    end
  end
end
document case
Which case made the transition of the latest tick, counted from 1 in its list: that of `always` or of the state.
end

define tick
  tbreak gliderStep
  continue
  finish
  state
  case
end
document tick
Runs to the end of the next tick, and shows `state` and `case`.
end
