// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/descriptor.h"

#include "hooks/transport/byte_stream.h"

#include <errno.h>
#include <poll.h>
#include <unistd.h>

namespace glider::hooks {
namespace {

int32_t statusOf(int error) {
  if (error == EAGAIN || error == EINTR) {
    return 0;
  }
  return error == EIO || error == EPIPE ? kGliderStreamClosed : kGliderStreamFailed;
}

}  // namespace

int32_t readDescriptor(int descriptor, uint8_t* bytes, uint32_t capacity) {
  if (capacity == 0) {
    return 0;
  }
  const ssize_t got = ::read(descriptor, bytes, capacity);
  if (got < 0) {
    return statusOf(errno);
  }
  return got == 0 ? kGliderStreamClosed : static_cast<int32_t>(got);
}

bool isHungUp(int descriptor) {
  pollfd state{descriptor, 0, 0};
  return ::poll(&state, 1, 0) == 1 && (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0;
}

int32_t writeDescriptor(int descriptor, const uint8_t* bytes, uint32_t count) {
  const ssize_t taken = ::write(descriptor, bytes, count);
  return taken < 0 ? statusOf(errno) : static_cast<int32_t>(taken);
}

}  // namespace glider::hooks
