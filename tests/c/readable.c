/*
 * What can be set can be read, and set again it is the same: ups, views along
 * the way, given distances, objects, names; paths and scenes as texts.
 */
#include "check.h"

/* The text of a path; to be freed. */
static char *text_of(const V_PATH *path)
{
    size_t length = 0, again = 0;
    char *text;
    OK(v_path_save_to_memory(path, NULL, 0, &length));
    text = malloc(length + 1);
    STATUS(V_ERR_SIZE, v_path_save_to_memory(path, text, length, &again));
    CHECK(again == length);
    OK(v_path_save_to_memory(path, text, length + 1, &again));
    CHECK(again == length && strlen(text) == length);
    return text;
}

static void same_paths(const V_PATH *a, const V_PATH *b)
{
    char *one = text_of(a), *two = text_of(b);
    CHECK(strcmp(one, two) == 0);
    free(one);
    free(two);
}

static void ups(void)
{
    static const char *const plain[] = {"axis", "minimal", "y", "z"};
    V_PATH *path = new_path(), *twin = new_path(), *second = new_path(), *made = path;
    double above[3] = {3, 4, 5}, place[3] = {77, 77, 77}, corner[3] = {0.1, 0.9, 0.3};
    const char *up = "";
    size_t i;
    for (i = 0; i < sizeof plain / sizeof *plain; i++) {
        OK(v_path_set_up(path, 1, 0, plain[i], NULL, NULL));
        OK(v_path_get_up(path, 1, 0, &up, place, &made));
        CHECK(strcmp(up, plain[i]) == 0 && made == NULL && place[0] == 0);
    }
    OK(v_path_set_up(path, 1, 0, "point", above, NULL));
    OK(v_path_get_up(path, 1, 0, &up, place, &made));
    CHECK(strcmp(up, "point") == 0 && memcmp(above, place, sizeof above) == 0 && made == NULL);
    OK(v_path_get_up(path, 1, 0, NULL, NULL, NULL));
    OK(v_path_get_up(path, 0, 0, &up, NULL, NULL));
    CHECK(strcmp(up, "axis") == 0);
    OK(v_path_set_text(path, "curve", "cubic"));
    OK(v_path_set_up(path, 1, 0, "frenet", NULL, NULL));
    OK(v_path_get_up(path, 1, 0, &up, NULL, NULL));
    CHECK(strcmp(up, "frenet") == 0);
    /* A path, closed too, comes back as a curve that makes the same. */
    OK(v_path_set_up(path, 1, 0, "axis", NULL, NULL));
    OK(v_path_set_text(path, "curve", "tcb"));
    OK(v_path_insert_point(second, 1, corner));
    for (i = 0; i < 2; i++) {
        int points = 0;
        OK(v_path_set_flag(second, "closed", (int)i));
        OK(v_path_set_up(path, 1, 0, "path", NULL, second));
        OK(v_path_get_up(path, 1, 0, &up, NULL, &made));
        CHECK(strcmp(up, "path") == 0 && made != NULL);
        OK(v_path_point_count(made, &points));
        CHECK(points == 3 + (int)i);
        OK(get_position(made, 1, place));
        CHECK(memcmp(place, corner, sizeof place) == 0);
        v_path_free(twin);
        OK(v_path_clone(path, &twin));
        OK(v_path_set_up(twin, 1, 0, "axis", NULL, NULL));
        OK(v_path_set_up(twin, 1, 0, "path", NULL, made));
        same_paths(path, twin);
        v_path_free(made);
        OK(v_path_get_up(path, 1, 0, &up, NULL, NULL)); /* no handle that nobody frees */
    }
    made = path;
    STATUS(V_ERR_RANGE, v_path_get_up(path, 2, 0, &up, place, &made));
    STATUS(V_ERR_RANGE, v_path_get_up(path, 1, 1, &up, place, &made));
    STATUS(V_ERR_NULL, v_path_get_up(NULL, 1, 0, &up, place, &made));
    CHECK(made == path);
    v_path_free(second);
    v_path_free(twin);
    v_path_free(path);
}

