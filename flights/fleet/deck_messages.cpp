// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/fleet/deck_messages.h"

#include "flights/logged_form.h"
#include "hooks/janus/packet.h"
#include "hooks/micro_modem/codec.h"
#include "hooks/share/message.h"
#include "ir/core/parameter_info.h"
#include "runtime/launch/quantity.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

namespace glider::flights {
namespace {

namespace micro_modem = hooks::micro_modem;
namespace janus = hooks::janus;

using hooks::share::MessageReader;
using hooks::share::MessageWriter;
using hooks::share::Scale;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kByteBits = 8;

std::span<const ir::Share> sharesOf(const ir::Mission& mission, const ir::ShareMessage& message) {
  return std::span(mission.shares).subspan(message.first, message.count);
}

Scale scaleOf(const ir::Share& share) {
  return {share.lowest, share.step, share.values};
}

std::vector<double> valuesIn(const ir::Mission& mission, const ir::ShareMessage& message,
                             MessageReader& reader) {
  std::vector<double> values;
  for (const ir::Share& share : sharesOf(mission, message)) {
    values.push_back(reader.take(scaleOf(share)));
  }
  return values;
}

std::optional<HeardMessage> frameOf(const ir::Mission& mission, HeardBy by, uint32_t source,
                                    const uint8_t* bytes, uint32_t size) {
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    const bool janus = by == HeardBy::Janus;
    if (janus && message.bytes > size) {
      continue;
    }
    MessageReader reader(bytes, janus ? message.bytes : size);
    std::vector<double> values = valuesIn(mission, message, reader);
    const bool fits =
        janus ? std::all_of(bytes + message.bytes, bytes + size, [](uint8_t b) { return b == 0; })
              : message.mini_bits == 0;
    if (fits && reader.end(static_cast<uint8_t>(message.signature), message.bytes)) {
      return HeardMessage{by, source, message, std::move(values)};
    }
  }
  return std::nullopt;
}

std::optional<HeardMessage> miniOf(const ir::Mission& mission, uint32_t source, uint32_t bits) {
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    MessageReader reader(bits);
    std::vector<double> values = valuesIn(mission, message, reader);
    if (message.mini_bits != 0 && reader.endMini(static_cast<uint8_t>(message.signature))) {
      return HeardMessage{HeardBy::MiniPacket, source, message, std::move(values)};
    }
  }
  return std::nullopt;
}

std::optional<HeardMessage> inSentence(const ir::Mission& mission, const hooks::Text& sentence) {
  if (micro_modem::Received frame; decode(sentence, frame)) {
    return frameOf(mission, HeardBy::Frame, frame.source, frame.data.bytes, frame.data.size);
  }
  if (micro_modem::Transmit told; decode(sentence, told)) {
    return frameOf(mission, HeardBy::Frame, told.source, told.data.bytes, told.data.size);
  }
  if (micro_modem::MiniPacketReceived mini; decode(sentence, mini)) {
    return miniOf(mission, mini.source, mini.bits);
  }
  if (micro_modem::SendMiniPacket mini; decode(sentence, mini)) {
    return miniOf(mission, mini.source, mini.bits);
  }
  return std::nullopt;
}

/// The message in the 16 digits at the end of `line`.
std::optional<HeardMessage> inJanus(const ir::Mission& mission, std::string_view line,
                                    uint8_t janus_class) {
  line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
  line = line.substr(line.find_last_of(" \t,:") + 1);
  std::array<uint8_t, janus::kPacketBytes> bytes{};
  if (line.size() != 2 * bytes.size()) {
    return std::nullopt;
  }
  for (size_t i = 0; i < bytes.size(); ++i) {
    const char* const digits = line.data() + 2 * i;
    if (std::from_chars(digits, digits + 2, bytes[i], 16).ptr != digits + 2) {
      return std::nullopt;
    }
  }
  janus::Packet packet;
  if (!decode(bytes.data(), packet) || packet.class_id != janus_class || packet.scheduled) {
    return std::nullopt;
  }
  std::array<uint8_t, (janus::kBlockBits + kByteBits - 1) / kByteBits> block{};
  for (size_t i = 0; i < block.size(); ++i) {
    block[i] = static_cast<uint8_t>(packet.block >> (kByteBits * i) & 0xFFU);
  }
  return frameOf(mission, HeardBy::Janus, packet.application, block.data(),
                 static_cast<uint32_t>(block.size()));
}

support::Result<double> valueOf(const ir::Mission& mission, const ir::Share& share,
                                const std::string& given) {
  const std::string units = ir::unitFactors(ir::typeOf(mission, share));
  double value = kUnknown;
  const auto reading = runtime::readQuantity(
      runtime::Piece{given.data(), given.data() + given.size()}.trimmed(), units.c_str(), value);
  const Scale scale = scaleOf(share);
  if (reading != runtime::Reading::Good || digitOf(scale, value) == 0) {
    const LoggedForm form = formOf(ir::typeOf(mission, share));
    const auto shown = [&](uint32_t digit) {
      const double end = hooks::share::valueOf(scale, digit) * form.to_shown;
      return shownValues({&form, 1}, {&end, 1});
    };
    return support::fail(
        support::diagnostics::notAShare, share.name + "=" + given,
        fmt::format("`{}` has values from {} to {}", share.name, shown(1), shown(share.values)));
  }
  return value;
}

