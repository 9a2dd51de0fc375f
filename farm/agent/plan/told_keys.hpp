#pragma once

#include <set>
#include <string>

namespace farm::agent {

/// Which keys of a bucket were told since the connection was made: when all have been, the others are there no
/// more.
class ToldKeys {
 public:
  /// All are told anew.
  void begin() {
    keys_.clear();
    is_complete_ = false;
  }
  void note(const std::string& key) { keys_.insert(key); }
  void complete() noexcept { is_complete_ = true; }

  [[nodiscard]] bool has(const std::string& key) const { return keys_.contains(key); }
  [[nodiscard]] bool is_complete() const noexcept { return is_complete_; }

 private:
  std::set<std::string> keys_;
  bool is_complete_ = false;
};

}  // namespace farm::agent