static void ahead_and_distance(void)
{
    V_PATH *path = new_path();
    double keys[] = {0, 0, 0.25, 0.5, 0.75, 0.625, 1, 1}, read[8], ahead = 0;
    size_t count = 77;
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &ahead));
    CHECK(isnan(ahead));
    OK(v_path_set_number(path, v_path_key(0, 0, "ahead"), 0));
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &ahead));
    CHECK(ahead == 0);
    OK(v_path_set_number(path, v_path_key(0, 0, "ahead"), 0.375));
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &ahead));
    CHECK(ahead == 0.375);
    OK(v_path_set_text(path, v_path_key(0, 0, "ahead"), ""));
    OK(v_path_get_number(path, v_path_key(0, 0, "ahead"), &ahead));
    CHECK(isnan(ahead));
    STATUS(V_ERR_RANGE, v_path_get_number(path, v_path_key(0, 1, "ahead"), &ahead));
    STATUS(V_ERR_NULL, v_path_get_number(path, v_path_key(0, 0, "ahead"), NULL));

    OK(v_path_get_numbers(path, v_path_key(0, 0, "distance"), NULL, 0, &count));
    CHECK(count == 0);
    OK(v_path_set_numbers(path, v_path_key(0, 0, "distance"), keys, 8));
    read[0] = 77;
    STATUS(V_ERR_SIZE, v_path_get_numbers(path, v_path_key(0, 0, "distance"), read, 6, &count));
    CHECK(count == 8 && read[0] == 77);
    OK(v_path_get_numbers(path, v_path_key(0, 0, "distance"), NULL, 0, &count));
    CHECK(count == 8);
    OK(v_path_get_numbers(path, v_path_key(0, 0, "distance"), read, 8, &count));
    CHECK(memcmp(keys, read, sizeof keys) == 0);
    OK(v_path_set_numbers(path, v_path_key(0, 0, "ease"), NUMBERS(V_EASE_SINE, 0.2, 0.2, 50)));
    OK(v_path_get_numbers(path, v_path_key(0, 0, "distance"), read, 8, &count));
    CHECK(count == 0);
    STATUS(V_ERR_RANGE, v_path_get_numbers(path, v_path_key(5, 0, "distance"), read, 8, &count));
    STATUS(V_ERR_NULL, v_path_get_numbers(path, v_path_key(0, 0, "distance"), read, 8, NULL));
    v_path_free(path);
}

