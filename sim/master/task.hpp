#pragma once

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

namespace sim {

/// What a master does, one thing behind the other, while the world goes on: a coroutine that begins when somebody
/// waits for it, and ends with a Value. Destroying it ends it where it stands.
///
/// What is waited for gets a name first (`const bool done = co_await step();`): g++ 12 loses its way where
/// co_await stands within a condition, or beside a temporary that has a destructor.
template <class Value>
class [[nodiscard]] Task {
 public:
  struct promise_type {
    Task get_return_object() noexcept { return Task{Handle::from_promise(*this)}; }
    std::suspend_always initial_suspend() noexcept { return {}; }
    auto final_suspend() noexcept {
      struct GoOn {
        bool await_ready() noexcept { return false; }
        std::coroutine_handle<> await_suspend(Handle handle) noexcept {
          const std::coroutine_handle<> waiting = handle.promise().waiting;
          return waiting ? waiting : std::noop_coroutine();
        }
        void await_resume() noexcept {}
      };
      return GoOn{};
    }
    template <class Given>
    void return_value(Given&& given) {
      value.emplace(std::forward<Given>(given));
    }
    void unhandled_exception() noexcept { std::terminate(); }

    std::coroutine_handle<> waiting{};
    std::optional<Value> value{};
  };

  Task(Task&& other) noexcept : handle_{std::exchange(other.handle_, {})} {}
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  Task& operator=(Task&&) = delete;
  ~Task() {
    if (handle_) handle_.destroy();
  }

  /// For a task that nobody waits for: begins it.
  void start() { handle_.resume(); }

  bool await_ready() const noexcept { return false; }
  std::coroutine_handle<> await_suspend(std::coroutine_handle<> waiting) noexcept {
    handle_.promise().waiting = waiting;
    return handle_;
  }
  Value await_resume() { return *std::move(handle_.promise().value); }

 private:
  using Handle = std::coroutine_handle<promise_type>;
  explicit Task(Handle handle) noexcept : handle_{handle} {}

  Handle handle_;
};

/// The value of a task that is done for what it does.
struct Done {};

}  // namespace sim
