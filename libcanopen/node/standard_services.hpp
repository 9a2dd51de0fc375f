#pragma once

#include <optional>

#include "libcanopen/emcy/emcy_producer.hpp"
#include "libcanopen/emcy/error_keeper.hpp"
#include "libcanopen/nmt/duplicate_watch.hpp"
#include "libcanopen/nmt/error_behaviour.hpp"
#include "libcanopen/nmt/heartbeat_consumer.hpp"
#include "libcanopen/nmt/heartbeat_producer.hpp"
#include "libcanopen/nmt/nmt_slave.hpp"
#include "libcanopen/nmt/node_guarding.hpp"
#include "libcanopen/pdo/receive_pdos.hpp"
#include "libcanopen/pdo/transmit_pdos.hpp"
#include "libcanopen/sdo/servers.hpp"
#include "libcanopen/storage/storage_objects.hpp"
#include "libcanopen/sync/sync_consumer.hpp"
#include "libcanopen/sync/sync_watch.hpp"
#include "libcanopen/time/time_consumer.hpp"

namespace canopen {

/// The services that every node has, in the order in which they register (see Service).
struct StandardServices {
  explicit StandardServices(Context& context)
      : nmt{context},
        sync{context},
        time{context},
        guarding{context},
        heartbeat{context},
        emcy{context},
        errors{context, emcy},
        sdo{context},
        duplicates{context},
        heartbeats{context},
        receive{context},
        transmit{context},
        error_behaviour{context.dictionary},
        storage{context} {
    if (context.policy.sync_supervision) sync.tell(sync_watch.emplace(context));
    const bool receives_first = context.policy.sync_order == SyncOrder::ReceiveFirst;
    if (receives_first) sync.tell(receive);
    sync.tell(transmit);
    if (!receives_first) sync.tell(receive);
  }

  NmtSlave nmt;
  SyncConsumer sync;
  TimeConsumer time;
  NodeGuarding guarding;
  HeartbeatProducer heartbeat;
  EmcyProducer emcy;
  ErrorKeeper errors;
  SdoServers sdo;
  DuplicateWatch duplicates;
  HeartbeatConsumer heartbeats;
  ReceivePdos receive;
  TransmitPdos transmit;
  std::optional<SyncWatch> sync_watch;  ///< if the policy wants it
  // Owners of objects, which need no more than the dictionary.
  ErrorBehaviour error_behaviour;
  StorageObjects storage;
};

}  // namespace canopen
