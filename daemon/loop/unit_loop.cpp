#include "daemon/loop/unit_loop.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include <sys/epoll.h>
#include <sys/eventfd.h>

#include "os/clock.hpp"

namespace axisd {
namespace {

void watch(int epoll, int descriptor, void* who) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.ptr = who;
  if (::epoll_ctl(epoll, EPOLL_CTL_ADD, descriptor, &event) != 0)
    throw std::system_error{errno, std::generic_category(), "epoll_ctl"};
}

}  // namespace

UnitLoop::UnitLoop(const Log& log, bus::TimeShare* time)
    : log_{log}, loop_{*this, &joint_, time}, ended_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)} {
  if (!ended_) throw std::system_error{errno, std::generic_category(), "eventfd"};
  watch(rare_.descriptor(), mailbox_.descriptor(), nullptr);
  loop_.watch(rare_.descriptor());
}

void UnitLoop::add(Instance& instance) {
  instances_.push_back(&instance);
  loop_.add(instance.bus());
  for (const Instance::RareSource& source : instance.rare_sources()) {
    watched_.push_back(source);
    watch(rare_.descriptor(), source.descriptor, &watched_.back());
  }
}

void UnitLoop::remove(Instance& instance) noexcept {
  loop_.remove(instance.bus());
  for (const Instance::RareSource& source : instance.rare_sources()) rare_.remove(source.descriptor);
  watched_.remove_if([&](const Instance::RareSource& source) { return source.instance == &instance; });
  instances_.remove(&instance);
}

void UnitLoop::start() {
  thread_ = std::thread{[this] { run(); }};
}

void UnitLoop::stop() noexcept {
  if (!thread_.joinable()) return;
  mailbox_.post([this] { stopping_ = true; });
  if (os::other_time != nullptr)
    os::other_time->wait_readable(ended_.get());  // by turns, the thread needs its own
  thread_.join();
}

void UnitLoop::post(Mailbox::Job job, Instance* instance) {
  if (instance == nullptr) return mailbox_.post(std::move(job));
  mailbox_.post([this, instance, job = std::move(job)] {
    job();
    look_after(*instance);
  });
}

void UnitLoop::look_after(Instance& instance) noexcept {
  instance.look_around();
  loop_.refresh(instance.bus());
}

bool UnitLoop::on_rare_event() noexcept {
  epoll_event event{};
  if (::epoll_wait(rare_.descriptor(), &event, 1, 0) <= 0) return false;
  if (event.data.ptr == nullptr) return mailbox_.do_one();
  const Instance::RareSource source = *static_cast<const Instance::RareSource*>(event.data.ptr);
  (source.instance->*source.handle)();
  if (os::other_time != nullptr) os::other_time->note_touched();  // it may have answered somebody
  look_after(*source.instance);
  return false;
}

void UnitLoop::run() noexcept {
  for (Instance* const instance : instances_) {
    instance->start();
    look_after(*instance);
  }
  while (!stopping_) loop_.turn();
  ::eventfd_write(ended_.get(), 1);
  loop_.end();
}

}  // namespace axisd
