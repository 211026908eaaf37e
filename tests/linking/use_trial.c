/* What a host does with the trial library. */
#include <stdio.h>
#include "use.h"

extern int v_trial_panic(void);
extern int v_trial_system(const char *folder);

int use_library(const char *folder)
{
    if (v_trial_panic() != 2) {
        fputs("a panic was not caught\n", stderr);
        return 1;
    }
    return v_trial_system(folder);
}
