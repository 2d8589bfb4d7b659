// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/frame_reader.h"
#include "hooks/protocol/instruction.h"
#include "hooks/protocol/messages.h"
#include "hooks/protocol/nap.h"
#include "hooks/protocol/send_queue.h"
#include "hooks/protocol/sensor_list.h"
#include "hooks/protocol/tick.h"
#include "hooks/transport/byte_stream.h"
#include "hooks/transport/clock.h"

#include <stdint.h>

/// The SBC's side of the 115200 line. It sends only in answer to a frame of the vehicle; every
/// answer ends with a Done message, which is the heartbeat at sea and the lockstep in virtual time.
/// No heap; one object per glider.
namespace glider::hooks {

using Reading = SensorValue;

/// One control cycle of the vehicle as its frame reports it.
struct VehicleTick {
  double vehicle_time_s = 0;  ///< since the vehicle's own mission started
  uint32_t cycle = 0;
  HookState hook_state = HookState::Absent;
  HookAnswer answer = HookAnswer::None;
  uint16_t answered_sequence = 0;
  uint32_t session = 0;  ///< in control, 0 for none
  uint32_t clock_s = 0;  ///< the vehicle's clock, s since 1970; 0: unknown
  bool kept = false;     ///< during a nap of this program: newer ones follow at once
  /// The vehicle obeys this program: the session in control is that of its newest Take.
  bool obeys_us = false;
  /// Number under which the newest instruction is sent from now on, 0 before the first. It differs
  /// from the one that instruct() returned if the vehicle treated that number as old.
  uint16_t instruction_sequence = 0;
  /// Ticks since hookbeh last answered while an instruction waits for its answer; 0: none waits.
  uint32_t unanswered_ticks = 0;
  uint32_t reading_count = 0;
  /// The sensors reported in this cycle with their values, changed or not, in the subscription's
  /// order.
  Reading readings[kMostSubscriptions];
};

struct ClientOptions {
  const char* mission_name = "";  ///< must outlive the client; only 47 bytes of it are sent
  /// First session number, 1…16777215; each new handshake counts up. A program that restarts should
  /// continue its earlier count (from its checkpoint, or from the time): hookbeh refuses numbers
  /// that were lost, and the client then counts up until one is accepted.
  uint32_t session = 1;
  const Subscription* sensors = nullptr;  ///< each at most once
  uint32_t sensor_count = 0;              ///< at most kMostSubscriptions
  Features features = {.offers = kAllFeatures, .needs = 0};
};

enum class ClientEvent : uint8_t {
  Nothing,     ///< no complete frame is there
  Handled,     ///< the client processed and answered a frame itself (a Beacon, a Welcome)
  Tick,        ///< tick() is new: the caller must call done()
  SilentLink,  ///< no whole tick for 12 s of the SBC's own clock, or, after a nap was ordered, for
               ///< as much longer as it may take (never in virtual time): a tick of the clock alone
  Refused,     ///< another protocol version or sensor dictionary, or a feature is missing;
               ///< reported once for each: see refusal()
  Closed,      ///< the stream's other end is gone
};

/// Why there is no link: what the vehicle reported.
struct Refusal {
  bool refused = false;
  uint8_t version = 0;
  uint32_t dictionary = 0;        ///< means something when the version is ours
  uint16_t missing_features = 0;  ///< what one side needs and the other does not offer; likewise
  bool operator==(const Refusal&) const = default;
};

/// A part of a client's memory that nothing on the line can break.
enum class ClientPart : uint8_t {
  None,
  SendQueue,
  Reader,
  Subscribed,
  Readings,
  Notices,
  Notes,
  Control,  ///< of the instruction that waits for its answer
  Vertical,
  Lateral,
};

class Client {
 public:
  /// `dictionary` outlives this.
  Client(const GliderDictionary& dictionary, const ClientOptions& options);

  /// Reads what is there and handles at most one frame; never blocks.
  ClientEvent poll(const GliderByteStream& stream, const GliderClock& clock);
  [[nodiscard]] const VehicleTick& tick() const { return tick_; }
  /// True when the vehicle reported that its time is virtual: the SBC's clock then does not advance
  /// between frames.
  [[nodiscard]] bool virtualTime() const { return virtual_time_; }

  [[nodiscard]] const Refusal& refusal() const { return refusal_; }
  /// Frames that arrived damaged, since the start.
  [[nodiscard]] uint32_t badFrames() const { return reader_.badFrames(); }
  /// True while the vehicle serves this program's subscription.
  [[nodiscard]] bool linked() const { return linked_; }

