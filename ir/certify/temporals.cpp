// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is watched over time: README step 3, E3, E5, B and W.

#include "ir/certify/tick.h"
#include "ir/core/ops.h"

namespace glider::ir::certify {

/// The temporals of `always`, or those of `state`, start, continue after a return or advance, in
/// the order of the vector.
void Tick::updateTemporals(bool always, StateId state, TemporalMoment moment, Store& store) {
  for (uint32_t i = 0; i < setting_.mission.temporals.size(); ++i) {
    const Temporal& t = setting_.mission.temporals[i];
    const bool of_always = t.list == ListKind::Always;
    if (of_always != always || (!of_always && t.state != state)) {
      continue;
    }
    if (isWindow(t.kind)) {
      updateWindow(i, moment, store);
    } else {
      updateGuard(i, moment, store);
    }
  }
}

/// B1 to B7. A return starts these again (E5).
void Tick::updateGuard(uint32_t temporal, TemporalMoment moment, Store& store) {
  const Temporal& t = setting_.mission.temporals[temporal];
  const Truths operand = expressions_.truth(t.operand, store);
  Memory& memory = store.memory.at(temporal);
  const bool starts = moment != TemporalMoment::Advance;
  const Term turned =
      starts ? Term("false") : out_.boolean(conjunction({operand.is_true, negation(memory.was)}));
  memory.since =
      starts ? expressions_.time() : out_.real(choice(turned, expressions_.time(), memory.since));
  memory.was = operand.is_true;
  if (t.kind == TemporalKind::Became) {
    const Term known = out_.boolean(disjunction({operand.is_true, operand.is_false}));
    store.temporals.at(temporal) =
        Truths{turned, out_.boolean(conjunction({known, negation(turned)}))};
    return;
  }
  const Number duration = expressions_.number(t.duration, store);
  const Term held = out_.real(operation("-", {expressions_.time(), memory.since}));
  const Term long_enough = out_.boolean(operation(">=", {held, duration.value}));
  store.temporals.at(temporal) = Truths{
      out_.boolean(conjunction({operand.is_true, duration.known, long_enough})),
      out_.boolean(disjunction({operand.is_false, conjunction({operand.is_true, duration.known,
                                                               negation(long_enough)})}))};
}

/// W5 to W9. Of a window's contents nothing is kept: its value is anything that its operand's range
/// allows. A window over time is unknown until its length has passed since it started: with its
/// state, or with the mission (exact: a difference of clocks). One along a sensor is unknown while
/// that is, and when it starts: one reading does not span a length.
void Tick::updateWindow(uint32_t temporal, TemporalMoment moment, Store& store) {
  const Temporal& t = setting_.mission.temporals[temporal];
  const Term started = t.list == ListKind::Always ? Term("0.0") : store.entered.back();
  const Term covered =
      t.along.valid()
          ? expressions_.number(t.along, store).known
          : out_.boolean(operation(
                ">=", {operation("-", {expressions_.time(), started}), literal(t.length)}));
  store.temporals.at(temporal) =
      expressions_.anyNumber(windowRange(t.kind, setting_.facts.ranges[t.operand.index]),
                             moment == TemporalMoment::Start ? Term("false") : covered);
}

}  // namespace glider::ir::certify
