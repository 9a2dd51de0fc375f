#include "injection/language/argument.hpp"

#include "injection/language/error_class.hpp"
#include "injection/language/state.hpp"

namespace injection {
namespace {

constexpr std::span<const std::string_view> kNmtStates = std::span{kStateNames}.first(3);
constexpr auto kDriveStates = std::to_array<std::string_view>(
    {"switch-on-disabled", "ready-to-switch-on", "switched-on", "operation-enabled", "quick-stop-active"});
constexpr std::uint32_t kMost = 0xFFFFFFFF;
constexpr std::uint32_t kLongest = 3'600'000;  ///< ms: an hour

constexpr std::array kRows{
    ArgumentRow{Argument::Code, "code", Form::Hexadecimal, 0, kMost, "SDO abort code, or emergency error code"},
    ArgumentRow{Argument::Object, "object", Form::Hexadecimal, 1, 0xFFFF,
                "index of the object that is transferred"},
    ArgumentRow{Argument::SubIndex, "sub_index", Form::Decimal, 0, 255, "its sub-index"},
    ArgumentRow{Argument::Server, "server", Form::Decimal, 1, 128,
                "SDO server: 1 that of 1200h, 2 that of 1201h, ..."},
    ArgumentRow{Argument::Step, "step", Form::Decimal, 1, kMost,
                "frame of the transfer, counted from 1 with the first request and the first response"},
    ArgumentRow{Argument::Pdo, "pdo", Form::Decimal, 1, 512, "number of the PDO"},
    ArgumentRow{Argument::DelayMs, "delay_ms", Form::Decimal, 1, kLongest, "how late, in ms"},
    ArgumentRow{Argument::PeriodMs, "period_ms", Form::Decimal, 1, kLongest, "time between two frames, in ms"},
    ArgumentRow{Argument::Length, "length", Form::Decimal, 0, 8, "bytes of data of the frame"},
    ArgumentRow{Argument::First, "first", Form::Decimal, 1, 64, "place of a mapped value in the PDO"},
    ArgumentRow{Argument::Second, "second", Form::Decimal, 1, 64, "place of the other value"},
    ArgumentRow{Argument::NmtState, "state", Form::Word, 0, kNmtStates.size() - 1, "NMT state", kNmtStates},
    ArgumentRow{Argument::DriveState, "state", Form::Word, 0, kDriveStates.size() - 1,
                "state of the drive that commands lead to", kDriveStates},
    ArgumentRow{Argument::Bit, "bit", Form::Decimal, 0, 15, "bit of the statusword"},
    ArgumentRow{Argument::Value, "value", Form::Decimal, 0, 1, "value of the bit"},
    ArgumentRow{Argument::Axis, "axis", Form::Decimal, 1, 8, "axis of the unit"},
    ArgumentRow{Argument::NodeId, "node_id", Form::Decimal, 1, 127, "node-ID"},
    ArgumentRow{Argument::Id, "id", Form::Hexadecimal, 0, 0x1FFFFFFF, "identifier of frames"},
    ArgumentRow{Argument::Mask, "mask", Form::Hexadecimal, 0, 0x1FFFFFFF, "bits of the identifier that count"},
    ArgumentRow{Argument::Byte, "byte", Form::Decimal, 0, 7, "byte of the data, the first is 0"},
    ArgumentRow{Argument::Bits, "bits", Form::Hexadecimal, 1, 0xFF, "bits of the byte that are turned over"},
    ArgumentRow{Argument::PeriodUs, "period_us", Form::Decimal, 10, kMost, "time between two frames, in µs"},
    ArgumentRow{Argument::ErrorClass, "class", Form::Word, 0, kErrorClassNames.size() - 1, "what the frame tells",
                kErrorClassNames},
    ArgumentRow{Argument::BitRate, "bit_rate", Form::Decimal, 1000, 1'000'000, "bit rate, in bit/s"},
    ArgumentRow{Argument::Percent, "percent", Form::Decimal, 1, 100, "share of the time of the bus"},
    ArgumentRow{
        Argument::Members, "members", Form::Text, 1, 200,
        "process identifiers, kinds, interfaces or URLs as canhub --status shows them, with commas between"},
};

constexpr bool is_in_order() noexcept {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (static_cast<std::size_t>(kRows[i].argument) != i) return false;
  return kRows.size() == kArguments;
}
static_assert(is_in_order());

}  // namespace

const ArgumentRow& row_of(Argument argument) noexcept {
  return kRows[static_cast<std::size_t>(argument)];
}

std::span<const ArgumentRow> argument_rows() noexcept {
  return kRows;
}

}  // namespace injection
