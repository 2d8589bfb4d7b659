// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace glider::campaign {

/// What a message between rank 0 and another rank is.
enum class MessageKind : uint8_t {
  // From another rank.
  Ready,        ///< it can fly; what Readiness holds
  Row,          ///< a flight is over; its row of the CSV
  HungRow,      ///< the same of one that was given up
  Failed,       ///< an I/O or system error
  Interrupted,  ///< it received a signal that ends it
  Bye,          ///< its last message
  // From rank 0.
  Fly,   ///< numbers of flights
  Land,  ///< begin no other flight, finish those under way
  Stop,  ///< end the flights under way
};

struct Message {
  size_t from = 0;
  MessageKind kind = MessageKind::Bye;
  std::string text;
};

/// The processes ("ranks", counted from 0) that fly one campaign together. A message arrives once;
/// those of one sender in their order. No function waits but `leave`.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  [[nodiscard]] virtual size_t rank() const = 0;
  [[nodiscard]] virtual size_t size() const = 0;
  virtual void send(size_t to, MessageKind kind, const std::string& text) = 0;
  void send(size_t to, MessageKind kind) { send(to, kind, ""); }
  virtual std::optional<Message> receive() = 0;
  /// Leaves the others; each rank must call it when it has sent and received everything.
  virtual void leave() = 0;
  /// Ends all ranks by force, with exit code `status`.
  virtual void abort(int status) = 0;
};

}  // namespace glider::campaign
