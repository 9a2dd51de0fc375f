/// The SDO window and records are doors to the same parameters: what one reads or refuses the other one does too.
#include <bit>
#include <limits>

#include "device/objects/abort_codes.hpp"
#include "profidrive/parameter/format.hpp"
#include "tests/profidrive/record_unit.hpp"

namespace profidrive {
namespace {

using namespace std::chrono_literals;

constexpr std::uint16_t kWindow = 0x41B6, kNumbersInWindow = 10000;
/// p8630[2] leads to no higher numbers.
constexpr std::uint16_t kBehindWindows = 60000;

/// A unit whose parameters are asked for through both doors.
struct TwoDoors {
  RecordUnit bus{{{}, {.drive = {.kind = drive::ObjectKind::Vector}}}};
  RecordUnit records{{{}, {.drive = {.kind = drive::ObjectKind::Vector}}}};
  std::array<std::uint16_t, 3> open{};

  /// Where the window of the bus shows @p index of parameter @p number of @p object.
  std::uint16_t show(std::uint8_t object, std::uint16_t number, std::size_t index) {
    const std::array<std::uint16_t, 3> wanted{object, static_cast<std::uint16_t>(index / 256),
                                              static_cast<std::uint16_t>(number / kNumbersInWindow)};
    for (std::uint8_t i = 0; i < wanted.size(); ++i)
      if (wanted[i] != open[i]) {
        EXPECT_EQ(bus.download(kWindow, i, wanted[i], 2), 0U);
      }
    open = wanted;
    return static_cast<std::uint16_t>(0x2000 + number % kNumbersInWindow);
  }
};

Bytes request(std::uint8_t service, std::uint8_t object, std::uint16_t number, std::size_t index) {
  const auto high = [](std::size_t word) { return static_cast<std::uint8_t>(word >> 8); };
  const auto low = [](std::size_t word) { return static_cast<std::uint8_t>(word); };
  return {1, service, object, 1, 0x10, 1, high(number), low(number), high(index), low(index)};
}

/// The error of a negative answer about one parameter; 0 = it is positive.
std::uint32_t abort_code_of(const Bytes& answer) {
  if (answer[1] < 0x80) return 0;
  EXPECT_EQ(answer[4], 0x44);
  const auto reason = drive::RefusalReason{answer[7]};
  return static_cast<std::uint32_t>(device::abort_code(reason));
}

TEST(Doors, ReadTheSameBits) {
  TwoDoors unit;
  std::size_t compared = 0;

  for (std::uint8_t object = 1; object <= 3; ++object)
    for (const drive::PlacedRow& placed : drive::parameters_of(unit.bus.device.unit().object(object)->kind())) {
      const drive::ParameterRow& row = *placed.row;
      if (row.number == 8630 || row.number >= kBehindWindows)
        continue;  // the window itself shows any drive object
      for (std::size_t index = 0; index <= row.count; ++index) {
        const std::uint16_t shown = unit.show(object, row.number, index);
        const device::Upload upload = unit.bus.upload(shown, static_cast<std::uint8_t>(index));
        const Bytes answer = unit.bus.serve(request(1, object, row.number, index));
        const std::string where = std::to_string(object) + " p" + std::to_string(row.number);
        ASSERT_EQ(abort_code_of(answer), upload.abort_code) << where;
        if (upload.abort_code != 0) continue;
        const Bytes value{answer.begin() + 6,
                          answer.begin() + 6 + static_cast<std::ptrdiff_t>(upload.bytes.size())};
        EXPECT_EQ(digits_of(value), digits_of(Bytes{upload.bytes.rbegin(), upload.bytes.rend()})) << where;
        ++compared;
      }
    }
  EXPECT_GT(compared, 3000U);
}

/// What is worth writing to a parameter of @p row.
std::vector<double> values_for(const drive::ParameterRow& row) {
  const drive::Range limits = drive::limits_of(row);
  if (row.type == drive::DataType::F32)
    return {limits.minimum, limits.maximum, limits.minimum - 1e3, limits.maximum * 2.0 + 1e3,
            std::numeric_limits<double>::quiet_NaN()};
  std::vector<double> values{limits.minimum, limits.maximum, 3.0, 77.0};
  for (const double beyond : {limits.minimum - 1.0, limits.maximum + 1.0})
    if (beyond >= drive::row_of(row.type).lowest && beyond <= drive::row_of(row.type).highest)
      values.push_back(beyond);
  return values;
}

/// The two doors name limits of the list by numbers of their own, and the value not allowed shares one with them.
std::uint32_t without_direction(std::uint32_t code) {
  constexpr std::uint32_t kInvalidValue = 0x06090030, kTooHigh = 0x06090031, kTooLow = 0x06090032;
  return code == kTooHigh || code == kTooLow ? kInvalidValue : code;
}

TEST(Doors, RefuseTheSameWrites) {
  std::size_t written = 0, refused = 0;
  for (std::uint8_t object = 1; object <= 3; ++object) {
    TwoDoors unit;
    for (const drive::PlacedRow& placed : drive::parameters_of(unit.bus.device.unit().object(object)->kind())) {
      const drive::ParameterRow& row = *placed.row;
      const bool is_command = row.keep == drive::Keep::No && row.is_writable();
      const bool is_of_the_bus = row.number >= 8600 && row.number < 8800;
      if (is_command || is_of_the_bus || row.number == 108 || row.number >= kBehindWindows) continue;
      const std::size_t size = drive::row_of(row.type).size;
      for (const double value : values_for(row)) {
        const std::uint32_t bits = row.type == drive::DataType::F32
                                       ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                                       : drive::encode(row.type, value).bits;
        const std::uint16_t shown = unit.show(object, row.number, 0);
        const std::uint32_t code = unit.bus.download(shown, 0, bits, static_cast<unsigned>(size));
        Bytes write = request(2, object, row.number, 0);
        write.push_back(static_cast<std::uint8_t>(format_of(row.type)));
        write.push_back(1);
        for (std::size_t i = size; i > 0; --i) write.push_back(static_cast<std::uint8_t>(bits >> 8 * (i - 1)));
        if (size % 2 != 0) write.push_back(0);
        const Bytes answer = unit.records.serve(write);
        EXPECT_EQ(abort_code_of(answer), without_direction(code))
            << int{object} << " p" << row.number << " = " << value << ", answer " << digits_of(answer);
        ++(code == 0 ? written : refused);
      }
    }
  }
  EXPECT_GT(written, 500U);
  EXPECT_GT(refused, 1000U);
}

TEST(Doors, TellTheBusWhatARecordHasWritten) {
  RecordUnit unit;
  ASSERT_EQ(unit.record("01020201 1001 2257 0000 0301 0002"), "01020201");  // p8791

  EXPECT_EQ(unit.upload(0x605D).number(), 2U);
}

TEST(Doors, CarryOutWhatAWriteLeadsToBehindTheAnswer) {
  RecordUnit unit;
  ASSERT_TRUE(unit.device.raise(1, 7900, 0, unit.now));
  unit.passes(20ms);
  ASSERT_EQ(unit.upload(0x1003, 0).number(), 1U);

  EXPECT_EQ(unit.record("01020201 1001 0F8D 0000 0501 0100"), "01020201");  // p3981 acknowledges

  EXPECT_EQ(unit.upload(0x1003, 0).number(), 0U);
}

}  // namespace
}  // namespace profidrive
