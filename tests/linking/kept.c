/* A host that opens the library at run time and closes it again. The code
 * must stay: Xt still holds pointers to it. */
#include <dlfcn.h>
#include <stdio.h>

int main(int count, char **words)
{
    void *library = dlopen(words[1], RTLD_NOW | RTLD_LOCAL);
    const char *(*version)(void);

    (void)count;
    if (!library) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    *(void **)&version = dlsym(library, "v_version");
    if (!version || !version()) return 2;
    if (dlclose(library) != 0) return 3;
    if (!version()) return 4;
    puts("well");
    return 0;
}
