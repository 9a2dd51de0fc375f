#pragma once

#include "libcanopen/application/application.hpp"
#include "libcanopen/application/policy.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/identifier_use.hpp"
#include "libcanopen/base/time.hpp"
#include "libcanopen/base/timer_queue.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/service/error_reports.hpp"
#include "libcanopen/service/nmt_control.hpp"

namespace canopen {

class SdoView;
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
  NmtState state = NmtState::Initialising;
  std::uint8_t pending_node_id = dictionary.node_id();  ///< from the next reset on (CiA 305), or kNoNodeId
  bool answer_deferred = false;  ///< by the owner of what is being written (Node::defer_answer())
};

}  // namespace canopen
