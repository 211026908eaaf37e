/* A host with two Rust libraries in it. */
#include <stdio.h>
#include "use.h"

extern int other_rust(int number);

int main(int count, char **words)
{
    if (other_rust(count) != 7) return 1;
    if (use_library(words[1]) != 0) return 2;
    if (other_rust(count) != 7) return 3;
    puts("well");
    return 0;
}