std::string namesOf(const ir::Mission& mission) {
  std::string names;
  for (const ir::Share& share : mission.shares) {
    names += (names.empty() ? "`" : ", `") + share.name + "`";
  }
  return names.empty() ? "the mission shares nothing" : "the mission shares " + names;
}

/// The values of all shares, by the number of the share; NaN: not given.
support::Result<std::vector<double>> given(const ir::Mission& mission,
                                           const std::vector<std::string>& settings) {
  std::vector<double> values(mission.shares.size(), kUnknown);
  for (const std::string& setting : settings) {
    const size_t equals = setting.find('=');
    const runtime::Piece name =
        runtime::Piece{setting.data(), setting.data() + std::min(equals, setting.size())}.trimmed();
    const auto share =
        std::ranges::find(mission.shares, std::string(name.begin, name.end), &ir::Share::name);
    if (equals == std::string::npos || share == mission.shares.end()) {
      return support::fail(support::diagnostics::notAShare, setting, namesOf(mission));
    }
    const auto value = valueOf(mission, *share, setting.substr(equals + 1));
    if (!value) {
      return std::unexpected(value.error());
    }
    values[static_cast<size_t>(share - mission.shares.begin())] = *value;
  }
  return values;
}

MessageWriter written(const ir::Mission& mission, const ir::ShareMessage& message,
                      const std::vector<double>& values) {
  MessageWriter writer;
  for (uint32_t i = message.count; i != 0; --i) {
    writer.put(scaleOf(mission.shares[message.first + i - 1]), values[i - 1]);
  }
  return writer;
}

/// Without its line end.
template <typename Sentence>
std::string sentenceOf(const Sentence& sentence) {
  std::array<char, micro_modem::kMostSentence> bytes{};
  const uint32_t size = encode(sentence, bytes.data(), static_cast<uint32_t>(bytes.size()));
  const std::string text(bytes.data(), size);
  return text.substr(0, text.find('\r'));
}

std::string janusOf(const ir::ShareMessage& message, const micro_modem::Data& data, uint32_t source,
                    uint8_t janus_class) {
  if (message.bits > janus::kBlockBits) {
    return "";
  }
  janus::Packet packet;
  packet.class_id = janus_class;
  packet.application = source;
  for (uint32_t i = data.size; i != 0; --i) {
    packet.block = packet.block << kByteBits | data.bytes[i - 1];
  }
  std::array<uint8_t, janus::kPacketBytes> bytes{};
  return encode(packet, bytes.data()) ? fmt::format("{:02x}", fmt::join(bytes, "")) : "";
}

DeckMessage deckMessage(const ir::Mission& mission, const ir::ShareMessage& message,
                        const std::vector<double>& values, uint32_t source, uint8_t janus_class) {
  DeckMessage made{message, {}, "", "", ""};
  micro_modem::Transmit frame;
  frame.source = source;
  frame.data.size = message.bytes;
  const auto signature = static_cast<uint8_t>(message.signature);
  (void)written(mission, message, values).end(signature, frame.data.bytes, frame.data.size);
  made.frame = sentenceOf(frame);
  if (message.mini_bits != 0) {
    micro_modem::SendMiniPacket mini;
    mini.source = source;
    (void)written(mission, message, values).endMini(signature, mini.bits);
    made.mini = sentenceOf(mini);
  }
  made.janus = janusOf(message, frame.data, source, janus_class);
  MessageReader reader(frame.data.bytes, frame.data.size);
  made.values = valuesIn(mission, message, reader);
  return made;
}

}  // namespace

const char* nameOf(HeardBy by) {
  constexpr const char* kNames[] = {"frame", "mini packet", "JANUS"};
  return kNames[static_cast<size_t>(by)];
}

std::optional<HeardMessage> messageIn(const ir::Mission& mission, std::string_view line,
                                      uint8_t janus_class) {
  hooks::SentenceReader reader;
  std::optional<HeardMessage> heard;
  for (const char c : line) {
    if (!heard && reader.push(static_cast<uint8_t>(c))) {
      heard = inSentence(mission, reader.text());
    }
  }
  heard = heard ? heard : inJanus(mission, line, janus_class);
  return heard && heard->source != 0 ? heard : std::nullopt;  // no vehicle has that address
}

support::Result<std::vector<DeckMessage>> messagesFor(const ir::Mission& mission,
                                                      const std::vector<std::string>& settings,
                                                      uint32_t source, uint8_t janus_class) {
  const auto all = given(mission, settings);
  if (!all) {
    return std::unexpected(all.error());
  }
  std::vector<DeckMessage> made;
  for (const ir::ShareMessage& message : ir::messagesOf(mission)) {
    const auto begin = all->begin() + message.first;
    const std::vector<double> values(begin, begin + message.count);
    if (std::ranges::any_of(values, [](double value) { return !std::isnan(value); })) {
      made.push_back(deckMessage(mission, message, values, source, janus_class));
    }
  }
  return made;
}

std::string shownMessage(const ir::Mission& mission, const ir::ShareMessage& message,
                         const std::vector<double>& values) {
  std::string list;
  const std::span<const ir::Share> shares = sharesOf(mission, message);
  for (size_t i = 0; i < shares.size(); ++i) {
    const LoggedForm form = formOf(ir::typeOf(mission, shares[i]));
    const double shown = values[i] * form.to_shown;
    list += (i == 0 ? "" : ", ") + shares[i].name + " " + shownValues({&form, 1}, {&shown, 1});
  }
  return list;
}

}  // namespace glider::flights
