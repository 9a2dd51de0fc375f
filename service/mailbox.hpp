#pragma once

#include <deque>
#include <functional>
#include <mutex>

#include "os/descriptor.hpp"

namespace axisd {

/// What other threads want a thread to do between two of its turns, in the order in which they came.
class Mailbox {
 public:
  using Job = std::function<void()>;

  /// Throws std::system_error if the kernel gives no descriptor.
  Mailbox();

  /// Any thread: @p job, which does not throw, is to be done.
  void post(Job job);
  /// Readable while jobs wait.
  int descriptor() const noexcept { return waiting_.get(); }
  /// Does the job that has waited longest. True if more of them wait.
  bool do_one() noexcept;

 private:
  std::mutex mutex_;
  std::deque<Job> jobs_;
  os::Descriptor waiting_;  ///< eventfd
};

}  // namespace axisd
