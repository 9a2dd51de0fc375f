#include "drive/values/checks.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "drive/base/function_modules.hpp"
#include "drive/identification/identification.hpp"
#include "drive/object/drive_object.hpp"
#include "drive/speed_control/speed_control.hpp"
#include "drive/values/factory_values.hpp"

namespace drive::check {
namespace {

std::optional<Refusal> refuse_unless(bool fine, Refusal reason) noexcept {
  return fine ? std::nullopt : std::optional{reason};
}

bool is_set(const DriveObject& object, std::uint16_t number, std::size_t index) noexcept {
  return object.read(number, index).value_or(0.0) > 0.0;
}

constexpr std::uint32_t kInvalid = 0x80000000;
constexpr std::uint32_t kNoRemoteFrame = 0x40000000;

/// A COB-ID of a PDO whose bits @p free have no meaning for the identifier.
bool is_pdo_cob_id(std::uint32_t value, std::uint32_t free) noexcept {
  constexpr std::uint32_t kHighest = 0x6DF;
  const std::uint32_t identifier = value & ~free;
  return (value & kInvalid) != 0 || (identifier >= 1 && identifier <= kHighest);
}

bool is_transmission_type(std::uint32_t type) noexcept {
  return type <= 0xF0 || type == 0xFE || type == 0xFF;
}

template <std::size_t Count>
std::optional<Refusal> one_of(const std::array<int, Count>& values, double value) noexcept {
  const bool listed = std::find(values.begin(), values.end(), static_cast<int>(value)) != values.end();
  return refuse_unless(listed, RefusalReason::IllegalValue);
}

constexpr std::array kDriveFilters{0, 1, 2, 3, 4, 5, 15, 17, 25, 30, 95};
constexpr std::array kDeviceFilters{0, 1, 2, 3, 4, 29, 30};
constexpr std::array kClockMethods{0, 2, 4};
constexpr std::array kStartStates{4, 5, 127};
constexpr std::array kRestartModes{0, 1, 4, 6, 14, 16, 26};
constexpr std::array kLinkNodes{8, 12, 16, 64};
constexpr std::array kBoardFirmwares{1, 2, 3, 4, 5, 99};
constexpr std::array kStateCommands{4, 5, 127, 128, 129};
constexpr std::array kServoMeasurements{-3, -1, 0, 1};  // p1910 and p1960
constexpr std::array kVectorStandstill{-3, -1, 0, 1, 2};
constexpr std::array kVectorRotating{-3, -1, 0, 1, 2, 3, 4};

/// A block of an axis; nullptr if @p object is none.
template <class Block>
const Block* block_of(const DriveObject& object) noexcept {
  return static_cast<const Block*>(object.block(kBlock<Block>));
}

/// -3 where nothing was found.
std::optional<Refusal> nothing_to_take(double value, bool found) noexcept {
  return refuse_unless(static_cast<int>(value) != selection::kTakeOver || found, Refusal::NotNow);
}

}  // namespace

std::optional<Refusal> zero_only(const DriveObject&, std::size_t, double value) noexcept {
  return refuse_unless(!(value > 0.0), Refusal::OnlyZero);
}

std::optional<Refusal> standstill_selection(const DriveObject& object, std::size_t, double value) noexcept {
  const bool vector = object.kind() == ObjectKind::Vector;
  const bool magnetises = object.context().axis.machine.type == motor::MachineType::Induction;
  const bool of_the_curve = static_cast<int>(value) == selection::kMeasureCurve && magnetises;
  const auto reason = vector ? one_of(kVectorStandstill, value) : one_of(kServoMeasurements, value);
  if (reason && !of_the_curve) return reason;
  const auto* const identification = block_of<Identification>(object);
  if (identification == nullptr) return Refusal::NotNow;
  return nothing_to_take(value, identification->results().standstill.has_value());
}

std::optional<Refusal> rotating_selection(const DriveObject& object, std::size_t, double value) noexcept {
  const bool vector = object.kind() == ObjectKind::Vector;
  if (const auto reason = vector ? one_of(kVectorRotating, value) : one_of(kServoMeasurements, value))
    return reason;
  const auto* const identification = block_of<Identification>(object);
  const auto* const control = block_of<SpeedControl>(object);
  if (identification == nullptr || control == nullptr) return Refusal::NotNow;
  const int choice = static_cast<int>(value);
  const bool measures = choice != selection::kNone && choice != selection::kTakeOver;
  if (measures && !can_rotate(choice, object.kind(), control->settings.control_mode)) return Refusal::NotNow;
  return nothing_to_take(value, identification->results().rotating.has_value());
}

std::optional<Refusal> not_zero(const DriveObject&, std::size_t, double value) noexcept {
  return refuse_unless(value > 0.0, Refusal::IllegalValue);
}

std::optional<Refusal> drive_filter(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kDriveFilters, value);
}

