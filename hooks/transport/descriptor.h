// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Reading and writing a non-blocking file descriptor by the rules of GliderByteStream: a count, 0
/// for "not now", or a GliderStreamStatus. The far end of a terminal that has gone shows as EIO,
/// that of a pipe as EPIPE.
namespace glider::hooks {

int32_t readDescriptor(int descriptor, uint8_t* bytes, uint32_t capacity);
/// True if the far end has gone for good, or the descriptor itself: no byte will come any more. For
/// libraries whose read function reports that as "nothing yet".
bool isHungUp(int descriptor);
int32_t writeDescriptor(int descriptor, const uint8_t* bytes, uint32_t count);

}  // namespace glider::hooks
