// Included before a file, it makes every name that only Linux has an error, as on macOS. The
// headers of POSIX are included first, since they define such names.
#pragma once

#include <cstddef>  // libc++'s configuration, before __linux__ is undefined

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/types.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>
#include <wchar.h>

// Names that may be used where they are defined.
#undef __linux__
#undef __linux
#undef linux
#undef __gnu_linux__
#undef MSG_NOSIGNAL
#undef MADV_HUGEPAGE
#undef MAP_POPULATE
#define SO_NOSIGPIPE 0x1022  // macOS's

#undef SOCK_CLOEXEC
#undef SOCK_NONBLOCK
#undef O_PATH
#undef O_TMPFILE
#undef CPU_COUNT
#undef CPU_SET
#pragma GCC poison SOCK_CLOEXEC SOCK_NONBLOCK O_PATH O_TMPFILE CPU_COUNT CPU_SET
#pragma GCC poison pipe2 accept4 dup3 prctl PR_SET_PDEATHSIG clock_getcpuclockid clock_nanosleep
#pragma GCC poison memfd_create execvpe secure_getenv getrandom ppoll pidfd_open close_range
#pragma GCC poison sched_getaffinity sched_setaffinity pthread_setaffinity_np gettid get_nprocs
#pragma GCC poison epoll_create1 epoll_wait inotify_init1 eventfd signalfd timerfd_create sysinfo
#pragma GCC poison fallocate posix_fallocate sendfile recvmmsg sendmmsg mremap sigtimedwait
#pragma GCC poison strchrnul mempcpy memrchr canonicalize_file_name program_invocation_name
