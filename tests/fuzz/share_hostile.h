// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/share/message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

/// What the fuzzer and the unit test do with hostile messages.
namespace glider::share_hostile {

using namespace hooks::share;
using Bytes = std::vector<uint8_t>;
using Scales = std::vector<Scale>;
using Values = std::vector<double>;

inline void require(bool condition) {
  if (!condition) {
    std::abort();
  }
}

/// The values of a message; nothing if it is refused.
inline std::optional<Values> valuesIn(const Scales& scales, const Bytes& bytes, uint8_t signature) {
  MessageReader reader(bytes.data(), static_cast<uint32_t>(bytes.size()));
  Values values;
  for (const Scale& scale : scales) {
    values.push_back(reader.take(scale));
  }
  const uint32_t size = sizeOf(scales.data(), static_cast<uint32_t>(scales.size())).bytes;
  return reader.end(signature, size) ? std::optional(values) : std::nullopt;
}

/// Empty if it does not fit.
inline Bytes messageOf(const Scales& scales, const Values& values, uint8_t signature) {
  MessageWriter writer;
  for (size_t i = scales.size(); i != 0; --i) {
    writer.put(scales[i - 1], values[i - 1]);
  }
  Bytes bytes(sizeOf(scales.data(), static_cast<uint32_t>(scales.size())).bytes);
  const bool fits = writer.end(signature, bytes.data(), static_cast<uint32_t>(bytes.size()));
  return fits ? bytes : Bytes{};
}

/// The first bytes make scales, the rest is a message. One that is read has values of the scales
/// alone, and is the only text of these values: it is written again as it was.
inline void requireOneText(const Bytes& input) {
  constexpr size_t kScaleBytes = 5;
  size_t next = 1;
  const size_t count = input.empty() ? 0 : input.front() % 8U;
  Scales scales;
  for (size_t i = 0; i < count && next + kScaleBytes <= input.size(); ++i, next += kScaleBytes) {
    const uint32_t values = (uint32_t{input[next]} << 24 | uint32_t{input[next + 1]} << 16 |
                             uint32_t{input[next + 2]} << 8 | input[next + 3]) >>
                            (input[next + 4] % 32U);
    scales.push_back(
        {-static_cast<double>(input[next + 4]), 0.25, std::clamp(values, 1U, UINT32_MAX - 1)});
  }
  const Bytes bytes(input.begin() + static_cast<ptrdiff_t>(std::min(next, input.size())),
                    input.end());
  const uint8_t signature = bytes.empty() ? 0 : bytes.front();
  const auto values = valuesIn(scales, bytes, signature);
  if (!values) {
    return;
  }
  for (size_t i = 0; i < scales.size(); ++i) {
    const double highest = scales[i].lowest + (scales[i].values - 1) * scales[i].step;
    require(std::isnan((*values)[i]) ||
            ((*values)[i] >= scales[i].lowest && (*values)[i] <= highest));
  }
  require(messageOf(scales, *values, signature) == bytes);
}

}  // namespace glider::share_hostile