std::optional<Refusal> device_filter(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kDeviceFilters, value);
}

std::optional<Refusal> restart_mode(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kRestartModes, value);
}

std::optional<Refusal> link_nodes(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kLinkNodes, value);
}

std::optional<Refusal> board_firmware(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kBoardFirmwares, value);
}

std::optional<Refusal> reaction(const DriveObject&, std::size_t, double value) noexcept {
  constexpr int kReserved = 4;
  return refuse_unless(static_cast<int>(value) != kReserved, Refusal::IllegalValue);
}

std::optional<Refusal> heartbeat_off(const DriveObject& object, std::size_t, double value) noexcept {
  return refuse_unless(!(value > 0.0) || !is_set(object, 8606, 0), Refusal::NotNow);
}

std::optional<Refusal> guarding_off(const DriveObject& object, std::size_t, double value) noexcept {
  const bool guarded = is_set(object, 8604, 0) && is_set(object, 8604, 1);
  return refuse_unless(!(value > 0.0) || !guarded, Refusal::NotNow);
}

std::optional<Refusal> acknowledge_only(const DriveObject&, std::size_t index, double value) noexcept {
  if (index != 0) return Refusal::ReadOnly;
  return refuse_unless(!(value > 0.0), Refusal::OnlyZero);
}

std::optional<Refusal> address_switch_off(const DriveObject& object, std::size_t, double) noexcept {
  const ObjectContext& context = object.context();
  return refuse_unless(context.node_id == 0 || context.address_switch_off, Refusal::Deactivated);
}

std::optional<Refusal> server_cob_id(const DriveObject&, std::size_t index, double value) noexcept {
  constexpr std::array<std::uint32_t, 2> kFirst{0x601, 0x581};
  constexpr std::uint32_t kCount = 0x7F;
  const auto cob_id = static_cast<std::uint32_t>(value);
  const bool valid = cob_id >= kFirst[index] && cob_id < kFirst[index] + kCount;
  return refuse_unless((cob_id & kInvalid) != 0 || valid, Refusal::IllegalValue);
}

std::optional<Refusal> function_modules(const DriveObject& object, std::size_t index, double value) noexcept {
  const ObjectContext& context = object.context();
  const std::size_t first_axis = first_axis_number(context.has_infeed) - std::size_t{kControlUnitNumber};
  const bool of_axis = index >= first_axis && index < first_axis + context.axis_count;
  const double factory = factory::object_modules(context, index);
  if (!of_axis) return refuse_unless(!(value < factory || value > factory), Refusal::IllegalValue);
  const ObjectKind kind = context.axes[index - first_axis];
  const auto wanted = static_cast<function_module::Set>(value);
  const function_module::Set configured = context.modules[index - first_axis] & function_module::kPositioning;
  const function_module::Set possible = function_module::possible(kind) | configured;
  const function_module::Set always = function_module::always(kind);
  return refuse_unless((wanted & ~possible) == 0 && (wanted & always) == always, Refusal::IllegalValue);
}

std::optional<Refusal> object_window(const DriveObject&, std::size_t index, double value) noexcept {
  constexpr std::array kLast{65535.0, 3.0, 5.0};
  return refuse_unless(value <= kLast[index], Refusal::IllegalValue);
}

std::optional<Refusal> clock_time(const DriveObject&, std::size_t index, double value) noexcept {
  constexpr double kMostDays = 65535.0;
  return refuse_unless(index == 0 || value <= kMostDays, Refusal::AboveMaximum);
}

std::optional<Refusal> clock_method(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kClockMethods, value);
}

std::optional<Refusal> start_state(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kStartStates, value);
}

std::optional<Refusal> state_command(const DriveObject&, std::size_t, double value) noexcept {
  return one_of(kStateCommands, value);
}

std::optional<Refusal> receive_pdo(const DriveObject&, std::size_t index, double value) noexcept {
  const auto number = static_cast<std::uint32_t>(value);
  return refuse_unless(index == 0 ? is_pdo_cob_id(number, 0) : is_transmission_type(number),
                       Refusal::IllegalValue);
}

std::optional<Refusal> transmit_pdo(const DriveObject&, std::size_t index, double value) noexcept {
  constexpr std::size_t kReserved = 3;
  const auto number = static_cast<std::uint32_t>(value);
  if (index == 0) return refuse_unless(is_pdo_cob_id(number, kNoRemoteFrame), Refusal::IllegalValue);
  if (index == 1) return refuse_unless(is_transmission_type(number), Refusal::IllegalValue);
  return refuse_unless(number <= (index == kReserved ? 0xFFU : 0xFFFFU), Refusal::AboveMaximum);
}

}  // namespace drive::check
