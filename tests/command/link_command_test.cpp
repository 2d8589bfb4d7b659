// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// --link: what fits a mission and a board is linked, all else is refused before it can fail at sea.

#include "tests/support/command.h"
#include "tests/support/user_code.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kLinked = R"(mission salty
extern function density(t: temperature, salty: bool): number in 0 .. 2
extern sensor range: length in 0 m .. 100 m
extern flightprofile spiral(to: length) reads depth, range
state look
begin
  flightprofile spiral(20 m)
  sensors missiontime, depth, temp, range
  events
    case density(temp, depth > 2 m) > 1 exit
    case missiontime > 200 s            exit
end
)";

constexpr const char* kCode = R"(#include "salty.h"
double function_density(double t, double salty) { return salty > 0.5 ? t / 100 : 0; }
double sensor_range(double at) { return at; }
void profile_spiral(GliderContext* context, GliderBehaviourMemory*, uint32_t, double to) {
  const double range = gliderRead(context, sensor_range_id);
  gliderDescend(context, range < 50 ? range : to, 0.45);
}
)";

/// A mission with C++ code in a folder of its own.
class Link : public testing::Test {
 protected:
  std::string compile(const std::string& board, const std::string& code = kCode,
                      const std::string& flags = "") {
    const auto source = folder_.write("salty.cpp", code);
    return compileFor(board, mission_, source, "salty-" + board + ".o", flags);
  }

  Outcome build(const std::string& board, const std::string& files,
                const std::string& more = "") const {
    return runShell("$GLIDERCC build " + mission_.string() + " --target " + board + " --link " +
                    files + " -o " + (folder_.path() / "product").string() + " " + more);
  }

  void expectRefused(const Outcome& outcome, const std::string& id, const std::string& says) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("[" + id + " "));
    EXPECT_THAT(outcome.err, HasSubstr(says));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "product"));
  }

  TemporaryFolder folder_;
  std::filesystem::path mission_ = folder_.write("salty.mission", kLinked);
};

// accepts: GL4003 GL4008 GL4009 GL4010 GL4011 GL4012 GL4017
TEST_F(Link, WhatFitsIsLinkedForEveryBoard) {
  for (const char* board : {"host", "ts7800", "ts5500", "pizero2", "cm4"}) {
    SCOPED_TRACE(board);
    const std::string object = compile(board);
    for (const char* level : {"-O0", "-O2", "-O3"}) {
      EXPECT_EQ(build(board, object, level).err, "");
    }
    const std::string archive = (folder_.path() / "salty.a").string();
    ASSERT_EQ(runShell("rm -f " + archive + "; ar rcs " + archive + " " + object).status, 0);
    EXPECT_EQ(build(board, archive).err, "");
    EXPECT_EQ(build(board, compile(board, kCode, "-emit-llvm")).err, "");
  }
}

TEST_F(Link, ItFliesInProcessAndOnABoard) {
  const std::string sim = "cd " + folder_.path().string() + "; $GLIDERCC sim salty.mission --link ";
  const Outcome here = runShell(sim + compile("host") + " -o here");
  EXPECT_EQ(here.status, 0) << here.err;
  const Outcome board = runShell(sim + compile("ts7800") + " --board ts7800 -o board");
  EXPECT_EQ(board.status, 0) << board.err;
  EXPECT_EQ(slurp(folder_.path() / "here/trace.csv"), slurp(folder_.path() / "board/trace.csv"));
}

