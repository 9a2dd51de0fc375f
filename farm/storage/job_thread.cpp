#include "farm/storage/job_thread.hpp"

#include <utility>

#include <pthread.h>

#include "os/no_signals.hpp"

namespace farm {

JobThread::JobThread(nats::Server server, std::string client)
    : server_{std::move(server)}, client_{std::move(client)} {
  const os::NoSignals none;
  thread_ = std::jthread{[this](const std::stop_token& stop) { work(stop); }};
}

void JobThread::end() {
  if (!thread_.joinable()) return;
  set_up(false);
  drop_connection();
  thread_.request_stop();
  wanted_.notify_all();
  thread_.join();
  while (done_.do_one()) {
  }
  for (Task& task : std::exchange(tasks_, {})) {
    task.job(nullptr);
    task.then();
  }
}

void JobThread::run(Job job, Then then) {
  if (!thread_.joinable()) return;
  const std::scoped_lock lock{mutex_};
  tasks_.push_back({std::move(job), std::move(then)});
  wanted_.notify_all();
}

void JobThread::set_up(bool is_up) {
  const std::scoped_lock lock{mutex_};
  is_up_ = is_up;
}

void JobThread::drop_connection() {
  std::unique_lock lock{mutex_};
  const auto former = connection_;
  lock.unlock();
  if (former) former->close();
}

void JobThread::work(const std::stop_token& stop) {
  pthread_setname_np(pthread_self(), "nats-jobs");
  for (;;) {
    std::unique_lock lock{mutex_};
    if (!wanted_.wait(lock, stop, [this] { return !tasks_.empty(); })) break;
    Task task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    if (const auto open = connection()) {
      Storage storage = open->storage();
      task.job(&storage);
    } else {
      task.job(nullptr);
    }
    done_.post(std::move(task.then));
  }
  connection_.reset();
  nats_ReleaseThreadMemory();
}

/// The one that there is, or a new one. One that was made while the server was lost is none.
std::shared_ptr<StorageConnection> JobThread::connection() {
  {
    const std::scoped_lock lock{mutex_};
    if (!is_up_) return nullptr;
    if (connection_ && connection_->is_good()) return connection_;
    connection_.reset();
  }
  auto opened = StorageConnection::open(server_, client_);
  const std::scoped_lock lock{mutex_};
  if (!opened || !is_up_) return nullptr;
  connection_ = *std::move(opened);
  return connection_;
}

}  // namespace farm