  /// Adds to the answer of this tick, or of the next one when called between ticks. `instruction`:
  /// session, sequence and check are filled in by the client (Take opens a new session; a Steer of
  /// a session whose Take was never accepted goes as Take); its real numbers go in whole steps. If
  /// there are several, only the newest is sent; it is repeated until hookbeh answers it. Returns
  /// its sequence number: answered when tick().answered_sequence equals it (see
  /// VehicleTick::instruction_sequence).
  uint16_t instruct(Instruction instruction);
  /// Reports a transition with the answer of this tick; notices beyond kMostNotices in one answer
  /// are dropped.
  void notify(const TransitionNotice& notice);
  /// Sends a note after everything more important; a note for which the line has no room is
  /// dropped.
  void tell(const MissionNote& note);
  /// Adds to the answer of the current tick the order to keep ticks while this program sleeps; it
  /// is dropped between ticks, unless mayNap(), and if anything else was added to the answer or
  /// waits for one. Returns whether it was added. The vehicle may have reasons not to follow: then
  /// ticks come as ever.
  bool nap(const Nap& nap);
  /// True while there is a link, of a program that needs naps: such a vehicle offers them.
  [[nodiscard]] bool mayNap() const {
    return linked_ && (options_.features.needs & kFeatureNaps) != 0;
  }
  /// Continues `session` of the program that this one replaces; its newest instruction had the
  /// number `sequence`. 0: no session, and the next Take opens a newer one. The session is claimed
  /// again with the next instruction.
  void resume(uint32_t session, uint16_t sequence);
  /// The session of the newest Take, 0 before the first.
  [[nodiscard]] uint32_t session() const { return session_; }
  /// The newest instruction's number, 0 before the first.
  [[nodiscard]] uint16_t sequence() const { return sequence_; }
  /// The first part that is broken, by a fault of the memory or of the program.
  [[nodiscard]] ClientPart brokenPart() const;
  /// Ends and sends the answer. Without a tick to answer it only remembers `status` for the next
  /// one.
  void done(const MissionStatus& status, const GliderByteStream& stream);

  /// After this many ticks without an expected answer of hookbeh, this program no longer claims
  /// control: its answers do not count as a heartbeat until hookbeh receives its instructions
  /// again.
  static constexpr uint32_t kMostUnansweredTicks = 6;
  static constexpr uint32_t kMostNotices = 8;
  static constexpr uint32_t kMostNotes = 8;
  /// Seconds of the SBC's own clock without a whole tick that make a SilentLink; again after each
  /// further such time. After a nap was ordered, its length, its time to wake and kLateSecs are
  /// added.
  static constexpr double kSilenceSecs = 12;
  /// So much later a nap may end if the vehicle's cycles do not come.
  static constexpr double kLateSecs = 24;

 private:
  ClientEvent handle(const Frame& frame, const GliderByteStream& stream);
  ClientEvent handleBeacon(const Frame& frame, const GliderByteStream& stream);
  ClientEvent handleWelcome(const Frame& frame, const GliderByteStream& stream);
  ClientEvent handleTick(const Frame& frame, const GliderByteStream& stream);
  ClientEvent refuse(const Refusal& refusal);
  void takeLink();
  /// False for a cycle that this link has reported already, or an earlier one.
  [[nodiscard]] bool isNewCycle(uint32_t cycle) const;
  void takeTick(const TickHead& head);
  bool takeReadings(const Frame& frame, const TickHead& head);
  bool takeReading(uint32_t index, const TickReadings& told);
  void followInstruction();
  void lookForAnswer();
  void renumber();
  void learnSession(uint32_t session);
  void queue(Frame& frame);
  void askForLink();
  void queueHello();
  void queueSubscribe();
  void queueInstruction();
  void queueNotes();
  void answer(const GliderByteStream& stream);

  const GliderDictionary* dictionary_;
  ClientOptions options_;
  FrameReader reader_;
  SendQueue out_;
  uint8_t out_sequence_ = 0;

  bool heard_ = false;  // a start time for counting silence is set
  double last_tick_s_ = 0;
  double silence_s_ = kSilenceSecs;  // until a SilentLink
  bool linked_ = false;
  bool virtual_time_ = false;
  Refusal refusal_;
  uint32_t link_ = 0;         // 0: no Hello sent yet
  bool link_used_ = false;    // the vehicle has used it in a frame
  bool cycle_known_ = false;  // a tick of it was taken: tick_.cycle
  uint32_t next_session_ = 1;

  Subscribe subscription_;
  uint16_t subscription_check_ = 0;
  bool resubscribe_ = false;
  // The newest value of each subscribed sensor, as the vehicle assumes it to be known here.
  double held_[kMostSubscriptions] = {};
  bool holds_[kMostSubscriptions] = {};

  VehicleTick tick_;
  bool must_answer_ = false;
  uint8_t answered_frame_ = 0;
  MissionStatus status_;
  TransitionNotice notices_[kMostNotices];
  uint32_t notice_count_ = 0;
  MissionNote notes_[kMostNotes];
  uint32_t note_count_ = 0;

  Instruction pending_;
  bool waiting_ = false;  // hookbeh has not answered `pending_` yet
  bool due_ = false;      // its answer is awaited, and it is sent with the next answer
  uint32_t unanswered_ticks_ = 0;
  uint16_t settled_ = 0;       // the newest number that hookbeh has reported as seen, 0 for none
  uint16_t last_settled_ = 0;  // in the tick before
  uint32_t session_ = 0;       // of the newest Take, 0 before the first
  bool claims_ = true;         // it is ours to keep alive
  bool taken_ = false;         // hookbeh was seen active in `session_`
  uint16_t sequence_ = 0;
};

}  // namespace glider::hooks
