#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace hub::trunk {

/// What one hub of a bus has at a time, kept where all hubs can change it, and nobody in between. Nothing here
/// waits for anybody.
class Lease {
 public:
  Lease() = default;
  Lease(const Lease&) = delete;
  Lease& operator=(const Lease&) = delete;
  virtual ~Lease() = default;

  /// What is kept.
  struct Entry {
    std::uint64_t revision = 0;  ///< another one with every change; 0: nobody has had it
    std::uint32_t term = 0;      ///< that it was taken for
    std::uint32_t hub = 0;       ///< who has it
  };

  /// Asks for the entry.
  virtual void look() noexcept = 0;
  /// Has this hub take it for @p term, if the entry has @p revision still, and asks for the entry then.
  virtual void take(std::uint64_t revision, std::uint32_t term) noexcept = 0;
  /// The answer to the last question, once; nothing while there is none.
  [[nodiscard]] virtual std::optional<Entry> take_answer() noexcept = 0;
  /// One line that says why there is none; empty if there is nothing new to say.
  [[nodiscard]] virtual std::string take_problem() = 0;
};

}  // namespace hub::trunk
