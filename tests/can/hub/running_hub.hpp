#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <semaphore>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

#include "can/hub/path/path_owner.hpp"
#include "can/hub/server.hpp"
#include "tests/can/hub/bus_client.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace hub_test {

/// A hub that serves a path of its own in a thread of the test.
class RunningHub {
 public:
  explicit RunningHub(std::uint32_t bit_rate = 0) : RunningHub{hub::Server::Settings{.bit_rate = bit_rate}} {}
  explicit RunningHub(hub::Server::Settings settings)
      : owner_{take(path())},
        server_{owner_.listener(), std::move(settings)},
        end_{server_},
        link_{server_},
        thread_{[this] { server_.run(); }} {}
  RunningHub(const RunningHub&) = delete;
  RunningHub& operator=(const RunningHub&) = delete;
  ~RunningHub() {
    end_.ask_for();
    thread_.join();
  }

  [[nodiscard]] std::string path() const { return folder_.path("bus"); }
  /// The wire goes on beyond the hub, and is cut or whole from now on; members have been told.
  void set_link(bool up) { link_.set(up); }

 private:
  /// Cuts the wire from another thread.
  class Link final : public hub::Source {
   public:
    explicit Link(hub::Server& server) : server_{server}, descriptor_{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
      server_.add(*this);
    }
    ~Link() override { server_.remove(*this); }
    [[nodiscard]] int descriptor() const noexcept override { return descriptor_.get(); }
    void on_readable(canopen::TimePoint) noexcept override {
      eventfd_t asked = 0;
      eventfd_read(descriptor_.get(), &asked);
      server_.set_link(up_);
      done_.release();
    }
    void set(bool up) {
      up_ = up;
      eventfd_write(descriptor_.get(), 1);
      done_.acquire();
    }

   private:
    hub::Server& server_;
    os::Descriptor descriptor_;
    std::atomic<bool> up_{true};
    std::binary_semaphore done_{0};
  };

  /// Ends the loop from another thread.
  class End final : public hub::Source {
   public:
    explicit End(hub::Server& server) : server_{server}, descriptor_{eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
      server_.add(*this);
    }
    ~End() override { server_.remove(*this); }
    [[nodiscard]] int descriptor() const noexcept override { return descriptor_.get(); }
    void on_readable(canopen::TimePoint) noexcept override { server_.stop(); }
    void ask_for() const { eventfd_write(descriptor_.get(), 1); }

   private:
    hub::Server& server_;
    os::Descriptor descriptor_;
  };

  static hub::PathOwner take(const std::string& path) {
    auto owner = hub::PathOwner::take(path_of(path), {});
    if (!owner) throw std::runtime_error{owner.error().text};
    return std::move(*owner);
  }

  fakes::TemporaryDirectory folder_;
  hub::PathOwner owner_;
  hub::Server server_;
  End end_;
  Link link_;
  std::thread thread_;
};

}  // namespace hub_test
