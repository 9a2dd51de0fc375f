#pragma once

#include <string>

#include <sys/types.h>
#include <tl/expected.hpp>

#include "os/descriptor.hpp"

namespace scenario {

/// A folder for the files of one run, with a process beside it that removes the folder, and ends the groups of
/// processes that it was told of, when this program is gone: also if that was killed.
class Workshop {
 public:
  /// Makes the folder, for this user alone. With @p keep it stays. The error is one line.
  [[nodiscard]] static tl::expected<Workshop, std::string> open(bool keep);
  Workshop(Workshop&& other) noexcept;
  Workshop& operator=(Workshop&&) = delete;
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop();

  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_ + '/' + name; }
  /// @p group shall not outlive this program.
  void guard(pid_t group) const noexcept { tell(group); }
  /// @p group has ended.
  void forget(pid_t group) const noexcept { tell(-group); }

 private:
  Workshop(std::string folder, bool keep, os::Descriptor pipe, pid_t keeper)
      : folder_{std::move(folder)}, keep_{keep}, pipe_{std::move(pipe)}, keeper_{keeper} {}
  void tell(pid_t number) const noexcept;

  std::string folder_;
  bool keep_ = false;
  os::Descriptor pipe_;
  pid_t keeper_ = 0;
};

}  // namespace scenario
