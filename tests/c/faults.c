/*
 * Every system call that saving, writing poses and loading make fails in turn,
 * once and from then on, for several reasons. The answer is a status with the
 * file and the reason, or success; a file is wholly the old or wholly the new;
 * after success it is the new one. The same where the process is allowed less
 * and less memory, also with files that are dear to parse.
 *
 * One thing is not asked for: that loading gets by when the system first grants
 * the memory that it asks for beforehand, and then no more.
 *
 * The program watches a child of its own (ptrace) and puts a failure in place
 * of the call. Its argument is a folder that it may write to.
 */
#define _GNU_SOURCE
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/user.h>
#include <sys/wait.h>
#include <unistd.h>

#include "files.h"

#ifndef __x86_64__
#error "the registers below are those of x86-64"
#endif

/* How a child ends: what it was answered. */
enum { ANSWERED_OK, ANSWERED_FAULT, ANSWERED_MEMORY, ANSWERED_BADLY };

static V_PATH *old, *new;
static WHOLE old_vid, new_vid, old_ascii, new_ascii;

/* What the child does, in a folder where file.vid and file.txt are. */
static int act_save(void)
{
    return v_path_save(new, "file.vid");
}

static int act_write(void)
{
    return v_path_write_ascii(new, "file.txt");
}

static int act_load(void)
{
    V_PATH *path = NULL;
    int status = v_path_load("file.vid", &path);
    if ((status == V_OK) != (path != NULL))
        return -1;
    return status;
}

/* The child: from the signal on its calls are counted. */
static void child(int (*act)(void), const char *file, int reason)
{
    int status, answer = ANSWERED_BADLY;
    ptrace(PTRACE_TRACEME, 0, NULL, NULL);
    raise(SIGSTOP);
    status = act();
    if (status == V_OK && v_last_error()[0] == '\0')
        answer = ANSWERED_OK;
    else if (status == V_ERR_MEMORY)
        answer = ANSWERED_MEMORY;
    else if (status == V_ERR_IO && strstr(v_last_error(), file) != NULL
             && strstr(v_last_error(), strerror(reason)) != NULL)
        answer = ANSWERED_FAULT;
    if (answer == ANSWERED_BADLY)
        fprintf(stderr, "status %d: \"%s\" for %s\n", status, v_last_error(), strerror(reason));
    _exit(answer);
}

/* What came of a run in which call number `failing` failed. */
typedef struct run {
    int answer;
    int reached;         /* the call was made */
    int memory;          /* it was one for memory, or failed for want of it */
    char call[200];      /* which one it was */
} RUN;

static const char *name_of(long number)
{
    static const struct {
        long number;
        const char *name;
    } known[] = {{SYS_openat, "openat"}, {SYS_open, "open"}, {SYS_statx, "statx"},
                 {SYS_newfstatat, "fstatat"}, {SYS_readlink, "readlink"}, {SYS_write, "write"},
                 {SYS_fchown, "fchown"}, {SYS_fchmod, "fchmod"}, {SYS_fsync, "fsync"},
                 {SYS_rename, "rename"}, {SYS_close, "close"}, {SYS_unlink, "unlink"},
                 {SYS_read, "read"}, {SYS_fstat, "fstat"}, {SYS_brk, "brk"}, {SYS_mmap, "mmap"},
                 {SYS_munmap, "munmap"}, {SYS_mremap, "mremap"}, {SYS_lseek, "lseek"},
                 {SYS_getpid, "getpid"}, {SYS_futex, "futex"}, {SYS_madvise, "madvise"}};
    static char other[40];
    size_t i;
    for (i = 0; i < sizeof known / sizeof *known; i++)
        if (known[i].number == number)
            return known[i].name;
    sprintf(other, "call %ld", number);
    return other;
}

/* Calls for memory, and to give it back. */
static int is_memory(long number)
{
    return number == SYS_brk || number == SYS_mmap || number == SYS_munmap
        || number == SYS_mremap || number == SYS_madvise;
}

