#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "gateway/units/daemon_client.hpp"

namespace gateway {

/// Answers of several, put together when the last of them has come.
class Gathering : public std::enable_shared_from_this<Gathering> {
  /// Lets make() construct one, in the memory of its owners: were there none for them behind it, it would tell
  /// before anybody has a place.
  struct OfMake {};

 public:
  using Answers = std::vector<Answer>;

  Gathering(OfMake, std::function<void(Answers)> on_all) noexcept : on_all_{std::move(on_all)} {}

  /// @p on_all gets the answers in the order in which place() was called.
  [[nodiscard]] static std::shared_ptr<Gathering> make(std::function<void(Answers)> on_all) {
    return std::make_shared<Gathering>(OfMake{}, std::move(on_all));
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
  std::function<void(Answers)> on_all_;
  Answers answers_;
};

}  // namespace gateway
