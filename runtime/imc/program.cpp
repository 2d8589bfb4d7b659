// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/system_clock.h"
#include "runtime/abi/imc_mission.h"
#include "runtime/board/dialect.h"
#include "runtime/board/files.h"
#include "runtime/board/own_line.h"
#include "runtime/imc/backseat.h"
#include "runtime/imc/tcp_line.h"

#include <new>

extern "C" const GliderImcMission gliderImc;

namespace glider::runtime {
namespace {

NetworkOption tcp_option{.name = "--tcp"};
imc::TcpLine* tcp = nullptr;

void tellConnection(bool connected) {
  tell(connected ? "connected to " : "no connection to ", tcp_option.text,
       connected ? "" : "; it is tried again");
}

void renewTcp(void* self) {
  static_cast<imc::TcpLine*>(self)->renew();
}

}  // namespace

int takeOwnLine(int argc, char** argv) {
  return tcp_option.take(argc, argv);
}

void tellOwnLine() {
  tell(
      "or over the network:\n  --tcp ADDRESS:PORT  the vehicle's port for a back seat: "
      "10.0.10.20:6006");
}

bool openOwnLine(OpenPort& line) {
  if (tcp_option.text == nullptr) {
    return false;
  }
  // They live as long as the program: no exit handlers.
  alignas(hooks::SystemClock) static uint8_t clock[sizeof(hooks::SystemClock)];
  alignas(imc::TcpLine) static uint8_t memory[sizeof(imc::TcpLine)];
  tcp = ::new (memory)
      imc::TcpLine(tcp_option.address, (::new (clock) hooks::SystemClock)->clock(), tellConnection);
  line.stream = tcp->stream();
  return true;
}

const int* ownDescriptor() {
  return tcp != nullptr ? tcp->descriptor() : nullptr;
}

FrameLine framesOver(const GliderByteStream& line, const LinkFacts* checkpoint) {
  alignas(imc::Backseat) static uint8_t memory[sizeof(imc::Backseat)];
  auto* backseat = ::new (memory) imc::Backseat(
      gliderMission, gliderImc,
      {.stream = line, .renew = tcp != nullptr ? renewTcp : nullptr, .self = tcp}, checkpoint);
  return {backseat->stream(), backseat->damaged(), backseat->afterTick()};
}

bool mayEnd() {
  return true;
}

}  // namespace glider::runtime
