#include "cia402/drive/error_code.hpp"

#include <algorithm>
#include <array>

namespace cia402 {
namespace {

/// Bits of 1001h (CiA 301, object 1001h).
enum : std::uint8_t { kGeneric = 0x01, kCurrent = 0x02, kVoltage = 0x04, kTemperature = 0x08, kProfile = 0x20 };

/// Messages `first` to `last` of the drive.
struct Row {
  std::uint16_t first, last;
  ErrorCode error;
};
// clang-format off
constexpr std::array kRows{
    Row{7011, 7016,   {0x4310, kGeneric | kTemperature}},  // motor temperature
    Row{7403, 7403,   {0x3220, kGeneric | kVoltage}},
    Row{7404, 7404,   {0x3210, kGeneric | kVoltage}},
    Row{7410, 7410,   {0x2310, kGeneric | kCurrent}},
    Row{7412, 7412,   {0x7305, kGeneric | kProfile}},      // commutation, by the encoder
    Row{7575, 7599,   {0x7305, kGeneric | kProfile}},
    Row{7801, 7801,   {0x2310, kGeneric | kCurrent}},
    Row{7802, 7802,   {0x3220, kGeneric | kVoltage}},
    Row{7805, 7805,   {0x2312, kGeneric | kCurrent}},
    Row{7840, 7841,   {0x3220, kGeneric | kVoltage}},
    Row{7850, 7862,   {0x9000, kGeneric}},                 // external
    Row{7900, 7900,   {0x7121, kGeneric | kProfile}},
    Row{7901, 7901,   {0x8400, kGeneric | kProfile}},
    Row{7902, 7902,   {0x7121, kGeneric | kProfile}},      // stalled
    Row{7903, 7903,   {0x8400, kGeneric | kProfile}},
    Row{7910, 7910,   {0x4310, kGeneric | kTemperature}},
    Row{30001, 30001, {0x2310, kGeneric | kCurrent}},
    Row{30002, 30002, {0x3210, kGeneric | kVoltage}},
    Row{30003, 30003, {0x3220, kGeneric | kVoltage}},
    Row{30004, 30004, {0x4210, kGeneric | kTemperature}},
    Row{30005, 30005, {0x2312, kGeneric | kCurrent}},
    Row{30011, 30011, {0x3130, kGeneric | kVoltage}},      // phase of the line
    Row{30015, 30015, {0x2340, kGeneric | kCurrent}},      // phase of the motor
    Row{30016, 30016, {0x3220, kGeneric | kVoltage}},
    Row{30017, 30017, {0x2310, kGeneric | kCurrent}},
    Row{30021, 30022, {0x2340, kGeneric | kCurrent}},      // earth fault, short circuit
    Row{30024, 30025, {0x4210, kGeneric | kTemperature}},
    Row{30027, 30027, {0x3220, kGeneric | kVoltage}},
    Row{30035, 30036, {0x4210, kGeneric | kTemperature}},
    Row{30040, 30040, {0x5112, kGeneric}},                 // 24 V
    Row{30502, 30502, {0x3210, kGeneric | kVoltage}},
    Row{31100, 31150, {0x7305, kGeneric | kProfile}},
};
// clang-format on
static_assert(std::ranges::is_sorted(kRows, {}, &Row::first));

constexpr ErrorCode kOther{0x1000, kGeneric};

}  // namespace

ErrorCode error_code_of(std::uint16_t number) noexcept {
  const auto row = std::ranges::upper_bound(kRows, number, {}, &Row::first);
  if (row == kRows.begin() || number > std::prev(row)->last) return kOther;
  return std::prev(row)->error;
}

}  // namespace cia402
