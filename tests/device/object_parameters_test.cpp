#include "device/parameters/object_parameters.hpp"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "drive/catalogue/table.hpp"

namespace device {
namespace {

/// The line of docs/reference/objects.md that opens object @p index: it says what the object does.
std::string line_of(std::uint16_t index) {
  std::ifstream page{std::string{SOURCE_FOLDER} + "/docs/reference/objects.md"};
  std::ostringstream start;
  start << "| " << std::hex << std::uppercase << index << " | ";
  const std::string variable = start.str() + "00 |";
  const std::string several = start.str() + "| **";
  for (std::string line; std::getline(page, line);)
    if (line.starts_with(variable) || line.starts_with(several)) return line;
  return {};
}

TEST(ObjectParameters, AreThoseThatTheCatalogueNames) {
  for (const ObjectParameter& row : kObjectParameters)
    EXPECT_NE(line_of(row.index).find('p' + std::to_string(row.parameter)), std::string::npos)
        << std::hex << row.index << ": p" << std::dec << row.parameter;
}

TEST(ObjectParameters, ExistOnTheirDriveObjects) {
  for (const ObjectParameter& row : kObjectParameters)
    for (const drive::ObjectKind kind : {drive::ObjectKind::Servo, drive::ObjectKind::Vector})
      EXPECT_NE(drive::find_parameter(kind, row.parameter), nullptr) << row.parameter;
  for (const Mirror& row : kMirrors)
    for (const drive::ObjectKind kind :
         {drive::ObjectKind::ControlUnit, drive::ObjectKind::Servo, drive::ObjectKind::Vector})
      for (unsigned number = row.first; drive::contains(row.kinds, kind) && number <= row.last; ++number)
        EXPECT_NE(drive::find_parameter(kind, static_cast<std::uint16_t>(number)), nullptr) << number;
}

}  // namespace
}  // namespace device
