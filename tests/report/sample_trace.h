// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstddef>

namespace glider::report {

/// A flight like that of the paper's Figure 5, by plain kinematics: three layered yos between 3 m
/// and 28 m; from 260 s to 1460 s a mission searches for the thermocline (24 degC over 7 degC, one
/// internal wave) and tracks it. Every column that the report knows is there. The same on every
/// call.
support::Trace sampleTrace();

/// The sample with `rows` rows, by repeating it in time.
support::Trace longTrace(size_t rows);

/// The sample with names that are markup, script, escape sequences and not ASCII; each `<script>`
/// would set window.glider_was_here.
support::Trace hostileTrace();

/// The sample without field, states and events, with a gap of unknown depths.
support::Trace bareTrace();

/// The sample with chlorophyll, a varying conductivity, roll, energy, a current, a logged value,
/// and what its mission says: it reads chlorophyll first.
support::Trace scienceTrace();

/// 20,000 rows that change the state every 10 rows, with 1000 transitions.
support::Trace crowdedTrace();

/// The same flight as the log of a vehicle would show it, beside a simulated one.
support::Trace logTrace();

}  // namespace glider::report
