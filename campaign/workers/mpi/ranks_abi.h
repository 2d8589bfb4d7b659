/* SPDX-FileCopyrightText: 2026 The glidercc authors
 * SPDX-License-Identifier: Apache-2.0 */

#pragma once

#include <stddef.h>

/* What glidercc loads when it was started by mpirun: the only code that is linked with MPI. */

#ifdef __cplusplus
extern "C" {
#endif

/* The functions are for the thread that has joined. */
struct GliderRanks {
  unsigned rank, size;
  /* Copies `bytes`; does not wait. */
  void (*send)(unsigned to, unsigned kind, const char* bytes, size_t length);
  /* The next message that has arrived; 0 if there is none. `bytes` are valid until the next call.
   */
  int (*receive)(unsigned* from, unsigned* kind, const char** bytes, size_t* length);
  /* Waits until all ranks have called it. */
  void (*leave)(void);
  /* Ends all ranks. */
  void (*abort)(int status);
};

/* Joins the other ranks; called once. */
const struct GliderRanks* gliderJoinRanks(void);

#ifdef __cplusplus
}
#endif
