#include "farm/storage/object_meta.hpp"

#include <chrono>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "farm/storage/digest.hpp"
#include "farm/storage/object_store.hpp"

namespace farm {

namespace {

using nlohmann::json;

std::string present() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

}  // namespace

std::string meta_subject(std::string_view bucket, std::string_view name) {
  return fmt::format("$O.{}.M.{}", bucket, base64url(name));
}

std::string chunk_subject(std::string_view bucket, std::string_view nuid) {
  return fmt::format("$O.{}.C.{}", bucket, nuid);
}

std::string text_of(const ObjectMeta& meta) {
  json object{{"name", meta.name},     {"options", {{"max_chunk_size", ObjectStore::kChunk}}},
              {"bucket", meta.bucket}, {"nuid", meta.nuid},
              {"size", meta.size},     {"mtime", present()},
              {"chunks", meta.chunks}, {"digest", meta.digest}};
  if (meta.is_deleted) object["deleted"] = true;
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<ObjectMeta> parse_object_meta(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  ObjectMeta meta;
  try {
    meta.bucket = object.value("bucket", "");
    meta.name = object.value("name", "");
    meta.nuid = object.value("nuid", "");
    meta.size = object.value("size", std::size_t{0});
    meta.chunks = object.value("chunks", std::size_t{0});
    meta.digest = object.value("digest", "");
    meta.is_deleted = object.value("deleted", false);
  } catch (const json::exception&) {  // a member of another type
    return std::nullopt;
  }
  return meta;
}

}  // namespace farm
