// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/hooks/imc_described.h"

#include <cstring>
#include <sstream>
#include <stdexcept>

namespace glider::imc_described {
namespace {

/// `?Name` is a message or none, `one Name` a list with at most one, `empty` a list with none.
constexpr char kDescription[] = R"(
50 SimulatedState: f64 lat, f64 lon, f32 height, f32 x, f32 y, f32 z, f32 phi, f32 theta, f32 psi, f32 u, f32 v, f32 w, f32 p, f32 q, f32 r, f32 svx, f32 svy, f32 svz
103 LogBookEntry: u8 type, f64 htime, text context, text text
150 Heartbeat:
151 Announce: text sys_name, u8 sys_type, u16 owner, f64 lat, f64 lon, f32 height, text services
250 Rpm: i16 value
251 Voltage: f32 value
253 GpsFix: u16 validity, u8 type, u16 utc_year, u8 utc_month, u8 utc_day, f32 utc_time, f64 lat, f64 lon, f32 height, u8 satellites, f32 cog, f32 sog, f32 hdop, f32 vdop, f32 hacc, f32 vacc
263 Temperature: f32 value
264 Pressure: f64 value
269 Conductivity: f32 value
270 Salinity: f32 value
279 FuelLevel: f32 value, f32 confidence, text opmodes
288 Turbidity: f32 value
289 Chlorophyll: f32 value
295 DissolvedOxygen: f32 value
350 EstimatedState: f64 lat, f64 lon, f32 height, f32 x, f32 y, f32 z, f32 phi, f32 theta, f32 psi, f32 u, f32 v, f32 w, f32 vx, f32 vy, f32 vz, f32 p, f32 q, f32 r, f32 depth, f32 alt
351 EstimatedStreamVelocity: f64 x, f64 y, f64 z
401 DesiredZ: f32 value, u8 z_units
402 DesiredSpeed: f64 value, u8 speed_units
478 FollowReference: u16 control_src, u8 control_ent, f32 timeout, f32 loiter_radius, f32 altitude_interval
479 Reference: u8 flags, ?DesiredSpeed speed, ?DesiredZ z, f64 lat, f64 lon, f32 radius
480 FollowRefState: u16 control_src, u8 control_ent, ?Reference reference, u8 state, u8 proximity
500 VehicleState: u8 op_mode, u8 error_count, text error_ents, u16 maneuver_type, f64 maneuver_stime, u16 maneuver_eta, u32 control_loops, u8 flags, text last_error, f64 last_error_time
508 VehicleMedium: u8 medium
550 Abort:
551 PlanSpecification: text plan_id, text description, text vnamespace, empty variables, text start_man_id, one PlanManeuver maneuvers, empty transitions, empty start_actions, empty end_actions
552 PlanManeuver: text maneuver_id, ?FollowReference data, empty start_actions, empty end_actions
559 PlanControl: u8 type, u8 op, u16 request_id, text plan_id, u16 flags, ?PlanSpecification arg, text info
560 PlanControlState: u8 state, text plan_id, i32 plan_eta, f32 plan_progress, text man_id, u16 man_type, i32 man_eta, u8 last_outcome
)";

struct Field {
  std::string kind;   ///< u8 … f64, text, `?`, one, empty
  std::string inner;  ///< the message of `?` and one
  std::string name;
};
struct Description {
  std::string name;
  std::vector<Field> fields;
};

std::map<uint16_t, Description> parsed() {
  std::map<uint16_t, Description> all;
  std::istringstream lines(kDescription + 1);
  for (std::string line; std::getline(lines, line);) {
    const size_t colon = line.find(':');
    std::istringstream head(line.substr(0, colon));
    unsigned id = 0;
    Description message;
    head >> id >> message.name;
    std::istringstream fields(line.substr(colon + 1));
    for (std::string text; std::getline(fields, text, ',');) {
      std::istringstream words(text);
      Field field;
      words >> field.kind;
      if (field.kind[0] == '?') {
        field.inner = field.kind.substr(1);
        field.kind = "?";
      } else if (field.kind == "one") {
        words >> field.inner;
      }
      words >> field.name;
      message.fields.push_back(field);
    }
    all[static_cast<uint16_t>(id)] = message;
  }
  return all;
}

const std::map<uint16_t, Description>& descriptions() {
  static const std::map<uint16_t, Description> all = parsed();
  return all;
}

uint16_t idOf(const std::string& name) {
  for (const auto& [id, message] : descriptions()) {
    if (message.name == name) {
      return id;
    }
  }
  throw std::logic_error(name);
}

/// Bytes of a number by its kind: its last letters are its bits.
size_t widthOf(const std::string& kind) {
  return std::stoul(kind.substr(1)) / 8;
}

bool isNumber(const std::string& kind) {
  return kind != "text" && kind != "?" && kind != "one" && kind != "empty";
}

void put(Bytes* out, uint64_t value, size_t width, ByteOrder order) {
  Bytes bytes;
  for (size_t i = 0; i < width; ++i, value /= 256) {
    bytes.insert(order == ByteOrder::Little ? bytes.end() : bytes.begin(),
                 static_cast<uint8_t>(value % 256));
  }
  out->insert(out->end(), bytes.begin(), bytes.end());
}

uint64_t randomNumber(const std::string& kind, std::mt19937& random) {
  constexpr double kSome[] = {0, -1, 1.2, 0.7188, 41.185, -0.1519, 1e6};
  const size_t width = widthOf(kind);
  if (kind[0] == 'f' && random() % 2 == 0) {
    const double some = kSome[random() % std::size(kSome)];
    const auto narrow = static_cast<float>(some);
    uint64_t bits = 0;
    std::memcpy(&bits, &some, sizeof some);
    uint32_t narrow_bits = 0;
    std::memcpy(&narrow_bits, &narrow, sizeof narrow);
    return width == 4 ? narrow_bits : bits;
  }
  const uint64_t any = uint64_t{random()} << 32 | random();
  const uint64_t bits = width == 8 ? any : any % (uint64_t{1} << 8 * width);
  // a NaN has the greatest exponent and a mantissa that is not 0
  if (kind == "f32" && (bits & 0x7FFFFFFF) > 0x7F800000) {
    return 0x7FC00000;
  }
  if (kind == "f64" && (bits & 0x7FFFFFFFFFFFFFFF) > 0x7FF0000000000000) {
    return 0x7FF8000000000000;
  }
  return bits;
}

std::string randomText(std::mt19937& random) {
  const bool is_long = random() % 30 == 0;
  std::string text(random() % (is_long ? 120 : 12), '\0');
  for (char& c : text) {
    const uint32_t kind = random() % 8;
    c = static_cast<char>(kind == 0 ? 0x54 : kind == 1 ? 0xFE : random());
  }
  return text;
}

void randomInto(uint16_t id, const std::string& path, std::mt19937& random, Leaves* leaves) {
  for (const Field& field : descriptions().at(id).fields) {
    const std::string name = path + field.name;
    if (isNumber(field.kind)) {
      (*leaves)[name] = randomNumber(field.kind, random);
    } else if (field.kind == "text") {
      (*leaves)[name] = randomText(random);
    } else if (field.kind != "empty") {
      const bool present = random() % 4 != 0;
      (*leaves)[name + "?"] = uint64_t{present};
      if (present) {
        randomInto(idOf(field.inner), name + ".", random, leaves);
      }
    }
  }
}

uint64_t numberOf(const Leaves& leaves, const std::string& name) {
  return std::get<uint64_t>(leaves.at(name));
}

void writeInto(uint16_t id, const std::string& path, const Leaves& leaves, ByteOrder order,
               Bytes* out) {
  for (const Field& field : descriptions().at(id).fields) {
    const std::string name = path + field.name;
    if (isNumber(field.kind)) {
      put(out, numberOf(leaves, name), widthOf(field.kind), order);
    } else if (field.kind == "text") {
      const auto& text = std::get<std::string>(leaves.at(name));
      put(out, text.size(), 2, order);
      out->insert(out->end(), text.begin(), text.end());
    } else if (field.kind == "empty") {
      put(out, 0, 2, order);
    } else {
      const bool present = numberOf(leaves, name + "?") != 0;
      if (field.kind == "one") {
        put(out, present ? 1 : 0, 2, order);
      }
      if (present || field.kind == "?") {
        put(out, present ? idOf(field.inner) : 65535, 2, order);
      }
      if (present) {
        writeInto(idOf(field.inner), name + ".", leaves, order, out);
      }
    }
  }
}

/// What is left of a payload.
struct Rest {
  const Bytes& bytes;
  ByteOrder order;
  size_t at = 0;

