#pragma once

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <pthread.h>
#include <sys/eventfd.h>
#include <tl/expected.hpp>

#include "can/nats/nats_handles.hpp"
#include "os/descriptor.hpp"
#include "os/no_signals.hpp"

namespace nats {

/// Makes a connection anew whenever the former one is given up, on a thread: connecting waits for the server.
template <class Made>
class Connector {
 public:
  /// A connection, or why there is none, in one line.
  using Result = tl::expected<std::unique_ptr<Made>, std::string>;
  /// Connects, and waits up to @p patience for each answer of the server.
  using Make = std::function<Result(std::chrono::milliseconds patience)>;

  /// Begins to connect; std::system_error if the kernel gives no descriptor or thread.
  explicit Connector(Make make) : make_{std::move(make)}, bell_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
    if (!bell_) throw std::system_error{errno, std::generic_category(), "eventfd"};
    const os::NoSignals none;
    thread_ = std::jthread{[this](const std::stop_token& stop) { work(stop); }};
  }
  Connector(const Connector&) = delete;
  Connector& operator=(const Connector&) = delete;
  ~Connector() {
    thread_.request_stop();
    wanted_.notify_all();
    thread_.join();
  }

  /// Readable when take() or take_problem() has something.
  [[nodiscard]] int descriptor() const noexcept { return bell_.get(); }
  /// The connection that was made, once.
  [[nodiscard]] std::unique_ptr<Made> take() {
    eventfd_t rings = 0;
    ::eventfd_read(bell_.get(), &rings);
    const std::scoped_lock lock{mutex_};
    return std::move(made_);
  }
  /// Why the last attempt has failed, once for each reason; else empty.
  [[nodiscard]] std::string take_problem() {
    const std::scoped_lock lock{mutex_};
    return std::exchange(problem_, {});
  }
  /// Has the thread close @p former, if there is one, and connect again.
  void again(std::unique_ptr<Made> former) {
    const std::scoped_lock lock{mutex_};
    given_up_ = std::move(former);
    made_.reset();
    is_wanted_ = true;
    wanted_.notify_all();
  }

 private:
  /// Time for each step of the first attempt, and at least for those after a cut: the server is near then, or it
  /// is as far away as it was.
  static constexpr std::chrono::milliseconds kFirstPatience{2000};
  static constexpr std::chrono::milliseconds kLeastPatience{250};
  /// Between two attempts.
  static constexpr std::chrono::milliseconds kPause{50};

  void work(const std::stop_token& stop) {
    using std::chrono::milliseconds;
    pthread_setname_np(pthread_self(), "nats-connect");
    milliseconds patience = kFirstPatience;
    while (is_wanted(stop)) {
      const auto begin = std::chrono::steady_clock::now();
      auto made = make_(patience);
      if (made) {
        constexpr int kMargin = 4;
        const auto needed = std::chrono::steady_clock::now() - begin;
        patience =
            std::clamp(std::chrono::duration_cast<milliseconds>(needed * kMargin), kLeastPatience, kFirstPatience);
        hand_over(*std::move(made));
      } else {
        report(made.error());
        wait(stop);
      }
    }
    nats_ReleaseThreadMemory();
  }

  /// Waits until a connection is wanted and closes the one before; false at the end.
  bool is_wanted(const std::stop_token& stop) {
    std::unique_ptr<Made> old;
    std::unique_lock lock{mutex_};
    wanted_.wait(lock, stop, [this] { return is_wanted_; });
    old = std::move(given_up_);
    lock.unlock();
    return !stop.stop_requested();
  }

  void wait(const std::stop_token& stop) {
    std::unique_lock lock{mutex_};
    wanted_.wait_for(lock, stop, kPause, [] { return false; });
  }

  void hand_over(std::unique_ptr<Made> made) {
    const std::scoped_lock lock{mutex_};
    made_ = std::move(made);
    is_wanted_ = false;
    told_.clear();
    ::eventfd_write(bell_.get(), 1);
  }

  void report(const std::string& problem) {
    const std::scoped_lock lock{mutex_};
    if (problem == told_) return;
    problem_ = problem;
    told_ = problem;
    ::eventfd_write(bell_.get(), 1);
  }

  Make make_;
  os::Descriptor bell_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable_any wanted_;
  bool is_wanted_ = true;           ///< a connection shall be made
  std::unique_ptr<Made> made_;      ///< one that was
  std::unique_ptr<Made> given_up_;  ///< to be closed by the thread
  std::string problem_;
  std::string told_;  ///< the last problem that was told
  std::jthread thread_;
};

}  // namespace nats
