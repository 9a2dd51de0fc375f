#include "farm/link/link.hpp"

#include <array>
#include <utility>

#include "farm/link/worker.hpp"

namespace farm {

namespace {

/// In the order of NoReply.
constexpr std::array<std::string_view, 4> kTexts{"no connection to the server", "nobody answers there",
                                                 "no answer in time", "too many requests wait for an answer"};

}  // namespace

std::string_view text_of(NoReply why) noexcept {
  return kTexts[static_cast<std::size_t>(why)];
}

Link::Link(axisd::ServiceEvents& events, const nats::Server& server, const std::string& client, Listener& listener)
    : worker_{std::make_unique<Worker>(events, server, client, listener)} {}

Link::~Link() = default;

bool Link::is_up() const noexcept {
  return worker_->is_up();
}

void Link::publish(std::string_view subject, std::string_view data) {
  worker_->publish(subject, data);
}

void Link::subscribe(const std::string& subject, OnMessage on_message) {
  worker_->subscribe(subject, std::move(on_message));
}

void Link::unsubscribe(const std::string& subject) {
  worker_->unsubscribe(subject);
}

void Link::drain(const std::string& subject) {
  worker_->drain(subject);
}

void Link::request(std::string_view subject, std::string_view data, std::chrono::milliseconds patience,
                   OnReply on_reply) {
  worker_->request(subject, data, patience, std::move(on_reply));
}

void Link::watch(const std::string& bucket, const std::string& pattern, std::function<void(const Entry&)> on_entry,
                 std::function<void()> on_all) {
  worker_->watch(std::make_unique<Watch>(bucket, pattern, std::move(on_entry), std::move(on_all)));
}

void Link::run_job(Job job, std::function<void()> then) {
  worker_->run_job(std::move(job), std::move(then));
}

}  // namespace farm
