#include "farm/link/session.hpp"

#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "can/nats/inbox.hpp"

namespace farm {

namespace {

constexpr std::uint64_t kBeatSubscription = 0;

}  // namespace

Session::Session(axisd::ServiceEvents& events, nats::Connector<Contact>::Make make, std::size_t most_unsent,
                 Listener& listener)
    : events_{events},
      most_unsent_{most_unsent},
      listener_{listener},
      beat_subject_{nats::new_inbox()},
      connector_{std::move(make)},
      on_connector_{watch<&Session::accept>(connector_.descriptor())},
      timer_{events.timer(
          [](sd_event_source*, std::uint64_t, void* self) noexcept {
            static_cast<Session*>(self)->look_after();
            return 0;
          },
          this)} {}

template <Session::Handler kHandler>
axisd::EventSource Session::watch(int descriptor) {
  return events_.watch(
      descriptor, EPOLLIN,
      [](sd_event_source*, int, std::uint32_t events, void* self) noexcept {
        (static_cast<Session*>(self)->*kHandler)(events);
        return 0;
      },
      this);
}

void Session::accept(std::uint32_t) {
  auto made = connector_.take();
  if (const std::string problem = connector_.take_problem(); !problem.empty()) tell_down(problem);
  if (!made) return;
  contact_ = std::move(made);
  is_watched_for_room_ = false;
  defect_.clear();
  beats_ = 0;
  on_socket_ = watch<&Session::serve_socket>(contact_->socket());
  on_arrival_ = watch<&Session::serve_arrivals>(contact_->arrivals().descriptor());
  listener_.on_contact();
  beat_ = subscribe(kBeatSubscription, beat_subject_);
  look_after();
}

/// By beats, not by a clock: a program that was stopped itself has not asked for a sign.
void Session::look_after() {
  if (!contact_) return;
  if (!defect_.empty()) return lose(defect_);
  if (beats_ == kMostBeats) {
    const std::string complaint = contact_->complaint();
    return lose(complaint.empty() ? "no sign of the server within 1 s" : complaint);
  }
  ++beats_;
  publish(beat_subject_, {}, {});
  if (!contact_) return;
  axisd::ServiceEvents::start(timer_, kBeat);
  if (is_up_) listener_.on_tick();
}

void Session::on_beat() {
  if (is_up_) return;
  is_up_ = true;
  is_told_down_ = false;
  listener_.on_up();
}

void Session::serve_socket(std::uint32_t events) {
  if ((events & EPOLLOUT) != 0) write();
  if (contact_ && (events & ~std::uint32_t{EPOLLOUT}) != 0) contact_->read();
  if (!contact_) return;
  if (const std::string why = contact_->why_closed(); !why.empty()) return lose(why);
  write();
}

void Session::serve_arrivals(std::uint32_t) {
  const Contact* const contact = contact_.get();
  is_taking_ = true;
  for (const Arrivals::Arrival& arrival : contact->arrivals().take()) {
    if (contact_.get() != contact) break;
    if (arrival.message) beats_ = 0;
    tell(arrival);
  }
  is_taking_ = false;
  if (contact_) write();
}

void Session::tell(const Arrivals::Arrival& arrival) {
  if (!arrival.message) return listener_.on_end(arrival.subscription);
  if (arrival.subscription == kBeatSubscription) return on_beat();
  listener_.on_message(arrival.subscription, arrival.message.get());
}

bool Session::publish(const std::string& subject, const std::string& reply, std::string_view data) {
  if (!contact_ || !contact_->publish(subject, reply, data, most_unsent_)) return false;
  if (!is_taking_) write();
  return true;
}

/// Without one of its subscriptions a connection would never tell what comes for that: it is given up, not at
/// once, for whoever subscribes is in the middle of something.
nats::Subscription Session::subscribe(std::uint64_t id, const std::string& subject) {
  if (!contact_) return nullptr;
  auto made = contact_->subscribe(id, subject);
  if (!is_taking_) write();
  if (made) return *std::move(made);
  defect_ = fmt::format("cannot subscribe to {}: {}", subject, made.error());
  axisd::ServiceEvents::start(timer_, std::chrono::microseconds{0});
  return nullptr;
}

bool Session::drain(const nats::Subscription& subscription) {
  if (!contact_ || !subscription || !Contact::drain(subscription)) return false;
  if (!is_taking_) write();
  return true;
}

/// A connection that fails here is given up when its socket is looked at.
void Session::write() {
  if (!contact_->wants_to_write()) return;
  contact_->write();
  if (std::exchange(is_watched_for_room_, contact_->wants_to_write()) == contact_->wants_to_write()) return;
  sd_event_source_set_io_events(on_socket_.get(), is_watched_for_room_ ? EPOLLIN | EPOLLOUT : EPOLLIN);
}

void Session::lose(const std::string& why) {
  on_socket_.reset();
  on_arrival_.reset();
  beat_.reset();
  contact_->drop_unsent();
  connector_.again(std::move(contact_));
  is_up_ = false;
  tell_down(why);
}

void Session::tell_down(const std::string& why) {
  if (std::exchange(is_told_down_, true)) return;
  listener_.on_down(why);
}

}  // namespace farm
