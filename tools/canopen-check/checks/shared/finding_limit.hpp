#pragma once

#include <utility>

#include <fmt/format.h>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Findings of a check that goes over many entries: the first twenty, and how many more there are.
class FindingLimit {
 public:
  explicit FindingLimit(Context& context) : context_{&context} {}
  FindingLimit(const FindingLimit&) = delete;
  FindingLimit& operator=(const FindingLimit&) = delete;
  ~FindingLimit() {
    if (more_ != 0)
      context_->fail(first_left_out_, "no further finding", fmt::format("and {} more, from here on", more_));
  }

  void fail(Subject subject, std::string expected, std::string found) {
    if (count_ < kMost) {
      ++count_;
      context_->fail(subject, std::move(expected), std::move(found));
      return;
    }
    if (more_++ == 0) first_left_out_ = subject;
  }

 private:
  static constexpr int kMost = 20;

  Context* context_;
  int count_ = 0, more_ = 0;
  Subject first_left_out_{};
};

}  // namespace conformance
