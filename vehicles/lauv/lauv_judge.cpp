// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/lauv/lauv_judge.h"

#include "hooks/imc/codec.h"
#include "hooks/imc/values.h"

namespace glider::lauv {

using namespace hooks::imc;

void LauvJudge::said(std::span<const uint8_t> bytes, double now_s) {
  for (size_t taken = 0; taken < bytes.size();) {
    taken += packets_.push(bytes.data() + taken, static_cast<uint32_t>(bytes.size() - taken));
    for (Packet packet; packets_.next(&packet);) {
      hear(packet, now_s);
    }
  }
}

void LauvJudge::hear(const Packet& packet, double now_s) {
  Reference reference;
  PlanControl request;
  if (packet.id == Reference::kId && decode(packet, reference)) {
    const bool whole = (reference.flags & ReferenceFlag::Location) != 0 &&
                       (reference.flags & ReferenceFlag::Z) != 0 &&
                       (reference.flags & ReferenceFlag::Speed) != 0 && reference.z.present &&
                       reference.speed.present && reference.z.value.z_units == ZUnits::Depth;
    takeCommand(static_cast<double>(reference.z.value.value), whole, now_s);
  }
  if (packet.id == PlanControl::kId && decode(packet, request)) {
    takeEnd(request.op == PlanOperation::Stop, now_s);
  }
}

}  // namespace glider::lauv
