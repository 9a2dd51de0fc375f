#pragma once

#include <cstddef>
#include <cstdint>

#include <linux/can.h>
#include <linux/can/bcm.h>
#include <linux/can/raw.h>

/// What goes over the socket between the hub of a user-space CAN bus and one member of it
/// (docs/explanation/user-space-bus.md).
///
/// A member is an AF_UNIX SOCK_SEQPACKET connection to the hub's path. It binds its own end, before it connects,
/// to the abstract name "can-bus.1/KIND/" with 16 hexadecimal digits of its own choice behind; so whoever holds
/// the descriptor, the hub and a program that inherited it included, can tell from the kernel what it is.
///
/// From member to hub: a message that carries a descriptor (SCM_RIGHTS) is a Request, whose Reply goes to that
/// descriptor and nowhere else. Any other message is a frame of 16 bytes for the interface the member is bound to,
/// or a frame with a Trailer behind that names the interface.
/// From hub to member: a frame of 16 bytes and a Trailer; for a member of kind BroadcastManager a bcm_msg_head,
/// its frames, and a Trailer. All numbers are in the byte order of the machine: the bus does not leave it.
/// Where both ends have said in Hello that they take such, a message is several frames with a Trailer each, one
/// behind the other.
namespace userbus {

/// How every member's own name begins, behind the zero byte of the abstract name space; the digit is the version.
inline constexpr char kNamePrefix[] = "can-bus.1/";
/// Hexadecimal digits at the end of a member's name.
inline constexpr size_t kNameDigits = 16;
/// Longest path of a bus (bytes, without the final zero): sun_path of struct sockaddr_un.
inline constexpr size_t kLongestPath = 107;

/// What a member is: the third part of its name.
enum class Kind : uint8_t {
  Raw,               ///< "raw": CAN_RAW
  BroadcastManager,  ///< "bcm": CAN_BCM
  Port,   ///< "port": as Raw, of a program that knows these messages; the preload library leaves it alone
  Down,   ///< "down": no member any more; stands in for a socket whose hub has gone
  Clock,  ///< "clock": a program's part in the time of the bus (can/userbus/time.hpp)
};
inline constexpr const char* kKindNames[] = {"raw", "bcm", "port", "down", "clock"};

/// Behind every frame and every message of the broadcast manager.
struct Trailer {
  int32_t
      interface_index;  ///< which interface the receiver sees it on; to the hub: where to send it, 0 = as bound
  uint32_t flags;       ///< MSG_DONTROUTE: sent on this machine; MSG_CONFIRM: sent by this very socket; kLinkDown,
                        ///< kLinkUp: the message is no frame but tells of the bus's link; for bridges
                        ///< from kOriginShift on the number that the frame got from hub `origin`
  int64_t time_ns;   ///< end of the frame on the bus, CLOCK_REALTIME; to the hub of a bus with virtual time: when
                     ///< it is sent, on the bus's CLOCK_MONOTONIC, 0 = now
  uint32_t dropped;  ///< messages this member has lost so far because it did not read
  uint32_t origin;   ///< for bridges: the hub on which the frame came up, 0 = that of the receiver; else 0
};
/// First bit of the number of a frame in Trailer::flags.
inline constexpr unsigned kOriginShift = 12;
static_assert(sizeof(Trailer) == 24);

/// In Trailer::flags of a message whose frame is CAN_ERR_FLAG with 8 bytes of zero: the bus is cut from the rest
/// of it, what is sent is lost until it is whole again.
inline constexpr uint32_t kLinkDown = 1;
/// Likewise: the bus is whole again. Told to members of kind Port only.
inline constexpr uint32_t kLinkUp = 2;
/// Size of the memory that Operation::Link passes (bytes): a uint32_t at its beginning is 1 while the bus is
/// whole, else 0.
inline constexpr size_t kLinkPageSize = 4096;

/// A frame as the hub sends it.
struct FrameMessage {
  can_frame frame;
  Trailer trailer;
};
static_assert(sizeof(FrameMessage) == 40 && offsetof(FrameMessage, trailer) == sizeof(can_frame));

/// Most frames that the hub sends and takes in one message, where that is agreed upon (Operation::Hello).
inline constexpr size_t kMostFrames = 32;

/// Most frames in a message of the broadcast manager (the kernel's MAX_NFRAMES).
inline constexpr size_t kMostBcmFrames = 256;
/// Room that holds every message, trailer and header included.
inline constexpr size_t kLongestMessage = 8192;

/// What a member asks of the hub. `value` and payload go in the Request, and come back in the Reply.
enum class Operation : uint32_t {
  Hello,  ///< the first request of a member; value 1: it is a bridge of another hub, whose frames carry where they
          ///< came from in both directions; payload, if any: uint32_t, frames that a message to this member may
          ///< have; reply value: bit rate of the bus, 0 = none; reply payload, if the request had one: uint32_t,
          ///< frames that a message to the hub may have; without it, and from an older hub: 1 in both directions
  Bind,   ///< value: interface index, 0 = all; ENODEV if there is none
  ReadState,       ///< reply payload: MemberState
  SetOption,       ///< payload: Option
  SetFilters,      ///< payload: 0 to CAN_RAW_FILTER_MAX struct can_filter
  ReadFilters,     ///< reply payload: the filters
  InterfaceIndex,  ///< payload: name without final zero; reply value: its index; ENODEV if it is no name of a CAN
  InterfaceName,   ///< value: index; reply payload: the name without final zero; ENODEV
  Interfaces,      ///< reply payload: struct InterfaceEntry each
  Broadcast,   ///< a message for the broadcast manager; value: interface index, 0 = as bound; payload: the message
  Statistics,  ///< value: members to leave out at the beginning; reply payload: BusStatistics, then one
               ///< MemberStatistics a member, as many as fit in a message
  Inject,      ///< the faults of the bus; payload: JSON, {"method": ..., "params": ...}; reply payload: JSON, the
               ///< result; with EINVAL {"message": ...}, and nothing from a hub without faults
  Link,   ///< whether the bus goes on beyond this hub: with the reply comes a descriptor of kLinkPageSize bytes
          ///< of memory to be mapped for reading; reply value: 1 = the bus is whole, 0 = it is cut; EOPNOTSUPP
          ///< from a hub whose bus ends with it
  Trunk,  ///< what is known of the way to other hosts; reply payload: JSON; EOPNOTSUPP likewise
  Time,   ///< whose time the bus has; with the reply comes a descriptor of kTimePageSize bytes of memory to be
          ///< mapped for reading, a TimePage; none if it is the machine's
  Step,   ///< payload: int64_t, ns by which stepped time may go on; answered when it has, with the present
          ///< (int64_t, ns) as payload; EOPNOTSUPP if the bus's time is not stepped
};

/// Options of a member that are numbers.
enum class OptionName : uint32_t {
  Loopback,      ///< CAN_RAW_LOOPBACK, at first 1
  OwnMessages,   ///< CAN_RAW_RECV_OWN_MSGS, at first 0
  ErrorFilter,   ///< CAN_RAW_ERR_FILTER, at first 0
  JoinFilters,   ///< CAN_RAW_JOIN_FILTERS, at first 0
  FdFrames,      ///< CAN_RAW_FD_FRAMES, at first 0: kept for getsockopt, the bus has classical frames only
  Timestamps,    ///< which SO_TIMESTAMP… option is on: kept for those who inherit the socket
  CountDropped,  ///< SO_RXQ_OVFL: kept likewise
};
inline constexpr size_t kOptionCount = 7;

struct Option {
  OptionName name;
  uint32_t value;
};

/// A request is this and `size` bytes of payload behind, in one message.
struct Request {
  Operation operation;
  int32_t value;
  uint32_t size;  ///< of the payload (bytes)
};

/// A reply is this and `size` bytes of payload behind, in one message.
struct Reply {
  int32_t error;  ///< errno, 0 = done
  int32_t value;
  uint32_t size;  ///< of the payload (bytes)
};

/// What the hub knows of a member.
struct MemberState {
  int32_t interface_index;         ///< that it is bound to; 0 = all, -1 = not bound yet
  uint32_t bit_rate;               ///< of the bus (bit/s), 0 = frames take no time
  uint32_t options[kOptionCount];  ///< by OptionName
  uint32_t dropped;
};

struct InterfaceEntry {
  int32_t index;
  char name[16];
};

struct BusStatistics {
  uint64_t frames;    ///< that went over the bus
  uint32_t bit_rate;  ///< bit/s, 0 = frames take no time
  uint32_t members;   ///< bridges included
};

struct MemberStatistics {
  char name[32];    ///< kind, or URL of a bridge
  int32_t process;  ///< process identifier, 0 = unknown
  int32_t interface_index;
  uint64_t sent;  ///< frames; for the broadcast manager: its requests
  uint64_t received;
  uint64_t dropped;  ///< because it did not read
  uint64_t refused;  ///< messages of it that were no frames, or for no interface
};

/// Exit status of `canhub --on-demand`.
enum class StartStatus : int {
  Served = 0,  ///< the path is being served, by this hub or by another that was faster
  Failed = 1,  ///< no socket, no memory, no such folder
  Usage = 2,
  InUse = 3,      ///< something that is no bus is at the path
  Different = 4,  ///< a hub serves the path, but with another bit rate or another time
};

}  // namespace userbus
