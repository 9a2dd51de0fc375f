#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "gateway/units/daemon_client.hpp"

namespace gateway {

/// Answers of several, put together when the last of them has come.
class Gathering : public std::enable_shared_from_this<Gathering> {
 public:
  using Answers = std::vector<Answer>;

  /// @p on_all gets the answers in the order in which place() was called.
  [[nodiscard]] static std::shared_ptr<Gathering> make(std::function<void(Answers)> on_all) {
    return std::shared_ptr<Gathering>{new Gathering{std::move(on_all)}};
  }
  Gathering(const Gathering&) = delete;
  Gathering& operator=(const Gathering&) = delete;
  /// Tells what has come: nobody has a place any more.
  ~Gathering() { on_all_(std::move(answers_)); }

  /// The place of one more answer.
  [[nodiscard]] OnAnswer place() {
    answers_.emplace_back(nlohmann::json{});
    return [self = shared_from_this(), at = answers_.size() - 1](Answer answer) {
      self->answers_[at] = std::move(answer);
    };
  }

 private:
  explicit Gathering(std::function<void(Answers)> on_all) : on_all_{std::move(on_all)} {}

  std::function<void(Answers)> on_all_;
  Answers answers_;
};

}  // namespace gateway
