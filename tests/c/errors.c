/*
 * The contract of statuses, of v_last_error(), and of v_haupt() and
 * v_free_liste(), which answer nothing.
 */
#include <pthread.h>
#include <unistd.h>

#include "check.h"

static void texts(void)
{
    char version[40];
    int status;
    sprintf(version, "%d.%d.%d", V_VERSION_MAJOR, V_VERSION_MINOR, V_VERSION_PATCH);
    CHECK(strcmp(v_version(), version) == 0);
    CHECK(V_OK == 0);
    for (status = V_OK; status <= V_ERR_INTERNAL; status++) {
        int other;
        CHECK(v_strerror(status)[0] != '\0');
        for (other = V_OK; other < status; other++)
            CHECK(strcmp(v_strerror(status), v_strerror(other)) != 0);
    }
    CHECK(v_strerror(-1) != NULL && v_strerror(14) != NULL && v_strerror(1 << 30) != NULL);
}

static void last_error(void)
{
    V_PATH *path;
    int count = 77;
    char kept[200];

    CHECK(strcmp(v_last_error(), "") == 0);
    path = new_path();
    CHECK(strcmp(v_last_error(), "") == 0);

    STATUS(V_ERR_NULL, v_path_point_count(path, NULL));
    sprintf(kept, "%.150s", v_last_error());
    /* Asking changes nothing. */
    (void)v_strerror(V_ERR_NULL);
    (void)v_version();
    CHECK(strcmp(v_last_error(), kept) == 0);

    OK(v_path_point_count(path, &count));
    CHECK(strcmp(v_last_error(), "") == 0);

    /* Functions without a status tell by the message alone. */
    v_path_free(path);
    CHECK(strcmp(v_last_error(), "") == 0);
    v_path_free(path);
    CHECK(strcmp(v_last_error(), "") != 0);
    v_path_free(NULL);
    CHECK(strcmp(v_last_error(), "") == 0);
    v_orientation_init(NULL);
    CHECK(strcmp(v_last_error(), "") != 0);
    v_free_liste(NULL);
    CHECK(strcmp(v_last_error(), "") == 0);
}

static void *other_thread(void *message)
{
    CHECK(strcmp(v_last_error(), "") == 0);
    STATUS(V_ERR_HANDLE, v_path_remove_point((V_PATH *)(size_t)7, 0));
    CHECK(v_last_error() != (const char *)message);
    return NULL;
}

static void each_thread_has_its_own(void)
{
    pthread_t thread;
    char kept[200];
    STATUS(V_ERR_NULL, v_path_new(NULL));
    sprintf(kept, "%.150s", v_last_error());
    CHECK(pthread_create(&thread, NULL, other_thread, (void *)v_last_error()) == 0);
    pthread_join(thread, NULL);
    CHECK(strcmp(v_last_error(), kept) == 0);
}

/* A name so long that no message holds it, of characters of three bytes: the
 * middle is left out (an ellipsis, three bytes too), the reason is there. */
static void a_long_message_stays_text(void)
{
    static char name[3 * 20000 + 1];
    V_PATH *path = NULL;
    const unsigned char *text;
    size_t i;
    for (i = 0; i + 3 < sizeof name; i += 3)
        memcpy(name + i, "\xe2\x82\xac", 3);
    STATUS(V_ERR_IO, v_path_load(name, &path));
    CHECK(path == NULL);
    /* Whole characters only. */
    text = (const unsigned char *)v_last_error();
    while (*text != '\0') {
        if (*text < 0x80) {
            text++;
        } else if (memcmp(text, "\xe2\x82\xac", 3) == 0
                   || memcmp(text, "\xe2\x80\xa6", 3) == 0) {
            text += 3;
        } else {
            CHECK(!"a broken character");
            break;
        }
    }
    CHECK(strstr(v_last_error(), ": File name too long") != NULL);
}

/* A file's name need not be UTF-8; a message is nevertheless. The system's
 * number for what it says is left out. */
static void a_name_is_bytes_and_a_message_is_text(void)
{
    V_PATH *path = NULL;
    STATUS(V_ERR_IO, v_path_load("no/such/\xff\xfe.vid", &path));
    CHECK(strcmp(v_last_error(), "no/such/\xef\xbf\xbd\xef\xbf\xbd.vid: "
                                 "No such file or directory") == 0);
}

/* One line on standard error that begins with "vides:". */
static void haupt_says_what_is_wrong(void)
{
    char said[1000] = "";
    int ends[2], kept = dup(2);
    ssize_t length;
    V_KAMERAPAR head;
    memset(&head, 0xa5, sizeof head);
    head.number = -1;
    CHECK(pipe(ends) == 0 && dup2(ends[1], 2) == 2);
    v_haupt(100, 100, 100, 100, &head, 0, NULL, NULL, NULL);
    CHECK(dup2(kept, 2) == 2);
    close(ends[1]);
    length = read(ends[0], said, sizeof said - 1);
    close(ends[0]);
    close(kept);
    CHECK(length > 0 && strncmp(said, "vides:", 6) == 0);
    CHECK(strchr(said, '\n') == said + strlen(said) - 1);
    CHECK(v_last_error()[0] != '\0' && strstr(said, v_last_error()) != NULL);
    CHECK(head.number == -1);
}

int main(void)
{
    texts();
    last_error();
    each_thread_has_its_own();
    a_long_message_stays_text();
    a_name_is_bytes_and_a_message_is_text();
    haupt_says_what_is_wrong();
    return failures != 0;
}
