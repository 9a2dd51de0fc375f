#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "injection/json/kind_table.hpp"
#include "injection/kinds/bus_kinds.hpp"

namespace {

TEST(BusFaultsPage, HasTheTablesOfTheKinds) {
  std::ifstream file{BUS_FAULTS_PAGE};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  for (const std::string& table :
       {injection::kind_table(injection::bus_kinds()), injection::argument_table(injection::bus_kinds())})
    EXPECT_NE(page.find(table), std::string::npos)
        << BUS_FAULTS_PAGE " differs from injection/: cmake --build BUILD --target update_generated";
}

}  // namespace
