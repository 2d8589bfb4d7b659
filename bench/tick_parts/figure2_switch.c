/* SPDX-FileCopyrightText: 2026 The glidercc authors
   SPDX-License-Identifier: Apache-2.0 */

/* Figure 2's transitions as a programmer would write them by hand, the time being the only input.
   With KNOWN it also keeps what glidercc's missions keep: readings with their times, unknown when
   older than 20 s or out of range. `TICKS`, then 1 if every sensor changes on each tick. */

#include "bench/tick_parts/timing.h"

enum state { S1, S2, S3, ENDED };
enum { kFigure2Sensors = 4 };

struct mission {
  enum state state;
  enum state caller;
  double time;
  double readings[kFigure2Sensors], raw[kFigure2Sensors], updated[kFigure2Sensors];
};

__attribute__((noinline)) void step(struct mission* m, double time, const double* values,
                                    unsigned count) {
  m->time = time;
  for (unsigned i = 0; i < count; ++i) {
    m->raw[i] = values[i];
    m->updated[i] = time;
  }
#ifdef KNOWN
  for (unsigned i = 0; i < kFigure2Sensors; ++i) {
    const int known = time - m->updated[i] <= 20 && m->raw[i] >= -1e3 && m->raw[i] <= 1e3;
    m->readings[i] = known ? m->raw[i] : 0.0 / 0.0;
  }
#endif
  switch (m->state) {
    case S1:
      if (time >= 2000) {
        m->state = S3;
      } else if (time >= 500 && time < 1500) {
        m->caller = S1;
        m->state = S2;
      }
      break;
    case S2:
      if (time >= 1500) {
        m->state = m->caller;
      }
      break;
    case S3:
      if (time >= 2500) {
        m->state = ENDED;
      }
      break;
    default:
      break;
  }
}

int main(int argc, char** argv) {
  const unsigned ticks = argc > 1 ? numberOf(argv[1]) : 1000;
  const unsigned all = argc > 2 ? numberOf(argv[2]) : 0;
  static struct mission mission;
  double values[kFigure2Sensors] = {1, 1, 1, 1};
  const double begin = now();
  for (unsigned tick = 1; tick <= ticks; ++tick) {
    for (unsigned i = 0; all && i < kFigure2Sensors; ++i) {
      values[i] = 1 + 0.001 * (tick % 64);
    }
    step(&mission, 400.0 * tick / ticks, values, all ? kFigure2Sensors : 0);
  }
  return report(now() - begin, ticks, mission.state == S1);
}
