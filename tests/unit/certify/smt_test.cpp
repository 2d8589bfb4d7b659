// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/smt.h"

#include "ir/certify/certificate.h"
#include "tests/unit/certify/judge.h"

#include <gtest/gtest.h>

#include <limits>

namespace glider::ir::certify {
namespace {

TEST(Literals, AreTheExactDoubles) {
  EXPECT_EQ(literal(0), "0.0");
  EXPECT_EQ(literal(-0.0), "0.0");
  EXPECT_EQ(literal(25), "25.0");
  EXPECT_EQ(literal(-1.5), "(- (/ 3.0 2.0))");
  EXPECT_EQ(literal(0.1), "(/ 3602879701896397.0 36028797018963968.0)");
  EXPECT_EQ(literal(0x1p60), "1152921504606846976.0");
  EXPECT_EQ(reciprocal(-1.5), "(- (/ 2.0 3.0))");
}

TEST(Literals, ReachToTheSmallestDoubles) {
  NEEDS_CVC5();
  const Term least = literal(std::numeric_limits<double>::denorm_min());
  Term product = least;
  for (int i = 0; i < 2; ++i) {
    product = operation("*", {product, literal(0x1p537)});
  }
  const std::string script =
      "(set-logic ALL)\n(assert (not (= 1.0 " + product + ")))\n(check-sat)\n";
  EXPECT_EQ(answersTo(script), std::vector<std::string>{"unsat"});
}

TEST(Formulas, AreOneTermOverTheirNames) {
  const std::vector<std::string> names{"|time|", "|was 0|", "|var a(b|"};
  for (const char* good : {"true", "|time|", " (and (<= |time| 3.0) (not |was 0|)) ",
                           "(let ((x (+ |var a(b| 1.0)) (a!1 true)) (and a!1 (< x 2.0)))",
                           "(ite true false (=> true (is_int (/ 1 2))))"}) {
    EXPECT_TRUE(isOneTerm(good, names)) << good;
  }
  for (const char* bad : {"",
                          " ",
                          "true true",
                          "(and true",
                          "true)",
                          "true) (assert false",
                          "|time",
                          "|depth|",
                          "true ; (",
                          "(= \"a\" \"b\")",
                          "(! true :named a)",
                          "glider.c0",
                          "(< glider.t1 3.0)",
                          "(and |a\\| b)",
                          "(witness ((x Real)) (< x x))",
                          "(|witness| ((x Real)) (< x x))",
                          "(forall ((x Real)) true)",
                          "(_ bv1 2)",
                          "(as x Real)",
                          "#b1"}) {
    EXPECT_FALSE(isOneTerm(bad, names)) << bad;
  }
}

}  // namespace
}  // namespace glider::ir::certify
