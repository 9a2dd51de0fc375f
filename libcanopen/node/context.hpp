#pragma once

#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"
#include "libcanopen/base/timer_queue.hpp"
#include "libcanopen/nmt/state.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// What every service of a node works with.
struct Context {
  FrameSink& sink;
  Dictionary& dictionary;
  TimerQueue& timers;
  TimePoint now{};  ///< the time that the owner told with the event being handled
  NmtState state = NmtState::Initialising;
};

}  // namespace canopen
