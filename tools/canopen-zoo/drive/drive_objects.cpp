#include "tools/canopen-zoo/drive/drive_objects.hpp"

namespace zoo {
namespace {

using canopen::EntryDescription;
using enum canopen::DataType;
using enum canopen::Access;

EntryDescription setting(std::uint16_t index, canopen::DataType type, std::int64_t initial, std::string_view name,
                         std::uint8_t sub_index = 0) {
  return {
      .index = index, .sub_index = sub_index, .type = type, .access = ReadWrite, .initial = initial, .name = name};
}

/// A value that RPDOs carry.
EntryDescription command(std::uint16_t index, canopen::DataType type, std::string_view name) {
  return {.index = index, .type = type, .access = ReadWriteWrite, .pdo_mappable = true, .name = name};
}

/// A value that TPDOs carry.
EntryDescription actual(std::uint16_t index, canopen::DataType type, std::string_view name) {
  return {.index = index, .type = type, .pdo_mappable = true, .name = name};
}

EntryDescription count(std::uint16_t index, std::int64_t highest) {
  return {.index = index, .access = Constant, .initial = highest, .name = "Highest sub-index"};
}

EntryDescription fixed(std::uint16_t index, std::uint8_t sub_index, canopen::DataType type, std::int64_t initial,
                       std::string_view name) {
  return {
      .index = index, .sub_index = sub_index, .type = type, .access = Constant, .initial = initial, .name = name};
}

}  // namespace

std::vector<EntryDescription> drive_objects() {
  EntryDescription status = actual(0x6041, Unsigned16, "Statusword");
  return {setting(0x6007, Integer16, 1, "Abort connection option code"),
          command(0x6040, Unsigned16, "Controlword"),
          status,
          setting(0x605A, Integer16, 2, "Quick stop option code"),
          setting(0x605D, Integer16, 1, "Halt option code"),
          command(0x6060, Integer8, "Modes of operation"),
          actual(0x6061, Integer8, "Modes of operation display"),
          actual(0x6064, Integer32, "Position actual value"),
          setting(0x6067, Unsigned32, 64, "Position window"),
          actual(0x606C, Integer32, "Velocity actual value"),
          command(0x607A, Integer32, "Target position"),
          setting(0x607C, Integer32, 0, "Home offset"),
          count(0x607D, 2),
          setting(0x607D, Integer32, 0, "Lowest position", 1),
          setting(0x607D, Integer32, 0, "Highest position", 2),
          setting(0x607F, Unsigned32, 50 * kUnitsOfRevolution, "Max profile velocity"),
          setting(0x6080, Unsigned32, 3000, "Max motor speed"),
          setting(0x6081, Unsigned32, kUnitsOfRevolution, "Profile velocity"),
          setting(0x6083, Unsigned32, 10 * kUnitsOfRevolution, "Profile acceleration"),
          setting(0x6084, Unsigned32, 10 * kUnitsOfRevolution, "Profile deceleration"),
          setting(0x6085, Unsigned32, 20 * kUnitsOfRevolution, "Quick stop deceleration"),
          count(0x608F, 2),
          fixed(0x608F, 1, Unsigned32, kUnitsOfRevolution, "Encoder increments"),
          fixed(0x608F, 2, Unsigned32, 1, "Motor revolutions"),
          setting(0x6098, Integer8, 37, "Homing method"),
          command(0x60FF, Integer32, "Target velocity"),
          fixed(0x6502, 0, Unsigned32, kDriveModes, "Supported drive modes")};
}

std::vector<DrivePdo> drive_pdos(bool transmitted) {
  constexpr std::int64_t kControl = 0x6040'0010, kStatus = 0x6041'0010;
  if (transmitted) return {{kStatus}, {kStatus, 0x6061'0008}, {kStatus, 0x6064'0020}, {kStatus, 0x606C'0020}};
  return {{kControl}, {kControl, 0x6060'0008}, {kControl, 0x607A'0020}, {kControl, 0x60FF'0020}};
}

}  // namespace zoo
