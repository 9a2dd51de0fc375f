#pragma once

#include <limits>
#include <memory>

#include <nats/nats.h>

namespace nats {

/// Destroys what the library has made.
template <auto kDestroy>
struct Destroyer {
  template <class T>
  void operator()(T* object) const noexcept {
    kDestroy(object);
  }
};

/// Messages and bytes that may wait in a subscription: losing one in silence is worse than any memory.
inline constexpr int kNoLimit = std::numeric_limits<int>::max();

using Options = std::unique_ptr<natsOptions, Destroyer<natsOptions_Destroy>>;
using Connection = std::unique_ptr<natsConnection, Destroyer<natsConnection_Destroy>>;
using Subscription = std::unique_ptr<natsSubscription, Destroyer<natsSubscription_Destroy>>;
using Message = std::unique_ptr<natsMsg, Destroyer<natsMsg_Destroy>>;
using JetStream = std::unique_ptr<jsCtx, Destroyer<jsCtx_Destroy>>;
using StreamInfo = std::unique_ptr<jsStreamInfo, Destroyer<jsStreamInfo_Destroy>>;
using ConsumerInfo = std::unique_ptr<jsConsumerInfo, Destroyer<jsConsumerInfo_Destroy>>;

}  // namespace nats
