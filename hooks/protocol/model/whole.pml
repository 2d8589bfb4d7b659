/* SPDX-FileCopyrightText: 2026 The glidercc authors */
/* SPDX-License-Identifier: Apache-2.0 */

/* A mission and the protocol together: control.pml, whose mission is the structure of a mission file. tests/model/check_whole
   writes that as mission.pml. */

#define COMPOSED
#define EXITED 255

chan tick = [0] of { bit };     /* the mission may take a step */
chan restart = [0] of { bit };  /* it is not run any more: another begins */
chan arrived = [0] of { byte }; /* the state in which it is then */

#define REACHED(mission, number) \
  arrived ! number; \
end_ ## number: \
  if \
  :: tick ? 0 \
  :: restart ? 0 -> goto restarted \
  fi

#include "mission.pml"
#include "control.pml"
