#include "libcanopen/pdo/receive_pdos.hpp"

namespace canopen {

ReceivePdos::ReceivePdos(Context& context, std::size_t first_timer)
    : context_{context},
      parameters_{context, Direction::Receive},
      first_timer_{first_timer},
      latches_(parameters_.pdos().size()) {
  parameters_.listen(*this);
  waiting_.reserve(latches_.size());
}

std::size_t ReceivePdos::timers_for(const Dictionary& dictionary) noexcept {
  std::size_t pdos = 0;
  for (std::uint16_t index = 0x1400; index < 0x1600; ++index) pdos += dictionary.contains(index) ? 1U : 0U;
  return pdos;
}

void ReceivePdos::on_timer(std::size_t which) noexcept {
  (void)which, (void)first_timer_;
}

void ReceivePdos::reload() noexcept {
  parameters_.reload();
  forget();
}

void ReceivePdos::forget() noexcept {
  for (const std::uint16_t position : waiting_) latches_[position].waits = false;
  waiting_.clear();
}

void ReceivePdos::on_pdo_changed(std::size_t position) noexcept {
  if (!latches_[position].waits) return;
  latches_[position].waits = false;
  std::erase(waiting_, position);
}

void ReceivePdos::on_frame(std::size_t position, const Frame& frame) noexcept {
  const PdoSettings& pdo = pdos()[position];
  if (frame.length < pdo.plan.length()) {
    ++too_short_;
    return;
  }
  const auto payload = load<std::uint64_t>(frame.data.data());
  if (!pdo.is_synchronous()) {
    apply(pdo, payload);
    return;
  }
  Latch& latch = latches_[position];
  latch.payload = payload;
  if (latch.waits) return;
  latch.waits = true;
  waiting_.push_back(static_cast<std::uint16_t>(position));  // within the capacity reserved by the constructor
}

void ReceivePdos::on_sync() noexcept {
  for (const std::uint16_t position : waiting_) {
    latches_[position].waits = false;
    apply(pdos()[position], latches_[position].payload);
  }
  waiting_.clear();
}

void ReceivePdos::apply(const PdoSettings& pdo, std::uint64_t payload) noexcept {
  pdo.plan.unpack(payload, context_.dictionary.image());
  context_.application.on_rpdo(pdo.number);
}

}  // namespace canopen
