#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "gateway/units/daemon_client.hpp"

namespace gateway {

/// Answers of so many, put together when the last of them has come.
class Gathering : public std::enable_shared_from_this<Gathering> {
  /// Lets make() alone construct one.
  struct OfMake {};

 public:
  using Answers = std::vector<Answer>;

  Gathering(OfMake, std::size_t count, std::function<void(Answers)> on_all)
      : on_all_{std::move(on_all)}, answers_(count, Answer{nlohmann::json{}}) {}
  /// @p on_all gets @p count answers, in the order in which place() was called.
  [[nodiscard]] static std::shared_ptr<Gathering> make(std::size_t count, std::function<void(Answers)> on_all) {
    return std::make_shared<Gathering>(OfMake{}, count, std::move(on_all));
  }
  Gathering(const Gathering&) = delete;
  Gathering& operator=(const Gathering&) = delete;
  /// Tells what has come: nobody has a place any more. Where not all had one, who asks was kept from it, and
  /// nothing is told.
  ~Gathering() {
    if (places_ == answers_.size()) on_all_(std::move(answers_));
  }

  /// The place of one more answer, @p count times.
  [[nodiscard]] OnAnswer place() {
    OnAnswer place = [self = shared_from_this(), at = places_](Answer answer) {
      self->answers_[at] = std::move(answer);
    };
    ++places_;
    return place;
  }

 private:
  std::function<void(Answers)> on_all_;
  Answers answers_;
  std::size_t places_ = 0;  ///< that were given
};

}  // namespace gateway
