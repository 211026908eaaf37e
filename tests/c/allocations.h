/*
 * This program's malloc and its kin, in the place of the C library's: they count,
 * and any one of them can be made to fail, once or from then on. To be included by
 * one file of a program.
 */
#ifndef ALLOCATIONS_H
#define ALLOCATIONS_H

#include <errno.h>
#include <stddef.h>

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *old, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);
extern void __libc_free(void *old);

static long blocks;          /* allocated and not freed */
static long asked;           /* allocations since the countdown was set */
static long fail_at = -1;    /* the allocation that fails, counted from 0 */
static int fail_forever;     /* and all that follow */

static int refused(void)
{
    long number = asked++;
    if (fail_at < 0 || number < fail_at || (number > fail_at && !fail_forever))
        return 0;
    errno = ENOMEM;
    return 1;
}

static void *counted(void *made)
{
    blocks += made != NULL;
    return made;
}

void *malloc(size_t size)
{
    return refused() ? NULL : counted(__libc_malloc(size));
}

void *calloc(size_t count, size_t size)
{
    return refused() ? NULL : counted(__libc_calloc(count, size));
}

void *realloc(void *old, size_t size)
{
    void *made;
    if (refused())
        return NULL;
    made = __libc_realloc(old, size);
    if (old == NULL)
        counted(made);
    return made;
}

void *memalign(size_t alignment, size_t size)
{
    return refused() ? NULL : counted(__libc_memalign(alignment, size));
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return memalign(alignment, size);
}

int posix_memalign(void **made, size_t alignment, size_t size)
{
    void *block = memalign(alignment, size);
    if (block == NULL)
        return ENOMEM;
    *made = block;
    return 0;
}

void free(void *old)
{
    blocks -= old != NULL;
    __libc_free(old);
}

#endif
