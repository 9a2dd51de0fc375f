#include "can/userbus/processor.hpp"

#include <cerrno>

namespace userbus {

namespace {

constexpr pid_t kThisThread = 0;

bool is_one_of_several(int processor, const cpu_set_t& processors) noexcept {
  if (processor < 0 || processor >= CPU_SETSIZE) return false;
  return CPU_ISSET(static_cast<unsigned>(processor), &processors) && CPU_COUNT(&processors) > 1;
}

void begin(Stay& stay, int processor) noexcept {
  if (sched_getaffinity(kThisThread, sizeof stay.before, &stay.before) != 0) return;
  if (!is_one_of_several(processor, stay.before)) return;
  CPU_ZERO(&stay.one);
  CPU_SET(static_cast<unsigned>(processor), &stay.one);
  stay.is_on = sched_setaffinity(kThisThread, sizeof stay.one, &stay.one) == 0;
}

void end(const Stay& stay) noexcept {
  cpu_set_t now;
  if (sched_getaffinity(kThisThread, sizeof now, &now) != 0 || !CPU_EQUAL(&now, &stay.one)) return;
  sched_setaffinity(kThisThread, sizeof stay.before, &stay.before);
}

}  // namespace

void begin_stay(Stay& stay, int processor) noexcept {
  if (stay.is_on) return;
  const int error = errno;
  begin(stay, processor);
  errno = error;
}

void end_stay(Stay& stay) noexcept {
  if (!stay.is_on) return;
  stay.is_on = false;
  const int error = errno;
  end(stay);
  errno = error;
}

}  // namespace userbus
