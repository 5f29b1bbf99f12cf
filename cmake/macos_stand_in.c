/* What a Mac's own library has, for the build on Linux that shows whether a Mac's files compile, and work: see ./dev macos. */

#include <stdint.h>
#include <unistd.h>

/* NOLINTNEXTLINE(bugprone-reserved-identifier): a Mac has it so */
int _NSGetExecutablePath(char* path, uint32_t* size);
int _NSGetExecutablePath(char* path, uint32_t* size) {
    const ssize_t length = readlink("/proc/self/exe", path, *size - 1);
    if (length < 0) return -1;
    path[length] = 0;
    return 0;
}
