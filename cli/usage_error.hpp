#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <tl/expected.hpp>

namespace cli {

/// What is wrong with a command line, in one line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value of an option that was @p read; throws UsageError with what is wrong with it.
template <class Value>
[[nodiscard]] Value valid(tl::expected<Value, std::string> read) {
  if (read) return *std::move(read);
  throw UsageError{read.error()};
}

}  // namespace cli
