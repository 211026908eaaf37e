/* A host as ordinary as can be; as C++ too. */
#include <stdio.h>
#include "use.h"

int main(int count, char **words)
{
    (void)count;
    if (use_library(words[1]) != 0) return 1;
    puts("well");
    return 0;
}
