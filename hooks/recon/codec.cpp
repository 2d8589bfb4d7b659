// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/recon/codec.h"

#include "hooks/protocol/numbers.h"
#include "hooks/recon/fields.h"
#include "hooks/recon/line_writer.h"

namespace glider::hooks::recon {
namespace {

constexpr double kMinutes = 60;
constexpr double kSecondsOfMinute = 60, kSecondsOfHour = 3600, kSecondsOfDay = 86400;
constexpr double kPole = 90, kHalfTurn = 180;
/// The decimals of a position and of a time of day.
constexpr double kThousand = 1000, kTen = 10;
constexpr uint32_t kLatitudeDigits = 2, kLongitudeDigits = 3;

/// Whether the line is of the message that these fields begin, with exactly so many fields.
bool begins(const Fields& fields, uint32_t count, const char* first, const char* second = nullptr,
            const char* third = nullptr) {
  return fields.count() == count && fields.is(0, first) &&
         (second == nullptr || fields.is(1, second)) && (third == nullptr || fields.is(2, third));
}

/// The field with its prefix and a number that may be unknown.
bool readField(const Fields& fields, uint32_t index, const char* prefix, double* value) {
  Text text = fields.at(index);
  return takePrefix(&text, prefix) && readPerhaps(text, value);
}

/// A field of which only the number is known: any capital letters may stand before it.
bool readGoal(const Fields& fields, uint32_t index, double* value) {
  Text text = fields.at(index);
  while (text.size != 0 && text.bytes[0] >= 'A' && text.bytes[0] <= 'Z') {
    text = {text.bytes + 1, text.size - 1};
  }
  return readPerhaps(text, value);
}

/// `Thh:mm:ss.s`. A leap second is the next one.
bool readTime(Text text, double* time_s) {
  double hours = 0, minutes = 0, seconds = 0;
  if (!takePrefix(&text, "T")) {
    return false;
  }
  if (text.size == 0) {
    return true;
  }
  if (!takeDigits(&text, 2, &hours) || !takePrefix(&text, ":") || !takeDigits(&text, 2, &minutes) ||
      !takePrefix(&text, ":") || !readUnsigned(text, &seconds)) {
    return false;
  }
  *time_s = hours * kSecondsOfHour + minutes * kSecondsOfMinute + seconds;
  return *time_s < kSecondsOfDay + 1 && minutes < kMinutes && seconds < kSecondsOfMinute + 1;
}

void writeTime(double time_s, LineWriter* out) {
  out->put(",T");
  if (!(time_s >= 0 && time_s < kSecondsOfDay)) {
    return;
  }
  const auto tenths = static_cast<uint32_t>(time_s * kTen);
  const uint32_t minutes = tenths / 600;
  out->digits(minutes / 60, 2).put(':').digits(minutes % 60, 2).put(':');
  out->digits(tenths % 600 / 10, 2).put('.').digits(tenths % 10, 1);
}

/// `LATddNmm.mmm`: degrees, the half of the Earth, minutes.
bool readPosition(Text text, const char* prefix, const char* halves, double most, double* value) {
  if (!takePrefix(&text, prefix)) {
    return false;
  }
  if (text.size == 0) {
    return true;
  }
  uint32_t digits = 0;
  while (digits < text.size && digits <= kLongitudeDigits && text.bytes[digits] != halves[0] &&
         text.bytes[digits] != halves[1]) {
    ++digits;
  }
  double degrees = 0, minutes = 0;
  if (digits == 0 || !takeDigits(&text, digits, &degrees) || text.size == 0) {
    return false;
  }
  const bool negative = text.bytes[0] == halves[1];
  if (!(negative || text.bytes[0] == halves[0]) ||
      !readUnsigned({text.bytes + 1, text.size - 1}, &minutes)) {
    return false;
  }
  const double size = degrees + minutes / kMinutes;
  *value = negative ? -size : size;
  return minutes < kMinutes && size <= most;
}

void writePosition(double degrees, const char* prefix, const char* halves, double most,
                   uint32_t digits, LineWriter* out) {
  out->put(',').put(prefix);
  const double size = hookMagnitude(degrees);
  if (!(size <= most)) {
    return;
  }
  const auto thousandths = static_cast<uint32_t>(size * kMinutes * kThousand + 0.5);
  out->digits(thousandths / 60000, digits).put(halves[degrees < 0 ? 1 : 0]);
  out->digits(thousandths % 60000 / 1000, 2).put('.').digits(thousandths % 1000, 3);
}

/// `M` and one or two hexadecimal digits.
bool readMode(Text text, uint8_t* mode) {
  if (!takePrefix(&text, "M") || text.size == 0 || text.size > 2) {
    return false;
  }
  uint32_t value = 0;
  for (uint32_t i = 0; i < text.size; ++i) {
    const char digit = text.bytes[i];
    const auto lower = static_cast<char>(digit | 0x20);
    const bool letter = lower >= 'a' && lower <= 'f';
    if (!letter && (digit < '0' || digit > '9')) {
      return false;
    }
    value = value * 16 + static_cast<uint32_t>(letter ? lower - 'a' + 10 : digit - '0');
  }
  *mode = static_cast<uint8_t>(value);
  return true;
}

void writeMode(uint8_t mode, LineWriter* out) {
  static constexpr char kHex[] = "0123456789ABCDEF";
  out->put(",M").put(kHex[mode >> 4]).put(kHex[mode & 0xF]);
}

/// A whole number that a message has, at most 65535.
bool readWhole(const Text& text, uint32_t* value) {
  constexpr double kMost = 65535;
  double number = 0;
  if (!readUnsigned(text, &number) || number > kMost) {
    return false;
  }
  *value = static_cast<uint32_t>(number);
  return static_cast<double>(*value) == number;
}

/// Without the comma before the `*`, if there is one.
Text withoutComma(const Text& text) {
  const bool has = text.size != 0 && text.bytes[text.size - 1] == ',';
  return {text.bytes, has ? text.size - 1 : text.size};
}

constexpr char kRpm[] = " rpm";
constexpr char kMetresPerSecond[] = " meters/sec";

}  // namespace

uint32_t encode(const HeadingGoal& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#C,Heading,Goal,").put(message.heading_deg).end();
}

bool decode(const Line& line, HeadingGoal& message) {
  const Fields fields(line);
  return begins(fields, 4, "#C", "Heading", "Goal") &&
         readNumber(fields.at(3), &message.heading_deg);
}

uint32_t encode(const SpeedGoal& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity)
      .put("#C,Speed,")
      .put(message.value)
      .put(message.unit == SpeedUnit::Rpm ? kRpm : kMetresPerSecond)
      .end();
}

