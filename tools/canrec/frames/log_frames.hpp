#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "record/log_lines.hpp"
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
  LogFrames(record::LogLines lines, std::string interface, OnDamage on_damage);

  record::LogLines lines_;
  std::string interface_;  ///< empty: that of the first frame
  bool is_chosen_;         ///< somebody has named it
  OnDamage on_damage_;
  std::uint64_t damaged_ = 0;
};

}  // namespace canrec
