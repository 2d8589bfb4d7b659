// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// check writes a certificate for each proof, and checks it again: what it prints, and its exit
// codes.

#include "tests/support/command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace glider::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kCertified =
    "mission m\n"
    "require exit within 40 min\n"
    "require always depth <= 20 m\n"
    "state only\nbegin\n  flightprofile yo(5 m, 15 m, 26 deg, 26 deg)\n"
    "  sensors missiontime\n  events\n"
    "    case missiontime >= 30 min exit\nend\n";

class CertificatesCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (runShell("cvc5 --version").status != 0) {
      GTEST_SKIP() << "cvc5 is not installed";
    }
    mission_ = folder_.write("m.mission", kCertified).string();
  }
  [[nodiscard]] std::string certificates() const { return (folder_.path() / "proofs").string(); }
  [[nodiscard]] Outcome check(const std::string& how, const std::string& before = "") const {
    return runShell(before + "$GLIDERCC check " + mission_ + " " + how + " " + certificates());
  }

  TemporaryFolder folder_;
  std::string mission_;
};

TEST_F(CertificatesCommand, WritesAndAcceptsThem) {
  const Outcome written = check("--certificates");
  EXPECT_EQ(written.status, 0);
  EXPECT_THAT(written.err, HasSubstr("2 certificates written to "));
  const Outcome found = check("--recheck");
  EXPECT_EQ(found.status, 0) << found.err;
  EXPECT_THAT(
      found.out,
      AllOf(HasSubstr("accepted: require exit within 40 min\n  by bound: 1 configuration, "),
            HasSubstr("accepted: require always depth <= 20 m\n")));
  EXPECT_THAT(found.err, HasSubstr("2 of 2 certificates accepted, checked with cvc5"));
}

TEST_F(CertificatesCommand, RefusesWhatIsChangedOrMissing) {
  ASSERT_EQ(check("--certificates").status, 0);
  std::filesystem::remove(certificates() + "/requirement-1.json");
  ASSERT_EQ(
      runShell("sed -i 's/deepest| 20.0/deepest| 21.0/' " + certificates() + "/requirement-2.json")
          .status,
      0);
  const Outcome found = check("--recheck");
  EXPECT_EQ(found.status, 1);
  EXPECT_THAT(found.out, AllOf(HasSubstr("no certificate: require exit within 40 min\n"),
                               HasSubstr("refused: require always depth <= 20 m\n  not so: ")));
  EXPECT_THAT(found.err, HasSubstr("0 of 2 certificates accepted"));
}

/// Also if it names what is no longer in the mission.
TEST_F(CertificatesCommand, RefusesWhatRestsOnADeletedAssumption) {
  const std::string assumed = "mission m\nassume no outage\n" + kCertified.substr(10);
  mission_ = folder_.write("m.mission", assumed).string();
  ASSERT_EQ(check("--certificates").status, 0);
  mission_ = folder_.write("m.mission", kCertified).string();
  const Outcome found = check("--recheck");
  EXPECT_EQ(found.status, 1) << found.err;
  EXPECT_THAT(found.out, HasSubstr("refused: require exit within 40 min\n  it is about another "
                                   "mission or another vehicle"));
}

TEST_F(CertificatesCommand, OfTwoMissionsOfOneNameAreRefused) {
  std::filesystem::create_directory(folder_.path() / "other");
  std::ofstream(folder_.path() / "other" / "m.mission") << kCertified;
  const std::string first = mission_;
  mission_ += " " + (folder_.path() / "other" / "m.mission").string();
  for (const char* how : {"--certificates", "--recheck", "--traces"}) {
    const Outcome both = check(how);
    EXPECT_EQ(both.status, 2);
    EXPECT_THAT(both.err, HasSubstr("would have their files in the same folder `m`"));
    EXPECT_FALSE(std::filesystem::exists(certificates()));
  }
}

TEST_F(CertificatesCommand, RemovesThoseOfEarlierProofs) {
  ASSERT_EQ(check("--certificates").status, 0);
  const std::string text = "mission m\nrequire exit within 5 min\n" +
                           kCertified.substr(kCertified.find("require always"));
  mission_ = folder_.write("m.mission", text).string();
  EXPECT_EQ(check("--certificates").status, 1) << "it does not end within 5 min";
  EXPECT_FALSE(std::filesystem::exists(certificates() + "/requirement-1.json"));
  EXPECT_TRUE(std::filesystem::exists(certificates() + "/requirement-2.json"));
}

/// It is not that they are missing.
TEST_F(CertificatesCommand, BehindALoopOfLinksCannotBeRead) {
  std::filesystem::create_symlink("proofs", certificates());
  const Outcome found = check("--recheck");
  EXPECT_EQ(found.status, 2) << found.out;
  EXPECT_THAT(found.err, HasSubstr("Too many levels of symbolic links [GL9001 cannot-read]"));
  EXPECT_THAT(found.err, testing::Not(HasSubstr("internal error")));
}

TEST_F(CertificatesCommand, SaysWhatIsDamagedOrNotInstalled) {
  ASSERT_EQ(check("--certificates").status, 0);
  const Outcome missing = check("--recheck", "PATH=/nowhere ");
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, AllOf(HasSubstr("cannot run `cvc5`"), HasSubstr("[GL9380 ")));
  std::ofstream(certificates() + "/requirement-1.json") << "{}";
  const Outcome damaged = check("--recheck");
  EXPECT_EQ(damaged.status, 2);
  EXPECT_THAT(damaged.err, HasSubstr("is not a certificate: a field is missing"));
  EXPECT_EQ(check("--report --recheck").status, 2) << "one or the other";
}

}  // namespace
}  // namespace glider::tests
