/*
 * Saving, when things go wrong around it: killed in the middle, the disk full,
 * the folder or the file read-only, two processes at one file, links. The file
 * is wholly the old or wholly the new one, nothing is left beside it (by a kill
 * only between naming a new file and renaming it), and the answer names file and
 * reason.
 *
 * The program's argument is a folder that it may write to. VIDES_SAVE_KILLS
 * says how often it is killed. Disks are filled where the process may mount
 * one; a file too large for the process's limit is tried everywhere.
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "files.h"

#define NOBODY 65534

static V_PATH *old, *new;

/* The answer names the file and the reason. */
static void refused(int status, const char *file, int reason, int line)
{
    const char *said = v_last_error();
    if (status != V_ERR_IO || strstr(said, file) == NULL || strstr(said, strerror(reason)) == NULL) {
        failures++;
        fprintf(stderr, "saving.c:%d: %s: \"%s\" instead of %s\n", line, v_strerror(status), said,
                strerror(reason));
    }
}

#define REFUSED(call, file, reason) refused(call, file, reason, __LINE__)

/* A child that does this; its failures count. */
static void in_child(void (*act)(const char *), const char *folder)
{
    int status = 0;
    pid_t child = fork();
    if (child == 0) {
        failures = 0;
        act(folder);
        fflush(NULL);
        _exit(failures != 0);
    }
    CHECK(child > 0 && waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

/* ---- Killed ----------------------------------------------------------------- */

static unsigned long random_below(unsigned long most)
{
    static unsigned long long state = 0x9E3779B97F4A7C15ull;
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return (unsigned long)((state * 0x2545F4914F6CDD1Dull >> 33) % most);
}

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec + 1e-9 * now.tv_nsec;
}

/* A child that saves one path and the other in turn, for ever. */
static pid_t saver(WRITE *write, const char *file)
{
    pid_t child = fork();
    while (child == 0) {
        if (write(new, file) != V_OK || write(old, file) != V_OK)
            _exit(1);
    }
    return child;
}

/* Whether a process has a file open that has no name. */
static int writes_nameless(pid_t process)
{
    char folder[40], link[400], target[400];
    struct dirent *entry;
    DIR *open;
    int found = 0;
    sprintf(folder, "/proc/%ld/fd", (long)process);
    open = opendir(folder);
    while (open != NULL && (entry = readdir(open)) != NULL) {
        ssize_t length;
        sprintf(link, "%s/%.300s", folder, entry->d_name);
        length = readlink(link, target, sizeof target - 1);
        target[length > 0 ? length : 0] = '\0';
        found |= strstr(target, " (deleted)") != NULL;
    }
    if (open != NULL)
        closedir(open);
    return found;
}

/* Whether the file system has files without a name. */
static int has_nameless(const char *folder)
{
    int made = open(folder, O_TMPFILE | O_WRONLY, 0600);
    return made >= 0 && close(made) == 0;
}

static void killed(const char *folder, WRITE *write, int kills)
{
    WHOLE one, two;
    char file[500];
    double took;
    int i, olds = 0, other = 0, writing = 0, unfinished = names(folder, UNFINISHED);

    OK(write(new, in(folder, "killed")));
    two = whole(in(folder, "killed"));
    took = seconds();
    OK(write(old, in(folder, "killed")));
    took = seconds() - took;
    one = whole(in(folder, "killed"));
    strcpy(file, in(folder, "killed"));
    for (i = 0; i < kills; i++) {
        pid_t child = saver(write, file);
        int status = 0;
        CHECK(child > 0);
        usleep((useconds_t)random_below(1 + (unsigned long)(4e6 * took)));
        CHECK(kill(child, SIGSTOP) == 0 && waitpid(child, &status, WUNTRACED) == child);
        writing += writes_nameless(child);
        CHECK(kill(child, SIGKILL) == 0 && waitpid(child, &status, 0) == child);
        CHECK(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
        if (holds(file, one))
            olds++;
        else if (!holds(file, two))
            other++;
    }
    CHECK(other == 0);
    unfinished = names(folder, UNFINISHED) - unfinished;
    if (has_nameless(folder)) {
        CHECK(writing > 0 || kills < 20);
        CHECK(unfinished <= 1 + kills / 20);
    } else {
        /* That the kills came in the midst of saving is seen by what they left. */
        CHECK(unfinished > 0 || kills < 20);
    }
    printf("note: %d kills at random moments of saving: %d times the one file, %d times the "
           "other, %d times neither; %d were in the midst of writing, %d left a file\n",
           kills, olds, kills - olds - other, other, writing, unfinished);
    /* What a kill left is in nobody's way. */
    OK(write(new, file));
    CHECK(holds(file, two));
    free(one.bytes);
    free(two.bytes);
}

/* ---- Full ------------------------------------------------------------------- */

/* The larger path does not fit; the file stays, and a small one still goes. */
static void too_large(const char *folder, int reason)
{
    V_PATH *large = path_of(3000, 3);
    WHOLE before;
    OK(v_path_save(old, in(folder, "full.vid")));
    before = whole(in(folder, "full.vid"));
    REFUSED(v_path_save(large, in(folder, "full.vid")), "full.vid", reason);
    REFUSED(v_path_write_ascii(large, in(folder, "full.vid")), "full.vid", reason);
    CHECK(holds(in(folder, "full.vid"), before));
    REFUSED(v_path_save(large, in(folder, "first.vid")), "first.vid", reason);
    CHECK(whole(in(folder, "first.vid")).size == -1);
    CHECK(names(folder, UNFINISHED) == 0);
    OK(v_path_save(new, in(folder, "full.vid")));
    free(before.bytes);
    v_path_free(large);
}

static void full_disk(const char *folder)
{
    char disk[400];
    struct stat inside, outside;
    WHOLE before;
    int filling, i;

    sprintf(disk, "%.300s/disk", folder);
    CHECK(mkdir(disk, 0700) == 0);
    /* In a namespace of our own, so that it is gone with us. */
    if (unshare(CLONE_NEWNS) != 0 || mount(NULL, "/", NULL, MS_REC | MS_PRIVATE, NULL) != 0
        || mount("none", disk, "tmpfs", 0, "size=256k,nr_inodes=8") != 0) {
        printf("note: no disk could be mounted here (%s): full and read-only ones not tried\n",
               strerror(errno));
        return;
    }
    CHECK(stat(disk, &inside) == 0 && stat(folder, &outside) == 0);
    CHECK(inside.st_dev != outside.st_dev);
    too_large(disk, ENOSPC);

    /* To the last byte; then to the last file. */
    before = whole(in(disk, "full.vid"));
    filling = open(in(disk, "filling"), O_WRONLY | O_CREAT, 0600);
    for (i = 0; i < 100000 && write(filling, "0123456789012345", 16) == 16; i++)
        ;
    CHECK(errno == ENOSPC && close(filling) == 0);
    REFUSED(v_path_save(old, in(disk, "full.vid")), "full.vid", ENOSPC);
    CHECK(holds(in(disk, "full.vid"), before) && names(disk, UNFINISHED) == 0);
    CHECK(unlink(in(disk, "filling")) == 0);
    for (i = 0; i < 20; i++) {
        char number[20];
        sprintf(number, "file%d", i);
        close(open(in(disk, number), O_WRONLY | O_CREAT, 0600));
    }
    REFUSED(v_path_save(old, in(disk, "full.vid")), "full.vid", ENOSPC);
    CHECK(holds(in(disk, "full.vid"), before) && names(disk, UNFINISHED) == 0);

    CHECK(mount("none", disk, NULL, MS_REMOUNT | MS_RDONLY, NULL) == 0);
    REFUSED(v_path_save(old, in(disk, "full.vid")), "full.vid", EROFS);
    REFUSED(v_path_save(old, in(disk, "another.vid")), "another.vid", EROFS);
    CHECK(holds(in(disk, "full.vid"), before));
    printf("note: disks that are full, without room for a file, and read-only\n");
    free(before.bytes);
}

static void limited_size(const char *folder)
{
    struct rlimit most = {150000, 150000};
    /* Else the system ends a process that writes more: that is the host's own wish. */
    signal(SIGXFSZ, SIG_IGN);
    CHECK(setrlimit(RLIMIT_FSIZE, &most) == 0);
    too_large(folder, EFBIG);
}

/* ---- Not allowed ------------------------------------------------------------ */

static void read_only(const char *folder)
{
    WHOLE before;
    /* Root may write everywhere. */
    CHECK(chdir(folder) == 0);
    if (geteuid() == 0)
        CHECK(setresgid(NOBODY, NOBODY, NOBODY) == 0 && setresuid(NOBODY, NOBODY, NOBODY) == 0);
    before = whole("theirs.vid");
    CHECK(before.size > 100);
    REFUSED(v_path_save(new, "theirs.vid"), "theirs.vid", EACCES);
    REFUSED(v_path_write_ascii(new, "theirs.vid"), "theirs.vid", EACCES);
    REFUSED(v_path_save(new, "none.vid"), "none.vid", EACCES);
    REFUSED(v_path_save(new, "shut/none.vid"), "shut/none.vid", EACCES);
    CHECK(holds("theirs.vid", before) && names(".", UNFINISHED) == 0);
    CHECK(whole("none.vid").size == -1);
    /* A folder that may be written to does not make a file ours to replace. */
    before = whole("open/kept.vid");
    REFUSED(v_path_save(new, "open/kept.vid"), "open/kept.vid", EACCES);
    CHECK(holds("open/kept.vid", before) && names("open", UNFINISHED) == 0);
    OK(v_path_save(new, "open/ours.vid"));
    free(before.bytes);
}

static void not_allowed(const char *above)
{
    char folder[400];
    sprintf(folder, "%.300s/read_only", above);
    CHECK(mkdir(folder, 0755) == 0);
    CHECK(mkdir(in(folder, "shut"), 0000) == 0);
    CHECK(mkdir(in(folder, "open"), 0777) == 0 && chmod(in(folder, "open"), 0777) == 0);
    OK(v_path_save(old, in(folder, "theirs.vid")));
    CHECK(chmod(in(folder, "theirs.vid"), 0666) == 0);
    OK(v_path_save(old, in(folder, "open/kept.vid")));
    CHECK(chmod(in(folder, "open/kept.vid"), 0444) == 0);
    CHECK(chmod(folder, 0555) == 0);
    in_child(read_only, folder);
    CHECK(chmod(folder, 0755) == 0); /* so that it can be cleared away */
}

/* ---- Links and permissions ---------------------------------------------------- */

static void links_and_permissions(const char *folder)
{
    struct stat link, file;
    OK(v_path_save(old, in(folder, "real.vid")));
    CHECK(chmod(in(folder, "real.vid"), 0640) == 0);
    CHECK(symlink("real.vid", in(folder, "link.vid")) == 0);
    OK(v_path_save(new, in(folder, "link.vid")));
    CHECK(lstat(in(folder, "link.vid"), &link) == 0 && S_ISLNK(link.st_mode));
    CHECK(lstat(in(folder, "real.vid"), &file) == 0 && S_ISREG(file.st_mode));
    CHECK((file.st_mode & 07777) == 0640);
    OK(v_path_save(new, in(folder, "new.vid")));
    {
        WHOLE should = whole(in(folder, "new.vid"));
        CHECK(should.size > 100 && holds(in(folder, "real.vid"), should));
        free(should.bytes);
    }
}

/* ---- Two at one file ------------------------------------------------------------ */

static void two_savers(const char *folder)
{
    enum { ROUNDS = 100 };
    WHOLE one, two;
    pid_t savers[2];
    char file[500];
    int i, looked = 0, wrong = 0, running = 2;

    OK(v_path_save(new, in(folder, "both.vid")));
    two = whole(in(folder, "both.vid"));
    OK(v_path_save(old, in(folder, "both.vid")));
    one = whole(in(folder, "both.vid"));
    strcpy(file, in(folder, "both.vid"));
    for (i = 0; i < 2; i++) {
        savers[i] = fork();
        if (savers[i] == 0) {
            int round, status = V_OK;
            for (round = 0; round < ROUNDS && status == V_OK; round++)
                status = v_path_save(i ? new : old, file);
            _exit(status);
        }
    }
    while (running > 0) {
        V_PATH *seen = NULL;
        int status = 0;
        wrong += !holds_either(file, one, two);
        OK(v_path_load(file, &seen));
        v_path_free(seen);
        looked++;
        if (waitpid(-1, &status, WNOHANG) > 0) {
            running--;
            CHECK(WIFEXITED(status) && WEXITSTATUS(status) == V_OK);
        }
    }
    CHECK(wrong == 0 && looked > 1);
    CHECK(names(folder, "both.vid") == 1);
    free(one.bytes);
    free(two.bytes);
}

int main(int argc, char **argv)
{
    const char *kills = getenv("VIDES_SAVE_KILLS");
    if (argc != 2)
        return 2;
    old = path_of(300, 1);
    new = path_of(310, 2);
    /* First those after which nothing unfinished may be there. */
    links_and_permissions(argv[1]);
    two_savers(argv[1]);
    in_child(limited_size, argv[1]);
    in_child(full_disk, argv[1]);
    not_allowed(argv[1]);
    CHECK(names(argv[1], UNFINISHED) == 0);
    killed(argv[1], v_path_save, kills ? atoi(kills) : 200);
    killed(argv[1], v_path_write_ascii, kills ? atoi(kills) / 4 : 50);
    v_path_free(old);
    v_path_free(new);
    return failures != 0;
}
