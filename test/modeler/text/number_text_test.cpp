// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/text/number_text.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "modeler/text/stream_numbers.hpp"

namespace ribbon_mapper {
namespace {

/// Returns numbers of all sizes, round ones among them, and the ends of what a double can be.
std::vector<double> numbers() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers{0.0,
                              -0.0,
                              1.0,
                              100.0,
                              1e5,
                              123456.0,
                              1e15,
                              1e22,
                              1e23,
                              0.3,
                              1e-4,
                              1.5e-7,
                              Limits::max(),
                              Limits::lowest(),
                              Limits::min(),
                              Limits::denorm_min(),
                              9007199254740993.0,
                              12345678901234567890.0,
                              0.30000000000000004};
  std::mt19937_64 random;
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value)) numbers.push_back(value);
    const double size = std::pow(10.0, static_cast<int>(random() % 13) - 6);
    numbers.push_back(static_cast<double>(random() % 100000) / 1000.0 * size);
  }
  return numbers;
}

TEST(NumberText, IsShortAndReadsBackAsTheSame) {
  EXPECT_EQ("0.3", shortest_text(0.3));
  EXPECT_EQ("1e-04", shortest_text(1e-4));
  EXPECT_EQ("-12", shortest_text(-12));
  for (const double number : numbers()) {
    EXPECT_EQ(number, number_from(shortest_text(number))) << number;
  }
}

TEST(NumberText, HasTheDigitsThatWereAskedFor) {
  EXPECT_EQ("0.333333333", fixed_text(1.0 / 3.0, 9));
  EXPECT_EQ("-2.00", fixed_text(-2.0, 2));
  EXPECT_EQ("3.333333e-01", scientific_text(1.0 / 3.0, 6));
  EXPECT_EQ("0.333", general_text(1.0 / 3.0, 3));
  EXPECT_EQ("1.23e+06", general_text(1234567.0, 3));
  EXPECT_EQ(309u + 21u, fixed_text(std::numeric_limits<double>::max(), 20).size());
}

TEST(NumberText, OfStreamsIsTheSame) {
  for (const double number : numbers()) {
    EXPECT_EQ(shortest_text(number), stream_numbers::shortest_text(number));
    EXPECT_EQ(fixed_text(number, 9), stream_numbers::text_of(number, 9, std::ios_base::fixed));
    EXPECT_EQ(scientific_text(number, 6),
              stream_numbers::text_of(number, 6, std::ios_base::scientific));
    EXPECT_EQ(general_text(number, 3), stream_numbers::text_of(number, 3, {}));
    EXPECT_EQ(number, stream_numbers::number_from(shortest_text(number)));
  }
}

TEST(NumberText, WhatIsNoNumberIsNone) {
  for (const char* text :
       {"",   " ", " 1", "1 ",   "+1",    "--1",    "-+1",    "1,5",   "1e",  "1e+",
        "e5", ".", "-",  "0x10", "1e400", "-1e400", "1e-400", "1.2.3", "1_0", "metres"}) {
    EXPECT_FALSE(number_from(text)) << '"' << text << '"';
    EXPECT_FALSE(stream_numbers::number_from(text)) << '"' << text << '"';
  }
  for (const char* text :
       {"1", "-1", "1.", ".5", "1e5", "1E+05", "1e-320", "0e-400", "inf", "-INF"}) {
    ASSERT_TRUE(number_from(text)) << '"' << text << '"';
    EXPECT_EQ(number_from(text), stream_numbers::number_from(text)) << '"' << text << '"';
  }
  EXPECT_TRUE(std::isnan(number_from("nan").value()));
  EXPECT_TRUE(std::isnan(stream_numbers::number_from("nan").value()));
}

}  // namespace
}  // namespace ribbon_mapper
