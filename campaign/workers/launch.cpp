// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/launch.h"

#include "campaign/workers/mpi/ranks_abi.h"
#include "compiler/share.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <string_view>

namespace glider::campaign {
namespace {

/// The number that a variable of the environment holds; `otherwise` without one.
size_t numberIn(const char* variable, size_t otherwise) {
  const char* value = std::getenv(variable);
  const std::string_view text = value == nullptr ? "" : value;
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : otherwise;
}

/// The variables of a launcher. mpirun may itself have been started by srun: the ranks are
/// mpirun's.
struct Variables {
  const char* rank;
  const char* size;
};
constexpr std::array<Variables, 3> kLaunchers = {{
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},  // Open MPI
    {"PMI_RANK", "PMI_SIZE"},                          // MPICH, Intel MPI, srun --mpi=pmi2
    // srun; a batch script itself has the number of tasks that it may start, but not of a step.
    {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"},
}};

/// Ranks that the loaded library connects.
class LoadedRanks final : public Ranks {
 public:
  explicit LoadedRanks(const GliderRanks& ranks) : ranks_(ranks) {}
  [[nodiscard]] size_t rank() const override { return ranks_.rank; }
  [[nodiscard]] size_t size() const override { return ranks_.size; }
  void send(size_t to, MessageKind kind, const std::string& text) override {
    ranks_.send(static_cast<unsigned>(to), static_cast<unsigned>(kind), text.data(), text.size());
  }
  std::optional<Message> receive() override {
    unsigned from = 0;
    unsigned kind = 0;
    const char* bytes = nullptr;
    size_t length = 0;
    if (ranks_.receive(&from, &kind, &bytes, &length) == 0) {
      return std::nullopt;
    }
    return Message{from, static_cast<MessageKind>(kind), std::string(bytes, length)};
  }
  void leave() override { ranks_.leave(); }
  void abort(int status) override { ranks_.abort(status); }

 private:
  const GliderRanks& ranks_;
};

}  // namespace

Launch launchOf() {
  for (const Variables& variables : kLaunchers) {
    if (std::getenv(variables.size) != nullptr) {
      return {numberIn(variables.rank, 0), numberIn(variables.size, 1)};
    }
  }
  return {};
}

support::Result<std::unique_ptr<Ranks>> joinRanks(const Launch& launch) {
  if (launch.size <= 1) {
    return nullptr;
  }
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    return support::fail(support::diagnostics::ranksNotJoined, launch.size, why, hint);
  };
  const auto file = compiler::shareDirectory() / "mpi" / "ranks.so";
  if (!std::filesystem::exists(file)) {
    return refuse(
        "this glidercc was built without MPI",
        "install Open MPI (on Debian, `sudo apt-get install libopenmpi-dev "
        "openmpi-bin`) and build glidercc again; or start it once, without mpirun or srun");
  }
  // Parts of Open MPI are loaded later and look for its symbols among all.
  void* const handle = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (handle == nullptr) {
    return refuse(fmt::format("cannot load MPI: {}", ::dlerror()),
                  "install Open MPI: on Debian, `sudo apt-get install openmpi-bin`");
  }
  const auto join =
      reinterpret_cast<decltype(&gliderJoinRanks)>(::dlsym(handle, "gliderJoinRanks"));
  if (join == nullptr) {
    return refuse(fmt::format("`{}` is not of glidercc", file.string()), "install glidercc again");
  }
  const GliderRanks* ranks = join();
  if (ranks->size != launch.size) {
    if (ranks->size == 1) {
      ranks->leave();
    }
    return refuse(fmt::format("the MPI of this glidercc finds {} of them", ranks->size),
                  "start it with the mpirun of the MPI that it was built with; srun needs `--mpi` "
                  "with a value that this MPI supports, such as `pmix`");
  }
  return std::make_unique<LoadedRanks>(*ranks);
}

}  // namespace glider::campaign
