#include "farm/link/worker.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>

#include "can/nats/inbox.hpp"
#include "can/nats/message.hpp"
#include "os/clock.hpp"

namespace farm {

namespace {

constexpr std::uint64_t kInbox = 1;

std::string_view view_of(const char* text) noexcept {
  return text != nullptr ? text : "";
}

}  // namespace

Link::Worker::Worker(axisd::ServiceEvents& events, const nats::Server& server, const std::string& client,
                     Link::Listener& listener)
    : listener_{listener},
      inbox_{nats::new_inbox()},
      last_id_{kInbox},
      request_timer_{events.timer(
          [](sd_event_source*, std::uint64_t, void* self) noexcept {
            static_cast<Worker*>(self)->advance_requests();
            return 0;
          },
          this)},
      jobs_{server, client},
      on_job_{events.watch(
          jobs_.descriptor(), EPOLLIN,
          [](sd_event_source*, int, std::uint32_t, void* self) noexcept {
            static_cast<Worker*>(self)->jobs_.serve();
            return 0;
          },
          this)},
      session_{events,
               [this, server, client](std::chrono::milliseconds patience) {
                 jobs_.drop_connection();
                 return Contact::make(server, client, patience);
               },
               kMostUnsent, *this} {}

/// Who is told of a job may ask for more, of a session that is still there.
Link::Worker::~Worker() {
  jobs_.end();
  inbox_subscription_.reset();
  subscriptions_.clear();
  drained_.clear();
  for (Watched& watched : watches_) watched.subscription.reset();
  requests_.end(NoReply::Down);
}

void Link::Worker::publish(std::string_view subject, std::string_view data) {
  if (is_up()) session_.publish(std::string{subject}, {}, data);
}

void Link::Worker::subscribe(const std::string& subject, OnMessage on_message) {
  unsubscribe(subject);
  const std::uint64_t id = ++last_id_;
  subscriptions_[id] = {subject, std::make_shared<const OnMessage>(std::move(on_message)),
                        session_.subscribe(id, subject)};
}

void Link::Worker::unsubscribe(const std::string& subject) {
  std::erase_if(subscriptions_, [&subject](const auto& each) { return each.second.subject == subject; });
}

/// What was sent before is on its way here, or in the library.
void Link::Worker::drain(const std::string& subject) {
  const auto found =
      std::ranges::find_if(subscriptions_, [&](const auto& each) { return each.second.subject == subject; });
  if (found == subscriptions_.end()) return;
  auto ended = subscriptions_.extract(found);
  if (session_.drain(ended.mapped().subscription)) drained_.insert(std::move(ended));
}

void Link::Worker::request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
                           OnReply on_reply) {
  if (!is_up()) return on_reply(tl::unexpected{NoReply::Down});
  const auto number = requests_.add(os::monotonic_time() + patience, on_reply);
  if (!number) return on_reply(tl::unexpected{NoReply::TooMuch});
  const std::string reply = fmt::format("{}.{}", inbox_, *number);
  if (!session_.publish(std::string{subject}, reply, data))
    return requests_.answer(*number, tl::unexpected{NoReply::TooMuch});
  advance_requests();
}

/// Tells those whose time is over, and comes back when that of the next one is.
void Link::Worker::advance_requests() {
  const auto now = os::monotonic_time();
  requests_.advance(now);
  const auto due = requests_.due();
  if (!due) return;
  const auto delay = std::chrono::ceil<std::chrono::microseconds>(*due - now);
  axisd::ServiceEvents::start(request_timer_, std::max(delay, std::chrono::microseconds{0}));
}

void Link::Worker::run_job(Job job, std::function<void()> then) {
  jobs_.run(std::move(job), std::move(then));
}

void Link::Worker::on_contact() {
  inbox_subscription_ = session_.subscribe(kInbox, inbox_ + ".*");
  for (auto& [id, subscribed] : subscriptions_)
    subscribed.subscription = session_.subscribe(id, subscribed.subject);
}

void Link::Worker::on_up() {
  jobs_.set_up(true);
  listener_.on_up();
  for (Watched& watched : watches_) begin(watched);
}

void Link::Worker::on_down(const std::string& why) {
  jobs_.set_up(false);
  inbox_subscription_.reset();
  for (auto& [id, subscribed] : subscriptions_) subscribed.subscription.reset();
  drained_.clear();
  requests_.end(NoReply::Down);
  listener_.on_down(why);
}

void Link::Worker::on_message(std::uint64_t id, natsMsg* message) {
  if (id == kInbox) return take_answer(message);
  if (Watch* const watch = watch_of(id)) return watch->on_message(message);
  const auto found = subscriptions_.find(id);
  const auto drained = drained_.find(id);
  if (found == subscriptions_.end() && drained == drained_.end()) return;
  const auto on_message =  // lives on if it unsubscribes
      (found != subscriptions_.end() ? found : drained)->second.on_message;
  (*on_message)({natsMsg_GetSubject(message), view_of(natsMsg_GetReply(message)), nats::data_of(message)});
}

/// The last token of the subject is the number of the request.
void Link::Worker::take_answer(natsMsg* message) {
  const std::string_view subject = natsMsg_GetSubject(message);
  const std::string_view token = subject.substr(subject.rfind('.') + 1);
  std::uint64_t number = 0;
  std::from_chars(token.data(), token.data() + token.size(), number);
  if (natsMsg_IsNoResponders(message)) return requests_.answer(number, tl::unexpected{NoReply::Nobody});
  requests_.answer(number, std::string{nats::data_of(message)});
}

void Link::Worker::on_tick() {
  for (Watched& watched : watches_) {
    watched.watch->on_tick();
    if (watched.watch->is_lost()) begin(watched);
  }
}

void Link::Worker::watch(std::unique_ptr<Watch> watch) {
  watches_.push_back({std::move(watch), 0, nullptr});
  if (is_up()) begin(watches_.back());
}

Watch* Link::Worker::watch_of(std::uint64_t id) const noexcept {
  const auto found = std::ranges::find(watches_, id, &Watched::id);
  return found != watches_.end() ? found->watch.get() : nullptr;
}

/// The bucket first, for which the server is waited for, then the consumer. Messages of another beginning have
/// another number.
void Link::Worker::begin(Watched& watched) {
  watched.watch->begin();
  watched.id = ++last_id_;
  watched.subscription.reset();
  const auto is_there = std::make_shared<bool>(false);
  run_job([bucket = watched.watch->bucket(), is_there](
              Storage* storage) { *is_there = storage != nullptr && storage->keys.make(bucket).has_value(); },
          [this, &watched, id = watched.id, is_there] {
            if (watched.id != id) return;
            if (*is_there)
              ask_for(watched);
            else
              watched.watch->lose();
          });
}

void Link::Worker::ask_for(Watched& watched) {
  const std::string inbox = nats::new_inbox();
  watched.subscription = session_.subscribe(watched.id, inbox);
  request(watched.watch->subject(), watched.watch->body(inbox), StorageConnection::kPatience,
          [&watched, id = watched.id](const Reply& reply) {
            if (watched.id != id) return;
            if (reply)
              watched.watch->on_made(*reply);
            else
              watched.watch->lose();
          });
}

}  // namespace farm
