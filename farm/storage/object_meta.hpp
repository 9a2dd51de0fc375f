#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace farm {

/// What an object store says of an object, beside its content.
struct ObjectMeta {
  std::string bucket;
  std::string name;
  std::string nuid;  ///< names its chunks
  std::size_t size = 0;
  std::size_t chunks = 0;
  std::string digest;  ///< as digest_of() gives it
  bool is_deleted = false;
};

/// Subject of what an object store says of the object @p name, and of the chunks of the one with @p nuid.
[[nodiscard]] std::string meta_subject(std::string_view bucket, std::string_view name);
[[nodiscard]] std::string chunk_subject(std::string_view bucket, std::string_view nuid);

/// JSON, in the form that other clients have.
[[nodiscard]] std::string text_of(const ObjectMeta& meta);
/// Reads it; nothing if @p text is none.
[[nodiscard]] std::optional<ObjectMeta> parse_object_meta(std::string_view text);

}  // namespace farm
