#include "can/hub/server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <system_error>
#include <utility>

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "can/hub/loop/clock.hpp"
#include "can/hub/member/broadcast_member.hpp"
#include "can/hub/member/raw_member.hpp"
#include "can/userbus/trust.hpp"

namespace hub {

using canopen::TimePoint;

namespace {

using namespace std::chrono_literals;

/// How long a hub without members goes on.
constexpr canopen::Duration kPatience = 1s;
/// Without descriptors or memory for another member: when to try again.
constexpr canopen::Duration kPause = 100ms;
/// Descriptors that members leave to the rest of the hub: requests bring some, and so do other clients.
constexpr std::size_t kReserved = 128;
/// New members of one turn, so that the others are not kept waiting.
constexpr int kMostAtOnce = 16;

/// Members that the limit of descriptors has room for.
std::size_t most_members() noexcept {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return kReserved;
  const std::size_t descriptors = limit.rlim_cur;
  return descriptors - std::min(descriptors / 2, kReserved);
}

/// Looks at the clock only if there is a deadline.
bool has_passed(TimePoint deadline) noexcept {
  return deadline != canopen::kNever && deadline <= monotonic_now();
}

}  // namespace

/// Tells a source what its descriptor polls.
class Server::SourceWatch final : public Watch {
 public:
  explicit SourceWatch(Source& source) : source_{&source}, descriptor_{source.descriptor()} {}

  void on_events(std::uint32_t) noexcept override { source_->on_readable(monotonic_now()); }

  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  [[nodiscard]] bool is_for(const Source* source) const noexcept { return source_ == source; }

