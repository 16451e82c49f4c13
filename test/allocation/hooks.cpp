// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "hooks.hpp"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>

#if defined(__has_feature)  // clang's way to say so
#define SANITIZED (__has_feature(address_sanitizer) || __has_feature(thread_sanitizer))
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#else
#define SANITIZED 0
#endif

#if SANITIZED || !defined(__GLIBC__)
#define CANNOT_COUNT 1
#else
#define CANNOT_COUNT 0
// NOLINTBEGIN(bugprone-reserved-identifier): names of the library, by which its own functions are still reached.
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* block, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
void __libc_free(void* block);
}
// NOLINTEND(bugprone-reserved-identifier)
#endif

namespace {

std::atomic<long> allocations{0}, liveBlocks{0}, firstFailure{0}, lastFailure{0};
std::atomic<size_t> sizeOfFailure{0};

}  // namespace

namespace allocation {

bool counted()
{
    return !CANNOT_COUNT;
}

long made()
{
    return allocations;
}

long live()
{
    return liveBlocks;
}

void failAfter(long count, bool onwards)
{
    const long first = count > 0 ? allocations + count : 0;
    lastFailure = onwards ? LONG_MAX : first;
    firstFailure = first;
}

bool failed()
{
    return firstFailure > 0 && allocations >= firstFailure;
}

size_t failedSize()
{
    return sizeOfFailure;
}

}  // namespace allocation

#if !CANNOT_COUNT

namespace {

bool fails(size_t size)
{
    const long number = ++allocations;
    if (firstFailure == 0 || number < firstFailure || number > lastFailure)
        return false;
    if (number == firstFailure)
        sizeOfFailure = size;
    errno = ENOMEM;
    return true;
}

void* counted(void* block)
{
    liveBlocks += block != nullptr;
    return block;
}

}  // namespace

extern "C" {
void* malloc(size_t size)
{
    return fails(size) ? nullptr : counted(__libc_malloc(size));
}
void* calloc(size_t count, size_t size)
{
    return fails(count * size) ? nullptr : counted(__libc_calloc(count, size));
}
void* realloc(void* block, size_t size)
{
    if (fails(size))
        return nullptr;
    void* const moved = __libc_realloc(block, size);
    liveBlocks += (block == nullptr && moved != nullptr) - (block != nullptr && size == 0);
    return moved;
}
int posix_memalign(void** block, size_t alignment, size_t size)
{
    *block = fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
    return *block ? 0 : ENOMEM;
}
void* aligned_alloc(size_t alignment, size_t size)
{
    return fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
}
void* memalign(size_t alignment, size_t size)
{
    return fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
}
void free(void* block)
{
    liveBlocks -= block != nullptr;
    __libc_free(block);
}
}

#endif
