#pragma once

namespace preload {

/// Whether none of the running threads will wait soon, so that the next may go on beside them: each computes for
/// long, or is blocked in a call that this library does not see. To be asked every few milliseconds; goes by
/// processor time and by what the kernel says, so that a busy machine changes nothing.
bool are_runners_stuck() noexcept;

}  // namespace preload
