#include "daemon/watch/pdo_watch.hpp"

namespace axisd {
namespace {

constexpr std::size_t kIdentifiers = 0x800;

}  // namespace

bool PdoWatch::begin(canopen::TimePoint now) {
  if (is_on()) return true;
  if (!tap_.add(*this)) return false;
  heard_.resize(kIdentifiers);
  since_ = now;
  return true;
}

void PdoWatch::end() noexcept {
  if (!is_on()) return;
  tap_.remove(*this);
  std::vector<Heard>{}.swap(heard_);
}

void PdoWatch::on_frame(const canopen::Frame& frame, Direction, canopen::TimePoint time) noexcept {
  if (frame.remote || frame.extended || frame.id >= heard_.size()) return;
  Heard& heard = heard_[frame.id];
  ++heard.frames;
  heard.before = heard.last;
  heard.last = time;
  heard.frame = frame;
}

}  // namespace axisd
