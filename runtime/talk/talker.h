// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/micro_modem/codec.h"
#include "hooks/share/message.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/glider_abi.h"
#include "runtime/abi/talk_mission.h"
#include "runtime/talk/slot_clock.h"

#include <stdint.h>

namespace glider::runtime::talk {

/// What a Talker has done since it was made.
struct TalkerCounts {
  uint32_t sent = 0;        ///< messages whose end, or mini packet, the modem has reported
  uint32_t received = 0;    ///< messages of the mission's own shares
  uint32_t refused = 0;     ///< frames of others that are not such a message
  uint32_t damaged = 0;     ///< frames that the modem could not read
  uint32_t unanswered = 0;  ///< cycles that the modem did not finish, or refused
};

/// Sends the shares of a mission to the other vehicles of its fleet, and receives theirs, by an
/// acoustic modem (README.md). It never blocks, and nothing that the modem does or omits has an
/// effect on the mission other than the values that are received. No heap.
class Talker {
 public:
  /// A modem that answers nothing for so long has given up the cycle, s: the longest part of one is
  /// a frame in the water, 6 s at rate 0.
  static constexpr double kPatienceSecs = 10;
  /// The modem is asked again to take its address after this, s.
  static constexpr double kAskAgainSecs = 5;
  /// The modem asks for the data, or has taken a mini packet, within this time after a cycle was
  /// begun, s; later, it would end in the slot of another vehicle. platforms::slotOf has room for
  /// it.
  static constexpr double kLongestDialogueSecs = 2;
  /// What was received waits so long for a frame of the vehicle, s: its age counts from there.
  static constexpr double kLongestWaitSecs = 20;
  static constexpr uint32_t kMostBytesPerPoll = 512;

  /// Whether a vehicle can have this address in a fleet that has so many slots.
  static bool isAddress(uint32_t address, uint32_t vehicles) {
    return address >= 1 && address <= vehicles && vehicles <= hooks::micro_modem::kMostAddress;
  }

  /// `talk` outlives this. If not isAddress(address, vehicles), it does nothing at all.
  Talker(const GliderTalk& talk, uint32_t address, uint32_t vehicles)
      : talk_(talk), address_(address), vehicles_(vehicles), clock_(talk) {}
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;

  /// Reads what the modem says, and writes what is due. To be called about once a second, and when
  /// the modem has bytes. `context` is the mission's memory, null before the mission has begun;
  /// `clock_s` is the SBC's clock, s.
  void poll(const GliderByteStream& modem, GliderContext* context, double clock_s);

  [[nodiscard]] const TalkerCounts& counts() const { return counts_; }
  /// Sentences of the modem that were begun and are wrong.
  [[nodiscard]] uint32_t badSentences() const { return reader_.bad(); }
  /// The line to the modem has ended: nothing more will be sent or received.
  [[nodiscard]] bool isClosed() const { return closed_; }

 private:
  enum class Step : uint8_t {
    Idle,
    Begins,    ///< a cycle was asked for
    Sends,     ///< the modem has its data
    SendsMini  ///< a mini packet was given to the modem
  };
  static constexpr double kNever = -1e30;

  void read(const GliderByteStream& modem, GliderContext* context);
  void flush(const GliderByteStream& modem);
  void take(const hooks::Text& sentence, GliderContext* context);
  void takeSetting(const hooks::micro_modem::SettingIs& setting);
  void takeRequest(const hooks::micro_modem::DataRequest& request, const GliderContext* context);
  void takeEcho(const hooks::micro_modem::MiniPacketEcho& echo);
  void takeMini(const hooks::micro_modem::MiniPacketReceived& packet, GliderContext* context);
  void takeFrame(const hooks::micro_modem::Received& frame, GliderContext* context);
  template <typename Packet, typename IsIt>
  void receive(const Packet& packet, const hooks::share::MessageReader& data,
               GliderContext* context, IsIt isIt);
  /// Takes the values of `message` out of `reader`, whose end the caller looks at.
  void skip(const GliderMessage& message, hooks::share::MessageReader& reader) const;
  void keep(const GliderMessage& message, hooks::share::MessageReader reader, uint32_t source,
            GliderContext* context);
  void wait(GliderReading& reading, double value, double& received);
  void forget(GliderContext& context) const;
  void pack(const GliderMessage& message, const GliderContext& context,
            hooks::share::MessageWriter& writer) const;
  void wasGiven();
  void askForAddress();
  void begin(const GliderContext& context);
  [[nodiscard]] bool beginMini(const GliderMessage& message, const GliderContext& context);
  void giveUp();
  [[nodiscard]] uint32_t mostOverdue() const;
  [[nodiscard]] bool hasRoom() const { return out_size_ == 0; }
  template <typename Sentence>
  bool say(const Sentence& sentence);

  const GliderTalk& talk_;
  uint32_t address_;
  uint32_t vehicles_;
  SlotClock clock_;
  hooks::SentenceReader reader_;
  TalkerCounts counts_;
  char out_[hooks::micro_modem::kMostSentence] = {};  ///< what the modem has not taken yet
  uint32_t out_size_ = 0;
  uint32_t out_taken_ = 0;
  Step step_ = Step::Idle;
  bool has_address_ = false;  ///< the modem has confirmed it
  bool closed_ = false;
  double asked_ = kNever;       ///< for the address, s
  double since_ = 0;            ///< the step, s
  uint32_t message_ = 0;        ///< of the cycle
  uint32_t mini_bits_ = 0;      ///< of the mini packet
  uint64_t slot_ = UINT64_MAX;  ///< the newest in which a cycle was begun
  double sent_[GLIDER_MOST_SHARES] = {};
  bool was_sent_[GLIDER_MOST_SHARES] = {};
  double received_[GLIDER_MOST_SHARES] = {};
  double named_received_[GLIDER_MOST_NAMED] = {};
};

}  // namespace glider::runtime::talk
