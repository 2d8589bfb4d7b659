// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// The recent readings of temperature over depth, and the thermocline in them: for thermoMet and
/// trackThermo of runtime/c/glider.h.
///
/// The newest reading in each half metre is kept, over a stretch of 32 m, so nothing depends on
/// readings coming in monotonic order (the paper's first deployment failed on that), and hovering
/// fills no buffer.
namespace glider::runtime {

/// A stretch of water and the temperatures met in it.
struct Stretch {
  double difference = 0;  ///< K, greatest less least temperature; 0 if there are no two readings
  double middle = 0;      ///< degC, halfway between them
};

/// Where the temperature passes a value.
struct Crossing {
  bool found = false;
  double depth = 0;  ///< m
};

class WaterColumn {
 public:
  static constexpr double kBinMetres = 0.5;
  static constexpr uint32_t kBins = 64;

  /// Forgets everything.
  void clear();
  /// Keeps a reading. Depth in m (a negative one, of a glider at the surface, counts as 0),
  /// temperature in degC, time in s.
  void record(double time, double depth, double temperature);
  /// Of the stretches at most `length` m long, the one with the greatest difference among readings
  /// not before `since`.
  [[nodiscard]] Stretch steepest(double length, double since) const;
  /// Where the temperature passes `middle` between neighbouring readings not before `since`; if
  /// there are several places, the one read last.
  [[nodiscard]] Crossing crossing(double middle, double since) const;

 private:
  struct Bin {
    float time;  ///< negative: empty
    float depth;
    float temperature;
  };
  /// The bin of half metre `number` if it holds a reading not before `since`.
  [[nodiscard]] const Bin* at(int32_t number, float since) const;
  static Crossing between(const Bin& above, const Bin& below, double middle);

  Bin bins_[kBins];  ///< by number of the half metre, going round
  int32_t newest_;   ///< number of the newest reading's half metre; the stretch is 16 m up and down
                     ///< from it
};

}  // namespace glider::runtime