static RUN run(int (*act)(void), const char *file, int failing, int reason, int forever)
{
    RUN done = {-1, 0, 0, ""};
    struct user_regs_struct registers;
    int status = 0, count = 0, inside = 0, failed = 0, signal_number = 0;
    long call = 0;
    pid_t pid = fork();

    if (pid == 0)
        child(act, file, reason);
    if (waitpid(pid, &status, 0) != pid || !WIFSTOPPED(status)) {
        CHECK(!"the child stops at its signal");
        return done;
    }
    ptrace(PTRACE_SETOPTIONS, pid, NULL, (void *)(PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL));
    for (;;) {
        ptrace(PTRACE_SYSCALL, pid, NULL, (void *)(long)signal_number);
        signal_number = 0;
        if (waitpid(pid, &status, 0) != pid || WIFEXITED(status) || WIFSIGNALED(status))
            break;
        if (WSTOPSIG(status) != (SIGTRAP | 0x80)) {
            signal_number = WSTOPSIG(status);
            continue;
        }
        ptrace(PTRACE_GETREGS, pid, NULL, &registers);
        inside = !inside;
        if (inside) {
            call = (long)registers.orig_rax;
            failed = 0;
            /* The end itself cannot fail. */
            if (call == SYS_exit_group)
                continue;
            count++;
            if (count == failing
                || (count > failing && forever && !(act == act_load && is_memory(call)))) {
                if (count == failing) {
                    strcpy(done.call, name_of(call));
                    done.memory = is_memory(call) || reason == ENOMEM;
                }
                failed = done.reached = 1;
                registers.orig_rax = (unsigned long long)-1;
                ptrace(PTRACE_SETREGS, pid, NULL, &registers);
            }
        } else if (failed) {
            registers.rax = (unsigned long long)-(long)reason;
            /* brk alone fails by answering an end that is not the one asked for. */
            if (call == SYS_brk)
                registers.rax = 0;
            ptrace(PTRACE_SETREGS, pid, NULL, &registers);
        }
    }
    if (WIFEXITED(status))
        done.answer = WEXITSTATUS(status);
    else
        fprintf(stderr, "ended by signal %d\n", WTERMSIG(status));
    return done;
}

static void put_back(const char *file, WHOLE contents)
{
    FILE *out = fopen(file, "wb");
    CHECK(out != NULL && fwrite(contents.bytes, 1, (size_t)contents.size, out) == (size_t)contents.size);
    CHECK(fclose(out) == 0);
}

/* Every call of one kind of action. */
static void each_call(const char *what, int (*act)(void), const char *file, WHOLE before,
                      WHOLE after)
{
    static const int reasons[] = {EIO, ENOSPC, EACCES, ENOMEM, EINTR, EDQUOT};
    int forever, calls = 0, runs = 0, answers[4] = {0, 0, 0, 0};
    size_t reason;

    for (forever = 0; forever < 2; forever++)
        for (reason = 0; reason < sizeof reasons / sizeof *reasons; reason++) {
            int failing;
            /* A call that is interrupted for ever is asked again for ever. */
            if (forever && reasons[reason] == EINTR)
                continue;
            for (failing = 1;; failing++) {
                RUN done;
                int right;
                put_back(file, before);
                done = run(act, file, failing, reasons[reason], forever);
                if (!done.reached)
                    break;
                runs++;
                right = done.answer >= 0 && done.answer < ANSWERED_BADLY
                    && (done.answer == ANSWERED_OK ? holds(file, after)
                                                   : holds(file, before) || holds(file, after));
                /* Out of memory is an answer to a want of memory only. */
                if (done.answer == ANSWERED_MEMORY)
                    right = right && (forever || done.memory);
                /* What is written beside the file goes again, if it can. */
                if (!forever && strcmp(done.call, "unlink") != 0)
                    right = right && names(".", UNFINISHED) == 0;
                if (!right) {
                    failures++;
                    fprintf(stderr, "faults.c: %s: call %d, %s: %s%s: answer %d, %d unfinished\n",
                            what, failing, done.call, strerror(reasons[reason]),
                            forever ? " for ever" : "", done.answer, names(".", UNFINISHED));
                }
                if (done.answer >= 0 && done.answer < 4)
                    answers[done.answer]++;
                CHECK(system("rm -f .vides-*") == 0);
            }
            if (failing - 1 > calls)
                calls = failing - 1;
        }
    CHECK(calls >= 5 && answers[ANSWERED_FAULT] > calls);
    printf("note: %s: %d system calls, %d failures: %d times file and reason told, %d times out "
           "of memory, %d times done all the same\n",
           what, calls, runs, answers[ANSWERED_FAULT], answers[ANSWERED_MEMORY],
           answers[ANSWERED_OK]);
}

/* ---- Too little memory ---------------------------------------------------------- */

