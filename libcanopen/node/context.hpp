#pragma once

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/base/time.hpp"
#include "libcanopen/base/timer_queue.hpp"
#include "libcanopen/nmt/control.hpp"
#include "libcanopen/node/application.hpp"
#include "libcanopen/node/communication_error.hpp"
#include "libcanopen/node/policy.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/pdo/pdo_cycle.hpp"
#include "libcanopen/sdo/sdo_view.hpp"

namespace canopen {

class ServiceList;

/// What every service of a node works with.
struct Context {
  FrameSink* sink = nullptr;
  Dictionary& dictionary;
  Application& application;
  const Policy& policy;
  TimerQueue& timers;
  ServiceList& services;
  IdentifierUse& identifiers;
  ErrorReports& errors;
  NmtControl& nmt;
  SdoView* view = nullptr;  ///< what the SDO servers show; nullptr: the dictionary
  TimePoint now{};          ///< the time that the owner told with the event being handled
  PdoCycle pdo_cycle{};     ///< what event-driven TPDOs are judged in
  NmtState state = NmtState::Initialising;
  std::uint8_t pending_node_id = dictionary.node_id();  ///< from the next reset on (CiA 305), or kNoNodeId
  bool answer_deferred = false;  ///< by the owner of what is being written (Node::defer_answer())
};

}  // namespace canopen
