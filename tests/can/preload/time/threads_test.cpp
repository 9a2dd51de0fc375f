#include <atomic>
#include <condition_variable>
#include <mutex>
#include <semaphore>
#include <shared_mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <threads.h>

#include "tests/can/preload/time/bus_clock.hpp"

namespace preload_test {
namespace {

TEST(Threads, SleepSideBySide) {
  const Stopwatch time;
  std::vector<std::string> order;  // one thread runs at a time; at one instant the one that has waited longest
  std::vector<std::thread> threads;
  for (const int length : {30, 10, 20})
    threads.emplace_back([length, &order, &time] {
      for (int i = 0; i < 2; ++i) {
        sleep_for(milliseconds{length});
        order.push_back(std::to_string(length) + "@" + std::to_string(time.passed() / milliseconds{1}));
      }
    });
  for (std::thread& thread : threads) thread.join();

  const std::vector<std::string> expected{"10@10", "20@20", "10@20", "30@30", "20@40", "30@60"};
  EXPECT_EQ(order, expected);
}

TEST(Threads, MayRunOnTheProcessorsOfTheirProgram) {
  const auto processors = [] {
    cpu_set_t set;
    CPU_ZERO(&set);
    sched_getaffinity(0, sizeof set, &set);
    return CPU_COUNT(&set);
  };
  const int all = processors();
  int of_thread = 0;
  sleep_for(milliseconds{1});
  std::thread other{[&] {
    sleep_for(milliseconds{1});
    of_thread = processors();
  }};
  sleep_for(milliseconds{2});

  EXPECT_EQ(processors(), all);
  EXPECT_EQ(of_thread, all);
  other.join();
}

TEST(Condition, WakesAtTheInstantOfItsSignal) {
  std::mutex mutex;
  std::condition_variable changed;
  bool ready = false;
  const Stopwatch time;
  std::thread other{[&] {
    sleep_for(seconds{2});
    const std::lock_guard lock{mutex};
    ready = true;
    changed.notify_one();
  }};
  std::unique_lock lock{mutex};

  EXPECT_FALSE(changed.wait_for(lock, milliseconds{500}, [&] { return ready; }));
  EXPECT_EQ(time.passed(), milliseconds{500});
  EXPECT_TRUE(changed.wait_for(lock, seconds{60}, [&] { return ready; }));
  EXPECT_EQ(time.passed(), seconds{2});
  other.join();
}

TEST(Condition, TakesTheTimeOfItsClock) {
  pthread_cond_t condition = PTHREAD_COND_INITIALIZER;
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  const Stopwatch time;
  const timespec end = instant(milliseconds{30}, CLOCK_REALTIME);
  pthread_mutex_lock(&mutex);

  EXPECT_EQ(pthread_cond_timedwait(&condition, &mutex, &end), ETIMEDOUT);
  EXPECT_EQ(time.passed(), milliseconds{30});
  pthread_mutex_unlock(&mutex);
}

TEST(Mutex, IsWaitedForWhileItsOwnerSleeps) {
  std::timed_mutex mutex;
  const Stopwatch time;
  std::thread owner{[&] {
    const std::lock_guard lock{mutex};
    sleep_for(seconds{1});
  }};
  sleep_for(milliseconds{1});

  EXPECT_FALSE(mutex.try_lock_for(milliseconds{99}));
  EXPECT_EQ(time.passed(), milliseconds{100});
  mutex.lock();
  EXPECT_EQ(time.passed(), seconds{1});
  mutex.unlock();
  owner.join();
}

TEST(Mutex, TellsItsOwnerThatItWouldWaitForItself) {
  pthread_mutex_t mutex = PTHREAD_ERRORCHECK_MUTEX_INITIALIZER_NP;
  ASSERT_EQ(pthread_mutex_lock(&mutex), 0);

  EXPECT_EQ(pthread_mutex_lock(&mutex), EDEADLK);
  EXPECT_EQ(pthread_mutex_unlock(&mutex), 0);
}

TEST(SharedMutex, LetsReadersInWhenItsWriterLeaves) {
  std::shared_mutex mutex;
  const Stopwatch time;
  std::thread writer{[&] {
    const std::lock_guard lock{mutex};
    sleep_for(milliseconds{40});
  }};
  sleep_for(milliseconds{1});
  const std::shared_lock reader{mutex};

  EXPECT_EQ(time.passed(), milliseconds{40});
  writer.join();
}

TEST(Semaphore, HasALimitOfTime) {
  sem_t semaphore;
  ASSERT_EQ(sem_init(&semaphore, 0, 0), 0);
  const Stopwatch time;
  std::thread other{[&] {
    sleep_for(milliseconds{70});
    sem_post(&semaphore);
  }};
  const timespec end = instant(milliseconds{50}, CLOCK_REALTIME);

  EXPECT_EQ(sem_timedwait(&semaphore, &end), -1);
  EXPECT_EQ(errno, ETIMEDOUT);
  EXPECT_EQ(time.passed(), milliseconds{50});
  EXPECT_EQ(sem_wait(&semaphore), 0);
  EXPECT_EQ(time.passed(), milliseconds{70});
  other.join();
}

TEST(Barrier, LetsAllGoAtTheInstantOfTheLast) {
  pthread_barrier_t barrier;
  ASSERT_EQ(pthread_barrier_init(&barrier, nullptr, 3), 0);
  const Stopwatch time;
  std::vector<std::thread> threads;
  for (const int length : {10, 30})
    threads.emplace_back([&barrier, &time, length] {
      sleep_for(milliseconds{length});
      pthread_barrier_wait(&barrier);
      EXPECT_EQ(time.passed(), milliseconds{30});
    });
  pthread_barrier_wait(&barrier);

  EXPECT_EQ(time.passed(), milliseconds{30});
  for (std::thread& thread : threads) thread.join();
}

TEST(StandardThreads, SleepAndWait) {
  struct Shared {
    mtx_t mutex;
    cnd_t changed;
    bool ready;
  } shared{};
  mtx_init(&shared.mutex, mtx_timed);
  cnd_init(&shared.changed);
  const Stopwatch time;
  thrd_t thread{};
  const auto work = [](void* argument) {
    auto& both = *static_cast<Shared*>(argument);
    const timespec length = timespec_of(seconds{2});
    thrd_sleep(&length, nullptr);
    mtx_lock(&both.mutex);
    both.ready = true;
    cnd_signal(&both.changed);
    mtx_unlock(&both.mutex);
    return 7;
  };
  ASSERT_EQ(thrd_create(&thread, work, &shared), thrd_success);
  mtx_lock(&shared.mutex);
  while (!shared.ready) cnd_wait(&shared.changed, &shared.mutex);
  mtx_unlock(&shared.mutex);

  EXPECT_EQ(time.passed(), seconds{2});
  int result = 0;
  EXPECT_EQ(thrd_join(thread, &result), thrd_success);
  EXPECT_EQ(result, 7);
}

/// By the kernel's futex itself, past the C library's threads.
TEST(Futex, WaitsForAnAtomicWord) {
  std::atomic<int> word{0};
  const Stopwatch time;
  std::thread other{[&] {
    sleep_for(seconds{5});
    word = 1;
    word.notify_all();
  }};

  word.wait(0);
  EXPECT_EQ(time.passed(), seconds{5});
  other.join();
}

TEST(Join, HasALimitOfTime) {
  const Stopwatch time;
  pthread_t thread{};
  ASSERT_EQ(pthread_create(
                &thread, nullptr,
                [](void*) -> void* {
                  sleep_for(seconds{3});
                  return nullptr;
                },
                nullptr),
            0);
  const timespec end = instant(seconds{1}, CLOCK_REALTIME);

  EXPECT_EQ(pthread_timedjoin_np(thread, nullptr, &end), ETIMEDOUT);
  EXPECT_EQ(time.passed(), seconds{1});
  EXPECT_EQ(pthread_join(thread, nullptr), 0);
  EXPECT_EQ(time.passed(), seconds{3});
}

TEST(Cancel, EndsASleepingThread) {
  const Stopwatch time;
  pthread_t thread{};
  const auto sleep_for_ever = [](void*) -> void* {
    for (;;) sleep(1000);
  };
  ASSERT_EQ(pthread_create(&thread, nullptr, sleep_for_ever, nullptr), 0);
  sleep_for(seconds{1});
  void* result = nullptr;

  EXPECT_EQ(pthread_cancel(thread), 0);
  EXPECT_EQ(pthread_join(thread, &result), 0);
  EXPECT_EQ(result, PTHREAD_CANCELED);
  EXPECT_EQ(time.passed(), seconds{1});
}

/// It sees nothing of another that waits for it in a loop: one of both has to get processor time.
TEST(Threads, MayWaitForEachOtherInALoop) {
  std::atomic<int> turn{0};
  std::thread other{[&] {
    while (turn != 1) continue;
    turn = 2;
  }};
  turn = 1;
  while (turn != 2) continue;
  other.join();
}

TEST(Threads, MayWaitInALoopForOneThatSleeps) {
  constexpr int kSleepers = 4;
  std::counting_semaphore<kSleepers> ends{0};
  std::vector<std::thread> sleepers;
  for (int i = 0; i < kSleepers; ++i) sleepers.emplace_back([&] { ends.acquire(); });
  std::binary_semaphore begins{0};
  std::atomic<bool> is_done = false;
  std::thread worker{[&] {
    begins.acquire();
    is_done = true;
  }};
  std::this_thread::sleep_for(milliseconds{1});

  begins.release();
  while (!is_done) continue;
  worker.join();
  ends.release(kSleepers);
  for (std::thread& sleeper : sleepers) sleeper.join();
}

TEST(Threads, MayMeetInALoopAfterTheirSleeps) {
  std::atomic<int> there = 0;
  const auto meet = [&] {
    std::this_thread::sleep_for(milliseconds{1});
    ++there;
    while (there != 2) continue;
  };
  const Stopwatch time;
  std::thread other{meet};
  meet();
  other.join();
  EXPECT_EQ(time.passed(), milliseconds{1});
}

}  // namespace
}  // namespace preload_test