TEST_F(Link, ParametersNeedNoCode) {
  const Outcome outcome = runShell("$GLIDERCC params " + mission_.string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
}

TEST_F(Link, WhatIsMissingIsNamedAsTheMissionHasIt) {  // GL4003
  const Outcome none =
      runShell("cd " + folder_.path().string() + "; $GLIDERCC build salty.mission");
  EXPECT_EQ(none.status, 2);
  EXPECT_THAT(none.err, HasSubstr("[GL4003 "));
  EXPECT_THAT(none.err, HasSubstr("--emit header"));
  std::string code = "extern \"C\" double gone();\n" + std::string(kCode);
  code.replace(code.find("return at"), 9, "return at + gone()");
  expectRefused(build("ts7800", compile("ts7800", code)), "GL4003", "`gone`");
}

TEST_F(Link, OtherFilesAreRefused) {  // GL4008
  expectRefused(build("host", mission_), "GL4008", "not an object");
  expectRefused(build("host", "/bin/true"), "GL4008", "a program");
  expectRefused(build("host", "/nonexistent.o"), "GL9001", "nonexistent");
  const std::string object = compile("host");
  const std::string bytes = slurp(object);
  for (const size_t size : {size_t{64}, size_t{300}, bytes.size() / 2}) {
    const auto cut = folder_.write("cut.o", bytes.substr(0, size));
    expectRefused(build("host", cut), "GL4008", "cut.o");
  }
}

/// A program of a board has a place of its own in memory; one of this machine, as a library, has
/// none.
TEST_F(Link, WhatIsLinkedAlreadyIsRefused) {  // GL4008
  const std::string object = compile("ts7800");
  ASSERT_EQ(build("ts7800", object).err, "");
  const auto program = folder_.path() / "program";
  std::filesystem::rename(folder_.path() / "product", program);
  expectRefused(build("ts7800", program), "GL4008", "it is a program or a shared library");
  expectRefused(build("host", "/bin/true"), "GL4008", "it is a program or a shared library");
  expectRefused(build("host", mission_), "GL4008", "it is not an object, an archive or bitcode");
}

TEST_F(Link, AnotherMachineIsRefused) {  // GL4009
  expectRefused(build("ts7800", compile("host")), "GL4009", "64-bit x86");
  expectRefused(build("ts7800", compile("ts5500")), "GL4009", "32-bit x86");
  expectRefused(build("ts5500", compile("ts7800")), "GL4009", "32-bit ARM");
  expectRefused(build("pizero2", compile("cm4")), "GL4009", "64-bit ARM");
  expectRefused(build("cm4", compile("pizero2")), "GL4009", "32-bit ARM");
  expectRefused(build("cm4", compile("host", kCode, "-emit-llvm")), "GL4009", "64-bit x86");
  expectRefused(build("host", compile("ts7800", kCode, "-emit-llvm")), "GL4009", "32-bit ARM");
  expectRefused(build("ts7800", compile("ts7800", kCode, "-mcpu=cortex-a8")), "GL4009",
                "later ARM");
  expectRefused(build("ts7800", compile("ts7800", kCode, "-mfloat-abi=hard -mfpu=vfpv2")), "GL4009",
                "FPU");
}

TEST_F(Link, InstructionsThatA486LacksAreRefused) {  // GL4010
  expectRefused(build("ts5500", compile("ts5500", kCode, "-march=pentium4 -msse2")), "GL4010",
                "an instruction that board `ts5500` does not have");
}

TEST_F(Link, InstructionsThatAnArmv8LacksAreRefused) {  // GL4010
  const std::string counts =
      std::string("int count;\nvoid add() { __atomic_fetch_add(&count, 1, 5); }\n") + kCode;
  expectRefused(build("cm4", compile("cm4", counts, "-march=armv8.1-a")), "GL4010",
                "an instruction that board `cm4` does not have");
  EXPECT_EQ(build("cm4", compile("cm4", counts)).err, "");
}

TEST_F(Link, FusedMultiplicationsAreRefused) {  // GL4017
  std::string sums = kCode;
  sums.replace(sums.find("t / 100"), 7, "t * salty + 0.5");
  expectRefused(build("cm4", compile("cm4", sums, "-ffp-contract=fast")), "GL4017", "`fmadd`");
  EXPECT_EQ(build("cm4", compile("cm4", sums)).err, "");
  EXPECT_EQ(build("cm4", compile("cm4", sums, "-ffp-contract=on -emit-llvm")).err, "")
      << "bitcode does not say how to round, and the compiler rounds twice";
  const std::string number = "asm(\".text; .word 0x1f400000\");\n";
  EXPECT_EQ(build("cm4", compile("cm4", number + kCode)).err, "") << "a word of data among code";
}

/// By the option of lld in the board's file: adrp at the end of a page, any load, one from that
/// page.
TEST_F(Link, WhatAnOldCortexA53ReadsWronglyIsReplaced) {
  const std::string page = R"(asm(".section .text.page, \"ax\"\n.balign 4096\n.zero 4088\n"
    ".globl page\n.type page, %function\npage: adrp x0, row\nldr x1, [sp]\nldr d0, [x0, :lo12:row]\n"
    "ret\n.size page, . - page\n.section .rodata.row, \"a\"\n.balign 8\nrow: .double 2.5\n.text");
extern "C" double page();
)";
  std::string code = page + kCode;
  code.replace(code.find("t / 100"), 7, "t / page()");
  EXPECT_EQ(build("cm4", compile("cm4", code)).err, "");
  const Outcome symbols =
      runShell("llvm-nm-19 " + (folder_.path() / "product.debug").string() + " | grep CortexA53");
  EXPECT_THAT(symbols.out, HasSubstr("843419"));
}

TEST_F(Link, AnotherDeclarationIsRefused) {  // GL4011
  const std::string object = compile("ts7800");
  std::string changed = kLinked;
  changed.replace(changed.find("t: temperature"), 14, "t: length");
  changed.replace(changed.find("density(temp"), 12, "density(depth");
  mission_ = folder_.write("salty.mission", changed);
  expectRefused(build("ts7800", object), "GL4011",
                "defines `function density(temperature, bool): number`, but the mission declares "
                "`function density(length, bool): number`");
}

TEST_F(Link, BitcodeThatCannotBeCompiledIsRefused) {  // GL4012
  const std::string assembly = std::string(kCode) + "void stop() { asm volatile(\"wfi r9\"); }\n";
  expectRefused(build("ts7800", compile("ts7800", assembly, "-emit-llvm")), "GL4012", "salty-");
  const std::string object = compile("ts7800", kCode, "-emit-llvm");
  const auto cut = folder_.write("cut.bc", slurp(object).substr(0, 1000));
  expectRefused(build("ts7800", cut), "GL4012", "cut.bc");
}

TEST_F(Link, AnInputIsNotOverwritten) {  // GL9350
  const std::string object = compile("host");
  const std::string before = slurp(object);
  const Outcome outcome =
      runShell("$GLIDERCC build " + mission_.string() + " --link " + object + " -o " + object);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("[GL9350 "));
  EXPECT_EQ(slurp(object), before);
}

}  // namespace
}  // namespace glider::tests
