// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/seat_on_board.h"

#include "runtime/extctl/backseat.h"
#include "runtime/imc/backseat.h"
#include "runtime/recon/backseat.h"

namespace glider::flights {
namespace {

/// A way to steer each, by the type of what a program knows of it.
struct Maker {
  const GliderMission& mission;
  const GliderByteStream& line;
  const runtime::LinkFacts* checkpoint;

  SeatOnBoard operator()(const GliderPortMission& port) const {
    auto seat = std::make_shared<runtime::extctl::Backseat>(
        mission, port, line, runtime::extctl::BackseatOptions{.checkpoint = checkpoint});
    return {seat, seat->stream(), [seat = seat.get()] { return seat->mayEnd(); }};
  }
  SeatOnBoard operator()(const GliderReconMission& recon) const {
    auto seat = std::make_shared<runtime::recon::Backseat>(mission, recon, line, checkpoint);
    return {seat, seat->stream(), [seat = seat.get()] { return seat->mayEnd(); }};
  }
  SeatOnBoard operator()(const GliderImcMission& imc) const {
    auto seat = std::make_shared<runtime::imc::Backseat>(
        mission, imc, runtime::imc::VehicleLine{.stream = line}, checkpoint);
    return {seat, seat->stream()};
  }
};

}  // namespace

SeatOnBoard makeSeat(const SeatSettings& settings, const GliderMission& mission,
                     const GliderByteStream& line, const runtime::LinkFacts* checkpoint) {
  return std::visit(Maker{mission, line, checkpoint}, settings);
}

}  // namespace glider::flights
