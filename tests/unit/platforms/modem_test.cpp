// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The table [modem] of a platform file.

#include "platforms/load/modem.h"

#include "platforms/load/load_platform.h"
#include "support/diagnostics/diagnostic.h"
#include "tests/slocum.h"
#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <string>

namespace glider::platforms {
namespace {

/// What is wrong with the Slocum's file when `from` of its [modem] is `to`; "": nothing.
std::string withModem(const std::string& from, const std::string& to) {
  std::string text = tests::slurp(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  text.replace(text.find("name = \"slocum\""), 15, "name = \"p\"");
  text.replace(text.find(from, text.find("[modem]")), from.size(), to);
  const tests::TemporaryFolder folder;
  const auto platform = loadPlatform(folder.write("p.toml", text));
  return platform ? "" : platform.error().message;
}

TEST(PlatformModem, EachVehicleHasOne) {
  for (const char* name : {"slocum", "lauv", "remus100"}) {
    const auto platform =
        loadPlatform(std::string(GLIDER_SOURCE_DIR "/platforms/") + name + ".toml");
    ASSERT_TRUE(platform) << platform.error().message;
    ASSERT_TRUE(platform->modem) << name;
    EXPECT_EQ(platform->modem->kind, "micro-modem");
    EXPECT_EQ(platform->modem->frame_bytes, 32);
    EXPECT_EQ(platform->modem->cycle_init_s + platform->modem->frame_s, 5.5);
    EXPECT_EQ(platform->modem->range_m, 2000);
    EXPECT_EQ(platform->modem->interference_m, 3000);
    EXPECT_EQ(platform->modem->send_j_byte, 0.49);
    EXPECT_EQ(platform->modem->receive_j_byte, 0.49);
    EXPECT_EQ(platform->modem->listen_W, 0.08);
  }
}

// accepts: GL5001
TEST(PlatformModem, ItsNumbersAreChecked) {
  EXPECT_EQ(withModem("", ""), "");
  EXPECT_NE(withModem("micro-modem", "parrot").find("must be \"micro-modem\""), std::string::npos);
  EXPECT_NE(withModem("kind = \"micro-modem\"\n", "").find("kind"), std::string::npos);
  EXPECT_NE(withModem("frame_bytes = 32", "frame_bytes = 33").find("at most 32"),
            std::string::npos);
  EXPECT_NE(withModem("frame_bytes = 32", "frame_bytes = 7.5").find("whole"), std::string::npos);
  EXPECT_NE(withModem("frame_bytes = 32", "frame_bytes = 0").find("above 0"), std::string::npos);
  EXPECT_NE(withModem("cycle_init_s = 1.5", "cycle_init_s = 0.4").find("0.5 and 60"),
            std::string::npos);
  EXPECT_NE(withModem("frame_s = 4.0", "frame_s = 61").find("0.5 and 60"), std::string::npos);
  EXPECT_EQ(withModem("interference_m = 3000.0", "interference_m = 2000.0"), "");
  EXPECT_NE(withModem("interference_m = 3000.0", "interference_m = 1999.0").find("below `range_m`"),
            std::string::npos);
  EXPECT_EQ(withModem("listen_W = 0.08", "listen_W = 0"), "");
  EXPECT_NE(withModem("listen_W = 0.08", "listen_W = -1").find("below 0"), std::string::npos);
  EXPECT_NE(withModem("send_J_per_byte = 0.49", "send_J_per_byte = -1").find("below 0"),
            std::string::npos);
  EXPECT_NE(withModem("receive_J_per_byte = 0.49", "receive_J_per_byte = -1").find("below 0"),
            std::string::npos);
  EXPECT_NE(withModem("listen_W = 0.08", "listen_W = 0.08\nsonar = 1").find("sonar"),
            std::string::npos);
}

TEST(PlatformModem, ASlotHoldsDialogueFrameAndTheWayOfSound) {
  Modem modem;
  modem.cycle_init_s = 1.5;
  modem.frame_s = 4;
  modem.interference_m = 3000;
  EXPECT_EQ(slotOf(modem, 4), 19);  // 5.5 + 2 + 2 + 8 + 1
  EXPECT_EQ(slotOf(modem, 1), 19) << "it takes turns with slower vehicles";
  EXPECT_EQ(slotOf(modem, 5), 21);
  modem.interference_m = 3750;
  EXPECT_EQ(slotOf(modem, 4), 19);  // exactly
  modem.interference_m = 3751;
  EXPECT_EQ(slotOf(modem, 4), 20);
}

}  // namespace
}  // namespace glider::platforms
