#include "can/hub/bridge.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/epoll.h>

#include "can/port/wire.hpp"

namespace hub {

namespace {

/// Frames that are taken from the other bus before the members have their turn.
constexpr int kBatch = 64;

/// By bus::LinkState.
constexpr std::array<std::string_view, 3> kLinkNames{"up", "down", "gone"};

}  // namespace

Bridge::Bridge(Medium& medium, bus::Connection connection, std::string name, Notice notice)
    : medium_{medium},
      connection_{std::move(connection)},
      queue_{*connection_.port, kQueue, 0},
      notices_{std::move(name), std::move(notice)} {
  if (!ready_.add(connection_.port->descriptor(), EPOLLIN) || !ready_.add(connection_.link->descriptor(), EPOLLIN))
    throw std::system_error{errno, std::generic_category(), notices_.name() + ": cannot be watched"};
  connection_.port->carry_marks();
  medium_.attach(*this);
}

Bridge::~Bridge() {
  medium_.detach(*this);
}

void Bridge::on_readable(canopen::TimePoint now) noexcept {
  queue_.retry(now);
  follow_link(now);
  read_frames(now);
}

void Bridge::follow_link(canopen::TimePoint now) noexcept {
  const auto state = connection_.link->read();
  if (!state) return;
  notices_.tell(kLinkNames[static_cast<std::size_t>(*state)], now);
  if (*state != bus::LinkState::Up)
    queue_.discard();
  else if (!connection_.port->reopen())
    notices_.tell("cannot be opened again", now);
}

void Bridge::read_frames(canopen::TimePoint now) noexcept {
  canopen::Frame frame;
  for (int i = 0; i < kBatch && !refused_; ++i) {
    const bus::Received received = connection_.port->receive(frame);
    switch (received.kind) {
      case bus::Received::Frame:
        put_on_medium(frame, now);
        break;
      case bus::Received::Error:
        notices_.tell(bus::name_of(received.state), now);
        break;
      case bus::Received::Down:  // what follows from it is the link's to say
        queue_.discard();
        return;
      case bus::Received::Nothing:
        return;
    }
  }
}

void Bridge::put_on_medium(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  const bus::Mark mark = connection_.port->mark();
  if (!medium_.is_new(mark)) {
    if (returned_++ == 0) notices_.tell("frames come back: bridges make a ring; each frame passes once", now);
    return;
  }
  Passage passage;
  passage.mark = mark;
  passage.frame = bus::to_wire(frame);
  passage.sender = this;
  passage.local = false;
  ++brought_;
  if (medium_.send(passage, now)) return;
  refused_ = passage;
  ready_.remove(connection_.port->descriptor());
}

void Bridge::on_room() noexcept {
  if (!refused_ || !medium_.send(*refused_, medium_.now())) return;
  refused_.reset();
  if (!ready_.add(connection_.port->descriptor(), EPOLLIN))
    notices_.tell("cannot be watched any more", medium_.now());
}

void Bridge::receive(const Passage& passage) noexcept {
  if (passage.sender == this || (passage.frame.can_id & CAN_ERR_FLAG) != 0) return;
  queue_.retry(medium_.now());
  queue_.send_marked(bus::from_wire(passage.frame), passage.mark);
}

Identity Bridge::identity() const noexcept {
  Identity who;
  notices_.name().copy(who.name.data(), who.name.size() - 1);
  return who;
}

bool Bridge::statistics(userbus::MemberStatistics& row) const noexcept {
  row = {};
  notices_.name().copy(row.name, sizeof row.name - 1);
  const bus::TransmitQueue::Counters& counters = queue_.counters();
  row.sent = brought_;
  row.received = counters.sent;
  row.refused = returned_;
  row.dropped = counters.dropped + connection_.port->dropped();
  return true;
}

void Bridge::on_time(canopen::TimePoint now) noexcept {
  queue_.retry(now);
  notices_.on_time(now);
}

}  // namespace hub
