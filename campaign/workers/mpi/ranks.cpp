// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The ranks of MPI. Nothing here waits in MPI while flights are flown: OpenMPI spins when it waits,
// and would take the core from a flight. An error of MPI ends all ranks, as MPI does by default.

#include "campaign/workers/mpi/ranks_abi.h"

#include <list>
#include <mpi.h>
#include <string>
#include <vector>

namespace {

/// A message that MPI may not have taken yet.
struct Sent {
  std::string bytes;
  MPI_Request request = MPI_REQUEST_NULL;
};
std::list<Sent> under_way;
std::vector<char> received;

void forgetTaken() {
  under_way.remove_if([](Sent& one) {
    int taken = 0;
    MPI_Test(&one.request, &taken, MPI_STATUS_IGNORE);
    return taken != 0;
  });
}

void send(unsigned to, unsigned kind, const char* bytes, size_t length) {
  forgetTaken();
  Sent& one = under_way.emplace_back(Sent{.bytes = std::string(bytes, length)});
  MPI_Isend(one.bytes.data(), static_cast<int>(length), MPI_BYTE, static_cast<int>(to),
            static_cast<int>(kind), MPI_COMM_WORLD, &one.request);
}

int receive(unsigned* from, unsigned* kind, const char** bytes, size_t* length) {
  forgetTaken();
  int arrived = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &status);
  if (arrived == 0) {
    return 0;
  }
  int count = 0;
  MPI_Get_count(&status, MPI_BYTE, &count);
  received.resize(static_cast<size_t>(count));
  MPI_Recv(received.data(), count, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  *from = static_cast<unsigned>(status.MPI_SOURCE);
  *kind = static_cast<unsigned>(status.MPI_TAG);
  *bytes = received.data();
  *length = received.size();
  return 1;
}

void leave() {
  for (Sent& one : under_way) {
    MPI_Wait(&one.request, MPI_STATUS_IGNORE);
  }
  under_way.clear();
  MPI_Finalize();
}

void abortAll(int status) {
  MPI_Abort(MPI_COMM_WORLD, status);
}

}  // namespace

const GliderRanks* gliderJoinRanks() {
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  int rank = 0;
  int size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  static GliderRanks ranks;
  ranks = {
      static_cast<unsigned>(rank), static_cast<unsigned>(size), send, receive, leave, abortAll};
  return &ranks;
}
