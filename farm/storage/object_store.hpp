#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "farm/storage/key_value.hpp"

namespace farm {

/// Object stores of a server, in the form that other clients of NATS have ("nats object ls"). Every call waits for
/// the server, 2 s at most for each message; errors are one line.
class ObjectStore {
 public:
  /// Bytes of an object that lie in one message.
  static constexpr std::size_t kChunk = 128UL * 1024;
  /// Longest object (bytes).
  static constexpr std::size_t kLongest = 8UL * 1024 * 1024;

  ObjectStore() = default;
  ObjectStore(const ObjectStore&) = delete;
  ObjectStore& operator=(const ObjectStore&) = delete;
  virtual ~ObjectStore() = default;

  /// Replaces the object @p name as a whole: whoever reads it gets the former one or this one.
  [[nodiscard]] virtual tl::expected<void, std::string> put(const std::string& bucket, const std::string& name,
                                                            std::string_view content) = 0;
  /// Nothing in it: there is no such object. What does not have the length and digest (SHA-256) that it should
  /// have is an error.
  [[nodiscard]] virtual tl::expected<std::optional<std::string>, std::string> get(const std::string& bucket,
                                                                                  const std::string& name) = 0;
  [[nodiscard]] virtual tl::expected<void, std::string> remove(const std::string& bucket,
                                                               const std::string& name) = 0;
};

/// What a job of Link::run() works with.
struct Storage {
  KeyValue& keys;
  ObjectStore& objects;
};

}  // namespace farm
