#include "device/bus/reception.hpp"

#include <algorithm>

#include "device/bus/unit_time.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace device {

void Reception::take_over(const canopen::PdoCycle& grid) noexcept {
  const drive::DriveObject& control_unit = *runner_.unit().object(drive::kControlUnitNumber);
  monitor_.set_cycle(grid);
  monitor_.set_time(control_unit.read(RpdoMonitor::kParameter).value_or(0.0));
}

/// RPDO @p number is about to be stored, and no cycle has taken the values before. If cycles were missed
/// meanwhile, one of them takes those.
void Reception::overwrite(std::uint16_t number) noexcept {
  if (runner_.now() >= runner_.next_deadline() && make_up_cycle()) {
    static_cast<void>(loss_.on_rpdo(number));
  } else if (now() != made_up_at_) {  // more frames than missed cycles: nobody knows which of those they belong to
    lose(number);
  }
}

bool Reception::make_up_cycle() noexcept {
  if (!runner_.make_up_cycle()) return false;
  made_up_at_ = now();
  return true;
}

/// A frame of RPDO @p number has overwritten the one before in the same cycle. A08751 is for asynchronous ones
/// only.
void Reception::lose(std::uint16_t number) noexcept {
  const auto pdos = node_.receive_pdos();
  const auto found = std::ranges::find(pdos, number, &canopen::PdoSettings::number);
  if (found != pdos.end() && found->transmission_type <= canopen::kLastSynchronousType) return;
  ++lost_telegrams_;
  if (!loss_.on_loss(now())) return;
  runner_.tell_time();
  communication_.on_telegram_loss();
  runner_.show_messages_later();
}

void Reception::end_loss() noexcept {
  loss_.clear();
  runner_.tell_time();
  communication_.on_telegram_loss_over();
  runner_.show_messages();
}

void Reception::on_frames_lost() noexcept {
  if (!loss_.on_loss(now())) return;
  communication_.on_telegram_loss();
  runner_.show_messages();
}

void Reception::miss_rpdos() noexcept {
  monitor_.stop();
  runner_.tell_time();
  communication_.on_rpdos_missing();
  runner_.show_messages();
}

}  // namespace device
