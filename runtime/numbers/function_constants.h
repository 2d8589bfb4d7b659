// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Written by scripts/fit_functions.
// clang-format off

#pragma once

namespace glider::runtime {

/// (sin x - x) / x^3 of x^2, |x| <= pi/4, constant term first; off by at most 2^-57 of the function.
inline constexpr double kSineRest[] = {
    -0x1.5555555555555p-3,
    0x1.1111111111110p-7,
    -0x1.a01a01a019926p-13,
    0x1.71de3a545e700p-19,
    -0x1.ae64540f0ba18p-26,
    0x1.61217c1864fa2p-33,
    -0x1.ab161757f0c64p-41,
};

/// (cos x - 1 + x^2/2) / x^4 of x^2, |x| <= pi/4, constant term first; off by at most 2^-59 of the function.
inline constexpr double kCosineRest[] = {
    0x1.5555555555555p-5,
    -0x1.6c16c16c16c16p-10,
    0x1.a01a01a019d02p-16,
    -0x1.27e4fb7711e1dp-22,
    0x1.1eed8de9ef73ep-29,
    -0x1.9394b76d1f266p-37,
    0x1.ab76cf6e9b366p-45,
};

/// (atan x - x) / x^3 of x^2, |x| <= 1/16, constant term first; off by at most 2^-63 of the function.
inline constexpr double kArctangentRest[] = {
    -0x1.5555555555555p-2,
    0x1.999999999994dp-3,
    -0x1.249249245a669p-3,
    0x1.c71c6feaeee60p-4,
    -0x1.745981dd28093p-4,
    0x1.37e423f27216fp-4,
};

/// 2/pi
inline constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;

/// pi/2: three pieces of 33 bits, then the rest.
inline constexpr double kHalfPiPieces[] = {
    0x1.921fb54400000p+0,
    0x1.0b4611a600000p-34,
    0x1.3198a2e000000p-69,
    0x1.b839a25204a22p-104,
};

/// pi/2 as the sum of two doubles.
inline constexpr double kHalfPi[] = {
    0x1.921fb54442d18p+0,
    0x1.1a62633145c07p-54,
};

/// pi as the sum of two doubles.
inline constexpr double kPi[] = {
    0x1.921fb54442d18p+1,
    0x1.1a62633145c07p-53,
};

/// pi/180 as the sum of two doubles.
inline constexpr double kDegree[] = {
    0x1.1df46a2529d39p-6,
    0x1.5c1d8becdd291p-62,
};

/// atan(k/8), k from 0 to 8
inline constexpr double kArctangentHigh[] = {
    0,
    0x1.fd5ba9aac2f6ep-4,
    0x1.f5b75f92c80ddp-3,
    0x1.6f61941e4def1p-2,
    0x1.dac670561bb4fp-2,
    0x1.1e00babdefeb4p-1,
    0x1.4978fa3269ee1p-1,
    0x1.700a7c5784634p-1,
    0x1.921fb54442d18p-1,
};

/// and what is missing from them.
inline constexpr double kArctangentLow[] = {
    0,
    -0x1.cd37686760c17p-59,
    0x1.8ab6e3cf7afbdp-57,
    -0x1.c63aae6f6e918p-56,
    0x1.a2b7f222f65e2p-56,
    -0x1.928df287a668fp-58,
    0x1.2419a87f2a458p-56,
    -0x1.8c34d25aadef6p-56,
    0x1.1a62633145c07p-55,
};

}  // namespace glider::runtime
