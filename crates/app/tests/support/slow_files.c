/* A slow file system, by LD_PRELOAD: every call waits a random while before and after, so that programs that start at
   once meet each other between any two of their calls.

   SLOW_FILES_SEED   of the random waits
   SLOW_FILES_US     longest wait [microseconds]
   SLOW_FILES_START  the program waits at its start until this file is there
   SLOW_FILES_SPREAD_US  and then a random while, at most this [microseconds]
   SLOW_FILES_END    once the folder holds a `summary.json`, the sync of the folder waits until this file is there: so the
                     first run that publishes is still at work when the last one comes
   SLOW_FILES_FAIL_SYNC  the sync of a folder that holds a file of this name fails */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

static _Atomic uint64_t state;
static uint64_t longest_us;

static void pause_us(uint64_t us)
{
    struct timespec t = { (time_t)(us / 1000000), (long)(us % 1000000) * 1000 };
    nanosleep(&t, NULL);
}

static void wait_for(const char *variable)
{
    const char *path = getenv(variable);
    struct stat there;
    /* A minute at most: a test that fails leaves no program behind. */
    for (int i = 0; path != NULL && stat(path, &there) != 0 && i < 60000; i++)
        pause_us(1000);
}

static uint64_t number_of(const char *variable)
{
    const char *text = getenv(variable);
    return text ? strtoull(text, NULL, 10) : 0;
}

/* SplitMix64. */
static uint64_t drawn(void)
{
    uint64_t x = state + 0x9e3779b97f4a7c15ULL;
    state = x;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

static void slow(void)
{
    uint64_t x = drawn();
    /* Two of three calls are as fast as ever: else all would be slow alike. */
    if (longest_us > 0 && x % 3 == 0)
        pause_us((x >> 8) % longest_us);
}

__attribute__((constructor)) static void begin(void)
{
    state = number_of("SLOW_FILES_SEED") * 1000003ULL + (uint64_t)getpid();
    longest_us = number_of("SLOW_FILES_US");
    uint64_t spread_us = number_of("SLOW_FILES_SPREAD_US");
    wait_for("SLOW_FILES_START");
    if (spread_us > 0)
        pause_us(drawn() % spread_us);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define SLOWED(type, call)   \
    do {                     \
        slow();              \
        type result_ = call; \
        slow();              \
        return result_;      \
    } while (0)

static mode_t mode_of(int flags, va_list list)
{
    return (flags & (O_CREAT | O_TMPFILE)) ? va_arg(list, mode_t) : 0;
}

int open(const char *path, int flags, ...)
{
    va_list list;
    va_start(list, flags);
    mode_t mode = mode_of(flags, list);
    va_end(list);
    SLOWED(int, REAL(open)(path, flags, mode));
}

int open64(const char *path, int flags, ...)
{
    va_list list;
    va_start(list, flags);
    mode_t mode = mode_of(flags, list);
    va_end(list);
    SLOWED(int, REAL(open64)(path, flags, mode));
}

int rename(const char *from, const char *to) { SLOWED(int, REAL(rename)(from, to)); }
int unlink(const char *path) { SLOWED(int, REAL(unlink)(path)); }
int flock(int fd, int how) { SLOWED(int, REAL(flock)(fd, how)); }
int ftruncate(int fd, off_t size) { SLOWED(int, REAL(ftruncate)(fd, size)); }
int ftruncate64(int fd, off64_t size) { SLOWED(int, REAL(ftruncate64)(fd, size)); }

ssize_t write(int fd, const void *bytes, size_t count)
{
    if (fd <= 2)
        return REAL(write)(fd, bytes, count);
    SLOWED(ssize_t, REAL(write)(fd, bytes, count));
}

int close(int fd)
{
    if (fd <= 2)
        return REAL(close)(fd);
    SLOWED(int, REAL(close)(fd));
}

int fsync(int fd)
{
    struct stat there;
    if (fstat(fd, &there) == 0 && S_ISDIR(there.st_mode)) {
        if (fstatat(fd, "summary.json", &there, AT_SYMLINK_NOFOLLOW) == 0)
            wait_for("SLOW_FILES_END");
        const char *fail = getenv("SLOW_FILES_FAIL_SYNC");
        if (fail != NULL && fstatat(fd, fail, &there, AT_SYMLINK_NOFOLLOW) == 0) {
            errno = EIO;
            return -1;
        }
    }
    /* Not carried out: what tests write need not outlive a power cut, and a thousand rounds would wear a disk. */
    SLOWED(int, 0);
}