  uint64_t number(size_t width) {
    if (bytes.size() - at < width) {
      throw std::out_of_range("number");
    }
    uint64_t value = 0;
    for (size_t i = 0; i < width; ++i) {
      const size_t weight = order == ByteOrder::Little ? i : width - 1 - i;
      value += uint64_t{bytes[at + i]} << 8 * weight;
    }
    at += width;
    return value;
  }
  std::string text(size_t size) {
    if (bytes.size() - at < size) {
      throw std::out_of_range("text");
    }
    at += size;
    return {bytes.begin() + static_cast<std::ptrdiff_t>(at - size),
            bytes.begin() + static_cast<std::ptrdiff_t>(at)};
  }
};

void readInto(uint16_t id, const std::string& path, Rest* rest, Leaves* leaves) {
  for (const Field& field : descriptions().at(id).fields) {
    const std::string name = path + field.name;
    if (isNumber(field.kind)) {
      (*leaves)[name] = rest->number(widthOf(field.kind));
      continue;
    }
    const uint64_t number = rest->number(2);
    if (field.kind == "text") {
      (*leaves)[name] = rest->text(number);
      continue;
    }
    const bool present = field.kind == "one" ? number == 1 : field.kind == "?" && number != 65535;
    if (field.kind == "empty" || (field.kind == "one" && !present)) {
      if (number != 0) {
        throw std::out_of_range("list");
      }
    }
    if (field.kind != "empty") {
      (*leaves)[name + "?"] = uint64_t{present};
    }
    if (present) {
      if ((field.kind == "one" ? rest->number(2) : number) != idOf(field.inner)) {
        throw std::out_of_range("id");
      }
      readInto(idOf(field.inner), name + ".", rest, leaves);
    }
  }
}

}  // namespace

