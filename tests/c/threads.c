/*
 * One path read by several threads at once, each with its own results and its
 * own list; and a path freed while others read it: every call either ends as if
 * it had come before, or finds the handle gone. A path that is changed without a
 * lock while others read it, as no host should, is before or after a change.
 */
#include <pthread.h>

#include "check.h"

#define THREADS 4

static V_PATH *shared;
static V_POSE expected[400];
static size_t expected_count;

static void *reader(void *unused)
{
    V_POSE poses[400];
    V_KAMERAPAR head;
    size_t count;
    int round;
    (void)unused;
    head.number = -1;
    for (round = 0; round < 100; round++) {
        double length;
        count = 0;
        OK(v_path_sample(shared, poses, 400, &count));
        CHECK(count == expected_count);
        CHECK(memcmp(poses, expected, count * sizeof *poses) == 0);
        OK(v_path_length(shared, &length));
        OK(v_path_to_list(shared, &head));
        CHECK(head.prev->number == (int)count);
    }
    v_free_liste(&head);
    return NULL;
}

static void reading_together(void)
{
    pthread_t threads[THREADS];
    V_PATH *first = new_path();
    int i;
    double xyz[3] = {0, 0.7, 0};
    OK(v_path_insert_point(first, 1, xyz));
    OK(v_path_sample(first, expected, 400, &expected_count));
    /* A copy has nothing computed yet: the threads meet there, too. */
    OK(v_path_clone(first, &shared));
    for (i = 0; i < THREADS; i++)
        CHECK(pthread_create(&threads[i], NULL, reader, NULL) == 0);
    for (i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
    v_path_free(shared);
    v_path_free(first);
}

static void *reader_to_the_end(void *unused)
{
    V_POSE poses[400];
    (void)unused;
    for (;;) {
        size_t count = 0;
        int status = v_path_sample(shared, poses, 400, &count);
        if (status == V_ERR_HANDLE)
            return NULL;
        CHECK(status == V_OK && count == expected_count);
        CHECK(memcmp(poses, expected, count * sizeof *poses) == 0);
    }
}

static void freed_while_read(void)
{
    int round, i;
    for (round = 0; round < 20; round++) {
        pthread_t threads[THREADS];
        V_PATH *others[10];
        double xyz[3] = {0, 0.7, 0};
        shared = new_path();
        OK(v_path_insert_point(shared, 1, xyz));
        for (i = 0; i < THREADS; i++)
            CHECK(pthread_create(&threads[i], NULL, reader_to_the_end, NULL) == 0);
        for (i = 0; i < 10; i++)
            others[i] = new_path();
        v_path_free(shared);
        for (i = 0; i < 10; i++)
            v_path_free(others[i]);
        for (i = 0; i < THREADS; i++)
            pthread_join(threads[i], NULL);
    }
}

static V_POSE closed[400];
static size_t closed_count;

static void *reader_of_changes(void *unused)
{
    V_POSE poses[400];
    int round;
    (void)unused;
    for (round = 0; round < 100; round++) {
        size_t count = 0;
        OK(v_path_sample(shared, poses, 400, &count));
        CHECK((count == expected_count && memcmp(poses, expected, count * sizeof *poses) == 0)
              || (count == closed_count && memcmp(poses, closed, count * sizeof *poses) == 0));
    }
    return NULL;
}

static void *changer(void *unused)
{
    int round;
    (void)unused;
    for (round = 0; round < 100; round++) {
        OK(v_path_set_flag(shared, "closed", 1));
        OK(v_path_set_flag(shared, "closed", 0));
    }
    return NULL;
}

static void changed_while_read(void)
{
    pthread_t threads[THREADS];
    double xyz[3] = {0, 0.7, 0};
    int i;
    shared = new_path();
    OK(v_path_insert_point(shared, 1, xyz));
    OK(v_path_set_flag(shared, "closed", 1));
    OK(v_path_sample(shared, closed, 400, &closed_count));
    OK(v_path_set_flag(shared, "closed", 0));
    OK(v_path_sample(shared, expected, 400, &expected_count));
    CHECK(closed_count > expected_count);
    for (i = 0; i < THREADS; i++)
        CHECK(pthread_create(&threads[i], NULL, i % 2 ? changer : reader_of_changes, NULL) == 0);
    for (i = 0; i < THREADS; i++)
        pthread_join(threads[i], NULL);
    v_path_free(shared);
}

int main(void)
{
    reading_together();
    changed_while_read();
    freed_while_read();
    return failures != 0;
}
