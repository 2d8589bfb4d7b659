// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/micro_modem/codec.h"

#include "hooks/micro_modem/fields.h"
#include "hooks/micro_modem/sentence_writer.h"

namespace glider::hooks::micro_modem {
namespace {

constexpr uint32_t kMostRate = 5, kMostFrames = 8, kMostRequest = 256;
constexpr uint32_t kMostWhole = 65535, kMostBits = 0x1FFF;
/// Both spellings occur.
constexpr char kBadSum[] = "BAD_CRC", kBadSumInWords[] = "Bad CRC";

const char* nameOf(Side side, const char* host, const char* modem) {
  return side == Side::Host ? host : modem;
}

template <Side side>
uint32_t write(const SettingOf<side>& message, char* bytes, uint32_t capacity) {
  return SentenceWriter(nameOf(side, "CCCFG", "CACFG"), bytes, capacity)
      .name(message.name)
      .whole(0, kMostWhole, message.value)
      .end();
}

template <Side side>
bool read(const Text& body, SettingOf<side>& message) {
  return Fields(body)
      .is(nameOf(side, "CCCFG", "CACFG"))
      .name(&message.name)
      .whole(0, kMostWhole, &message.value)
      .end();
}

template <Side side>
uint32_t write(const CycleOf<side>& message, char* bytes, uint32_t capacity) {
  return SentenceWriter(nameOf(side, "CCCYC", "CACYC"), bytes, capacity)
      .text("0")
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .whole(0, kMostRate, message.rate)
      .flag(message.acknowledge)
      .whole(1, kMostFrames, message.frames)
      .end();
}

template <Side side>
bool read(const Text& body, CycleOf<side>& message) {
  return Fields(body)
      .is(nameOf(side, "CCCYC", "CACYC"))
      .is("0")
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .whole(0, kMostRate, &message.rate)
      .flag(&message.acknowledge)
      .whole(1, kMostFrames, &message.frames)
      .end();
}

const char* nameOf(Mini mini) {
  constexpr const char* kNames[] = {"CCMUC", "CAMUC", "CAMUA"};
  return kNames[static_cast<uint32_t>(mini)];
}

template <Mini mini>
uint32_t write(const MiniPacketOf<mini>& message, char* bytes, uint32_t capacity) {
  return SentenceWriter(nameOf(mini), bytes, capacity)
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .bits(kMostBits, message.bits)
      .end();
}

template <Mini mini>
bool read(const Text& body, MiniPacketOf<mini>& message) {
  return Fields(body)
      .is(nameOf(mini))
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .bits(kMostBits, &message.bits)
      .end();
}

}  // namespace

uint32_t encode(const SetSetting& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, SetSetting& message) {
  return read(body, message);
}
uint32_t encode(const SettingIs& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, SettingIs& message) {
  return read(body, message);
}

uint32_t encode(const StartCycle& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, StartCycle& message) {
  return read(body, message);
}
uint32_t encode(const CycleStarts& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, CycleStarts& message) {
  return read(body, message);
}

uint32_t encode(const SendMiniPacket& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, SendMiniPacket& message) {
  return read(body, message);
}
uint32_t encode(const MiniPacketEcho& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, MiniPacketEcho& message) {
  return read(body, message);
}
uint32_t encode(const MiniPacketReceived& message, char* bytes, uint32_t capacity) {
  return write(message, bytes, capacity);
}
bool decode(const Text& body, MiniPacketReceived& message) {
  return read(body, message);
}

uint32_t encode(const Transmit& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CCTXD", bytes, capacity)
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .flag(message.acknowledge)
      .data(message.data)
      .end();
}

bool decode(const Text& body, Transmit& message) {
  return Fields(body)
      .is("CCTXD")
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .flag(&message.acknowledge)
      .data(&message.data)
      .end();
}

uint32_t encode(const DataRequest& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CADRQ", bytes, capacity)
      .time(message.time_s)
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .flag(message.acknowledge)
      .whole(0, kMostRequest, message.bytes)
      .whole(1, kMostFrames, message.frame)
      .end();
}

bool decode(const Text& body, DataRequest& message) {
  return Fields(body)
      .is("CADRQ")
      .time(&message.time_s)
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .flag(&message.acknowledge)
      .whole(0, kMostRequest, &message.bytes)
      .whole(1, kMostFrames, &message.frame)
      .end();
}

uint32_t encode(const Received& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CARXD", bytes, capacity)
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .flag(message.acknowledge)
      .whole(1, kMostFrames, message.frame)
      .data(message.data)
      .end();
}

bool decode(const Text& body, Received& message) {
  return Fields(body)
      .is("CARXD")
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .flag(&message.acknowledge)
      .whole(1, kMostFrames, &message.frame)
      .data(&message.data)
      .end();
}

uint32_t encode(const Damaged& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CAMSG", bytes, capacity)
      .text(kBadSum)
      .whole(1, kMostFrames, message.frame)
      .end();
}

bool decode(const Text& body, Damaged& message) {
  return Fields(body)
      .is("CAMSG")
      .isEither(kBadSum, kBadSumInWords)
      .whole(1, kMostFrames, &message.frame)
      .end();
}

uint32_t encode(const Acknowledged& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CAACK", bytes, capacity)
      .whole(0, kMostAddress, message.source)
      .whole(0, kMostAddress, message.destination)
      .whole(1, kMostFrames, message.frame)
      .flag(message.acknowledged)
      .end();
}

bool decode(const Text& body, Acknowledged& message) {
  return Fields(body)
      .is("CAACK")
      .whole(0, kMostAddress, &message.source)
      .whole(0, kMostAddress, &message.destination)
      .whole(1, kMostFrames, &message.frame)
      .flag(&message.acknowledged)
      .end();
}

uint32_t encode(const TransmitEnds& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CATXF", bytes, capacity).whole(0, kMostWhole, message.bytes).end();
}

bool decode(const Text& body, TransmitEnds& message) {
  return Fields(body).is("CATXF").whole(0, kMostWhole, &message.bytes).end();
}

uint32_t encode(const Refusal& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CAERR", bytes, capacity).text(message.text).end();
}

bool decode(const Text& body, Refusal& message) {
  return Fields(body).is("CAERR").rest(&message.text).end();
}

uint32_t encode(const Revision& message, char* bytes, uint32_t capacity) {
  return SentenceWriter("CAREV", bytes, capacity).text(message.text).end();
}

bool decode(const Text& body, Revision& message) {
  return Fields(body).is("CAREV").rest(&message.text).end();
}

}  // namespace glider::hooks::micro_modem
