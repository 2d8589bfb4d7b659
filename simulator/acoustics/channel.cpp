// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/acoustics/channel.h"

#include "simulator/acoustics/uniform.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glider::simulator {
namespace {

/// An assumption. Over the disc of the range this is a loss of 28 %; in a published campaign of
/// gliders, a quarter of the bytes needed a second try.
constexpr double kLossNear = 0.05, kLossFar = 0.5;

/// Streams of random numbers, apart from the noise of all sensors.
constexpr uint32_t kOfDistance = 0x6D6F6465, kOfTrouble = 0x6D6F6466;

double distance(const TruePlace& one, const TruePlace& other) {
  return std::hypot(one.east_m - other.east_m, one.north_m - other.north_m,
                    one.depth_m - other.depth_m);
}

bool overlap(const Span& one, const Span& other) {
  return one.from_s < other.to_s && other.from_s < one.to_s;
}

}  // namespace

double faintLoss(double range_m, double greatest_range_m) {
  const double share = std::min(range_m / greatest_range_m, 1.0);
  return kLossNear + (kLossFar - kLossNear) * share * share;
}

bool Channel::isFaint(uint32_t sender, uint32_t frame, uint32_t receiver, double probability,
                      uint32_t reason) const {
  return uniform(seed_, {sender, frame, receiver, reason}) < probability;
}

void Channel::send(uint32_t vehicle, double now_s, const AcousticFrame& frame,
                   const ModemSettings& settings) {
  const auto found = nodes_.find(vehicle);
  if (found == nodes_.end()) {
    return;
  }
  Node& sender = found->second;
  const uint32_t number = sender.sent++;
  const auto liar = trouble_.liars.find(vehicle);
  const AcousticFrame sent = liar == trouble_.liars.end() ? frame : liar->second.insteadOf(frame);
  const double length_s = settings.lengthOf(sent);
  sender.sending.push_back({now_s, now_s + length_s});
  for (auto& [other, node] : nodes_) {
    const double range_m = distance(sender.place, node.place);
    if (other == vehicle || range_m > settings.interference_m) {
      continue;
    }
    Arrival arrival;
    arrival.begin_s = now_s + range_m / kSoundSpeed;
    arrival.announced_s = arrival.begin_s + settings.cycle_init_s;
    arrival.end_s = arrival.begin_s + length_s;
    arrival.announcement_taken = sent.is_mini;
    arrival.sender = vehicle;
    arrival.in_range = range_m <= settings.range_m;
    arrival.faint =
        isFaint(vehicle, number, other, faintLoss(range_m, settings.range_m), kOfDistance) ||
        isFaint(vehicle, number, other, trouble_.loss, kOfTrouble);
    arrival.frame = sent;
    node.arrivals.push_back(arrival);
  }
}

/// Faintness is of the frame alone: the announcement is short and robust.
Loss Channel::lossOf(uint32_t vehicle, const Arrival& arrival, const Span& packet) const {
  const Node& node = nodes_.at(vehicle);
  const auto meets = [&](const Span& span) { return overlap(span, packet); };
  if (std::ranges::any_of(node.sending, meets)) {
    return Loss::Sending;
  }
  const auto jammed = jammed_.find(vehicle);
  if (jammed != jammed_.end() && std::ranges::any_of(jammed->second, meets)) {
    return Loss::Jammed;
  }
  const bool collides = std::ranges::any_of(node.arrivals, [&](const Arrival& other) {
    return &other != &arrival && meets({other.begin_s, other.end_s});
  });
  if (collides) {
    return Loss::Collision;
  }
  return arrival.faint && packet.to_s == arrival.end_s ? Loss::Faint : Loss::None;
}

std::vector<Reception> Channel::take(uint32_t vehicle, double now_s) {
  const auto found = nodes_.find(vehicle);
  if (found == nodes_.end()) {
    return {};
  }
  Node& node = found->second;
  std::vector<std::pair<uint32_t, Reception>> ended;  // with the sender
  for (Arrival& arrival : node.arrivals) {
    if (!arrival.in_range) {
      continue;
    }
    const auto take = [&](bool is_frame, double end_s) {
      const Loss loss = lossOf(vehicle, arrival, {arrival.begin_s, end_s});
      arrival.announced = is_frame ? arrival.announced : loss == Loss::None;
      ended.push_back(
          {arrival.sender,
           {is_frame, is_frame && arrival.announced, arrival.begin_s, end_s, loss, arrival.frame}});
    };
    if (!arrival.announcement_taken && arrival.announced_s <= now_s) {
      arrival.announcement_taken = true;
      take(false, arrival.announced_s);
    }
    if (!arrival.frame_taken && arrival.end_s <= now_s) {
      arrival.frame_taken = true;
      take(true, arrival.end_s);  // also lost if its announcement is
    }
  }
  std::ranges::stable_sort(ended, {},
                           [](const auto& one) { return std::tuple(one.second.end_s, one.first); });
  forget(node, now_s);
  std::vector<Reception> receptions;
  for (auto& [sender, reception] : ended) {
    receptions.push_back(reception);
  }
  return receptions;
}

/// Drops what cannot overlap with a frame that has not ended.
void Channel::forget(Node& node, double now_s) {
  double since_s = now_s;
  for (const Arrival& arrival : node.arrivals) {
    since_s = arrival.end_s > now_s ? std::min(since_s, arrival.begin_s) : since_s;
  }
  std::erase_if(node.arrivals, [&](const Arrival& arrival) { return arrival.end_s <= since_s; });
  std::erase_if(node.sending, [&](const Span& span) { return span.to_s <= since_s; });
}

}  // namespace glider::simulator
