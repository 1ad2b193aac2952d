#include "tests/study/text.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace study {
namespace {

using Cells = std::vector<std::string>;

TEST(Text, ACellOfACsvFileIsReadAsItWasWritten) {
  const Cells cells = {"", "a", "a,b", "say \"no\"", ",", "\"", "a b", ""};
  std::string line;
  for (const std::string& cell : cells) line.append(csv_cell(cell)).append(1, ',');
  line.pop_back();
  EXPECT_EQ(csv_cells(line), cells) << line;
  EXPECT_EQ(csv_cells("a,b,"), (Cells{"a", "b", ""}));
  EXPECT_EQ(csv_cells(""), Cells{""});
  EXPECT_EQ(csv_cell("plain"), "plain");
  for (const char* line_with_open_quote : {"\"a", "\"a\"b,c", "a,\"", "\"a\"\""}) {
    EXPECT_THROW(csv_cells(line_with_open_quote), std::invalid_argument) << line_with_open_quote;
  }
}

}  // namespace
}  // namespace study
