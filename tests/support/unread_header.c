/* Preloaded into a program, or a part of one, it lets libnats have no memory where it is asked for the header that
   is named by UNREAD_HEADER. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <nats/nats.h>
#include <stdlib.h>
#include <string.h>

natsStatus natsMsgHeader_Get(natsMsg* message, const char* key, const char** value) {
  const char* const unread = getenv("UNREAD_HEADER");
  if (unread != NULL && strcmp(key, unread) == 0) return NATS_NO_MEMORY;
  return ((natsStatus(*)(natsMsg*, const char*, const char**))dlsym(RTLD_NEXT, "natsMsgHeader_Get"))(message, key,
                                                                                                     value);
}
