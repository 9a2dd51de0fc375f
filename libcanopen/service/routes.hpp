#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/service/subscription.hpp"

namespace canopen {

/// Which service takes the frames of an identifier, and which of its objects.
struct Route {
  std::uint8_t service = 0;  ///< its place in the ServiceList, 0 = nobody
  bool used = false;         ///< some service sends or receives the identifier
  std::uint16_t slot = 0;    ///< as the service has named it
};

/// Where received frames go: a table over all 11-bit identifiers, and sorted lists for what is rare (29-bit
/// identifiers, remote frames).
class Routes {
 public:
  /// Room for @p count identifiers more. To be called before the node starts.
  void make_room(std::size_t count);

  /// Takes all routes out.
  void clear() noexcept;
  /// Leads data frames of @p identifier to @p slot of @p service, unless they are led elsewhere already.
  void lead(Identifier identifier, std::uint8_t service, std::uint16_t slot) noexcept;
  /// The same for remote frames.
  void lead_remote(Identifier identifier, std::uint8_t service, std::uint16_t slot) noexcept;
  /// A service uses @p identifier, at least to send.
  void use(Identifier identifier) noexcept;
  /// Lists what the routes need; to be called after the last lead(). True if it is not what it was before.
  bool list_subscriptions() noexcept;

  /// True for a data frame of an 11-bit identifier.
  bool is_common(const Frame& frame) const noexcept {
    return !frame.remote && !frame.extended && frame.id < base_.size();
  }
  /// The route of such a frame.
  Route of_common(const Frame& frame) const noexcept { return base_[frame.id]; }
  /// The route of a data frame of a 29-bit identifier.
  Route of_extended(const Frame& frame) const noexcept { return find(extended_, identifier_of(frame)); }
  /// The route of a remote frame.
  Route of_remote(const Frame& frame) const noexcept { return find(remote_, identifier_of(frame)); }
  /// Whether data frames of @p identifier are received or sent.
  bool is_used(Identifier identifier) const noexcept;
  /// In ascending order of identifiers, data before remote.
  std::span<const Subscription> subscriptions() const noexcept { return subscriptions_; }

 private:
  struct Led {
    Identifier identifier = 0;
    Route route{};
  };
  using List = std::vector<Led>;
  static Route find(const List& list, Identifier identifier) noexcept;
  static Route& place(List& list, Identifier identifier) noexcept;
  static void lead(Route& route, std::uint8_t service, std::uint16_t slot) noexcept;
  Route& place(Identifier identifier) noexcept;

  std::array<Route, 2048> base_{};
  List extended_;
  List remote_;
  std::vector<Subscription> subscriptions_;
  std::vector<Subscription> before_;  ///< the list before it was made anew
  std::size_t room_ = 0;
};

}  // namespace canopen
