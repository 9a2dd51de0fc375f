#pragma once

namespace preload {

/// The program is writing to @p descriptor, which is no CAN socket: whether others may find it there.
void note_writing(int descriptor) noexcept;

/// The program is about to close @p descriptor, at whose other end somebody may wait for that.
void note_closing(int descriptor) noexcept;

/// Whether anything has been written past the wrapped calls, as stdio does, since this was asked last; false if
/// all that it could have come to is files.
bool has_unseen_writes() noexcept;

/// From now on stdio may write to a pipe that the program has opened itself.
void expect_unseen_writes() noexcept;

/// In a new process.
void begin_to_see_writes() noexcept;

}  // namespace preload
