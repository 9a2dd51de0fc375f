#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <tl/expected.hpp>

#include "can/hub/trunk/lease/lease.hpp"
#include "can/nats/bus.hpp"

namespace nats {

/// The lease of the arbiter of a bus: an entry in a key-value bucket of the server.
///
/// A thread asks, over a connection that it has while there are questions.
class NatsLease final : public hub::trunk::Lease {
 public:
  /// Who takes the lease, for those who read the entry.
  struct Holder {
    std::uint32_t hub = 0;
    std::string name;
    std::uint32_t bit_rate = 0;  ///< of the bus (bit/s)
  };

  /// std::system_error if the kernel gives no thread.
  NatsLease(Bus bus, Holder holder);
  NatsLease(const NatsLease&) = delete;
  NatsLease& operator=(const NatsLease&) = delete;
  ~NatsLease() override;

  void look() noexcept override { ask(std::nullopt); }
  void take(std::uint64_t revision, std::uint32_t term) noexcept override { ask(Take{revision, term}); }
  [[nodiscard]] std::optional<Entry> take_answer() noexcept override;
  [[nodiscard]] std::string take_problem() override;

 private:
  struct Take {
    std::uint64_t revision = 0;
    std::uint32_t term = 0;
  };
  struct Question {
    std::optional<Take> take;  ///< nothing: how the entry is
    std::uint64_t number = 0;
  };
  struct Store;
  using Result = tl::expected<Entry, std::string>;

  void ask(std::optional<Take> take) noexcept;
  void work(const std::stop_token& stop);
  [[nodiscard]] std::optional<Question> next(const std::stop_token& stop);
  [[nodiscard]] Result answer(const Question& question);
  [[nodiscard]] Result change(const Take& take);
  void post(const Question& question, const Result& result);
  void wait(const std::stop_token& stop, std::chrono::milliseconds time);

  Bus bus_;
  Holder holder_;
  std::unique_ptr<Store> store_;  ///< of the thread

  std::mutex mutex_;  ///< of what the thread shares: the rest of the members
  std::condition_variable_any asked_;
  std::uint64_t questions_ = 0;
  std::optional<Question> question_;  ///< that was not answered yet
  std::optional<Entry> answer_;
  std::string problem_;
  std::string told_;  ///< the last one that was told
  std::jthread thread_;
};

}  // namespace nats
