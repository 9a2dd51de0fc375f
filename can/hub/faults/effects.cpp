#include "can/hub/faults/effects.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include <linux/can/error.h>

#include "injection/kinds/bus_kinds.hpp"
#include "injection/language/error_class.hpp"

namespace hub::faults {

namespace {

using injection::Argument;
using injection::Fault;
using injection::Trigger;

constexpr std::uint32_t kUsualErrorPeriodMs = 100;
constexpr canid_t kFillerIdentifier = CAN_SFF_MASK;

void drop(const Fault&, Fate& fate) noexcept {
  fate.lost = true;
}

void delay(const Fault& fault, Fate& fate) noexcept {
  fate.delay += std::chrono::milliseconds{fault.value_or(Argument::DelayMs, 0)};
}

void duplicate(const Fault&, Fate& fate) noexcept {
  fate.twice = true;
}

void corrupt(const Fault& fault, Fate& fate) noexcept {
  std::uint8_t& byte = fate.heard.data[fault.value_or(Argument::Byte, 0)];
  byte = static_cast<std::uint8_t>(byte ^ fault.value_or(Argument::Bits, 1));
}

bool any_frame(const Fault&, const can_frame&) noexcept {
  return true;
}

bool has_byte(const Fault& fault, const can_frame& frame) noexcept {
  return (frame.can_id & CAN_RTR_FLAG) == 0 && frame.can_dlc > fault.value_or(Argument::Byte, 0);
}

canid_t wire_identifier(std::uint32_t identifier) noexcept {
  return identifier > CAN_SFF_MASK ? identifier | CAN_EFF_FLAG : identifier;
}

std::unique_ptr<Talker> make_babbler(const Fault& fault, Medium& medium, Trigger& trigger) {
  can_frame frame{};
  frame.can_id = wire_identifier(fault.value_or(Argument::Id, 0));
  frame.can_dlc = static_cast<std::uint8_t>(fault.value_or(Argument::Length, CAN_MAX_DLEN));
  if (const auto period = fault.value(Argument::PeriodUs))
    return std::make_unique<PeriodicTalker>(medium, trigger, frame, std::chrono::microseconds{*period});
  return std::make_unique<EagerTalker>(medium, trigger, frame);
}

/// What a SocketCAN driver puts into an error frame.
struct ErrorContent {
  canid_t error_class;
  std::array<std::uint8_t, CAN_ERR_DLC> data;
};

constexpr std::uint8_t kBothWarning = CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_WARNING;
constexpr std::uint8_t kBothPassive = CAN_ERR_CRTL_RX_PASSIVE | CAN_ERR_CRTL_TX_PASSIVE;

/// In the order of injection::kErrorClassNames.
constexpr auto kErrorContents = std::to_array<ErrorContent>({
    {CAN_ERR_TX_TIMEOUT, {}},
    {CAN_ERR_LOSTARB, {CAN_ERR_LOSTARB_UNSPEC}},
    {CAN_ERR_CRTL, {0, CAN_ERR_CRTL_RX_OVERFLOW}},
    {CAN_ERR_CRTL, {0, CAN_ERR_CRTL_ACTIVE}},
    {CAN_ERR_CRTL, {0, kBothWarning}},
    {CAN_ERR_CRTL, {0, kBothPassive}},
    {CAN_ERR_PROT | CAN_ERR_BUSERROR, {0, 0, CAN_ERR_PROT_STUFF, CAN_ERR_PROT_LOC_DATA}},
    {CAN_ERR_TRX, {0, 0, 0, 0, CAN_ERR_TRX_CANH_NO_WIRE}},
    {CAN_ERR_ACK, {}},
    {CAN_ERR_BUSOFF, {}},
    {CAN_ERR_BUSERROR, {}},
    {CAN_ERR_RESTARTED, {}},
});
static_assert(kErrorContents.size() == injection::kErrorClassNames.size());

std::unique_ptr<Talker> make_complainer(const Fault& fault, Medium& medium, Trigger& trigger) {
  const ErrorContent& content = kErrorContents[fault.value_or(Argument::ErrorClass, 0)];
  can_frame frame{};
  frame.can_id = CAN_ERR_FLAG | content.error_class;
  frame.can_dlc = CAN_ERR_DLC;
  for (std::size_t i = 0; i < content.data.size(); ++i) frame.data[i] = content.data[i];
  const std::chrono::milliseconds period{fault.value_or(Argument::PeriodMs, kUsualErrorPeriodMs)};
  return std::make_unique<PeriodicTalker>(medium, trigger, frame, period);
}

std::unique_ptr<Talker> make_filler(const Fault& fault, Medium& medium, Trigger& trigger) {
  can_frame frame{};
  frame.can_id = kFillerIdentifier;
  frame.can_dlc = CAN_MAX_DLEN;
  return std::make_unique<FillingTalker>(medium, trigger, frame, fault.value_or(Argument::Percent, 1));
}

bool never(const Fault&) noexcept {
  return false;
}

bool always(const Fault&) noexcept {
  return true;
}

bool without_period(const Fault& fault) noexcept {
  return !fault.value(Argument::PeriodUs);
}

/// In the order of injection::bus_kinds().
constexpr std::array kTable{
    Effect{"bus.drop", &drop, &any_frame, nullptr, &never},
    Effect{"bus.delay", &delay, &any_frame, nullptr, &never},
    Effect{"bus.duplicate", &duplicate, &any_frame, nullptr, &never},
    Effect{"bus.corrupt", &corrupt, &has_byte, nullptr, &never},
    Effect{"bus.cut", nullptr, nullptr, nullptr, &never},
    Effect{"bus.babble", nullptr, nullptr, &make_babbler, &without_period},
    Effect{"bus.error-frames", nullptr, nullptr, &make_complainer, &never},
    Effect{"bus.bit-rate", nullptr, nullptr, nullptr, &never},
    Effect{"bus.load", nullptr, nullptr, &make_filler, &always},
};
static_assert(std::ranges::equal(kTable, injection::bus_kinds(), {}, &Effect::kind, &injection::Kind::name));

}  // namespace

const Effect& effect_of(const Fault& fault) noexcept {
  return kTable[static_cast<std::size_t>(fault.kind - injection::bus_kinds().data())];
}

}  // namespace hub::faults
