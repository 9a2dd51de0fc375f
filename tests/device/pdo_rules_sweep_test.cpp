#include <set>
#include <utility>

#include "tests/device/pdo_rules_fixture.hpp"

/// The rules of the unit for PDO parameters, tried on every object and every PDO.
namespace device {
namespace {

/// What facts and EDS let stand in a PDO of the first axis: objects and their lengths in bits.
using Objects = std::set<std::pair<std::uint16_t, unsigned>>;

Objects with_free(Objects objects, std::uint16_t words, std::uint16_t double_words) {
  for (std::uint16_t i = 0; i < 16; ++i) objects.emplace(static_cast<std::uint16_t>(words + i), 16U);
  for (std::uint16_t i = 0; i < 8; ++i) objects.emplace(static_cast<std::uint16_t>(double_words + i), 32U);
  return objects;
}
const Objects kReceived =
    with_free({{0x6040, 16}, {0x6042, 16}, {0x6060, 8}, {0x60FF, 32}, {0x6071, 16}}, 0x5800, 0x5820);
const Objects kSent = with_free({{0x6041, 16},
                                 {0x6043, 16},
                                 {0x6044, 16},
                                 {0x6061, 8},
                                 {0x6063, 32},
                                 {0x6069, 32},
                                 {0x606B, 32},
                                 {0x606C, 32},
                                 {0x6074, 16},
                                 {0x6077, 16}},
                                0x5810, 0x5830);

/// The object that @p index of the first axis is on @p axis.
std::uint16_t on_axis(std::uint16_t index, std::size_t axis) {
  return static_cast<std::uint16_t>(index + (index < 0x6000 ? 0x80 : 0x800) * (axis - 1));
}

/// Tries every index, as long as 8, 16 and 32 bits, in a PDO of @p axis; counts what is accepted.
std::size_t try_every_object(TestUnit& unit, std::size_t axis, std::uint16_t first_record,
                             const Objects& allowed) {
  const auto record = static_cast<std::uint16_t>(first_record + 0x40 * (axis - 1));
  std::size_t accepted = 0;
  for (std::uint32_t place = 0; place < 3 * (0x80 + 0x200); ++place) {
    const auto index = static_cast<std::uint16_t>(place / 3 < 0x80 ? 0x5800 + place / 3 : 0x5F80 + place / 3);
    const unsigned bits = 8U << place % 3;
    const std::uint32_t entry = std::uint32_t{on_axis(index, axis)} << 16 | bits;
    const bool mappable = allowed.contains({index, bits});
    const std::uint32_t answer = unit.download(record, 1, entry, 4);
    EXPECT_EQ(answer, mappable ? 0U : 0x06040041U) << std::hex << entry;
    accepted += answer == 0 ? 1 : 0;
  }
  for (const auto& [index, bits] : allowed) {
    const std::uint32_t entry = std::uint32_t{on_axis(index, axis)} << 16 | bits;
    const std::uint32_t elsewhere = std::uint32_t{on_axis(index, axis % 8 + 1)} << 16 | bits;
    EXPECT_EQ(unit.download(record, 1, entry | 0x100, 4), 0x06040041U) << "sub-index 1";
    EXPECT_EQ(unit.download(record, 1, elsewhere, 4), 0x06040041U) << "of another axis";
  }
  expect_accepted(unit, {record, 1, 0});
  return accepted;
}

TEST(PdoRules, LetEveryAxisMapItsOwnObjectsOnly) {
  TestUnit unit{unit_of(8)};
  unit.start();

  for (std::size_t axis = 1; axis <= 8; ++axis) {
    EXPECT_EQ(try_every_object(unit, axis, 0x1607, kReceived), kReceived.size());
    EXPECT_EQ(try_every_object(unit, axis, 0x1A07, kSent), kSent.size());
  }
}

/// One object mapped by the procedure of CiA 301, with every refusal on its way.
void try_rules_of(TestUnit& unit, std::uint16_t record, std::uint32_t entry) {
  SCOPED_TRACE(record);
  const auto mapping = static_cast<std::uint16_t>(record + 0x200);
  expect_accepted(unit, {record, 1, kInvalid});
  expect_accepted(unit, {mapping, 0, 0, 1});
  expect_accepted(unit, {mapping, 1, entry});
  expect_accepted(unit, {mapping, 2, 0});
  expect_accepted(unit, {mapping, 0, 1, 1});
  EXPECT_EQ(unit.download(mapping, 0, 2, 1), 0x06040041U) << "an empty entry";
  EXPECT_EQ(unit.download(record, 1, 0x80, 4), 0x06040043U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 2U);
  expect_accepted(unit, {record, 1, 0x6D0});
  expect_no_alarm(unit);
  EXPECT_EQ(unit.download(mapping, 1, 0, 4), 0x08000022U);
  EXPECT_EQ(unit.download(record, 1, 0x6D1, 4), 0x08000022U);
  unit.says("000#0105");
  EXPECT_EQ(unit.download(record, 1, kInvalid, 4), 0x08000022U);
  EXPECT_EQ(unit.download(record, 2, 1, 1), 0x08000022U);
  EXPECT_EQ(unit.upload(0x1003, 0).number(), 1U);
  unit.says("000#8005");
  expect_accepted(unit, {record, 1, kInvalid});
  expect_no_alarm(unit);
}

TEST(PdoRules, HoldForEveryPdoOfEveryAxis) {
  TestUnit unit{unit_of(8)};
  unit.start();
  for (std::uint16_t number = 0; number < 64; ++number) {
    const auto record = static_cast<std::uint16_t>(0x1400 + number / 8 * 0x40 + number % 8);
    const std::uint32_t controlword = on_axis(0x6040, number / 8 + 1U),
                        statusword = on_axis(0x6041, number / 8 + 1U);
    try_rules_of(unit, record, controlword << 16 | 0x10);
    try_rules_of(unit, static_cast<std::uint16_t>(record + 0x400), statusword << 16 | 0x10);
  }
}

}  // namespace
}  // namespace device
