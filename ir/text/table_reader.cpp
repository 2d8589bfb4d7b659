// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/text/table_reader.h"

#include "ir/core/ops.h"

namespace glider::ir::text {
namespace {

constexpr int64_t kMostEntries = UINT32_MAX;

/// `(`, what `element` reads with commas between, `)`.
template <typename Element>
void list(Cursor& in, Element element) {
  in.expect('(');
  if (in.accept(')')) {
    return;
  }
  do {
    element();
  } while (in.accept(','));
  in.expect(')');
}

uint32_t number(Cursor& in) {
  return static_cast<uint32_t>(in.integer(0, kMostEntries));
}

/// The sensor or clock; a sensor is followed by its name.
void source(Cursor& in, Names& sensors, GuardColumn& column) {
  for (const Op op : {Op::Sensor, Op::MissionTime, Op::StateTime, Op::ResumeTime}) {
    if (in.accept(opInfo(op).text)) {
      column.source = op;
      if (op == Op::Sensor) {
        column.sensor = {sensors.find(in.nameToken("the sensor's name"))};
      }
      return;
    }
  }
  in.failExpecting("`sensor`, `missiontime`, `statetime` or `resumetime`");
}

Cut cut(Cursor& in) {
  Cut result;
  result.inclusive = in.accept("ge");
  if (!result.inclusive) {
    in.expect("gt");
  }
  result.at = in.number(false);
  return result;
}

GuardColumn column(Cursor& in, Names& sensors) {
  GuardColumn result;
  source(in, sensors, result);
  list(in, [&] { result.cuts.push_back(cut(in)); });
  return result;
}

GuardRow row(Cursor& in) {
  GuardRow result;
  result.number = number(in);
  list(in, [&] {
    const uint32_t first = number(in);
    result.within.push_back({first, number(in)});
  });
  result.exact = in.accept("exact");
  return result;
}

}  // namespace

GuardTable readTable(Cursor& in, Names& sensors) {
  GuardTable table;
  while (!in.failed() && !in.accept("end")) {
    if (in.accept("column")) {
      table.columns.push_back(column(in, sensors));
    } else if (in.accept("row")) {
      table.rows.push_back(row(in));
    } else {
      in.failExpecting("`column`, `row` or `end`");
    }
  }
  return table;
}

}  // namespace glider::ir::text
