#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace axisd {

/// A value in a JSON file that knows where it stands, so that every complaint names file and key path.
class JsonReader {
 public:
  /// The whole of @p file, whose content is @p text; throws ConfigurationError if it is not JSON.
  static JsonReader parse(std::string_view text, const std::string& file);

  /// Throws ConfigurationError unless this is an object that has no other keys than @p keys.
  void expect_object(std::span<const std::string_view> keys) const;
  void expect_object(std::initializer_list<std::string_view> keys) const {
    expect_object(std::span{keys.begin(), keys.size()});
  }
  /// Throws ConfigurationError unless this is an array of @p low to @p high values.
  void expect_array(std::size_t low, std::size_t high) const;

  bool has(const std::string& key) const { return value_.is_object() && value_.contains(key); }
  JsonReader at(const std::string& key) const;
  JsonReader at(std::size_t position) const;
  std::size_t size() const { return value_.size(); }
  /// Keys of an object, in the order of nlohmann's map.
  std::vector<std::string> keys() const;

  /// The value itself, for a reader of another layer.
  const nlohmann::json& value() const noexcept { return value_; }

  /// Where in the file the value stands: "/axes/0/load".
  const std::string& path() const noexcept { return path_; }
  /// Name of the file, for paths in it that are relative.
  const std::string& file() const noexcept { return file_; }

  bool is_string() const { return value_.is_string(); }
  bool is_number() const { return value_.is_number(); }
  bool is_object() const { return value_.is_object(); }
  bool is_array() const { return value_.is_array(); }
  std::string text() const;
  bool boolean() const;
  int integer(int low, int high) const;
  std::int64_t whole_number(std::int64_t low, std::int64_t high) const;
  double number(double low, double high) const;

  /// Throws ConfigurationError: this value is not @p expected.
  [[noreturn]] void fail(const std::string& expected) const;
  /// The same of what is at @p path ("a/b") below this value, or should be.
  [[noreturn]] void fail_below(const std::string& path, const std::string& expected) const;

 private:
  JsonReader(nlohmann::json value, std::string file, std::string path)
      : value_(std::move(value)), file_{std::move(file)}, path_{std::move(path)} {}
  std::string place() const;

  nlohmann::json value_;
  std::string file_;
  std::string path_;
};

}  // namespace axisd
