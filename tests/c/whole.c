/*
 * What a path says besides its poses, texts in memory, and poses in pieces. And
 * structs of a host that was compiled with an earlier version: their fields are
 * read, and nothing behind them.
 */
#include <stddef.h>

#include "check.h"

static void titles_and_comments(void)
{
    V_PATH *path = new_path(), *again = NULL;
    char text[100], small[4] = "abc";
    size_t length = 99;
    double fps = 0, first = 0;

    OK(v_path_get_text(path, "title", text, sizeof text, &length));
    CHECK(length == 0 && text[0] == '\0');
    OK(v_path_set_text(path, "title", "Um die Kirche \xc3\xbc"));
    OK(v_path_get_text(path, "title", NULL, 0, &length));
    CHECK(length == strlen("Um die Kirche xx"));
    OK(v_path_get_text(path, "title", text, sizeof text, &length));
    CHECK(strcmp(text, "Um die Kirche \xc3\xbc") == 0 && length == strlen(text));
    length = 0;
    STATUS(V_ERR_SIZE, v_path_get_text(path, "title", small, sizeof small, &length));
    CHECK(strcmp(small, "abc") == 0 && length == strlen(text));
    /* The zero needs its place, too. */
    STATUS(V_ERR_SIZE, v_path_get_text(path, "title", text, length, &length));
    OK(v_path_get_text(path, "title", text, length + 1, &length));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "title", "\xff"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, "title", "two\nlines"));
    STATUS(V_ERR_NULL, v_path_set_text(path, "title", NULL));
    STATUS(V_ERR_NULL, v_path_get_text(path, "title", text, sizeof text, NULL));
    STATUS(V_ERR_NULL, v_path_get_text(path, "title", NULL, 1, &length));
    OK(v_path_get_text(path, "title", text, sizeof text, &length));
    CHECK(strcmp(text, "Um die Kirche \xc3\xbc") == 0);

    OK(v_path_set_text(path, "comment", "first\nsecond"));
    OK(v_path_get_text(path, "comment", text, sizeof text, &length));
    CHECK(strcmp(text, "first\nsecond") == 0);

    OK(v_path_get_number(path, "fps", &fps));
    CHECK(fps == 25);
    OK(v_path_set_number(path, "fps", 29.97));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "fps", NAN));
    STATUS(V_ERR_RANGE, v_path_set_number(path, "fps", 0));
    OK(v_path_get_number(path, "first_frame", &first));
    CHECK(first == 1);
    OK(v_path_set_number(path, "first_frame", -7));

    OK(v_path_clone(path, &again));
    OK(v_path_get_number(again, "fps", &fps));
    OK(v_path_get_number(again, "first_frame", &first));
    OK(v_path_get_text(again, "comment", text, sizeof text, &length));
    CHECK(fps == 29.97 && first == -7 && strcmp(text, "first\nsecond") == 0);
    v_path_free(again);
    v_path_free(path);
}

static void poses_in_pieces(void)
{
    V_PATH *path = new_path();
    V_POSE all[500], part[500], none;
    size_t count = 0, first, step;

    OK(v_path_sample(path, all, 500, &count));
    CHECK(count > 100);
    for (step = 1; step <= count; step += 37) {
        memset(part, 0, sizeof part);
        for (first = 1; first <= count; first += step) {
            size_t many = first + step <= count + 1 ? step : count + 1 - first;
            OK(v_path_sample_range(path, first, many, part + first - 1));
        }
        CHECK(memcmp(all, part, count * sizeof *all) == 0);
    }
    OK(v_path_sample_range(path, 1, 0, &none));
    OK(v_path_sample_range(path, count + 1, 0, &none));
    memset(&none, 0x5a, sizeof none);
    STATUS(V_ERR_RANGE, v_path_sample_range(path, 0, 1, &none));
    STATUS(V_ERR_RANGE, v_path_sample_range(path, count + 1, 1, &none));
    STATUS(V_ERR_RANGE, v_path_sample_range(path, 2, (size_t)-1, &none));
    STATUS(V_ERR_NULL, v_path_sample_range(path, 1, 1, NULL));
    for (first = 0; first < sizeof none; first++)
        CHECK(((unsigned char *)&none)[first] == 0x5a);
    v_path_free(path);
}

