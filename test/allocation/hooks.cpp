// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "hooks.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>

#include "sanitized.hpp"

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

// Of a failure: what was asked for, and the block that its thread had got right before, null once it is freed.
struct Record
{
    std::atomic<size_t> size;
    std::atomic<void*> blockBefore;
};

constexpr long RECORDS = 64;  // where all allocations fail a call is over after a few
Record records[RECORDS];
std::atomic<long> recorded{0};
std::atomic<long> madeBefore{0};  // failAfter()

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
    if (count > 0) {
        madeBefore = made();
        recorded = 0;
    }
    firstFailure = first;
}

bool failed()
{
    return firstFailure > 0 && allocations >= firstFailure;
}

std::vector<Failure> failures()
{
    std::vector<Failure> all;
    for (long k = 0; k < std::min(recorded.load(), RECORDS); ++k)
        all.push_back({records[k].size, records[k].blockBefore != nullptr});
    return all;
}

}  // namespace allocation

#if !CANNOT_COUNT

namespace {

thread_local void* latestBlock = nullptr;  // of this thread,
thread_local long latestNumber = 0;        // got when so many allocations had been made

void record(size_t size)
{
    const long at = recorded++;
    if (at >= RECORDS)
        return;
    records[at].size = size;
    records[at].blockBefore = latestNumber > madeBefore ? latestBlock : nullptr;
    latestBlock = nullptr;
}

bool fails(size_t size)
{
    const long number = ++allocations;
    if (firstFailure == 0 || number < firstFailure || number > lastFailure)
        return false;
    record(size);
    errno = ENOMEM;
    return true;
}

void keep(void* block)
{
    latestBlock = block;
    latestNumber = allocations;
}

void* counted(void* block)
{
    liveBlocks += block != nullptr;
    keep(block);
    return block;
}

void forget(void* block)
{
    if (latestBlock == block)
        latestBlock = nullptr;
    for (long k = 0; k < std::min(recorded.load(), RECORDS); ++k) {
        void* expected = block;
        records[k].blockBefore.compare_exchange_strong(expected, nullptr);
    }
}

}  // namespace

extern "C" {
void* malloc(size_t size)
{
    return fails(size) ? nullptr : counted(__libc_malloc(size));
}
void* calloc(size_t nmemb, size_t size)
{
    return fails(nmemb * size) ? nullptr : counted(__libc_calloc(nmemb, size));
}
void* realloc(void* ptr, size_t size)
{
    if (fails(size))
        return nullptr;
    forget(ptr);
    void* const moved = __libc_realloc(ptr, size);
    keep(moved);
    liveBlocks += (ptr == nullptr && moved != nullptr) - (ptr != nullptr && size == 0);
    return moved;
}
int posix_memalign(void** memptr, size_t alignment, size_t size)
{
    *memptr = fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
    return *memptr ? 0 : ENOMEM;
}
void* aligned_alloc(size_t alignment, size_t size)
{
    return fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
}
void* memalign(size_t alignment, size_t size)
{
    return fails(size) ? nullptr : counted(__libc_memalign(alignment, size));
}
void free(void* ptr)
{
    liveBlocks -= ptr != nullptr;
    forget(ptr);
    __libc_free(ptr);
}
}

#endif
