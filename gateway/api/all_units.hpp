#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include "gateway/server/exchange.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// What all units do, in short. The daemons are asked for it twice a second at most, however many clients ask: all
/// get the same text.
class AllUnits {
 public:
  /// How old an answer may be.
  static constexpr std::chrono::milliseconds kAge{500};

  /// @p daemons outlives it.
  explicit AllUnits(const Daemons& daemons) : daemons_{daemons} {}
  AllUnits(const AllUnits&) = delete;
  AllUnits& operator=(const AllUnits&) = delete;
  ~AllUnits() = default;

  /// Answers @p exchange.
  void answer(const std::shared_ptr<Exchange>& exchange);

 private:
  /// What outlives this while the daemons are asked.
  struct Shared {
    std::shared_ptr<const std::string> text{};
    std::chrono::nanoseconds since{};  ///< of the text
    bool is_asking = false;
    std::list<std::shared_ptr<Exchange>> waiting{};
  };

  void ask() const;

  const Daemons& daemons_;
  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
};

/// What the overview tells of @p unit: excerpts of its `status`, or why there is none.
[[nodiscard]] nlohmann::json overview_of(const std::string& unit, const Answer& status);

}  // namespace gateway