/* What a file has, the memory has. */
static void texts_in_memory(const char *folder)
{
    static const char broken[] = "version = 1\nfsp = 3\n";
    V_PATH *path = new_path(), *again = NULL;
    char name[1000], vid[20000], lines[100000], *in_memory = malloc(100000);
    V_POSE one[500], two[500];
    size_t size, length = 0, count_one, count_two;
    FILE *file;

    snprintf(name, sizeof name, "%s/path.vid", folder);
    OK(v_path_save(path, name));
    file = fopen(name, "rb");
    size = fread(vid, 1, sizeof vid, file);
    fclose(file);
    OK(v_path_load_from_memory(vid, size, &again));
    OK(v_path_sample(path, one, 500, &count_one));
    OK(v_path_sample(again, two, 500, &count_two));
    CHECK(count_one == count_two && memcmp(one, two, count_one * sizeof *one) == 0);
    STATUS(V_ERR_FORMAT, v_path_load_from_memory(broken, sizeof broken - 1, &path));
    CHECK(strstr(v_last_error(), "memory: line 2") != NULL);
    STATUS(V_ERR_FORMAT, v_path_load_from_memory(broken, 0, &path));
    STATUS(V_ERR_NULL, v_path_load_from_memory(NULL, 0, &path));

    snprintf(name, sizeof name, "%s/poses.txt", folder);
    OK(v_path_write_ascii(path, name));
    file = fopen(name, "rb");
    size = fread(lines, 1, sizeof lines, file);
    fclose(file);
    OK(v_path_write_ascii_to_memory(path, NULL, 0, &length));
    CHECK(length == size && size > 1000);
    in_memory[size] = 'x';
    STATUS(V_ERR_SIZE, v_path_write_ascii_to_memory(path, in_memory, size, &length));
    OK(v_path_write_ascii_to_memory(path, in_memory, size + 1, &length));
    CHECK(length == size && memcmp(in_memory, lines, size) == 0 && in_memory[size] == '\0');
    free(in_memory);
    v_path_free(again);
    v_path_free(path);
}

/* A struct too short for version 1.0: nothing is written, neither into it nor behind. */
static void no_room_no_struct(void)
{
    size_t rooms[2 * sizeof(V_EDITOR_OPTIONS) / sizeof(size_t)]; /* aligned */
    unsigned char *room = (unsigned char *)rooms, before[sizeof rooms];
    char sentence[99];
    size_t size;

    memset(before, 0xa5, sizeof before);
    memcpy(room, before, sizeof rooms);
    for (size = 0; size < sizeof(V_EDITOR_OPTIONS); size++) {
        v_editor_options_init_sized((V_EDITOR_OPTIONS *)room, size);
        CHECK(memcmp(room, before, sizeof rooms) == 0);
        sprintf(sentence, "size is %d, but sizeof (V_EDITOR_OPTIONS) is %d", (int)size,
                (int)sizeof(V_EDITOR_OPTIONS));
        CHECK(strcmp(v_last_error(), sentence) == 0);
    }
    /* That of a later version: as far as this one knows it. */
    v_editor_options_init_sized((V_EDITOR_OPTIONS *)room, sizeof rooms);
    size = sizeof(V_EDITOR_OPTIONS);
    CHECK(((V_EDITOR_OPTIONS *)room)->size == size && strcmp(v_last_error(), "") == 0);
    CHECK(memcmp(room + size, before, sizeof rooms - size) == 0);
}

static void whole_structs_only(void)
{
    /* On the heap without a byte to spare, so that reading on would be seen. */
    V_EDITOR_OPTIONS *options = malloc(sizeof *options);
    size_t shorter, *stub;
    V_EDITOR *editor = NULL;

    v_editor_options_init_sized(options, sizeof *options);
    CHECK(options->size == sizeof *options && options->on_frame == NULL);
    /* As a program in another language calls it: all of version 1.0. */
    memset(options, 0xff, sizeof *options);
    (v_editor_options_init)(options);
    CHECK(options->size == sizeof *options && options->user == NULL && options->on_frame == NULL);
    options->display = ":none";
    /* As far as the display, which is not there. */
    STATUS(V_ERR_DISPLAY, v_editor_open(options, &editor));
    options->language = "fr";
    STATUS(V_ERR_ARGUMENT, v_editor_open(options, &editor));
    for (shorter = 0; shorter < sizeof *options; shorter += sizeof(void *)) {
        options->size = shorter;
        STATUS(V_ERR_SIZE, v_editor_open(options, &editor));
    }
    options->size = sizeof *options + 1;
    STATUS(V_ERR_SIZE, v_editor_open(options, &editor));
    options->size = sizeof *options + sizeof(void *);
    STATUS(V_ERR_SIZE, v_editor_open(options, &editor));
    free(options);
    stub = malloc(sizeof *stub);
    *stub = sizeof *stub;
    STATUS(V_ERR_SIZE, v_editor_open((V_EDITOR_OPTIONS *)stub, &editor));
    free(stub);
}

int main(int argc, char **argv)
{
    if (argc != 2)
        return 2;
    titles_and_comments();
    poses_in_pieces();
    texts_in_memory(argv[1]);
    no_room_no_struct();
    whole_structs_only();
    return failures != 0;
}
