// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"
#include "runtime/abi/recon_mission.h"
#include "runtime/board/dialect.h"
#include "runtime/board/files.h"
#include "runtime/board/own_line.h"
#include "runtime/recon/backseat.h"
#include "runtime/recon/udp_line.h"

#include <new>

extern "C" const GliderReconMission gliderRecon;

namespace glider::runtime {
namespace {

recon::Backseat* backseat = nullptr;
NetworkOption udp_option{.name = "--udp", .usual_port = recon::kUsualPort};
recon::UdpLine* udp = nullptr;

/// `power` is one of ten.
void tellStrangers(uint32_t power) {
  char text[] = "1000000000";
  uint32_t size = 1;
  for (; power >= 10; power /= 10) {
    ++size;
  }
  text[size] = '\0';
  tell(text, " datagram(s) passed over: not from ", udp_option.text);
}

void tellNews(recon::UdpLine::News news, uint32_t count) {
  using enum recon::UdpLine::News;
  switch (news) {
    case NoPort:
      tell("cannot listen for ", udp_option.text,
           ": another program may have the port; it is tried again");
      break;
    case Heard:
      tell("datagrams arrive from ", udp_option.text);
      break;
    case Stranger:
      tellStrangers(count);
      break;
  }
}

}  // namespace

int takeOwnLine(int argc, char** argv) {
  return udp_option.take(argc, argv);
}

void tellOwnLine() {
  static_assert(recon::kUsualPort == 23456, "as the text says");
  tell(
      "or over the network:\n  --udp ADDRESS[:PORT]  the vehicle's, for RECON: 192.168.1.10 "
      "(port 23456 on both sides)");
}

bool openOwnLine(OpenPort& line) {
  if (udp_option.text == nullptr) {
    return false;
  }
  // They live as long as the program: no exit handlers.
  alignas(hooks::SystemClock) static uint8_t clock[sizeof(hooks::SystemClock)];
  alignas(recon::UdpLine) static uint8_t memory[sizeof(recon::UdpLine)];
  udp = ::new (memory)
      recon::UdpLine(udp_option.address, (::new (clock) hooks::SystemClock)->clock(), tellNews);
  line.stream = udp->stream();
  return true;
}

const int* ownDescriptor() {
  return udp != nullptr ? udp->descriptor() : nullptr;
}

FrameLine framesOver(const GliderByteStream& line, const LinkFacts* checkpoint) {
  alignas(recon::Backseat) static uint8_t memory[sizeof(recon::Backseat)];
  backseat = ::new (memory) recon::Backseat(gliderMission, gliderRecon, line, checkpoint);
  return {backseat->stream(), backseat->damaged(), backseat->afterTick()};
}

bool mayEnd() {
  return backseat->mayEnd();
}

}  // namespace glider::runtime
