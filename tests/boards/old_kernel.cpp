// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// old_kernel LIST PROGRAM [ARGUMENT...]: runs an i386 PROGRAM on this x86-64 kernel, which answers
// ENOSYS to every i386 system call that is not in section [exists] of LIST
// (platforms/boards/*.syscalls). So the ways round missing calls are proved, not only read. Exit
// status: the program's; 77 when this machine cannot do it (no i386 programs, no seccomp); 2 for a
// bad command line.

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sstream>
#include <string>
#include <sys/prctl.h>
#include <unistd.h>
#include <vector>

namespace {

constexpr int kSkipped = 77;

std::vector<unsigned> readExisting(const std::string& name) {
  std::ifstream file(name);
  std::vector<unsigned> numbers;
  bool exists = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('[')) {
      exists = line == "[exists]";
    } else if (exists && !line.empty() && !line.starts_with('#')) {
      std::istringstream words(line);
      std::string call;
      unsigned number = 0;
      if (!(words >> call >> number)) {
        return {};
      }
      numbers.push_back(number);
    }
  }
  return numbers;
}

// The filter: all of x86-64 passes (it is this program before execve), of i386 the numbers given.
std::vector<sock_filter> makeFilter(const std::vector<unsigned>& numbers) {
  const auto load = [](std::size_t offset) {
    return sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<unsigned>(offset)};
  };
  const auto allow = sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW};
  const auto skip_unless = [](unsigned value) {
    return sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 1, value};
  };
  std::vector<sock_filter> filter = {load(offsetof(seccomp_data, arch)),
                                     skip_unless(AUDIT_ARCH_X86_64), allow,
                                     load(offsetof(seccomp_data, nr))};
  for (unsigned number : numbers) {
    filter.push_back(skip_unless(number));
    filter.push_back(allow);
  }
  filter.push_back({BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS});
  return filter;
}

bool install(std::vector<sock_filter> filter) {
  const sock_fprog program = {static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: old_kernel LIST PROGRAM [ARGUMENT...]\n", stderr);
    return 2;
  }
  const auto numbers = readExisting(argv[1]);
  if (numbers.empty()) {
    std::fprintf(stderr, "old_kernel: no list of system calls in %s\n", argv[1]);
    return 2;
  }
  if (!install(makeFilter(numbers))) {
    std::fprintf(stderr, "old_kernel: skipped: no seccomp here: %s\n", std::strerror(errno));
    return kSkipped;
  }
  execv(argv[2], argv + 2);
  std::fprintf(stderr, "old_kernel: cannot run %s: %s\n", argv[2], std::strerror(errno));
  return errno == ENOEXEC ? kSkipped : 2;
}
