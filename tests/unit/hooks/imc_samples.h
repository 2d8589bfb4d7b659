// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Packets of DUNE 2026.01.0 and of its clients, as they were on the wire, and the same packets in
/// the other byte order, converted by a program that is not part of the project. For boards too.
namespace glider::imc_samples {

struct Sample {
  const char* name;
  uint16_t id;
  const char* little;  ///< hexadecimal
  const char* big;
};

inline constexpr Sample kSamples[] = {
    {"Heartbeat", 150, "54fe960000000000a0b48065d2410140ffffffff6502",
     "fe540096000041d26580b4a000004001fffffffff742"},
    {"Reference", 479,
     "54fedf0127000000a0b48065d2410140ff1e00ff079201333333333333f33f0091010000a0400171ac8bdb6800e73"
     "f5396218e7571c3bf00000000f8ff",
     "fe5401df002741d26580b4a000004001ff001eff0701923ff333333333333300019140a00000013fe70068db8bac7"
     "1bfc371758e21965300000000e05a"},
    {"PlanControlStart", 559,
     "54fe2f024b00eb6e063db8c1da410140ffd100ff0000a60209006261636b5f736561740000270209006261636b5f7"
     "365617400000000000001003101002802010031de010140ff00007041000020410000003f00000000000000000000"
     "0000b125",
     "fe54022f004b41dac1b83d066eeb4001ff00d1ff000002a600096261636b5f736561740000022700096261636b5f7"
     "36561740000000000000001310001022800013101de4001ff41700000412000003f00000000000000000000000000"
     "00009f20"},
    {"FollowRefStateWait", 480, "54fee0010700dc9f063db8c1da41d10011ffffff0140ffffff0101784a",
     "fe5401e0000741dac1b83d069fdc00d111ffffff4001ffffff0101f302"},
    {"FollowRefState", 480,
     "54fee0012e00662e916fb8c1da41d10011ffffff0140ffdf01079201333333333333f33f0091010000803f013edde"
     "2914001e73f15de0e8f2873c3bf000000000101f281",
     "fe5401e0002e41dac1b86f912e6600d111ffffff4001ff01df0701923ff33333333333330001913f800000013fe70"
     "14091e2dd3ebfc373288f0ede15000000000101c62a"},
    {"EstimatedState", 350,
     "54fe5e015800c425873cb8c1da41d10032ffffff9eaf83e88500e73fdea79e8c2873c3bf00002cb3660d973ea0b43"
     "cba5091b03d295a53397219be3a6b3a1cb9b40b1a3bc4b17eba60f4d7bc850e0d3bb5627dba64fbd7bcb9352bb974"
     "07f4ba24e30839e9b1023d4e2d8f401dfe",
     "fe54015e005841dac1b83c8725c400d132ffffff3fe70085e883af9ebfc373288c9ea7deb32c00003e970d66ba3cb"
     "4a03db0915039535a293abe1972b91c3a6b3b1a0bb4ba7eb1c4bcd7f4603b0d0e85ba7d62b5bcd7fb64b92b35b9ba"
     "f407743908e3243d02b1e9408f2d4e2c8d"},
    {"Temperature", 263, "54fe070104000d84893cb8c1da41d10036ffffff6982774104b8",
     "fe540107000441dac1b83c89840d00d136ffffff417782692aa9"},
    {"Conductivity", 269, "54fe0d0104000d84893cb8c1da41d10036ffffffeb4b5e4008d1",
     "fe54010d000441dac1b83c89840d00d136ffffff405e4beb8505"},
    {"Salinity", 270, "54fe0e0104000d84893cb8c1da41d10036ffffffbd9cda4178b4",
     "fe54010e000441dac1b83c89840d00d136ffffff41da9cbdada8"},
    {"VehicleMedium", 508, "54fefc010100eed0933cb8c1da41d1002dffffff02cc71",
     "fe5401fc000141dac1b83c93d0ee00d12dffffff023f9a"},
    {"VehicleState", 500,
     "54fef4011f0092b3953cb8c1da41d10048ffffff00000000ffff000000000000f0bfffff000000000000000000000"
     "00000f0bfc174",
     "fe5401f4001f41dac1b83c95b39200d148ffffff00000000ffffbff0000000000000ffff00000000000000bff0000"
     "0000000007cf9"},
    {"PlanControlState", 560,
     "54fe30021d00e7d3136fb8c1da41d10034ffffff0109006261636b5f7365617400000000000080bf0000ffffffff0"
     "00002e1a7",
     "fe540230001d41dac1b86f13d3e700d134ffffff0100096261636b5f7365617400000000bf8000000000ffff0000f"
     "fff025361"},
    {"HeartbeatOfVehicle", 150, "54fe9600000046419e3cb8c1da41d10000ffffff9ccf",
     "fe540096000041dac1b83c9e414600d100ffffff8c79"},
};
inline constexpr uint32_t kSampleCount = sizeof kSamples / sizeof kSamples[0];
inline constexpr uint32_t kMostSample = 128;

constexpr uint8_t digitOf(char c) {
  return static_cast<uint8_t>(c >= 'a' ? c - 'a' + 10 : c - '0');
}

/// The bytes that `hex` is; returns their number, at most kMostSample.
constexpr uint32_t bytesOf(const char* hex, uint8_t* bytes) {
  uint32_t count = 0;
  for (; hex[0] != '\0' && count < kMostSample; hex += 2) {
    bytes[count++] = static_cast<uint8_t>(digitOf(hex[0]) << 4U | digitOf(hex[1]));
  }
  return count;
}

}  // namespace glider::imc_samples
