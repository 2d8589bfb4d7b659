// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/unit/hooks/recon_described.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <limits>
#include <numeric>
#include <regex>

namespace glider::recon_described {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// {field:kind} is a value; all else is in the line as it is here.
const std::map<std::string, std::string> kLines = {
    {"HeadingGoal", "#C,Heading,Goal,{heading_deg:number},*"},
    {"SpeedGoal", "#C,Speed,{value:number} {unit:unit},*"},
    {"DepthGoal", "#C,Depth,Depth,{depth_m:number},*"},
    {"TriangleGoal",
     "#C,Depth,Triangle,{depth_m:number},{altitude_m:number},{rate:number},{greatest_depth_m:"
     "number},*"},
    {"Override", "#E,{on:flag},*"},
    {"KeepAlive", "#V,0.000000,*"},
    {"TimeQuery", "#s,Time,query,*"},
    {"ModemText", "#m 1,1, {text:text}, *"},
    {"State",
     "#S,T{time_s:clock},LAT{latitude_deg:north},LON{longitude_deg:east},D{depth_m:perhaps},{depth_"
     "goal_m:perhaps},A{altitude_m:height},P{pitch_deg:perhaps},R{roll_deg:perhaps},TR{rpm:perhaps}"
     ",{rpm_goal:perhaps},V{speed_m_s:perhaps},H{heading_deg:perhaps},HR{heading_rate_deg_s:"
     "perhaps},{heading_goal_deg:perhaps},M{mode:byte},{leg:perhaps},*"},
    {"TimeSet", "#s,TIME,{unix_s:whole},*"},
    {"Shutdown", "#s,SHUTDOWN,*"},
    {"Ctd",
     "#c,T{temperature_degC:perhaps},C{conductivity:perhaps},S{salinity:perhaps},D{depth_m:perhaps}"
     ",V{sound_speed_m_s:perhaps},*"},
    {"ModemData", "#m,MSG_DATA,{source:whole},{destination:whole},{text:text},*"},
    {"SimulationText", "#G,{text:text},*"},
};

struct Kind {
  std::string pattern;  ///< of a regular expression, without groups
  std::function<Value(std::mt19937&)> any;
  std::function<std::string(const Value&)> write;
  std::function<Value(const std::string&)> read;
};

double uniform(std::mt19937& random, int64_t low, int64_t high) {
  return static_cast<double>(std::uniform_int_distribution<int64_t>(low, high)(random));
}

template <typename... Values>
std::string printed(const char* format, Values... values) {
  char text[64];
  return {text, static_cast<size_t>(std::snprintf(text, sizeof text, format, values...))};
}

std::string six(double number) {
  return printed("%.6f", number);
}

Value number(double value) {
  return {value, ""};
}

/// Degrees and minutes in thousandths, around a letter.
std::string position(double degrees, const char* halves, int width) {
  const auto all = static_cast<int64_t>(std::llround(std::abs(degrees) * 60000));
  return printed("%0*d%c%06.3f", width, static_cast<int>(all / 60000), halves[degrees < 0 ? 1 : 0],
                 static_cast<double>(all % 60000) / 1000);
}

double degreesOf(const std::string& text, char negative) {
  const size_t letter = text.find_first_of("NSEW");
  const double size = std::stod(text.substr(0, letter)) + std::stod(text.substr(letter + 1)) / 60;
  return text[letter] == negative ? -size : size;
}

/// The same, or nothing: unknown.
Kind orNothing(Kind kind) {
  return {"(?:" + kind.pattern + ")?",
          [any = kind.any](std::mt19937& random) {
            return random() % 5 == 0 ? number(kNaN) : any(random);
          },
          [write = kind.write](const Value& value) {
            return std::isnan(value.number) ? "" : write(value);
          },
          [read = kind.read](const std::string& text) {
            return text.empty() ? number(kNaN) : read(text);
          }};
}

using Kinds = std::map<std::string, Kind>;

Kinds kindsOfNumbers() {
  static const Kind kNumber = {
      R"(-?\d+\.\d{6})",
      [](std::mt19937& random) {
        return number(uniform(random, -9'000'000'000, 9'000'000'000) / 1e6);
      },
      [](const Value& value) { return six(value.number); },
      [](const std::string& text) { return number(std::stod(text)); }};
  static const Kind kWhole = {
      R"(\d+)", [](std::mt19937& random) { return number(uniform(random, 0, 65535)); },
      [](const Value& value) { return printed("%.0f", value.number); },
      [](const std::string& text) { return number(std::stod(text)); }};
  return {
      {"number", kNumber},
      {"perhaps", orNothing(kNumber)},
      {"whole", kWhole},
      {"height",
       {kNumber.pattern,
        [](std::mt19937& random) {
          return number(random() % 5 == 0 ? kNaN : uniform(random, 1, 900'000'000) / 1e6);
        },
        [](const Value& value) { return six(std::isnan(value.number) ? 0 : value.number); },
        [](const std::string& text) {
          const double height = std::stod(text);
          return number(height == 0 ? kNaN : height);
        }}},
  };
}

Kinds kindsOfWords() {
  return {
      {"flag",
       {"[01]", [](std::mt19937& random) { return number(static_cast<double>(random() % 2)); },
        [](const Value& value) { return value.number == 1 ? "1" : "0"; },
        [](const std::string& text) { return number(text == "1" ? 1 : 0); }}},
      {"unit",
       {"(?:rpm|meters/sec)",
        [](std::mt19937& random) { return Value{0, random() % 2 == 0 ? "rpm" : "meters/sec"}; },
        [](const Value& value) { return value.text; },
        [](const std::string& text) { return Value{0, text}; }}},
      {"text",
       {R"([ -~]*)",
        [](std::mt19937& random) {
          std::string text;
          for (auto left = random() % 20; left > 0; --left) {
            const char c = static_cast<char>(uniform(random, ' ', '~'));
            text += c == '#' || c == '*' || c == ',' ? '.' : c;
          }
          return Value{0, text};
        },
        [](const Value& value) { return value.text; },
        [](const std::string& text) { return Value{0, text}; }}},
      {"byte",
       {"[0-9A-F]{2}", [](std::mt19937& random) { return number(uniform(random, 0, 255)); },
        [](const Value& value) { return printed("%02X", static_cast<unsigned>(value.number)); },
        [](const std::string& text) { return number(std::stoi(text, nullptr, 16)); }}},
  };
}

Kinds kindsOfPlacesAndTimes() {
  return {
      {"clock",
       orNothing({R"(\d\d:\d\d:\d\d\.\d)",
                  [](std::mt19937& random) { return number(uniform(random, 0, 863'999) / 10); },
                  [](const Value& value) {
                    const auto tenths = static_cast<int>(std::llround(value.number * 10));
                    return printed("%02d:%02d:%02d.%d", tenths / 36000, tenths / 600 % 60,
                                   tenths / 10 % 60, tenths % 10);
                  },
                  [](const std::string& text) {
                    return number(std::stod(text.substr(0, 2)) * 3600 +
                                  std::stod(text.substr(3, 2)) * 60 + std::stod(text.substr(6)));
                  }})},
      {"north", orNothing({R"(\d\d[NS]\d\d\.\d\d\d)",
                           [](std::mt19937& random) {
                             return number(uniform(random, -5'400'000, 5'400'000) / 60000);
                           },
                           [](const Value& value) { return position(value.number, "NS", 2); },
                           [](const std::string& text) { return number(degreesOf(text, 'S')); }})},
      {"east", orNothing({R"(\d\d\d[EW]\d\d\.\d\d\d)",
                          [](std::mt19937& random) {
                            return number(uniform(random, -10'800'000, 10'800'000) / 60000);
                          },
                          [](const Value& value) { return position(value.number, "EW", 3); },
                          [](const std::string& text) { return number(degreesOf(text, 'W')); }})},
  };
}

const Kinds& kinds() {
  static const Kinds kAll = [] {
    Kinds all = kindsOfNumbers();
    all.merge(kindsOfWords());
    all.merge(kindsOfPlacesAndTimes());
    return all;
  }();
  return kAll;
}

/// Calls f(plain text, name, kind) for each part of a line; the last one has no name.
template <typename F>
void forParts(const std::string& name, F f) {
  const std::string& line = kLines.at(name);
  size_t at = 0;
  for (size_t open = line.find('{'); open != std::string::npos; open = line.find('{', at)) {
    const size_t colon = line.find(':', open);
    const size_t close = line.find('}', colon);
    f(line.substr(at, open - at), line.substr(open + 1, colon - open - 1),
      &kinds().at(line.substr(colon + 1, close - colon - 1)));
    at = close + 1;
  }
  f(line.substr(at), std::string(), static_cast<const Kind*>(nullptr));
}

std::string quoted(const std::string& plain) {
  return std::regex_replace(plain, std::regex(R"([*.+?()\[\]{}|^$\\])"), R"(\$&)");
}

/// A line as a regular expression, with a group for each field.
struct Pattern {
  explicit Pattern(const std::string& name) {
    std::string pattern;
    forParts(name, [&](const std::string& plain, const std::string& field, const Kind* kind) {
      pattern += quoted(plain);
      if (kind != nullptr) {
        pattern += "(" + kind->pattern + ")";
        fields.emplace_back(field, kind);
      }
    });
    expression = std::regex(pattern);
  }
  std::regex expression;
  std::vector<std::pair<std::string, const Kind*>> fields;
};

}  // namespace

std::vector<std::string> described() {
  std::vector<std::string> names;
  for (const auto& [name, line] : kLines) {
    names.push_back(name);
  }
  return names;
}

Values randomValues(const std::string& name, std::mt19937& random) {
  Values values;
  forParts(name, [&](const std::string&, const std::string& field, const Kind* kind) {
    if (kind != nullptr) {
      values[field] = kind->any(random);
    }
  });
  return values;
}

std::string summed(const std::string& text) {
  const int sum = std::accumulate(text.begin(), text.end(), 0, [](int total, char c) {
    return (total + static_cast<unsigned char>(c)) % 256;
  });
  return text + printed("%02X\n", static_cast<unsigned>(sum));
}

std::string lineOf(const std::string& name, const Values& values) {
  std::string line;
  forParts(name, [&](const std::string& plain, const std::string& field, const Kind* kind) {
    line += plain + (kind == nullptr ? "" : kind->write(values.at(field)));
  });
  return summed(line);
}

std::optional<Values> valuesOf(const std::string& name, const std::string& line) {
  static std::map<std::string, Pattern> patterns;
  const auto& [expression, fields] = patterns.try_emplace(name, name).first->second;
  constexpr size_t kSum = 3;
  std::smatch found;
  const std::string text = line.size() < kSum ? "" : line.substr(0, line.size() - kSum);
  if (!std::regex_match(text, found, expression) || summed(text) != line) {
    return std::nullopt;
  }
  Values values;
  for (size_t i = 0; i < fields.size(); ++i) {
    values[fields[i].first] = fields[i].second->read(found[i + 1].str());
  }
  return values;
}

bool isSame(const Values& one, const Values& other) {
  bool same = one.size() == other.size();
  for (const auto& [name, value] : one) {
    const auto found = other.find(name);
    same = same && found != other.end() && found->second.text == value.text &&
           (std::isnan(value.number) ? std::isnan(found->second.number)
                                     : std::abs(found->second.number - value.number) < 1e-9);
  }
  return same;
}

std::string shown(const Values& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += name + "=" + printed("%.9f", value.number) + " " + value.text + " ";
  }
  return text;
}

}  // namespace glider::recon_described
