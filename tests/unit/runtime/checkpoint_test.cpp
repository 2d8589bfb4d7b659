// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// After any power cut, the file of checkpoints contains the last committed tick.

#include "runtime/checkpoint/checkpoint.h"

#include "tests/unit/runtime/resume_bench.h"

#include <gtest/gtest.h>

#include <map>

namespace glider::runtime::testing {
namespace {

class CheckpointTest : public ResumeBench {};

class Counting : public ResumeBench, public ::testing::WithParamInterface<bool> {};

TEST_P(Counting, AfterAnyPowerCutTheFileContainsTheLastCommittedTick) {
  counts = GetParam();
  std::vector<Bytes> kept;  // of each commit, in order
  VehicleBench vehicle({.silence_secs = 24});
  store_.mark = [this, &kept] {
    const Bytes body = bodyOf(*reinterpret_cast<const GliderContext*>(mission_.memory.data()));
    if (kept.empty() || kept.back() != body) {
      kept.push_back(body);
    }
    return kept.size();
  };
  boot(vehicle);
  vehicle.run(counts ? 220 : 420);
  ASSERT_GT(kept.size(), 20U);

  std::vector<double> memory(mission_.memory.size());
  size_t files = 0;
  for (size_t made = 0; made <= store_.log.size(); ++made) {
    const bool is_synced = made > 0 && store_.log[made - 1].bytes.empty();
    const size_t newest = made == 0 ? 0 : store_.log[made - 1].answered;
    const size_t whole = is_synced ? newest : newest - (made == 0 ? 0 : 1);
    eachFileAfterCut(store_.log, made, [&](const SparseFile& file) {
      ++files;
      RecordingStore left;
      left.content = file;
      GliderContext* context = layOut(memory.data(), mission_.mission);
      LinkFacts facts;
      const auto found = Checkpoint(left.store(), 7).find(*context, facts);
      if (found != Checkpoint::Found::Good) {
        ASSERT_EQ(whole, 0U) << "one was whole after " << made << " writes";
        return;
      }
      const Bytes body = bodyOf(*context);
      const bool of_last = whole > 0 && body == kept[whole - 1];
      const bool of_newest = newest > 0 && body == kept[newest - 1];
      ASSERT_TRUE(of_last || of_newest) << "after " << made << " writes";
      ASSERT_TRUE(!is_synced || of_newest) << "what was synced is what is found";
    });
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(files, 3000U);
}

INSTANTIATE_TEST_SUITE_P(, Counting, ::testing::Bool());

/// A mission that has made some commits, each file that they may have left, and what is in it.
class EraseBlocks : public ResumeBench {
 protected:
  EraseBlocks() : memory_(mission_.memory.size()) {
    store_.mark = [this] { return static_cast<size_t>(checkpoints_); };
    GliderContext* context = layOut(memory_.data(), mission_.mission);
    context->moved_list = GLIDER_NO_LIST;
    Checkpoint checkpoint(store_.store(), 7);
    for (checkpoints_ = 1; checkpoints_ <= 8; ++checkpoints_) {
      EXPECT_EQ(checkpoint.keep(*context, {0, 0, 0, 1, checkpoints_}), Checkpoint::Kept::Written);
    }
  }

  /// Number of the checkpoint that is found in `file`, 0 for none.
  uint32_t foundIn(const SparseFile& file) {
    RecordingStore left;
    left.content = file;
    LinkFacts facts;
    GliderContext* context = layOut(memory_.data(), mission_.mission);
    const auto found = Checkpoint(left.store(), 7).find(*context, facts);
    return found == Checkpoint::Found::Good ? facts.instruction : 0;
  }

  /// Calls `visit` with blocks of `bytes` that begin anywhere in the file.
  template <typename Visit>
  static void eachPhase(uint32_t bytes, Visit visit) {
    for (uint32_t part = 0; part < 4; ++part) {
      visit(EraseBlock{bytes, bytes / 4 * part});
      visit(EraseBlock{bytes, bytes - Checkpoint::kBlock * (part + 1) % bytes});
    }
  }

  uint32_t checkpoints_ = 0;
  std::vector<double> memory_;
};

constexpr uint32_t kSizes[] = {64U << 10U, 512U << 10U, 1U << 20U, 2U << 20U, 4U << 20U};
constexpr Leaves kLeavings[] = {Leaves::Zeros, Leaves::Ones, Leaves::Noise};

TEST_F(EraseBlocks, ARewriteThatIsInterruptedTakesNoneThatWasCommitted) {
  for (size_t made = 1; made < store_.log.size(); ++made) {
    const RecordedWrite& write = store_.log[made];  // during which the power goes
    if (write.bytes.empty()) {
      continue;
    }
    const auto committed = static_cast<uint32_t>(write.answered - 1);
    const SparseFile written = fileAfter(store_.log, made + 1);
    for (const uint32_t bytes : kSizes) {
      eachPhase(bytes, [&](const EraseBlock& blocks) {
        for (const Leaves leaves : kLeavings) {
          const SparseFile file = withoutBlock(written, blocks, blocks.of(write.offset), leaves);
          ASSERT_EQ(foundIn(file), committed)
              << "blocks of " << bytes << " bytes, phase " << blocks.phase << ", write " << made;
        }
      });
    }
  }
}

TEST_F(EraseBlocks, ARewriteOfAnotherFilesBlockTakesTheNewestAtMost) {
  const SparseFile whole = fileAfter(store_.log, store_.log.size());
  for (const uint32_t bytes : kSizes) {
    eachPhase(bytes, [&](const EraseBlock& blocks) {
      for (uint32_t number = 0; number <= blocks.of(static_cast<uint32_t>(whole.size()));
           ++number) {
        ASSERT_GE(foundIn(withoutBlock(whole, blocks, number, Leaves::Noise)), 7U)
            << "blocks of " << bytes << " bytes, phase " << blocks.phase;
      }
    });
  }
}

TEST_F(EraseBlocks, OfTwiceTheSizeLeaveTheNewestOrTheOneBefore) {
  for (size_t made = 9; made < store_.log.size(); ++made) {
    const RecordedWrite& write = store_.log[made];
    eachPhase(8U << 20U, [&](const EraseBlock& blocks) {
      const SparseFile file = withoutBlock(fileAfter(store_.log, made + 1), blocks,
                                           blocks.of(write.offset), Leaves::Ones);
      ASSERT_TRUE(write.bytes.empty() || foundIn(file) + 2 >= write.answered)
          << "phase " << blocks.phase << ", write " << made;
    });
  }
}

TEST_F(EraseBlocks, AFileOfAnOlderFormatIsAnotherPrograms) {
  store_.content.write(3, reinterpret_cast<const uint8_t*>("2"), 1);  // "GLK2"
  SparseFile older;
  uint8_t first[512];
  store_.content.read(0, first, sizeof first);
  older.write(0, first, sizeof first);
  RecordingStore left;
  left.content = older;
  LinkFacts facts;
  GliderContext* context = layOut(memory_.data(), mission_.mission);
  EXPECT_EQ(Checkpoint(left.store(), 7).find(*context, facts), Checkpoint::Found::Foreign);
}

TEST_F(CheckpointTest, ACardThatFailsForLongLosesNoneThatWasKept) {
  std::vector<double> memory(mission_.memory.size());
  GliderContext* context = layOut(memory.data(), mission_.mission);
  context->moved_list = GLIDER_NO_LIST;
  Checkpoint checkpoint(store_.store(), 7);
  for (uint32_t instruction = 1; instruction <= 5; ++instruction) {
    ASSERT_EQ(checkpoint.keep(*context, {0, 0, 0, 1, instruction}), Checkpoint::Kept::Written);
  }
  store_.fails = true;
  for (uint32_t instruction = 6; instruction < 6 + Checkpoint::kSlots - 1; ++instruction) {
    ASSERT_EQ(checkpoint.keep(*context, {0, 0, 0, 1, instruction}), Checkpoint::Kept::Failed);
  }
  store_.fails = false;
  context->mission_time += 1;
  const size_t made = store_.log.size();
  ASSERT_EQ(checkpoint.keep(*context, {0, 0, 1, 99}), Checkpoint::Kept::Written);
  eachFileAfterCut(store_.log, made + 1, [&](const SparseFile& file) {
    RecordingStore left;
    left.content = file;
    LinkFacts facts;
    GliderContext* found = layOut(memory.data(), mission_.mission);
    ASSERT_EQ(Checkpoint(left.store(), 7).find(*found, facts), Checkpoint::Found::Good);
    EXPECT_EQ(facts.instruction, 5U) << "the newest that was kept";
  });
}

TEST_F(CheckpointTest, WearIsBoundedAndTheFileDoesNotGrow) {
  counts = false;
  end = 1000;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(900);
  const auto syncs =
      std::ranges::count_if(store_.log, [](const auto& w) { return w.bytes.empty(); });
  EXPECT_LE(syncs, 900 / 20 + 6) << "each 20 s, two transitions and their commands";
  EXPECT_GE(syncs, 900 / 20 - 3);
  EXPECT_LE(store_.content.size(), Checkpoint::storeBytes(mission_.mission.context_bytes));
  std::map<uint32_t, int> writes;
  for (const auto& write : store_.log) {
    writes[write.offset] += write.bytes.empty() ? 0 : 1;
  }
  for (const auto& [offset, count] : writes) {
    EXPECT_LE(count, syncs / static_cast<int>(Checkpoint::kSlots) + 1) << "at " << offset;
  }
}

}  // namespace
}  // namespace glider::runtime::testing