 private:
  Source* source_;
  int descriptor_;
};

Server::Server(int listener, Settings settings)
    : core_{settings.bit_rate, settings.time},
      timer_{core_.poll},
      listener_{listener},
      settings_{std::move(settings)},
      most_members_{most_members()},
      listen_again_{canopen::kNever},
      end_{settings_.on_demand ? monotonic_now() + kPatience : canopen::kNever} {
  if (settings_.time.mode != userbus::TimeMode::Real) time_.emplace(core_, settings_.turns);
  if (!core_.poll.add(listener_, EPOLLIN, *this))
    throw std::system_error{errno, std::generic_category(), "cannot watch the bus's socket"};
}

/// Members leave the time of the bus, which ends first.
Server::~Server() {
  core_.gathering.clear();
  core_.members.clear();
}

void Server::add(Source& source) {
  auto watch = std::make_unique<SourceWatch>(source);
  core_.sources.push_back(&source);
  watches_.push_back(std::move(watch));
  if (core_.poll.add(source.descriptor(), EPOLLIN, *watches_.back())) return;
  const int error = errno;
  remove(source);
  throw std::system_error{error, std::generic_category(), "cannot watch a bridge"};
}

void Server::remove(Source& source) noexcept {
  const auto same = [&source](const auto& watch) { return watch->is_for(&source); };
  const auto watch = std::ranges::find_if(watches_, same);
  if (watch == watches_.end()) return;
  core_.poll.remove((*watch)->descriptor(), **watch);
  watches_.erase(watch);
  std::erase(core_.sources, &source);
}

void Server::set_link(bool up) noexcept {
  if (up)
    for (const auto& member : core_.members) member->drain();
  core_.medium.set_up(up);
  core_.link_page.set_up(up);
  for (const auto& member : core_.members) member->tell_link(up);
}

void Server::run() noexcept {
  while (!stopped_) {
    wait();
    if (has_passed(next_machine_deadline())) on_machine_time(monotonic_now());
    if (core_.clock.is_told())
      goes_on_ = time_->go_on(*this);
    else if (is_event_due())
      have_events(core_.clock.now());
    core_.hand_over();
    if (core_.anyone_departed) {
      sweep(monotonic_now());
      goes_on_ = core_.clock.is_told();  // it may have waited for one of them
    }
    end_if_lonely();
  }
}

/// Until something has happened to a descriptor, or a deadline has come.
void Server::wait() noexcept {
  TimePoint next = next_machine_deadline();
  if (!core_.clock.is_told()) next = std::min(next, core_.clock.machine_time(next_event()));
  const bool is_due = goes_on_ || has_passed(next);
  if (!is_due) timer_.wake_at(next);
  core_.poll.turn(is_due);
}

void Server::on_events(std::uint32_t) noexcept {
  accept_members(monotonic_now());
}

void Server::accept_members(TimePoint now) noexcept {
  for (int i = 0; i < kMostAtOnce; ++i) {
    if (core_.members.size() >= most_members_) return pause_listening(now);
    sockaddr_un address{};
    socklen_t length = sizeof address;
    os::Descriptor socket{
        accept4(listener_, reinterpret_cast<sockaddr*>(&address), &length, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (!socket && (errno == ECONNABORTED || errno == EINTR)) continue;
    if (!socket && errno != EAGAIN) pause_listening(now);
    if (!socket) return;
    userbus::Name name{};
    if (!userbus::is_trusted_peer(socket.get())) continue;
    if (userbus::read_name(address, length, name)) admit(std::move(socket), name.kind);
  }
}

void Server::admit(os::Descriptor socket, userbus::Kind kind) noexcept {
  try {
    timed_.reserve(timed_.size() + 1);
    core_.members.reserve(core_.members.size() + 1);
    auto member = make_member(std::move(socket), kind);
    if (!member || !member->begin()) return;
    if (kind == userbus::Kind::BroadcastManager) timed_.push_back(member.get());
    core_.members.push_back(std::move(member));
  } catch (const std::exception&) {
    return;  // no memory: the program is told by the end of its connection
  }
}

std::unique_ptr<Member> Server::make_member(os::Descriptor socket, userbus::Kind kind) {
  if (kind == userbus::Kind::Raw || kind == userbus::Kind::Port)
    return std::make_unique<RawMember>(core_, std::move(socket), kind);
  if (kind == userbus::Kind::BroadcastManager) return std::make_unique<BroadcastMember>(core_, std::move(socket));
  if (kind == userbus::Kind::Clock && time_) return time_->make_member(std::move(socket));
  if (kind == userbus::Kind::Clock) return std::make_unique<ClockMember>(core_, std::move(socket), nullptr);
  return nullptr;
}

/// A listening socket that polls readable and cannot be accepted from would keep the loop busy.
void Server::pause_listening(TimePoint now) noexcept {
  core_.poll.remove(listener_, *this);
  listen_again_ = now + kPause;
}

TimePoint Server::next_event() const noexcept {
  TimePoint next = core_.medium.next_deadline();
  for (const Member* const member : timed_) next = std::min(next, member->next_deadline());
  for (const Source* const source : core_.sources) next = std::min(next, source->next_deadline());
  return next;
}

/// Looks at the clock only if there is an event.
bool Server::is_event_due() const noexcept {
  const TimePoint next = next_event();
  return next != canopen::kNever && next <= core_.clock.now();
}

void Server::have_events(TimePoint now) noexcept {
  if (core_.medium.next_deadline() <= now) core_.medium.on_time(now);
  for (Member* const member : timed_)
    if (member->next_deadline() <= now) member->on_time(now);
  for (std::size_t i = 0; i < core_.sources.size();) {
    Source& source = *core_.sources[i++];  // by number, since a source may take itself out
    if (source.next_deadline() <= now) source.on_time(now);
  }
}

TimePoint Server::next_machine_deadline() const noexcept {
  const TimePoint next = std::min(listen_again_, end_);
  return time_ ? std::min(next, time_->next_machine_deadline()) : next;
}

void Server::on_machine_time(TimePoint now) noexcept {
  if (time_) time_->on_machine_time(now);
  if (listen_again_ > now) return;
  listen_again_ = canopen::kNever;
  if (!core_.poll.add(listener_, EPOLLIN, *this)) listen_again_ = now + kPause;
}

void Server::sweep(TimePoint now) noexcept {
  const auto departed = [](const auto& member) { return member->departed(); };
  std::erase_if(timed_, [](const Member* member) { return member->departed(); });
  std::erase_if(core_.members, departed);
  core_.anyone_departed = false;
  if (listen_again_ != canopen::kNever) listen_again_ = now;
}

void Server::end_if_lonely() noexcept {
  if (!settings_.on_demand) return;
  if (!core_.members.empty()) {
    end_ = canopen::kNever;
    return;
  }
  const TimePoint now = monotonic_now();
  if (end_ == canopen::kNever) end_ = now + kPatience;
  if (end_ > now) return;
  accept_members(now);  // whoever came this very moment is served still
  stopped_ = core_.members.empty();
}

}  // namespace hub
