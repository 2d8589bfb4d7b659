// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Salinity and density against the check values of UNESCO technical papers in marine science 44,
// and against a table that another implementation made.

#include "runtime/abi/glider_abi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace glider {
namespace {

constexpr double kOf35 = 4.2914;  // S/m at 15 degC and no pressure
constexpr double kDecibar = 1e4;

double degrees90(double degrees68) {
  return degrees68 / 1.00024;
}

TEST(Seawater, SalinityIsThatOfThePublishedCheckValues) {
  EXPECT_NEAR(gliderSalinity(1.0 * kOf35, degrees90(15), 0), 35.0, 5e-7);
  EXPECT_NEAR(gliderSalinity(1.2 * kOf35, degrees90(20), 2000 * kDecibar), 37.245628, 5e-7);
  EXPECT_NEAR(gliderSalinity(0.65 * kOf35, degrees90(5), 1500 * kDecibar), 27.995347, 5e-7);
}

/// The conductivity (S/m) at which the salinity is `salinity`, by bisection.
double conductivityOf(double salinity, double temperature, double pressure) {
  double low = 0;
  double high = 12;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    const double found = gliderSalinity(middle, temperature, pressure);
    (std::isnan(found) || found > salinity ? high : low) = middle;
  }
  return low;
}

TEST(Seawater, DensityIsThatOfThePublishedCheckValues) {
  struct Row {
    double salinity, degrees68, bars, density;
  };
  for (const Row& row :
       {Row{35, 5, 0, 1027.67547}, Row{35, 5, 1000, 1069.48914}, Row{35, 25, 0, 1023.34306},
        Row{35, 25, 1000, 1062.53817}, Row{0, 5, 0, 999.96675}, Row{0, 25, 1000, 1037.90204}}) {
    const double pressure = row.bars * 1e5;
    const double conductivity = conductivityOf(row.salinity, degrees90(row.degrees68), pressure);
    // The least salinity that a conductivity gives is a few thousandths, not 0.
    EXPECT_NEAR(gliderDensity(conductivity, degrees90(row.degrees68), pressure), row.density,
                row.salinity > 0 ? 2e-5 : 2e-2)
        << row.salinity << " " << row.degrees68 << " " << row.bars;
  }
}

TEST(Seawater, AgreesWithATableOfAnotherImplementation) {
  const std::filesystem::path file =
      std::filesystem::path(GLIDER_SOURCE_DIR) / "../shared/data/ocean/eos_reference.csv";
  std::ifstream in(file);
  if (!in) {
    GTEST_SKIP() << "the table eos_reference.csv is not here";
  }
  std::string line;
  int rows = 0;
  while (std::getline(in, line)) {
    if (line.empty() || (std::isdigit(static_cast<unsigned char>(line[0])) == 0)) {
      continue;
    }
    std::istringstream cells(line);
    std::vector<double> v;
    for (std::string cell; std::getline(cells, cell, ',');) {
      v.push_back(std::stod(cell));
    }
    const double salinity = v.at(0);
    const double pressure = v.at(2) * kDecibar;
    if (salinity < 2 || salinity > 42) {
      continue;  // outside the scale
    }
    EXPECT_NEAR(gliderSalinity(v.at(8), v.at(1), pressure), salinity, 1e-4) << line;
    EXPECT_NEAR(gliderDensity(v.at(8), v.at(1), pressure), v.at(6), 1e-3) << line;
    ++rows;
  }
  EXPECT_GT(rows, 20);
}

TEST(Seawater, IsUnknownOutsideItsScale) {
  EXPECT_TRUE(std::isnan(gliderSalinity(NAN, 10, 0)));
  EXPECT_TRUE(std::isnan(gliderSalinity(3, NAN, 0)));
  EXPECT_TRUE(std::isnan(gliderSalinity(3, 10, NAN)));
  EXPECT_TRUE(std::isnan(gliderSalinity(3, 46, 0)));
  EXPECT_TRUE(std::isnan(gliderSalinity(3, -4.1, 0)));
  EXPECT_TRUE(std::isnan(gliderSalinity(9, 10, 0)));
  EXPECT_TRUE(std::isnan(gliderDensity(3, 10, 1.3e8)));
  EXPECT_EQ(gliderSalinity(0, 15, 0) >= 0, true);
}

TEST(Remainder, IsThatOfTheLongDoubleFunction) {
  for (const double x : {0.0, 5.0, -5.0, 1e9, -1e9, 1.8e9, 0.1, 1e-9, 86399.999999999, 86400.0}) {
    for (const double y : {1.0, 0.1, 86400.0, 44712.0, 3.0, 1e-3, 7e8}) {
      if (std::fabs(x / y) >= 2147483648.0) {
        EXPECT_TRUE(std::isnan(gliderRemainder(x, y))) << x << " " << y;
        continue;
      }
      const long double rest = std::fmod(static_cast<long double>(x), static_cast<long double>(y));
      const auto exact = static_cast<double>(rest < 0 ? rest + y : rest);
      const double found = gliderRemainder(x, y);
      EXPECT_GE(found, 0) << x << " " << y;
      EXPECT_LT(found, y) << x << " " << y;
      const double apart = std::fabs(found - exact);
      EXPECT_LE(std::min(apart, y - apart), 1e-15 * y) << x << " " << y;
    }
  }
}

TEST(Remainder, IsUnknownWithoutAPeriod) {
  for (const double y :
       {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY), 1e-300}) {
    EXPECT_TRUE(std::isnan(gliderRemainder(5, y))) << y;
  }
  EXPECT_TRUE(std::isnan(gliderRemainder(NAN, 5)));
  EXPECT_TRUE(std::isnan(gliderRemainder(1e300, 5)));
}

}  // namespace
}  // namespace glider
