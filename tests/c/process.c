/*
 * Nothing process-wide is changed by any kind of call: signal actions and mask,
 * locale, environment, the number of open descriptors, standard output.
 *
 * The program's argument is a folder that it may write to.
 */
#include <fcntl.h>
#include <locale.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "check.h"

extern char **environ;

#define SIGNALS 32

struct process {
    struct sigaction actions[SIGNALS];
    sigset_t mask;
    char locale[200];
    char environment[20000];
    int descriptors;
    off_t written;
};

static void look(struct process *p)
{
    size_t used = 0;
    char **entry;
    int i;
    struct stat out;
    memset(p, 0, sizeof *p);
    for (i = 1; i < SIGNALS; i++)
        sigaction(i, NULL, &p->actions[i]);
    sigprocmask(SIG_BLOCK, NULL, &p->mask);
    strncpy(p->locale, setlocale(LC_ALL, NULL), sizeof p->locale - 1);
    for (entry = environ; *entry && used + strlen(*entry) + 2 < sizeof p->environment; entry++)
        used += (size_t)sprintf(p->environment + used, "%s\n", *entry);
    for (i = 0; i < 256; i++)
        p->descriptors += fcntl(i, F_GETFD) >= 0;
    CHECK(fflush(stdout) == 0 && fstat(STDOUT_FILENO, &out) == 0);
    p->written = out.st_size;
}

static void same(const struct process *a, const struct process *b)
{
    int i;
    for (i = 1; i < SIGNALS; i++) {
        CHECK(a->actions[i].sa_handler == b->actions[i].sa_handler);
        CHECK(a->actions[i].sa_flags == b->actions[i].sa_flags);
        CHECK(sigismember(&a->mask, i) == sigismember(&b->mask, i));
    }
    CHECK(strcmp(a->locale, b->locale) == 0);
    CHECK(strcmp(a->environment, b->environment) == 0);
    CHECK(a->descriptors == b->descriptors);
    CHECK(a->written == b->written);
}

static void work(const char *folder)
{
    static V_POSE poses[2000];
    char file[400];
    size_t count = 0;
    double length;
    V_PATH *path = new_path(), *loaded = NULL;
    V_KAMERAPAR head;
    head.number = -1;
    OK(v_path_sample(path, poses, 2000, &count));
    OK(v_path_to_list(path, &head));
    v_free_liste(&head);
    sprintf(file, "%.300s/a.vid", folder);
    OK(v_path_save(path, file));
    OK(v_path_load(file, &loaded));
    sprintf(file, "%.300s/a.txt", folder);
    OK(v_path_write_ascii(loaded, file));
    STATUS(V_ERR_IO, v_path_save(path, "/no/such/folder/a.vid"));
    STATUS(V_ERR_NULL, v_path_sample(path, NULL, 2, NULL));
    v_haupt(100, 100, 100, 100, &head, 0, NULL, NULL, NULL);
    v_path_free(loaded);
    v_path_free(path);
    STATUS(V_ERR_HANDLE, v_path_length(path, &length));
}

int main(int argc, char **argv)
{
    static struct process before, after;
    char file[400];
    CHECK(argc == 2);
    /* Standard output as a file of its own, so that a single byte shows. */
    sprintf(file, "%.300s/stdout", argv[1]);
    CHECK(freopen(file, "w", stdout) != NULL);
    CHECK(setlocale(LC_ALL, "de_DE.UTF-8") != NULL);
    look(&before);
    work(argv[1]);
    look(&after);
    same(&before, &after);
    return failures != 0;
}
