// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/codec.h"
#include "simulator/acoustics/channel.h"
#include "simulator/acoustics/modem_settings.h"
#include "simulator/journal.h"
#include "simulator/link/serial_line.h"
#include "support/trace/flight_facts.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace glider::simulator {

/// The Micro-Modem of a vehicle: it speaks with the SBC on a serial line, and with other modems
/// through the channel. It has power while the SBC has, and keeps its address without. Only what
/// glidercc uses is simulated: rate 0, one frame, no acknowledgement, and mini packets; it refuses
/// all else.
class SimulatedModem {
 public:
  /// `vehicle`: its number in the channel, in which it must be placed.
  SimulatedModem(const ModemSettings& settings, std::shared_ptr<Channel> channel, uint32_t vehicle);
  SimulatedModem(const SimulatedModem&) = delete;
  SimulatedModem& operator=(const SimulatedModem&) = delete;

  /// Puts what the SBC has sent on the line.
  void fromHost(std::span<const uint8_t> bytes, double now_s);
  /// What has arrived at the SBC.
  std::vector<uint8_t> toHost(double now_s);
  /// Works until `now_s`, with power since the step before or without. Returns the energy that it
  /// has drawn since then, J.
  double step(double now_s, bool powered);

  /// Sent and received so far.
  [[nodiscard]] const support::AcousticTotals& totals() const { return totals_; }
  /// What has happened since they were last taken, for the journal of the flight.
  std::vector<News>& news() { return news_; }

 private:
  enum class Doing : uint8_t { Listening, WaitingForData, Sending, SendingMini };

  void turnOn(double now_s);
  void turnOff();
  void readLine(double now_s);
  void answer(const hooks::Text& body, double now_s);
  void configure(const hooks::micro_modem::SetSetting& setting, double now_s);
  void startCycle(const hooks::micro_modem::StartCycle& cycle, double now_s);
  void transmit(const hooks::micro_modem::Transmit& data, double now_s);
  void sendMini(const hooks::micro_modem::SendMiniPacket& packet, double now_s);
  void send(const AcousticFrame& frame, double now_s);
  void followTime(double now_s);
  void receive(double now_s);
  void receive(const Reception& reception);
  void refuse(const char* why, double now_s);
  template <typename Message>
  void say(const Message& message);
  [[nodiscard]] double drawnJ() const {
    return totals_.sent_J + totals_.received_J + totals_.listen_J;
  }

  ModemSettings settings_;
  std::shared_ptr<Channel> channel_;
  uint32_t vehicle_;
  SerialLine line_;
  GliderByteStream modem_end_, host_end_;
  hooks::SentenceReader sentences_;
  Doing doing_ = Doing::Listening;
  uint32_t address_ = 0;  ///< 0: not set
  bool powered_ = false;
  double on_since_s_ = 0;
  double stepped_s_ = 0;
  double until_s_ = 0;  ///< of the wait, or of what is being sent
  hooks::micro_modem::StartCycle cycle_;
  uint32_t sent_bytes_ = 0;
  support::AcousticTotals totals_;
  std::vector<News> news_;
};

}  // namespace glider::simulator
