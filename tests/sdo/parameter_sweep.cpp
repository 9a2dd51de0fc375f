#include "tests/sdo/parameter_sweep.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "libcanopen/base/little_endian.hpp"
#include "tests/drive/csv.hpp"
#include "tests/fakes/candump.hpp"

namespace sdo_test {
namespace {

constexpr unsigned kFirstObject = 0x2000;
constexpr unsigned kNumbersOfAnArea = 10000;
constexpr unsigned kIndicesOfAWindow = 256;
constexpr unsigned kVectorHasTwo = 1801;  // r1801: one index on a servo
constexpr std::uint8_t kUpload = 0x40;

/// Commissioning and motor identification, saturation characteristic, encoder fault reaction, terminals, holding
/// brake, fixed and jog setpoints, fixed values, BICO inputs of the setpoint channel, the positioner, sequence
/// control and messages.
const std::set<unsigned> kNamedElsewhere{
    47,   108,  205,  344,  353,  357,  362,  363,  364,  365,  366,  367,  368,  369,  491,  500,  723,
    728,  738,  739,  740,  741,  742,  743,  744,  745,  748,  795,  796,  856,  1001, 1002, 1003, 1004,
    1005, 1006, 1007, 1008, 1009, 1010, 1011, 1012, 1013, 1014, 1015, 1020, 1021, 1022, 1023, 1024, 1055,
    1056, 1058, 1059, 1078, 1085, 1088, 1110, 1111, 1114, 1143, 1144, 1150, 1216, 982,  1217, 1544, 1912,
    1913, 1914, 1925, 1927, 1932, 1934, 1936, 1937, 1967, 1969, 1984, 2098, 2130, 2136, 2145, 2146, 2510,
    2511, 2523, 2657, 2658, 2659, 2660, 2661, 2662, 2663, 2900, 2901, 2902, 3294};

const std::map<std::string, unsigned> kSizes{{"I8", 1},  {"U8", 1},      {"I16", 2},    {"U16", 2},
                                             {"I32", 4}, {"U32", 4},     {"F32", 4},    {"CI", 4},
                                             {"BI", 4},  {"U32/I16", 4}, {"U32/I32", 4}};

/// Answer to an expedited upload of @p size bytes.
constexpr std::uint8_t expedited(unsigned size) {
  return static_cast<std::uint8_t>(0x43U | (4U - size) << 2);
}

}  // namespace

std::vector<ListedParameter> listed_parameters(bool of_the_control_unit) {
  std::vector<ListedParameter> parameters;
  std::vector<drive_test::CsvRow> rows = drive_test::read_csv("parameters.csv");
  for (drive_test::CsvRow& row : drive_test::read_csv("interfaces-parameters.csv")) rows.push_back(std::move(row));
  for (const drive_test::CsvRow& row : rows) {
    const std::string& owner = row.at("do");
    const bool has = owner == "BOTH" || (owner == "CU") == of_the_control_unit;
    const auto number = static_cast<unsigned>(std::stoi(row.at("number").substr(1)));
    if (!has || number >= kNumbersOfAnArea) continue;
    const auto count = number == kVectorHasTwo ? 1U : static_cast<unsigned>(std::stoi(row.at("index_count")));
    for (unsigned index = 0; index < std::min(count, kIndicesOfAWindow); ++index)
      parameters.push_back({.name = row.at("number") + "[" + std::to_string(index) + "]",
                            .object = static_cast<std::uint16_t>(kFirstObject + number),
                            .sub_index = static_cast<std::uint8_t>(index),
                            .size = kSizes.at(row.at("type"))});
  }
  return parameters;
}

bool is_named_elsewhere(std::uint16_t object) {
  return kNamedElsewhere.contains(object - kFirstObject);
}

std::optional<canopen::Frame> ServerTransfer::request_frame() const {
  if (next == parameters.size()) return std::nullopt;
  canopen::Frame frame{.id = request, .length = 8, .data = {kUpload}};
  canopen::store(&frame.data[1], parameters[next].object);
  frame.data[3] = parameters[next].sub_index;
  return frame;
}

void ServerTransfer::take_answer(const canopen::Frame& answer) {
  const ListedParameter& asked = parameters[next++];
  EXPECT_EQ(canopen::load<std::uint16_t>(&answer.data[1]), asked.object) << asked.name;
  EXPECT_EQ(answer.data[3], asked.sub_index) << asked.name;
  EXPECT_EQ(answer.data[0], expedited(asked.size)) << asked.name << ": " << fakes::candump(answer);
}

}  // namespace sdo_test
