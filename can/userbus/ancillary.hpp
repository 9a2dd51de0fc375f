#pragma once

#include <cstring>

#include <sys/socket.h>

namespace userbus {

/// Control data of one descriptor.
union Ancillary {
  cmsghdr header;
  char room[CMSG_SPACE(sizeof(int))];
};

/// Has @p message receive a descriptor into @p ancillary.
inline void receive_with(msghdr& message, Ancillary& ancillary) noexcept {
  memset(&ancillary, 0, sizeof ancillary);
  message.msg_control = ancillary.room;
  message.msg_controllen = sizeof ancillary.room;
}

/// Has @p message carry @p descriptor; @p ancillary lives until it is sent.
inline void carry(msghdr& message, Ancillary& ancillary, int descriptor) noexcept {
  receive_with(message, ancillary);
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof descriptor);
  memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
}

/// The descriptor that came with @p message, -1 if none did.
inline int carried(msghdr& message) noexcept {
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  if (header == nullptr || header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) return -1;
  int descriptor = -1;
  memcpy(&descriptor, CMSG_DATA(header), sizeof descriptor);
  return descriptor;
}

}  // namespace userbus
