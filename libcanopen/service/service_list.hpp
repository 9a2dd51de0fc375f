#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/service/routes.hpp"
#include "libcanopen/service/service.hpp"

namespace canopen {

/// The services of a node, in the order in which they have registered, and the ways that frames and timers go to
/// those that live in the NMT state. It knows none of them by name.
class ServiceList final : public IdentifierUse {
 public:
  /// Most services of a node.
  static constexpr std::size_t kMost = 32;

  explicit ServiceList(Context& context) noexcept : context_{context}, nobody_{context} { living_.fill(&nobody_); }

  /// Registers @p service and gives it its timers; returns the number of the first. Throws std::length_error
  /// beyond kMost services. Only before the node starts.
  std::size_t add(Service& service, const ServiceFacts& facts);

  /// A frame goes to the service that hears its identifier, if that lives.
  void on_frame(const Frame& frame) noexcept {
    if (!routes_.is_common(frame)) return on_rare_frame(frame);
    const Route route = routes_.of_common(frame);
    living_[route.service]->on_frame(frame, route.slot);
  }
  /// Timer @p timer of the node's queue is due.
  void on_timer(std::size_t timer) noexcept;

  /// The NMT state of the context is another one: services that do not live in it stop.
  void leave() noexcept;
  /// The application knows the NMT state of the context: services that live in it start, if they have not yet.
  void enter() noexcept;

  /// The services of the stages before the boot-up message take over their objects, then all have their
  /// identifiers. The application is told.
  void reload(Reload how) noexcept;
  /// The services behind the boot-up message do.
  void reload_after_boot_up(Reload how) noexcept { reload(how, ReloadStage::AfterBootUp); }
  /// After a reload without a boot-up: the services that live go on.
  void go_on() noexcept;

  /// See Node::subscriptions().
  std::span<const Subscription> subscriptions() const noexcept { return routes_.subscriptions(); }

  bool is_used(Identifier identifier) const noexcept override { return routes_.is_used(identifier); }
  void take(Identifier identifier) noexcept override { routes_.use(identifier); }
  void on_identifiers_changed() noexcept override;

 private:
  /// Takes what no living service takes.
  class Nobody final : public Service {
   public:
    explicit Nobody(Context& context) noexcept : Service{context} {}
  };
  struct Registered {
    Service* service = nullptr;
    ServiceFacts facts{};
    std::size_t first_timer = 0;
    bool started = false;
  };

  bool lives(const Registered& registered) const noexcept {
    return registered.facts.lives_in.contains(context_.state);
  }
  /// A node without a node-ID has no services but those that live in Unconfigured.
  bool takes_part(const Registered& registered) const noexcept {
    return context_.dictionary.node_id() != kNoNodeId ||
           registered.facts.lives_in.contains(NmtState::Unconfigured);
  }
  void on_rare_frame(const Frame& frame) noexcept;
  void reload(Reload how, ReloadStage stage) noexcept;
  bool lay_routes() noexcept;

  Context& context_;
  Nobody nobody_;
  std::array<Service*, kMost + 1> living_{};  ///< by place; place 0 and those that do not live: nobody
  std::vector<Registered> services_;          ///< the first has place 1
  std::vector<std::uint8_t> timer_owners_;    ///< places
  bool reloading_ = false;                    ///< identifiers change, the routes wait
  Routes routes_;
};

}  // namespace canopen
