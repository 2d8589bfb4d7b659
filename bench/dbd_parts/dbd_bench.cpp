// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Decodes data files in memory and prints, for each, MB/s of decoding, and of a loop that adds up
// the same bytes one by one: what a machine can do that looks at each byte once. Both are the best
// of several runs, made in turn.

#include "support/files.h"
#include "vehicles/slocum/data_files/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>
#include <string>

namespace {

using namespace glider;

constexpr int kRuns = 15;

/// A file like those of a vehicle: how many sensors it has, and how often they are updated.
struct Kind {
  const char* name;
  int sensors;
  int records;
  double fresh;     ///< share of the sensors that a record gives a new value
  double repeated;  ///< share of those that it says to be the same again
};

// The shares are those of real files; the sizes are 4 MB and more, so that time can be measured.
constexpr Kind kKinds[] = {{"all sensors of flight", 2142, 6000, 0.028, 0.069},
                           {"all sensors of science", 91, 60000, 0.108, 0.035},
                           {"some sensors of flight for Iridium", 20, 200000, 0.15, 0.026},
                           {"every sensor in every record", 64, 30000, 1, 0}};

int widthOf(int sensor) {
  return sensor % 20 == 0 ? 8 : sensor % 3 == 0 ? 1 : 4;
}

std::string sensorList(const Kind& kind) {
  std::string list;
  for (int i = 0; i < kind.sensors; ++i) {
    list += fmt::format("s: T {:4} {:4} {} m_sensor_{} nodim\n", i, i, widthOf(i), i);
  }
  return list;
}

/// A big-endian file: its bytes have to be swapped on the computers that read it.
std::string fileOf(const Kind& kind) {
  const std::string list = sensorList(kind);
  std::string file = fmt::format(
      "dbd_label: DBD\nencoding_ver: 5\nnum_ascii_tags: 14\nall_sensors: T\nthe8x3_filename: 1\n"
      "full_filename: bench-2024-1-1-1\nfilename_extension: dbd\nmission_name: BENCH.MI\n"
      "fileopen_time: x\ntotal_num_sensors: {0}\nsensors_per_cycle: {0}\n"
      "state_bytes_per_cycle: {1}\nsensor_list_crc: {2:08x}\nsensor_list_factored: 0\n{3}",
      kind.sensors, (kind.sensors + 3) / 4, slocum::sensorListCrc(list), list);
  file += "sa\x12\x34\x42\xf6\xe9\x79\x41\x9d\x6f\x34\x54\x7e\x69\xad";
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> share(0, 1);
  for (int record = 0; record < kind.records; ++record) {
    std::string states(static_cast<size_t>((kind.sensors + 3) / 4), '\0'), values;
    for (int i = 0; i < kind.sensors; ++i) {
      // In real files some sensors are updated often and most others never.
      const double busy = std::min(1.0, 2 * (kind.fresh + kind.repeated));
      const double draw = i * 7 % 100 < 100 * busy ? share(random) * busy : 1;
      const int state = draw < kind.fresh ? 2 : draw < kind.fresh + kind.repeated ? 1 : 0;
      char& byte = states[static_cast<size_t>(i / 4)];
      byte = static_cast<char>(byte | state << (6 - 2 * (i % 4)));
      for (int left = state == 2 ? widthOf(i) : 0; left > 0; --left) {
        values += static_cast<char>(0x40 + left);
      }
    }
    file += 'd' + states + values;
  }
  return file + 'X';
}

template <typename Work>
double seconds(Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

volatile uint64_t g_sink = 0;

/// Adds up bytes in an order that the compiler cannot make into one of several at once.
uint64_t sumOf(const std::string& bytes) {
  uint64_t sum = 0;
  for (const char c : bytes) {
    sum = sum * 31 + static_cast<uint8_t>(c);
  }
  return sum;
}

void measure(const std::string& name, const std::string& path, const std::string& bytes,
             slocum::SensorLists& lists) {
  double decode = 1e9, sum = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    uint32_t records = 0;
    decode = std::min(decode, seconds([&] {
                        const auto file = slocum::decodeDataFile(path, bytes, lists);
                        records = file ? file->records : 0;
                      }));
    sum = std::min(sum, seconds([&] { g_sink = sumOf(bytes); }));
    if (records == 0) {
      fmt::print("{}: cannot be decoded\n", name);
      return;
    }
  }
  const auto size = static_cast<double>(bytes.size()) / 1e6;
  fmt::print("{}\t{:.2f}\t{:.1f}\t{:.1f}\n", name, size, size / decode, size / sum);
}

}  // namespace

int main(int argc, char** argv) {
  slocum::SensorLists lists;
  for (int i = 1; i < argc; ++i) {
    if (const auto bytes = support::readFile(argv[i])) {
      measure(argv[i], argv[i], *bytes, lists);
    }
  }
  for (const Kind& kind : kKinds) {
    if (argc == 1) {
      measure(kind.name, "bench.dbd", fileOf(kind), lists);
    }
  }
  return 0;
}
