/* A host that has functions of its own under names of the system. None of
 * them may ever be called by the library. `run.sh` writes the list of names:
 * those that the library refers to, and some that hosts are fond of. With
 * NAMES_ONLY the functions make a shared library that a host brings along. */
#include <stdio.h>
#include <stdlib.h>
#include "use.h"

#define NAME(name)                                                        \
    void name(void)                                                       \
    {                                                                     \
        fputs("the library called the host's function " #name "\n", stderr); \
        abort();                                                          \
    }
#include "hostile_names.h"

#ifndef NAMES_ONLY
int main(int count, char **words)
{
    (void)count;
    if (use_library(words[1]) != 0) return 1;
    puts("well");
    return 0;
}
#endif