bool decode(const Line& line, SpeedGoal& message) {
  const Fields fields(line);
  const Text text = fields.at(2);
  uint32_t digits = 0;
  while (digits < text.size && text.bytes[digits] != ' ') {
    ++digits;
  }
  const Text unit{text.bytes + digits, text.size - digits};
  message.unit = unit == textOf(kRpm) ? SpeedUnit::Rpm : SpeedUnit::MetresPerSecond;
  return begins(fields, 3, "#C", "Speed") &&
         (unit == textOf(kRpm) || unit == textOf(kMetresPerSecond)) &&
         readNumber({text.bytes, digits}, &message.value);
}

uint32_t encode(const DepthGoal& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#C,Depth,Depth,").put(message.depth_m).end();
}

bool decode(const Line& line, DepthGoal& message) {
  const Fields fields(line);
  return begins(fields, 4, "#C", "Depth", "Depth") && readNumber(fields.at(3), &message.depth_m);
}

uint32_t encode(const TriangleGoal& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity)
      .put("#C,Depth,Triangle,")
      .put(message.depth_m)
      .put(',')
      .put(message.altitude_m)
      .put(',')
      .put(message.rate)
      .put(',')
      .put(message.greatest_depth_m)
      .end();
}

bool decode(const Line& line, TriangleGoal& message) {
  const Fields fields(line);
  return begins(fields, 7, "#C", "Depth", "Triangle") &&
         readNumber(fields.at(3), &message.depth_m) &&
         readNumber(fields.at(4), &message.altitude_m) && readNumber(fields.at(5), &message.rate) &&
         readNumber(fields.at(6), &message.greatest_depth_m);
}

uint32_t encode(const Override& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#E,").put(message.on ? '1' : '0').end();
}

bool decode(const Line& line, Override& message) {
  const Fields fields(line);
  message.on = fields.is(1, "1");
  return begins(fields, 2, "#E") && (message.on || fields.is(1, "0"));
}

uint32_t encode(const KeepAlive& /*message*/, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#V,").put(0.0).end();
}

bool decode(const Line& line, KeepAlive& /*message*/) {
  const Fields fields(line);
  double number = 0;
  return begins(fields, 2, "#V") && readNumber(fields.at(1), &number) && number == 0;
}

uint32_t encode(const TimeQuery& /*message*/, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#s,Time,query").end();
}

bool decode(const Line& line, TimeQuery& /*message*/) {
  return begins(Fields(line), 3, "#s", "Time", "query");
}

uint32_t encode(const ModemText& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#m 1,1, ").put(message.text).end(", *");
}

bool decode(const Line& line, ModemText& message) {
  Text text{line.text, line.size};
  const Text end = textOf(", ");
  if (!takePrefix(&text, "#m 1,1, ") || text.size < end.size) {
    return false;
  }
  message.text = {text.bytes, text.size - end.size};
  return Text{text.bytes + message.text.size, end.size} == end;
}

