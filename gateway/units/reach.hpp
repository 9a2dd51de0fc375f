#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "os/descriptor.hpp"

namespace gateway {

/// Where daemons are found, and how they are connected to.
class Reach {
 public:
  Reach() = default;
  Reach(const Reach&) = delete;
  Reach& operator=(const Reach&) = delete;
  virtual ~Reach() = default;

  /// What there is to connect to at the moment, by its name.
  [[nodiscard]] virtual std::vector<std::string> places() const = 0;
  /// Whether somebody has asked for these places: one that cannot be reached is worth a word.
  [[nodiscard]] virtual bool are_named() const noexcept = 0;
  /// Whether units come and go while a daemon runs.
  [[nodiscard]] virtual bool do_units_change() const noexcept = 0;
  /// A stream to the daemon at @p place that does not block; the error is one line.
  [[nodiscard]] virtual tl::expected<os::Descriptor, std::string> connect(const std::string& place) = 0;
};

/// The daemons of this machine.
class SocketReach final : public Reach {
 public:
  /// Those at the sockets @p paths alone, or all in the runtime folders where there are none.
  explicit SocketReach(std::vector<std::string> paths) : paths_{std::move(paths)} {}

  [[nodiscard]] std::vector<std::string> places() const override;
  [[nodiscard]] bool are_named() const noexcept override { return !paths_.empty(); }
  [[nodiscard]] bool do_units_change() const noexcept override { return false; }
  /// Only to a server that is to be trusted.
  [[nodiscard]] tl::expected<os::Descriptor, std::string> connect(const std::string& path) override;

 private:
  std::vector<std::string> paths_;
};

}  // namespace gateway
