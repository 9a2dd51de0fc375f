#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "farm/storage/storage_connection.hpp"
#include "service/mailbox.hpp"

namespace farm {

/// Does jobs with the storage of the server, one after the other, for a loop that must not wait.
class JobThread {
 public:
  /// What is done with the storage; nullptr: there is no connection.
  using Job = std::function<void(Storage*)>;
  using Then = std::function<void()>;

  /// Throws std::system_error if the kernel gives no descriptor or thread.
  JobThread(nats::Server server, std::string client);
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;
  ~JobThread() { end(); }

  /// Ends the thread: whoever waits is told before this returns, and who comes later is not heard.
  void end();

  /// Does @p job in its turn, then has serve() call @p then; neither behind end().
  void run(Job job, Then then);
  /// Whether the server can be reached. While it cannot, jobs fail at once.
  void set_up(bool is_up);
  /// Any thread: ends the connection, and so the job that waits for its server. May wait itself.
  void drop_connection();

  /// Readable while serve() has something to do.
  [[nodiscard]] int descriptor() const noexcept { return done_.descriptor(); }
  void serve() noexcept { done_.do_one(); }

 private:
  struct Task {
    Job job;
    Then then;
  };

  void work(const std::stop_token& stop);
  [[nodiscard]] std::shared_ptr<StorageConnection> connection();

  nats::Server server_;
  std::string client_;
  axisd::Mailbox done_;
  std::mutex mutex_;  ///< of what follows
  std::condition_variable_any wanted_;
  std::deque<Task> tasks_;
  std::shared_ptr<StorageConnection> connection_;
  bool is_up_ = false;
  std::jthread thread_;
};

}  // namespace farm
