#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "farm/storage/object_store.hpp"

namespace fakes {

/// Objects in memory. Once `error` is there, every call fails with it.
class FakeObjectStore final : public farm::ObjectStore {
 public:
  tl::expected<void, std::string> put(const std::string& bucket, const std::string& name,
                                      std::string_view content) override {
    if (!error.empty()) return tl::unexpected{error};
    objects[{bucket, name}] = content;
    return {};
  }
  tl::expected<std::optional<std::string>, std::string> get(const std::string& bucket,
                                                            const std::string& name) override {
    if (!error.empty()) return tl::unexpected{error};
    const auto found = objects.find({bucket, name});
    if (found == objects.end()) return std::nullopt;
    return found->second;
  }
  tl::expected<void, std::string> remove(const std::string& bucket, const std::string& name) override {
    if (!error.empty()) return tl::unexpected{error};
    objects.erase({bucket, name});
    return {};
  }

  std::map<std::pair<std::string, std::string>, std::string> objects;
  std::string error;
};

}  // namespace fakes
