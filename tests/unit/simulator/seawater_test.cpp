// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The conductivity of the simulated water against published check values, against a table that
// another implementation made, and against the salinity that the mission computes from it.

#include "simulator/ocean/seawater.h"

#include "runtime/abi/glider_abi.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace glider::simulator {
namespace {

constexpr double kOf35 = 4.2914;  // S/m at 15 degC and no pressure

double degrees90(double degrees68) {
  return degrees68 / 1.00024;
}

// UNESCO technical papers in marine science 44 (1983): the check values of SAL78 in both
// directions.
TEST(Seawater, ConductivityIsThatOfThePublishedCheckValues) {
  EXPECT_NEAR(conductivityOf(40, degrees90(40), 10000) / kOf35, 1.888091, 5e-7);
  EXPECT_NEAR(conductivityOf(35, degrees90(15), 0) / kOf35, 1, 5e-7);
  EXPECT_NEAR(conductivityOf(37.245628, degrees90(20), 2000) / kOf35, 1.2, 5e-7);
  EXPECT_NEAR(conductivityOf(27.995347, degrees90(5), 1500) / kOf35, 0.65, 5e-7);
}

TEST(Seawater, TheMissionComputesTheSalinityOfTheWater) {
  constexpr double kPascalPerDecibar = 1e4;
  for (double salinity = 0.1; salinity <= 42; salinity += 0.7) {
    for (const double degrees : {-2.0, 0.0, 4.5, 15.0, 24.0, 40.0}) {
      for (const double dbar : {0.0, 0.5, 30.0, 1000.0, 6000.0}) {
        const double conductivity = conductivityOf(salinity, degrees, dbar);
        EXPECT_NEAR(gliderSalinity(conductivity, degrees, dbar * kPascalPerDecibar), salinity, 1e-9)
            << degrees << " degC, " << dbar << " dbar";
      }
    }
  }
}

TEST(Seawater, FreshWaterConductsNextToNothing) {
  for (const double degrees : {-2.0, 0.0, 15.0, 40.0}) {
    const double conductivity = conductivityOf(0, degrees, 0);
    EXPECT_GT(conductivity, 0);
    EXPECT_LT(conductivity, 5e-4);
    EXPECT_LT(gliderSalinity(conductivity, degrees, 0), 0.02);
  }
}

TEST(Seawater, AgreesWithATableOfAnotherImplementation) {
  std::ifstream in(std::filesystem::path(GLIDER_SOURCE_DIR) /
                   "../shared/data/ocean/eos_reference.csv");
  if (!in) {
    GTEST_SKIP() << "the table eos_reference.csv is not here";
  }
  int rows = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] < '0' || line[0] > '9') {
      continue;
    }
    std::istringstream cells(line);
    std::vector<double> v;
    for (std::string cell; std::getline(cells, cell, ',');) {
      v.push_back(std::stod(cell));
    }
    if (v.at(0) >= 2 && v.at(0) <= 42) {  // else outside the scale
      EXPECT_NEAR(conductivityOf(v.at(0), v.at(1), v.at(2)), v.at(8), 1e-5) << line;
      ++rows;
    }
  }
  EXPECT_GT(rows, 20);
}

}  // namespace
}  // namespace glider::simulator