uint32_t encode(const State& message, char* bytes, uint32_t capacity) {
  LineWriter out(bytes, capacity);
  out.put("#S");
  writeTime(message.time_s, &out);
  writePosition(message.latitude_deg, "LAT", "NS", kPole, kLatitudeDigits, &out);
  writePosition(message.longitude_deg, "LON", "EW", kHalfTurn, kLongitudeDigits, &out);
  out.field("D", message.depth_m).field("", message.depth_goal_m);
  out.field("A", hookIsFinite(message.altitude_m) ? message.altitude_m : 0);
  out.field("P", message.pitch_deg).field("R", message.roll_deg);
  out.field("TR", message.rpm).field("", message.rpm_goal);
  out.field("V", message.speed_m_s).field("H", message.heading_deg);
  out.field("HR", message.heading_rate_deg_s).field("", message.heading_goal_deg);
  writeMode(message.mode, &out);
  return out.field("", message.leg).end();
}

bool decode(const Line& line, State& message) {
  constexpr uint32_t kLeastFields = 17;  // with `#S`, and without the sum
  message = {};
  const Fields fields(line);
  const bool good =
      fields.count() >= kLeastFields && fields.is(0, "#S") &&
      readTime(fields.at(1), &message.time_s) &&
      readPosition(fields.at(2), "LAT", "NS", kPole, &message.latitude_deg) &&
      readPosition(fields.at(3), "LON", "EW", kHalfTurn, &message.longitude_deg) &&
      readField(fields, 4, "D", &message.depth_m) && readGoal(fields, 5, &message.depth_goal_m) &&
      readField(fields, 6, "A", &message.altitude_m) &&
      readField(fields, 7, "P", &message.pitch_deg) &&
      readField(fields, 8, "R", &message.roll_deg) && readField(fields, 9, "TR", &message.rpm) &&
      readGoal(fields, 10, &message.rpm_goal) && readField(fields, 11, "V", &message.speed_m_s) &&
      readField(fields, 12, "H", &message.heading_deg) &&
      readField(fields, 13, "HR", &message.heading_rate_deg_s) &&
      readGoal(fields, 14, &message.heading_goal_deg) && readMode(fields.at(15), &message.mode) &&
      readGoal(fields, 16, &message.leg);
  message.altitude_m = message.altitude_m == 0 ? kUnknown : message.altitude_m;
  return good;
}

uint32_t encode(const TimeSet& message, char* bytes, uint32_t capacity) {
  constexpr double kMost = 4294967295.0;
  if (!(message.unix_s >= 0 && message.unix_s <= kMost)) {
    return 0;
  }
  return LineWriter(bytes, capacity)
      .put("#s,TIME,")
      .whole(static_cast<uint32_t>(message.unix_s))
      .end();
}

bool decode(const Line& line, TimeSet& message) {
  const Fields fields(line);
  return begins(fields, 3, "#s", "TIME") && readUnsigned(fields.at(2), &message.unix_s);
}

uint32_t encode(const Shutdown& /*message*/, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#s,SHUTDOWN").end();
}

bool decode(const Line& line, Shutdown& /*message*/) {
  return begins(Fields(line), 2, "#s", "SHUTDOWN");
}

uint32_t encode(const Ctd& message, char* bytes, uint32_t capacity) {
  LineWriter out(bytes, capacity);
  out.put("#c").field("T", message.temperature_degC).field("C", message.conductivity);
  out.field("S", message.salinity).field("D", message.depth_m);
  return out.field("V", message.sound_speed_m_s).end();
}

bool decode(const Line& line, Ctd& message) {
  constexpr uint32_t kLeastFields = 6;
  message = {};
  const Fields fields(line);
  return fields.count() >= kLeastFields && fields.is(0, "#c") &&
         readField(fields, 1, "T", &message.temperature_degC) &&
         readField(fields, 2, "C", &message.conductivity) &&
         readField(fields, 3, "S", &message.salinity) &&
         readField(fields, 4, "D", &message.depth_m) &&
         readField(fields, 5, "V", &message.sound_speed_m_s);
}

uint32_t encode(const ModemData& message, char* bytes, uint32_t capacity) {
  LineWriter out(bytes, capacity);
  out.put("#m,MSG_DATA,").whole(message.source).put(',').whole(message.destination).put(',');
  return out.put(message.text).end();
}

bool decode(const Line& line, ModemData& message) {
  constexpr uint32_t kLeastFields = 5;
  const Fields fields(line);
  if (fields.count() < kLeastFields || !fields.is(0, "#m") || !fields.is(1, "MSG_DATA") ||
      !readWhole(fields.at(2), &message.source) || !readWhole(fields.at(3), &message.destination)) {
    return false;
  }
  const auto begin = static_cast<uint32_t>(fields.at(4).bytes - line.text);
  message.text = withoutComma({line.text + begin, line.size - begin});
  return true;
}

uint32_t encode(const SimulationText& message, char* bytes, uint32_t capacity) {
  return LineWriter(bytes, capacity).put("#G,").put(message.text).end();
}

bool decode(const Line& line, SimulationText& message) {
  message.text = withoutComma({line.text, line.size});
  return takePrefix(&message.text, "#G,");
}

}  // namespace glider::hooks::recon
