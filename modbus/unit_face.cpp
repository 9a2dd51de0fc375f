#include "modbus/unit_face.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "profidrive/record/record.hpp"

namespace modbus {
namespace {

static_assert(RecordMailbox::kMostBytes == profidrive::record::kMostBytes);

constexpr std::uint16_t kCyclicObjects = 978;  // p0978
constexpr std::uint16_t kConfigurationAlarm = 8555;
constexpr std::uint32_t kNoAxis = 2;  // r2124

}  // namespace

const drive::DriveObject* UnitFace::target() const noexcept {
  const drive::DriveUnit& unit = std::as_const(runner_).unit();
  const double number = unit.control_unit().read(kCyclicObjects).value_or(0.0);
  const drive::DriveObject* const object = unit.object(static_cast<std::uint8_t>(number));
  const bool is_axis = object != nullptr &&
                       (object->kind() == drive::ObjectKind::Servo || object->kind() == drive::ObjectKind::Vector);
  return is_axis ? object : nullptr;
}

void UnitFace::write_mailbox(std::size_t first, std::span<const std::uint16_t> values) noexcept {
  const bool was_pending = mailbox_.is_pending();
  mailbox_.write(first, values);
  if (was_pending || !mailbox_.is_pending()) return;
  activated_ = runner_.now();
  runner_.wake();
}

void UnitFace::show() noexcept {
  const bool wanted = target() == nullptr;
  if (!wanted && !has_alarm_) return;
  has_alarm_ = wanted;
  const std::uint8_t object = drive::kControlUnitNumber;
  if (!wanted) return runner_.unit().withdraw(object, kConfigurationAlarm);
  if (shows_alarm()) return;
  static_cast<void>(runner_.unit().raise(object, kConfigurationAlarm, kNoAxis, drive::Cause::Present));
}

bool UnitFace::shows_alarm() const noexcept {
  return std::ranges::any_of(
      std::as_const(runner_).unit().control_unit().messages().alarms(),
      [](const drive::FaultEntry& alarm) { return alarm.row->number == kConfigurationAlarm; });
}

void UnitFace::on_cycles_over() noexcept {
  if (!mailbox_.is_pending()) return;
  const unit::CycleClock& clock = runner_.clock();
  if (clock.last() - clock.period() < activated_) return;
  std::array<std::uint8_t, RecordMailbox::kMostBytes> response{};
  const std::size_t bytes = profidrive::record::answer(mailbox_.request(), response, runner_.parameter_access());
  mailbox_.finish(std::span{response}.first(std::min(bytes, response.size())));
}

}  // namespace modbus
