#include "hub/medium.hpp"

#include <algorithm>
#include <chrono>

namespace hub {

namespace {

std::int64_t real_time() noexcept {
  return std::chrono::nanoseconds{std::chrono::system_clock::now().time_since_epoch()}.count();
}

}  // namespace

Medium::Medium(std::uint32_t bit_rate) : bit_rate_{bit_rate} {}

void Medium::attach(Participant& participant) {
  participants_.push_back(&participant);
}

void Medium::detach(Participant& participant) noexcept {
  std::erase(participants_, &participant);
}

bool Medium::send(const Passage& passage, canopen::TimePoint) noexcept {
  deliver(passage);
  return true;
}

canopen::TimePoint Medium::next_deadline() const noexcept {
  return canopen::kNever;
}

void Medium::on_time(canopen::TimePoint) noexcept {}

void Medium::deliver(Passage passage) noexcept {
  passage.time_ns = real_time();
  ++passed_;
  for (Participant* const participant : participants_) participant->receive(passage);
}

}  // namespace hub