/* Bytes of address space that this process has. */
static rlim_t in_use(void)
{
    unsigned long pages = 0;
    FILE *in = fopen("/proc/self/statm", "r");
    CHECK(in != NULL && fscanf(in, "%lu", &pages) == 1 && fclose(in) == 0);
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

static int act_load_dear(void)
{
    V_PATH *path = NULL;
    int status = v_path_load("dear.vid", &path);
    return status == V_ERR_FORMAT || status == V_ERR_LIMIT ? V_OK : status;
}

/* Takes all memory that the process may have and gives so many bytes back. */
static void leave(rlim_t bytes)
{
    static void *taken[100000];
    int count = 0;
    size_t size;
    for (size = 1024; size >= 16; size /= 2)
        while (count < 100000 && (taken[count] = malloc(size)) != NULL)
            count++;
    /* The large ones, which are the first, lie side by side. */
    for (count = 0; (rlim_t)count * 1024 < bytes; count++)
        free(taken[count]);
}

/* From no memory to enough: V_ERR_MEMORY, then success. */
static void little_memory(const char *what, int (*act)(void), int exhausted)
{
    const rlim_t step = exhausted ? 1 << 10 : 48 << 10;
    int refused = 0, done = 0, tries = 0;
    rlim_t more = 0;
    /* Coarser steps where much is wanted; 3 GiB are more than anything takes. */
    for (; done < 3 && more < (exhausted ? (rlim_t)1 << 20 : (rlim_t)3 << 30); more += exhausted || ++tries < 60 ? step : more / 16) {
        int status = 0;
        pid_t pid = fork();
        if (pid == 0) {
            struct rlimit most;
            most.rlim_cur = most.rlim_max = in_use() + (exhausted ? 1 << 20 : more);
            if (setrlimit(RLIMIT_AS, &most) != 0)
                _exit(99);
            if (exhausted)
                leave(more);
            _exit(act());
        }
        CHECK(waitpid(pid, &status, 0) == pid);
        if (WIFEXITED(status) && WEXITSTATUS(status) == V_ERR_MEMORY)
            refused++;
        else if (WIFEXITED(status) && WEXITSTATUS(status) == V_OK)
            done++;
        else {
            failures++;
            fprintf(stderr, "faults.c: %s with %lu bytes more: ended with %d\n", what,
                    (unsigned long)more, status);
        }
    }
    CHECK(refused > 0 && done == 3);
    printf("note: %s: %d times refused for want of memory, then done\n", what, refused);
}

/* Texts that take far more memory than room, each line or piece so many times. */
static const struct {
    const char *begin, *each, *end;
    int times;
} dear[] = {
    {"version = 1\n", "\n", "", 8000000},
    {"version = 1\na=[", "1,", "]\n", 300000},
    {"version = 1\na=[", "{a.b.c.d.e=1},", "]\n", 20000},
    {"version = 1\na=[", "[0.1, -0.2, 1e9], ", "]\n", 50000},
    {"version = 1\n", "[[a.b]]\n", "", 50000},
    {"version = 1\n", "[[point]]\nposition = [0, 0, 0]\n", "", 50000},
};

static void dear_files(void)
{
    size_t kind;
    for (kind = 0; kind < sizeof dear / sizeof *dear; kind++) {
        int i;
        FILE *out = fopen("dear.vid", "w");
        CHECK(out != NULL);
        fputs(dear[kind].begin, out);
        for (i = 0; i < dear[kind].times; i++)
            fputs(dear[kind].each, out);
        fputs(dear[kind].end, out);
        CHECK(fclose(out) == 0);
        little_memory("loading a dear file", act_load_dear, 0);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2 || chdir(argv[1]) != 0)
        return 2;
    old = path_of(300, 1);
    new = path_of(310, 2);
    OK(v_path_save(new, "file.vid"));
    OK(v_path_write_ascii(new, "file.txt"));
    new_vid = whole("file.vid");
    new_ascii = whole("file.txt");
    OK(v_path_save(old, "file.vid"));
    OK(v_path_write_ascii(old, "file.txt"));
    old_vid = whole("file.vid");
    old_ascii = whole("file.txt");
    each_call("saving", act_save, "file.vid", old_vid, new_vid);
    each_call("writing poses", act_write, "file.txt", old_ascii, new_ascii);
    each_call("loading", act_load, "file.vid", old_vid, old_vid);
    little_memory("saving", act_save, 1);
    little_memory("writing poses", act_write, 1);
    little_memory("loading", act_load, 1);
    dear_files();
    v_path_free(old);
    v_path_free(new);
    free(old_vid.bytes);
    free(new_vid.bytes);
    free(old_ascii.bytes);
    free(new_ascii.bytes);
    return failures != 0;
}
