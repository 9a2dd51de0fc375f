#include "bench/trunk/load.hpp"

#include <utility>

namespace bench {

Load::Load(hub::Medium& medium, Settings settings, std::function<void()> on_complete)
    : medium_{medium},
      settings_{settings},
      on_complete_{std::move(on_complete)},
      tally_{settings.senders, settings.count} {
  medium_.attach(*this);
}

Load::~Load() {
  medium_.detach(*this);
}

void Load::begin(canopen::TimePoint now) noexcept {
  for (; sent_ < settings_.count; ++sent_) {
    hub::Passage passage;
    passage.frame = numbered(settings_.sender, sent_);
    passage.sender = this;
    if (!medium_.send(passage, now)) return;
  }
}

void Load::receive(const hub::Passage& passage) noexcept {
  if (tally_.is_complete()) return;
  tally_.add(passage.frame, medium_.now());
  if (tally_.is_complete()) on_complete_();
}

}  // namespace bench
