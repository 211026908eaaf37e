/* The library's own way to the functions of the system.
 *
 * A host may define a global function `read`, `pause` or `round`: standard C
 * keeps none of these names from it. The linker would then lead our calls of
 * the system's function, and those of Rust's standard library, to the host's.
 * So every call of such a name goes to a stub of ours instead, and the stub to
 * the address that the C library itself gives for the name.
 *
 * `libraries.sh` finds the names, writes the list SYSTEM_NAMES and compiles
 * this file with it; the stubs become local to the library.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <gnu/lib-names.h>
#include SYSTEM_NAMES

/* Where each stub leads. Until `find` has run, and in a program without any
 * shared library, that is what the name means in the program as a whole. */
#define NAME(name)                                                            \
    extern void plain_##name(void) __asm__(#name);                            \
    __attribute__((visibility("hidden"))) void (*vides_to_##name)(void) =     \
        plain_##name;
EACH_SYSTEM_NAME
#undef NAME

/* A bare jump: arguments, results and the stack stay as the caller left them,
 * whatever the function's type. */
#if defined(__x86_64__)
#define JUMP(slot) "endbr64\n\tjmp *" slot "(%rip)\n"
#elif defined(__aarch64__)
#define JUMP(slot)                                                            \
    "bti c\n\tadrp x16, " slot "\n\tldr x16, [x16, :lo12:" slot "]\n\tbr x16\n"
#elif defined(__riscv) && __riscv_xlen == 64
#define JUMP(slot) "la t1, " slot "\n\tld t1, 0(t1)\n\tjr t1\n"
#else
#error "system_names.c: no stub is written for this processor yet"
#endif

#define NAME(name)                                                            \
    __asm__(".text\n.balign 16\n"                                             \
            ".globl vides_" #name "\n.hidden vides_" #name "\n"               \
            ".type vides_" #name ", %function\n"                              \
            "vides_" #name ":\n\t.cfi_startproc\n\t"                          \
            JUMP("vides_to_" #name)                                           \
            "\t.cfi_endproc\n.size vides_" #name ", .-vides_" #name "\n");
EACH_SYSTEM_NAME
#undef NAME

/* Weak: a fully static program may have none, and no host's name to fear either.
 * `dlopen` is asked for by name, since the linker warns of every static program
 * that mentions it. */
extern __typeof__(dlsym) dlsym __attribute__((weak));

static const struct {
    const char *name;
    void (**slot)(void);
} names[] = {
#define NAME(name) {#name, &vides_to_##name},
    EACH_SYSTEM_NAME
#undef NAME
};

/* Before any other constructor that may already call the library (the
 * priorities up to 100 belong to the system). */
__attribute__((constructor(101))) static void find(void) {
    void *library[2];
    void *(*open)(const char *, int);
    unsigned i, k;

    if (!dlsym) return;
    open = (void *(*)(const char *, int))dlsym(RTLD_DEFAULT, "dlopen");
    if (!open) return;
    library[0] = open(LIBC_SO, RTLD_LAZY | RTLD_NOLOAD);
    if (!library[0]) return;
    /* Not there yet where the host has all the names that we call in it. */
    library[1] = open(LIBM_SO, RTLD_LAZY);
    for (i = 0; i < sizeof names / sizeof *names; i++) {
        for (k = 0; k < 2; k++) {
            void *address = library[k] ? dlsym(library[k], names[i].name) : 0;
            if (address) {
                *names[i].slot = (void (*)(void))address;
                break;
            }
        }
    }
}