static void objects(void)
{
    V_PATH *path = new_path(), *twin = new_path();
    double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0.5, 0.5};
    unsigned char rgb[15] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    unsigned corners[] = {0, 1, 2, 0, 2, 3}, lines[] = {0, 1, 1, 2, 4, 4};
    V_MESH mesh, read;
    memset(&mesh, 0, sizeof mesh);
    mesh.size = read.size = sizeof mesh;
    OK(v_path_get_object(path, &read));
    CHECK(read.points == 0 && read.xyz == NULL && read.lines == NULL && read.triangles == NULL);
    mesh.xyz = xyz;
    mesh.points = 5;
    mesh.rgb = rgb;
    mesh.triangles = corners;
    mesh.corners = 6;
    OK(v_path_set_object(path, &mesh));
    OK(v_path_get_object(path, &read));
    CHECK(read.size == sizeof read && read.points == 5 && read.corners == 6 && read.line_ends == 0);
    CHECK(memcmp(read.xyz, xyz, sizeof xyz) == 0 && memcmp(read.rgb, rgb, sizeof rgb) == 0);
    CHECK(memcmp(read.triangles, corners, sizeof corners) == 0 && read.lines == NULL);
    /* What was given stays when the path goes, and can be set where it came from. */
    v_path_free(path);
    OK(v_path_set_object(twin, &read));
    CHECK(memcmp(read.xyz, xyz, sizeof xyz) == 0);

    /* Lines alone: as they are drawn, a single point being a line of no length. */
    mesh.triangles = NULL;
    mesh.corners = 0;
    mesh.rgb = NULL;
    mesh.lines = lines;
    mesh.line_ends = 6;
    OK(v_path_set_object(twin, &mesh));
    path = new_path();
    OK(v_path_get_object(twin, &read));
    CHECK(read.points == 4 && read.line_ends == 6 && read.corners == 0);
    CHECK(read.lines[0] == 0 && read.lines[1] == 1 && read.lines[2] == 1 && read.lines[3] == 2);
    CHECK(read.lines[4] == 3 && read.lines[5] == 3);
    CHECK(memcmp(read.xyz + 9, xyz + 12, 3 * sizeof *xyz) == 0);
    OK(v_path_set_object(path, &read));
    same_paths(path, twin);
    /* Points alone. */
    mesh.lines = NULL;
    mesh.line_ends = 0;
    OK(v_path_set_object(twin, &mesh));
    OK(v_path_get_object(twin, &read));
    CHECK(read.points == 5 && read.line_ends == 0 && memcmp(read.xyz, xyz, sizeof xyz) == 0);
    read.size = 8;
    STATUS(V_ERR_SIZE, v_path_get_object(twin, &read));
    STATUS(V_ERR_NULL, v_path_get_object(twin, NULL));
    read.size = sizeof read;
    v_path_free(twin);
    STATUS(V_ERR_HANDLE, v_path_get_object(twin, &read));
    v_path_free(path);
}

static void names_and_numbers(void)
{
    V_PATH *path = new_path();
    double middle[3] = {0, 0.5, 0}, place[3];
    char name[300], untouched[4] = "ZZZ";
    size_t length = 77;
    OK(v_path_insert_point(path, 1, middle));
    OK(v_path_get_text(path, v_path_key(1, -1, "name"), name, sizeof name, &length));
    CHECK(length == 0 && name[0] == '\0');
    OK(v_path_set_text(path, v_path_key(1, -1, "name"), "gate \xc3\xbc"));
    OK(v_path_get_text(path, v_path_key(1, -1, "name"), NULL, 0, &length));
    CHECK(length == 7);
    STATUS(V_ERR_SIZE, v_path_get_text(path, v_path_key(1, -1, "name"), untouched, 4, &length));
    CHECK(strcmp(untouched, "ZZZ") == 0);
    OK(v_path_get_text(path, v_path_key(1, -1, "name"), name, 8, &length));
    CHECK(strcmp(name, "gate \xc3\xbc") == 0);
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, v_path_key(1, -1, "name"), "two\nlines"));
    STATUS(V_ERR_ARGUMENT, v_path_set_text(path, v_path_key(1, -1, "name"), "\377"));
    memset(name, 'x', sizeof name);
    name[257] = '\0';
    STATUS(V_ERR_LIMIT, v_path_set_text(path, v_path_key(1, -1, "name"), name));
    STATUS(V_ERR_RANGE, v_path_set_text(path, v_path_key(3, -1, "name"), "x"));
    STATUS(V_ERR_RANGE, v_path_get_text(path, v_path_key(-1, -1, "name"), name, 8, &length));
    STATUS(V_ERR_NULL, v_path_set_text(path, v_path_key(1, -1, "name"), NULL));

    /* The name goes along, the others move up. */
    OK(v_path_move_point(path, 1, 0));
    OK(v_path_get_text(path, v_path_key(0, -1, "name"), name, sizeof name, &length));
    CHECK(strcmp(name, "gate \xc3\xbc") == 0);
    OK(get_position(path, 0, place));
    CHECK(memcmp(place, middle, sizeof place) == 0);
    OK(get_position(path, 1, place));
    CHECK(place[0] == -0.6);
    OK(v_path_move_point(path, 0, 2));
    OK(get_position(path, 2, place));
    CHECK(memcmp(place, middle, sizeof place) == 0);
    OK(v_path_move_point(path, 2, 2));
    STATUS(V_ERR_RANGE, v_path_move_point(path, 0, 3));
    STATUS(V_ERR_RANGE, v_path_move_point(path, 3, 0));
    STATUS(V_ERR_RANGE, v_path_move_point(path, 0, -1));
    STATUS(V_ERR_NULL, v_path_move_point(NULL, 0, 1));
    OK(v_path_set_text(path, v_path_key(2, -1, "name"), ""));
    OK(v_path_get_text(path, v_path_key(2, -1, "name"), name, sizeof name, &length));
    CHECK(length == 0);
    v_path_free(path);
}

