// Where the values of parameters live: every block that a row names is there, and the page of the inputs names
// every input that something acts on.
#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "drive/parameter/home.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {
namespace {

/// The block that @p row lies in, nullptr if in none.
BlockId block_of(const ParameterRow& row) {
  if (const auto* const home = std::get_if<Setting>(&row.home)) return home->block;
  if (const auto* const home = std::get_if<BitInput>(&row.home)) return home->block;
  if (const auto* const home = std::get_if<ValueInput>(&row.home)) return home->block;
  if (const auto* const home = std::get_if<BlockOutput>(&row.home)) return home->block;
  return nullptr;
}

TEST(ParameterHomes, AreInBlocksThatTheDriveObjectHas) {
  UnitConfiguration configuration{};
  configuration.axes.assign(2, AxisConfiguration{});
  configuration.axes[1].kind = ObjectKind::Vector;
  configuration.infeed = true;
  const DriveUnit unit{configuration};
  std::size_t homes = 0;
  unit.for_each_object([&](const DriveObject& object) {
    for (const PlacedRow& placed : parameters_of(object.kind())) {
      const BlockId block = block_of(*placed.row);
      if (block == nullptr) continue;
      ++homes;
      EXPECT_NE(object.block(block), nullptr) << parameter_text(*placed.row) << " of " << int{object.number()};
    }
  });
  EXPECT_GT(homes, 200U);
}

std::string page() {
  std::ifstream file{SOURCE_FOLDER "/docs/reference/interconnections.md"};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The parameters in the first column of the table under "## Inputs".
std::set<std::uint16_t> inputs_of_the_page() {
  const std::string text = page();
  const std::size_t begin = text.find("\n## Inputs\n");
  EXPECT_NE(begin, std::string::npos);
  std::istringstream section{text.substr(begin + 1, text.find("\n## ", begin + 1) - begin)};
  std::set<std::uint16_t> numbers;
  const std::regex range{"p(\\d{4})(?: to p(\\d{4}))?"};
  for (std::string line; std::getline(section, line);) {
    if (line.rfind("| p", 0) != 0) continue;
    const std::string column = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator found{column.begin(), column.end(), range}, none; found != none; ++found) {
      const int first = std::stoi((*found)[1]);
      const int last = (*found)[2].matched ? std::stoi((*found)[2]) : first;
      for (int number = first; number <= last; ++number) numbers.insert(static_cast<std::uint16_t>(number));
    }
  }
  return numbers;
}

TEST(ParameterHomes, OfInputsThatAreFollowedAreThoseOfThePage) {
  std::set<std::uint16_t> followed;
  for (const ParameterRow* const row : parameter_rows())
    if (is_bico_input(row->type) && !std::holds_alternative<Stored>(row->home)) followed.insert(row->number);
  EXPECT_EQ(inputs_of_the_page(), followed);
}

TEST(ParameterHomes, HaveTheReferencesOfThePage) {
  const std::string text = page();
  std::size_t references = 0;
  for (const auto& [quantity, name] :
       {std::pair{Quantity::Speed, "speed"}, std::pair{Quantity::Voltage, "voltage"},
        std::pair{Quantity::Current, "current"}, std::pair{Quantity::Torque, "torque"},
        std::pair{Quantity::Power, "power"}, std::pair{Quantity::Angle, "angle"},
        std::pair{Quantity::Temperature, "temperature"}, std::pair{Quantity::Acceleration, "acceleration"}}) {
    const std::string entry = "p" + std::to_string(reference_of(quantity)) + " " + name;
    std::string flat = text;
    std::replace(flat.begin(), flat.end(), '\n', ' ');
    EXPECT_NE(flat.find(entry), std::string::npos) << entry;
    ++references;
  }
  for (const QuantityRow& row : kQuantities) references -= row.reference != 0 ? 1U : 0U;
  EXPECT_EQ(references, 0U) << "a quantity with reference is missing here";
}

}  // namespace
}  // namespace drive
