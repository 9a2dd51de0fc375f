#pragma once

#include <array>
#include <cstddef>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "tools/canrec/frames/frame_source.hpp"

namespace canrec {

/// The frames of one interface in a log of candump.
class LogFrames final : public FrameSource {
 public:
  /// Takes the line that says what is wrong with one of the log.
  using OnDamage = std::function<void(std::string_view)>;

  /// Opens the file @p path. @p interface: the frames of that one; if it is empty, all have to be of one. With @p
  /// on_damage lines that are damaged are told and left out, else the first one is a failure.
  [[nodiscard]] static Expected<std::unique_ptr<LogFrames>> open(const std::string& path, std::string interface,
                                                                 OnDamage on_damage = {});

  [[nodiscard]] Expected<std::optional<TimedFrame>> next() override;
  /// Name of the interface; empty until the first frame.
  [[nodiscard]] const std::string& interface() const noexcept { return interface_; }
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }

 private:
  LogFrames(std::string path, std::string interface, OnDamage on_damage);

  /// Longest line that is looked at (bytes): twice what a frame takes.
  static constexpr std::size_t kLongestLine = 256;

  bool read_line();
  [[nodiscard]] std::string complaint(std::string_view expected) const;

  std::string path_;
  std::string interface_;  ///< empty: that of the first frame
  bool is_chosen_;         ///< somebody has named it
  OnDamage on_damage_;
  std::ifstream file_;
  std::array<char, kLongestLine + 1> line_{};
  std::string_view text_;  ///< of the line
  bool is_too_long_ = false;
  std::uint64_t number_ = 0;  ///< of the line, from 1
  std::uint64_t damaged_ = 0;
};

}  // namespace canrec
