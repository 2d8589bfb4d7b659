// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/certify/certificate.h"
#include "ir/certify/expressions.h"

#include <vector>

/// What is kept between two ticks: the names of certificate.h, and what always holds of them.
namespace glider::ir::certify {

/// What a requirement's monitor remembers.
struct Remembered {
  Term after_seen = "false";
  Term surfaced = "0.0";
};

struct Between {
  Store store;
  Term time = "0.0";
  Remembered remembered;
};

/// A store in which nothing has started.
Store emptyStore(const Mission& mission);
/// The names of `at` themselves.
Between namedIn(const Setting& setting, const Configuration& at);
/// The values of namesIn(at), in their order.
std::vector<Term> valuesOf(const Setting& setting, const Configuration& at, const Between& between);

/// That clocks are in order, a truth value is not both true and false, and the vehicle is between
/// the surface and its deepest: a part of every invariant that need not be written.
Term wellFormed(const Setting& setting, const Configuration& at, const Between& between);

/// Requires that variables that have started are in their declared ranges, whole if only whole
/// numbers are ever assigned to them, and that parameters are known.
void requireRanges(const Setting& setting, SmtText& out, const Configuration& at,
                   const Store& store);

}  // namespace glider::ir::certify
