#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/axis.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/stored_values.hpp"
#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kAxes = 8;

std::uint16_t at(std::uint16_t object, std::uint16_t offset) noexcept {
  return static_cast<std::uint16_t>(object + offset);
}

/// A drive of CiA 402 says so, and one of several axes names none of them.
void states_its_profile(Context& context) {
  constexpr std::uint16_t kAxisTypes = 0x67FF;
  constexpr std::uint64_t kProfile = 402, kProfileBits = 0xFFFF, kSeveral = 0xFFFF'0000;
  const auto axes = axes_with(context, kStatusword);
  const auto type = axes.empty() ? std::nullopt : context.number(0x1000);
  if (!type) return;
  if ((*type & kProfileBits) != kProfile)
    context.fail(0x1000, 0, "profile 402 in the low word", fmt::format("{:08X}h", *type));
  if (axes.size() > 1 && (*type & kSeveral) != kSeveral)
    context.fail(0x1000, 0, fmt::format("FFFF0192h for a device of {} axes", axes.size()),
                 fmt::format("{:08X}h", *type));
  for (const std::uint16_t offset : axes) {
    if (!context.eds().has(at(kAxisTypes, offset))) continue;
    context.step();
    const auto of_axis = context.number(at(kAxisTypes, offset));
    if (of_axis && (*of_axis & kProfileBits) != kProfile)
      context.fail(at(kAxisTypes, offset), 0, "profile 402 in the low word", fmt::format("{:08X}h", *of_axis));
  }
}

void shows_a_supported_mode(Context& context) {
  for (const std::uint16_t offset : axes_with(context, kSupportedModes)) {
    context.step();
    const auto modes = context.number(at(kSupportedModes, offset));
    const auto shown = context.number(at(kModeDisplay, offset));
    if (!modes || !shown) continue;
    const auto mode = static_cast<std::int8_t>(*shown);
    // Negative modes are those of the manufacturer, 0 is none.
    if (mode > 0 && (mode > 32 || (*modes >> (mode - 1) & 1U) == 0))
      context.fail(at(kModeDisplay, offset), 0, fmt::format("a mode of 6502h, {:08X}h", *modes),
                   fmt::format("mode {}", mode));
  }
}

/// Highest value that CiA 402-2 defines; negative ones are those of the manufacturer.
struct OptionCode {
  std::uint16_t index;
  std::int16_t low, high;
};
constexpr std::array kOptionCodes{OptionCode{0x6007, 0, 3}, OptionCode{0x605A, 0, 8}, OptionCode{0x605B, 0, 1},
                                  OptionCode{0x605C, 0, 1}, OptionCode{0x605D, 1, 4}, OptionCode{0x605E, 0, 4}};

void has_defined_option_codes(Context& context) {
  int tried = 0;
  for (const OptionCode& code : kOptionCodes)
    for (std::uint16_t axis = 0; axis < kAxes; ++axis) {
      const std::uint16_t index = at(code.index, static_cast<std::uint16_t>(axis * kAxisDistance));
      if (!context.eds().has(index)) continue;
      ++tried;
      context.step();
      const auto number = context.number(index);
      const auto value = static_cast<std::int16_t>(number.value_or(0));
      if (number && value >= 0 && (value < code.low || value > code.high))
        context.fail(index, 0, fmt::format("{} to {}, or a negative one", code.low, code.high),
                     fmt::format("{}", value));
    }
  if (tried == 0) context.skip("the EDS has none of 6007h and 605Ah to 605Eh");
}

/// RPDOs and TPDOs 1 to 4 as CiA 402-3 fills them for the first axis, in order.
struct GenericPdo {
  std::uint16_t mapping;
  std::uint16_t second;  ///< object behind controlword or statusword; 0: none
};
constexpr std::array kGenericPdos{
    GenericPdo{0x1600, 0}, GenericPdo{0x1601, 0x6060}, GenericPdo{0x1602, 0x607A}, GenericPdo{0x1603, 0x60FF},
    GenericPdo{0x1A00, 0}, GenericPdo{0x1A01, 0x6061}, GenericPdo{0x1A02, 0x6064}, GenericPdo{0x1A03, 0x606C}};

void has_generic_pdos(Context& context) {
  if (axes_with(context, kStatusword).empty()) return;
  int tried = 0;
  for (const GenericPdo& pdo : kGenericPdos) {
    std::vector<std::uint64_t> objects;
    for (const eds::EntryFacts& entry : context.eds().entries_of(pdo.mapping)) {
      const auto mapped = entry.initial ? entry.initial->at(context.session().node_id()) : std::nullopt;
      if (entry.sub_index != 0 && mapped && mapped->magnitude != 0) objects.push_back(mapped->magnitude >> 16U);
    }
    if (objects.empty()) continue;
    ++tried;
    std::vector<std::uint64_t> wanted{pdo.mapping < 0x1800 ? kControlword : kStatusword};
    if (pdo.second != 0) wanted.push_back(pdo.second);
    if (objects == wanted) continue;
    const auto list = [](const std::vector<std::uint64_t>& numbers) {
      std::string text;
      for (const std::uint64_t number : numbers)
        text += fmt::format("{}{:04X}h", text.empty() ? "" : ", ", number);
      return text;
    };
    context.fail({pdo.mapping, {}}, list(wanted) + " by default", list(objects));
  }
  if (tried == 0) context.skip("the EDS states no default mapping");
}

void boots_without_power(Context& context) {
  constexpr DriveState kNotReady{0x4F, 0x00, "Not ready to switch on"};
  const auto axes = axes_with(context, kStatusword);
  if (axes.empty() || !restart(context)) return;
  for (const std::uint16_t offset : axes) {
    context.step();
    const auto word = context.number(at(kStatusword, offset));
    const bool fault = word && (*word & kFaultBit) != 0;
    if (fault) context.note(fmt::format("{:04X}h: a fault after the boot-up", at(kStatusword, offset)));
    if (word && !fault && !kSwitchOnDisabled.is(*word) && !kNotReady.is(*word))
      context.fail(at(kStatusword, offset), 0, "Switch on disabled, xx40h or xx50h",
                   fmt::format("{:04X}h", *word));
  }
}

constexpr auto row(std::string_view id, std::string_view name, std::string_view clause, Mode mode,
                   void (*run)(Context&)) {
  return Check{.id = id, .name = name, .clause = clause, .group = Group::Drive, .mode = mode, .run = run};
}

constexpr std::array kChecks{
    row("drive.device-type", "The device type is that of CiA 402", "CiA 402-2 1000h", Mode::ReadOnly,
        states_its_profile),
    row("drive.mode-display", "The mode that is shown is one of the supported ones", "CiA 402-2 6502h",
        Mode::ReadOnly, shows_a_supported_mode),
    row("drive.option-codes", "Option codes have defined values", "CiA 402-2 6007h, 605Ah to 605Eh",
        Mode::ReadOnly, has_defined_option_codes),
    row("drive.generic-pdos", "By default PDOs 1 to 4 hold what CiA 402-3 says", "CiA 402-3 1600h, 1A00h",
        Mode::ReadOnly, has_generic_pdos),
    row("drive.boot-state", "A drive boots into Switch on disabled", "CiA 402-2 6041h", Mode::Full,
        boots_without_power),
};

}  // namespace

std::span<const Check> drive_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