std::map<uint16_t, std::string> described() {
  std::map<uint16_t, std::string> names;
  for (const auto& [id, message] : descriptions()) {
    names[id] = message.name;
  }
  return names;
}

Leaves randomLeaves(uint16_t id, std::mt19937& random) {
  Leaves leaves;
  randomInto(id, "", random, &leaves);
  return leaves;
}

Bytes payloadOf(uint16_t id, const Leaves& leaves, ByteOrder order) {
  Bytes out;
  writeInto(id, "", leaves, order, &out);
  return out;
}

std::optional<Leaves> leavesOf(uint16_t id, const Bytes& payload, ByteOrder order) {
  Rest rest{payload, order};
  Leaves leaves;
  try {
    readInto(id, "", &rest, &leaves);
  } catch (const std::out_of_range&) {
    return std::nullopt;
  }
  return rest.at == payload.size() ? std::optional(leaves) : std::nullopt;
}

Bytes packetOf(uint16_t id, const Header& header, const Bytes& payload, ByteOrder order) {
  uint64_t time = 0;
  std::memcpy(&time, &header.time_s, sizeof time);
  Bytes packet;
  put(&packet, 0xFE54, 2, order);
  put(&packet, id, 2, order);
  put(&packet, payload.size(), 2, order);
  put(&packet, time, 8, order);
  put(&packet, header.source, 2, order);
  put(&packet, header.source_entity, 1, order);
  put(&packet, header.destination, 2, order);
  put(&packet, header.destination_entity, 1, order);
  packet.insert(packet.end(), payload.begin(), payload.end());
  put(&packet, slowCrc(packet), 2, order);
  return packet;
}

uint16_t slowCrc(const Bytes& bytes) {
  unsigned crc = 0;
  for (const uint8_t byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool flip = ((crc ^ (unsigned{byte} >> bit)) & 1U) != 0;
      crc = crc / 2 ^ (flip ? 0xA001U : 0U);
    }
  }
  return static_cast<uint16_t>(crc);
}

}  // namespace glider::imc_described
