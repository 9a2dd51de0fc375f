#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/subscription.hpp"

namespace canopen {

/// The services that frames go to.
enum class Service : std::uint8_t {
  None,
  Nmt,
  Sync,
  Sdo,
  ViewedSdo,  ///< with an SdoView
  Rpdo,
  Heartbeat,
  Time,
  Own,          ///< data that only this node may send
  Guarding,     ///< remote frames only
  TpdoRequest,  ///< remote frames only
};

/// Which service takes the frames of an identifier, and which of its objects.
struct Route {
  Service service = Service::None;
  std::uint16_t position = 0;
};

/// Where received frames go: a table over all 11-bit identifiers, and sorted lists for what is rare (29-bit
/// identifiers, remote frames).
class CANOPEN_EXPORT Routes {
 public:
  /// Room for @p most routes.
  explicit Routes(std::size_t most);

  /// Takes all routes out.
  void clear() noexcept;
  /// Leads data frames of @p identifier to @p route; an earlier route of that identifier is lost.
  void lead(Identifier identifier, Route route) noexcept;
  /// Leads remote frames of @p identifier to @p route.
  void lead_remote(Identifier identifier, Route route) noexcept;
  /// Lists what the routes need; to be called after the last lead().
  void list_subscriptions() noexcept;

  /// The route of a data frame.
  Route of(const Frame& frame) const noexcept {
    return frame.id < base_.size() && !frame.extended ? base_[frame.id] : find(extended_, identifier_of(frame));
  }
  /// The route of a remote frame.
  Route of_remote(const Frame& frame) const noexcept { return find(remote_, identifier_of(frame)); }
  /// The route of data frames of @p identifier.
  Route of(Identifier identifier) const noexcept;
  /// In ascending order of identifiers, data before remote.
  std::span<const Subscription> subscriptions() const noexcept { return subscriptions_; }

 private:
  struct Led {
    Identifier identifier = 0;
    Route route{};
  };
  using List = std::vector<Led>;
  static Route find(const List& list, Identifier identifier) noexcept;
  static void insert(List& list, Identifier identifier, Route route) noexcept;

  std::array<Route, 2048> base_{};
  List extended_;
  List remote_;
  std::vector<Subscription> subscriptions_;
};

}  // namespace canopen