/* The text is that of the file, and read again the same. */
static void texts(const char *folder)
{
    V_PATH *path = new_path(), *again = NULL;
    V_SCENE *scene = NULL, *read = NULL;
    V_NODE node;
    char file[500], *text, *other, from_file[10000];
    size_t length = 0, count;
    double weight = 1;
    FILE *stream;
    snprintf(file, sizeof file, "%s/path.vid", folder);
    OK(v_path_set_text(path, "title", "Flight"));
    OK(v_path_set_text(path, v_path_key(0, -1, "name"), "gate"));
    OK(v_path_save(path, file));
    stream = fopen(file, "rb");
    count = fread(from_file, 1, sizeof from_file - 1, stream);
    fclose(stream);
    from_file[count] = '\0';
    text = text_of(path);
    CHECK(strcmp(text, from_file) == 0);
    OK(v_path_load_from_memory(text, strlen(text), &again));
    same_paths(path, again);
    STATUS(V_ERR_NULL, v_path_save_to_memory(path, text, 9, NULL));
    STATUS(V_ERR_NULL, v_path_save_to_memory(path, NULL, 9, &length));
    free(text);
    v_path_free(again);
    v_path_free(path);

    OK(v_scene_new(&scene));
    v_node_init(&node, V_NODE_LIGHT);
    OK(v_scene_add_node(scene, "lamp", &node, NULL));
    OK(v_scene_set_marker(scene, "meet", 20));
    OK(v_scene_save_to_memory(scene, NULL, 0, &length));
    text = malloc(length + 1);
    other = malloc(length + 1);
    STATUS(V_ERR_SIZE, v_scene_save_to_memory(scene, text, length, &count));
    CHECK(count == length);
    OK(v_scene_save_to_memory(scene, text, length + 1, &count));
    OK(v_scene_load_from_memory(text, length, &read));
    OK(v_scene_save_to_memory(read, other, length + 1, &count));
    CHECK(count == length && strcmp(text, other) == 0);
    v_scene_free(read);
    read = scene;
    STATUS(V_ERR_FORMAT, v_scene_load_from_memory("versio = 1", 10, &read));
    CHECK(strstr(v_last_error(), "memory") != NULL && read == scene);
    /* Nothing of it is read. */
    STATUS(V_ERR_LIMIT, v_scene_load_from_memory("versio = 1", (size_t)1 << 60, &read));
    STATUS(V_ERR_LIMIT, v_path_load_from_memory("versio = 1", (size_t)1 << 60, &again));
    STATUS(V_ERR_LIMIT, v_path_blend(&again, &weight, (size_t)1 << 60, &again));
    STATUS(V_ERR_NULL, v_scene_load_from_memory(NULL, 10, &read));
    STATUS(V_ERR_NULL, v_scene_load_from_memory(text, length, NULL));
    v_scene_free(scene);
    STATUS(V_ERR_HANDLE, v_scene_save_to_memory(scene, text, length, &count));
    free(other);
    free(text);
}

int main(int count, char **arguments)
{
    (void)count;
    ups();
    ahead_and_distance();
    objects();
    names_and_numbers();
    texts(arguments[1]);
    return failures != 0;
}
