/*
 * Files: a path saved and loaded again is the same; broken and missing files
 * give a status and a reason; the ASCII output is line by line what C prints,
 * under a locale whose decimal sign is the comma.
 *
 * The program's argument is a folder that it may write to.
 */
#include <locale.h>
#include <sys/stat.h>
#include <unistd.h>

#include "files.h"

static V_PATH *some_path(void)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    double xyz[3] = {0.1, -0.7, 1.0 / 3};
    v_orientation_init(&o);
    o.absolute = 1;
    o.target[0] = -0.123456789;
    o.roll = 33.3;
    o.zoom = 50.123;
    OK(v_path_insert_point(path, 1, xyz));
    OK(v_path_insert_orientation(path, 1, 1, &o));
    OK(v_path_set_numbers(path, v_path_key(2, -1, "own"), NUMBERS(0.1, -0.2, 0.3)));
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(123.4, 56.7, 89, 1e3)));
    return path;
}

static void saved_and_loaded(const char *folder)
{
    V_PATH *path = some_path(), *again = NULL;
    V_POSE one[1000], two[1000];
    size_t count_one = 0, count_two = 0;
    struct stat found;
    OK(v_path_save(path, in(folder, "path.vid")));
    OK(v_path_load(in(folder, "path.vid"), &again));
    OK(v_path_sample(path, one, 1000, &count_one));
    OK(v_path_sample(again, two, 1000, &count_two));
    CHECK(count_one == count_two && count_one > 100);
    CHECK(memcmp(one, two, count_one * sizeof *one) == 0);
    STATUS(V_ERR_IO, v_path_save(path, in(folder, "none/path.vid")));
    CHECK(strstr(v_last_error(), "none/path.vid") != NULL);
    STATUS(V_ERR_IO, v_path_save(path, folder)); /* a folder */
    STATUS(V_ERR_IO, v_path_save(path, "/"));
    STATUS(V_ERR_IO, v_path_save(path, ".."));
    STATUS(V_ERR_IO, v_path_save(path, ""));
    CHECK(stat(in(folder, "path.vid"), &found) == 0);
    v_path_free(path);
    v_path_free(again);
}

/* A name without a folder is one in the folder where the process is. */
static void a_name_alone(const char *folder)
{
    V_PATH *path = some_path(), *again = NULL;
    char before[1000];
    struct stat found;
    CHECK(getcwd(before, sizeof before) != NULL && chdir(folder) == 0);
    OK(v_path_save(path, "alone.vid"));
    OK(v_path_load("alone.vid", &again));
    CHECK(chdir(before) == 0);
    CHECK(stat(in(folder, "alone.vid"), &found) == 0 && found.st_size > 100);
    v_path_free(path);
    v_path_free(again);
}

static void not_loaded(int status, const char *file, const char *said)
{
    static int somewhere;
    V_PATH *path = (V_PATH *)(void *)&somewhere;
    STATUS(status, v_path_load(file, &path));
    CHECK(path == (V_PATH *)(void *)&somewhere);
    if (strstr(v_last_error(), said) == NULL) {
        failures++;
        fprintf(stderr, "files.c: \"%s\" does not say \"%s\"\n", v_last_error(), said);
    }
}

static void broken_files(const char *folder)
{
    not_loaded(V_ERR_IO, in(folder, "missing.vid"), "missing.vid");
    not_loaded(V_ERR_IO, "", "");
    not_loaded(V_ERR_IO, folder, "");
    write_text(in(folder, "empty.vid"), "");
    not_loaded(V_ERR_FORMAT, in(folder, "empty.vid"), "empty.vid");
    write_text(in(folder, "noise.vid"), "version = 1\n\n= what\n");
    not_loaded(V_ERR_FORMAT, in(folder, "noise.vid"), "3");
    write_text(in(folder, "typo.vid"), "version = 1\ntitel = \"x\"\n");
    not_loaded(V_ERR_FORMAT, in(folder, "typo.vid"), "titel");
    write_text(in(folder, "newer.vid"), "version = 2\n");
    not_loaded(V_ERR_FORMAT, in(folder, "newer.vid"), "version");
}

static void ascii(const char *folder)
{
    V_PATH *path = some_path();
    static V_POSE poses[1000];
    size_t count = 0, i;
    FILE *file;
    char is[400], should[400], *comma;

    OK(v_path_sample(path, poses, 1000, &count));
    if (setlocale(LC_ALL, "de_DE.UTF-8") == NULL) {
        failures++;
        fprintf(stderr, "files.c: there is no locale de_DE.UTF-8\n");
    }
    sprintf(is, "%.1f", 0.5);
    CHECK(strcmp(is, "0,5") == 0);
    OK(v_path_write_ascii(path, in(folder, "poses.txt")));
    file = fopen(in(folder, "poses.txt"), "r");
    CHECK(file != NULL);
    for (i = 0; i < count && file != NULL; i++) {
        double numbers[10];
        char *end = should;
        int k;
        memcpy(numbers, &poses[i], sizeof numbers); /* ten doubles, frozen */
        for (k = 0; k < 10; k++) {
            char number[100];
            sprintf(number, "%3.4f", numbers[k]);
            if (strcmp(number, "-0,0000") == 0)
                strcpy(number, "0,0000"); /* minus zero is written as zero */
            end += sprintf(end, "%s%c", number, k < 9 ? ' ' : '\n');
        }
        for (comma = should; (comma = strchr(comma, ',')) != NULL;)
            *comma = '.';
        if (fgets(is, sizeof is, file) == NULL || strcmp(is, should) != 0) {
            failures++;
            fprintf(stderr, "files.c: line %lu is %sinstead of %s", (unsigned long)i + 1, is,
                    should);
        }
    }
    CHECK(file != NULL && fgets(is, sizeof is, file) == NULL);
    if (file != NULL)
        fclose(file);
    STATUS(V_ERR_IO, v_path_write_ascii(path, in(folder, "none/poses.txt")));
    /* Numbers in a .vid do not follow the locale either. */
    saved_and_loaded(folder);
    v_path_free(path);
}

/* As many frames as poses, elements of the list, and lines of the file. */
static void counts(const char *folder)
{
    int kind;
    for (kind = 0; kind < 20; kind++) {
        V_PATH *path = path_of(1 + kind, kind);
        V_KAMERAPAR first;
        size_t frames = 0, poses = 0, lines = 0;
        int c;
        FILE *file;
        OK(v_path_set_numbers(path, "base_speeds", NUMBERS(3 + 7 * kind, 20, 20, 20)));
        OK(v_path_set_flag(path, "closed", kind % 2));
        OK(v_path_frame_count(path, &frames));
        STATUS(V_OK, v_path_sample(path, NULL, 0, &poses));
        first.number = -1;
        OK(v_path_to_list(path, &first));
        OK(v_path_write_ascii(path, in(folder, "counted.txt")));
        file = fopen(in(folder, "counted.txt"), "r");
        while (file != NULL && (c = getc(file)) != EOF)
            lines += c == '\n';
        if (file != NULL)
            fclose(file);
        CHECK(frames > 1 && poses == frames && lines == frames);
        CHECK((size_t)first.prev->number == frames);
        v_free_liste(&first);
        v_path_free(path);
    }
}

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    saved_and_loaded(argv[1]);
    a_name_alone(argv[1]);
    broken_files(argv[1]);
    ascii(argv[1]);
    counts(argv[1]);
    return failures != 0;
}
