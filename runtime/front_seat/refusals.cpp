// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/front_seat/refusals.h"

#include "runtime/core/persistence.h"

namespace glider::runtime {
namespace {

struct Record {
  LogEvent event;
  LogDetail request;
};

Record recordOf(Refusals::Kind kind) {
  switch (kind) {
    case Refusals::Kind::PlanStart:
      return {LogEvent::VehicleRefused, LogDetail::PlanStart};
    case Refusals::Kind::PlanEnd:
      return {LogEvent::VehicleRefused, LogDetail::PlanEnd};
    case Refusals::Kind::PlanFailed:
      return {LogEvent::PlanFailed, LogDetail::None};
    case Refusals::Kind::Override:
      return {LogEvent::WithoutEffect, LogDetail::Override};
    case Refusals::Kind::OverrideEnd:
      break;
  }
  return {LogEvent::WithoutEffect, LogDetail::OverrideEnd};
}

}  // namespace

void Refusals::report(void* self, Persistence& persistence) {
  auto& refusals = *static_cast<Refusals*>(self);
  for (uint32_t i = 0; i < kKinds; ++i) {
    if (refusals.wait_[i] != 0) {
      --refusals.wait_[i];
    } else if (refusals.times_[i] != 0) {
      const Record record = recordOf(static_cast<Kind>(i));
      persistence.logs(record.event, record.request, refusals.times_[i]);
      refusals.times_[i] = 0;
      refusals.wait_[i] = kBetween - 1;
    }
  }
}

}  // namespace glider::runtime
